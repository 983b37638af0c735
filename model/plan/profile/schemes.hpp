#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/design/lane.hpp"
#include "model/plan/profile/profile.hpp"

namespace mixcmp::profile {

/// The lanes with one kind of error bound, at every precision where they exist.
struct SchemeLanes {
  std::string name;
  std::optional<Bound> bound;  ///< none: lanes without a bound
  SchemeKind kind;
  std::vector<std::optional<design::Lane>> lanes;  ///< one per precision
  std::string reason;                              ///< why there is no lane at some precision

  bool exists() const;
};

/// The exponent bits of all lanes that a profile counts: those of reduced.format, or of the
/// reference if reduced.format is "auto".
int profiled_exponent_bits(const scene::Scene& scene);

/// The lane's graph at one precision, with `profiled_exponent_bits`.
TypedGraph graph_at(const scene::Scene& scene, int precision, LaneInputs inputs);

/// Makes the schemes for a profile: lanes without a bound, lanes profiled with the constants of
/// `errors`, and every certified candidate, in floating point and in fixed point. The precision of
/// a fixed-point lane is its W. If `bounds` names any, only these.
std::vector<SchemeLanes> make_schemes(const scene::Scene& scene, const ErrorProfile& errors,
                                      std::span<const Bound> bounds = {});

}  // namespace mixcmp::profile
