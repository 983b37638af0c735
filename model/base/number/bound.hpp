#pragma once

#include <compare>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/number/lane_format.hpp"

namespace mixcmp::inline number {

enum class NumberSystem {
  floating,
  fixed,
  block,  ///< block floating point
};

/// How the error of f - g is bounded.
enum class BoundKind {
  relative,  ///< by the relative errors of f and g: a distance in ulps, one integer subtraction
  running,   ///< by an absolute bound that follows magnitudes, computed beside the values
  constant,  ///< by an absolute bound that follows from the inputs' ranges
  norm,      ///< by the norm of the errors (docs/fixed_point.md, theorem 4)
  grid,      ///< by 0: operands are multiples of a grid, which is checked, and nothing is rounded
  profiled,  ///< by relative errors that were measured on data: the only kind without a proof
};
std::string_view to_string(BoundKind kind);

/// A way to bound the errors of a lane, whatever its precision. In profiles, tables and options it
/// is named "relative", "running_4" (digits), "constant" or "profiled". Fixed-point lanes have
/// "fixed_constant", "fixed_norm", "fixed_running" or "fixed_grid". In block floating point the
/// names are "block_constant" and so on. With guard digits they are like "fixed_norm_g3".
struct Bound {
  NumberSystem system = NumberSystem::floating;
  BoundKind kind = BoundKind::relative;
  int digits = 0;  ///< a running bound's in floating point; guard digits in the other systems

  bool is_profiled() const { return kind == BoundKind::profiled; }
  /// Whether the system is fixed point; that includes block floating point.
  bool is_fixed_point() const { return system != NumberSystem::floating; }

  /// The fixed-point format with W = `bits` for lanes that have this bound.
  FixedPoint fixed_point(int bits) const;

  /// Whether lanes of this format have such bounds.
  bool is_for(const LaneFormat& format) const;

  /// The order of the names without digits, in which tables are sorted; then the order of digits.
  friend std::strong_ordering operator<=>(const Bound& a, const Bound& b);
  friend bool operator==(const Bound&, const Bound&) = default;
};

/// The bound of lanes that rely on promised grids.
inline constexpr Bound grid_bound = {.system = NumberSystem::fixed, .kind = BoundKind::grid};

std::string to_string(const Bound& bound);
/// Returns an empty string if there is no bound.
std::string to_string(const std::optional<Bound>& bound);

/// The bounds of lanes in this format, norms first.
std::vector<Bound> bounds_of(const FixedPoint& format);

/// The bounds that a profile counts of every scene.
std::span<const Bound> counted_bounds();

}  // namespace mixcmp::inline number
