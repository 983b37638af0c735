#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/error/certified_lane.hpp"
#include "model/fixed/fixed_lane.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::scene {

/// A way to bound the errors of a lane, whatever its precision. Profiles, tables and options name
/// it "relative", "running_4" (digits), "constant" or "profiled"; of lanes in fixed point
/// "fixed_constant", "fixed_norm" or "fixed_running", in block floating point "block_constant" and
/// so on; with guard digits "fixed_norm_g3".
struct BoundChoice {
  /// In the order of their names, in which tables are sorted.
  enum class Kind {
    block_constant,
    block_norm,
    block_running,
    constant,
    fixed_constant,
    fixed_norm,
    fixed_running,
    profiled,
    relative,
    running
  };

  Kind kind = Kind::relative;
  int digits = 0;  ///< of a running bound; in fixed point guard digits; 0 for others

  bool is_block() const {
    return kind == Kind::block_constant || kind == Kind::block_norm || kind == Kind::block_running;
  }
  /// Block floating point included.
  bool is_fixed_point() const {
    return is_block() || kind == Kind::fixed_constant || kind == Kind::fixed_norm ||
           kind == Kind::fixed_running;
  }

  bool is_running() const {
    return kind == Kind::running || kind == Kind::fixed_running || kind == Kind::block_running;
  }

  /// The lanes in fixed point of W = `bits` that have this bound.
  FixedPoint fixed_point(int bits) const;

  /// Whether lanes of this format have such bounds.
  bool is_for(const LaneFormat& format) const;

  friend auto operator<=>(const BoundChoice&, const BoundChoice&) = default;
};

std::string to_string(const BoundChoice& choice);
/// Returns an empty string where there is no choice.
std::string to_string(const std::optional<BoundChoice>& choice);

Result<BoundChoice> parse_bound_choice(std::string_view name);
/// All names, for helps and messages.
std::string bound_choice_names();

/// How one part of a lane bounds its errors.
BoundChoice bound_choice(const error::LanePart& part);
/// How a lane bounds its errors; none if its parts do so in different ways.
std::optional<BoundChoice> bound_choice(const error::Lane& lane);
BoundChoice bound_choice(const fixed::FixedLane& lane);
/// The choice with which `candidate_lanes` made a candidate.
BoundChoice bound_choice(const error::CandidateLane& candidate);

/// The choices of lanes in this format.
std::vector<BoundChoice> fixed_bound_choices(const FixedPoint& format);

/// The choices that a profile counts.
std::span<const BoundChoice> counted_bound_choices();

/// Returns a copy of `reduced` with this bound, in its number system: W of fixed point is that of
/// `reduced`, or the digits of its format.
ReducedSpec with_bound(const ReducedSpec& reduced, const BoundChoice& choice);

}  // namespace mixcmp::scene
