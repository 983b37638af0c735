#include "model/error/lane.hpp"

#include <fmt/core.h>

namespace mixcmp::model {

std::string describe_decision(const Lane& lane) {
  if (const auto* interval = std::get_if<IntervalDecision>(&lane.decision)) {
    return fmt::format("profiled, not certified: RE_f = {:.4g}, RE_g = {:.4g}",
                       interval->relative_error_f.get_d(), interval->relative_error_g.get_d());
  }
  const Bits guard = std::get<UlpDistanceDecision>(lane.decision).guard_ulp;
  if (guard == 0) return "certified: everywhere, f and g are exact";
  return fmt::format("certified: where f and g are {} ulp apart or more", guard);
}

}  // namespace mixcmp::model
