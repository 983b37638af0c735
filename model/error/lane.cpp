#include "model/error/lane.hpp"

#include <fmt/core.h>

namespace mixcmp::error {
namespace {

std::string describe_bound(const BoundGraph& bound) {
  const BoundNode& last = bound.nodes.back();
  if (last.operation == BoundOperation::constant) {
    return fmt::format("{:.4g}, a constant", last.constant.get_d());
  }
  if (bound.format.precision == 1) return "a running bound of exponents alone";
  return fmt::format("a running bound of {} digits", bound.format.precision);
}

}  // namespace

std::string describe_decision(const Lane& lane) {
  if (const auto* interval = std::get_if<IntervalDecision>(&lane.decision)) {
    return fmt::format("profiled, not certified: RE_f = {:.4g}, RE_g = {:.4g}",
                       interval->relative_error_f.get_d(), interval->relative_error_g.get_d());
  }
  if (const auto* absolute = std::get_if<AbsoluteBoundDecision>(&lane.decision)) {
    return "certified: where |f - g| exceeds " + describe_bound(absolute->bound);
  }
  const Bits guard = std::get<UlpDistanceDecision>(lane.decision).guard_ulp;
  if (guard == 0) return "certified: everywhere, f and g are exact";
  return fmt::format("certified: where f and g are {} ulp apart or more", guard);
}

}  // namespace mixcmp::error
