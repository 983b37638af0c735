#include "generator/components/lane_bound.hpp"

#include <fmt/core.h>

#include "model/common/quote.hpp"

namespace mixcmp::gen {

using model::BoundKind;
using model::ErrorBoundKind;

model::Result<LaneBound> find_lane_bound(std::string_view name) {
  if (name == "relative") return LaneBound{.kind = ErrorBoundKind::relative};
  if (name == "constant") return LaneBound{.kind = ErrorBoundKind::constant};
  if (name == "profiled") return LaneBound{.bound = BoundKind::profiled};
  constexpr std::string_view running = "running_";
  constexpr model::Limits digits = model::limits::bound_digits;
  static_assert(digits.most <= 9, "one character names the digits");
  if (name.size() == running.size() + 1 && name.starts_with(running) &&
      digits.allow(name.back() - '0')) {
    return LaneBound{.kind = ErrorBoundKind::running, .digits = name.back() - '0'};
  }
  return model::Error{
      .message = "not a bound",
      .received = model::in_quotes(name),
      .accepted = fmt::format("relative, running_{} to running_{}, constant, profiled",
                              digits.least, digits.most)};
}

const std::vector<std::string>& profiled_lane_bounds() {
  static const std::vector<std::string> names = {"relative", "running_4", "running_1", "constant",
                                                 "profiled"};
  return names;
}

model::ReducedSpec with_bound(const model::ReducedSpec& reduced, const LaneBound& bound) {
  model::ReducedSpec copy = reduced;
  copy.bound = bound.bound;
  copy.error_bound.reset();
  if (bound.bound == BoundKind::certified) copy.error_bound = bound.kind;
  copy.bound_digits = bound.digits;
  return copy;
}

}  // namespace mixcmp::gen
