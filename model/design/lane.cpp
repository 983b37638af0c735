#include "model/design/lane.hpp"

#include <fmt/core.h>

#include "model/base/common/cases.hpp"

namespace mixcmp::design {

bool is_certified(const Lane& lane) {
  const auto* floating = std::get_if<error::Lane>(&lane);
  return floating == nullptr || floating->certified();
}

std::string format_name(const Lane& lane) {
  return std::visit(Cases{[](const error::Lane& l) { return l.graph.arithmetic.format.name(); },
                          [](const fixed::FixedLane& l) { return l.format.name(); }},
                    lane);
}

std::string describe_criterion(const Lane& lane) {
  return std::visit([](const auto& l) { return describe_criterion(l); }, lane);
}

}  // namespace mixcmp::design
