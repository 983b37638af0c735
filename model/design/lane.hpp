#pragma once

#include <string>
#include <variant>

#include "model/lane/error/lane.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::design {

/// A lane in either number system.
using Lane = std::variant<error::Lane, fixed::FixedLane>;

/// A lane made in one number system, as a Lane. An error is returned unchanged.
template <class Made>
Result<Lane> as_lane(Result<Made> made) {
  if (!made.ok()) return made.error();
  return Lane(std::move(made).value());
}

/// Whether no decision of the lane can be wrong.
bool is_certified(const Lane& lane);
/// "s17e8", "q13" or "block13".
std::string format_name(const Lane& lane);
/// When the lane decides, for a report.
std::string describe_criterion(const Lane& lane);

/// The lane, which must be a floating-point lane.
inline const error::Lane& float_lane(const Lane& lane) {
  return std::get<error::Lane>(lane);
}
inline error::Lane& float_lane(Lane& lane) {
  return std::get<error::Lane>(lane);
}

}  // namespace mixcmp::design
