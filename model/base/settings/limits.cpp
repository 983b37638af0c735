#include "model/base/settings/limits.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mixcmp::settings {

std::string to_string(Limits limits) {
  return fmt::format("{}..{}", limits.least, limits.most);
}

Limits lane_precisions(FloatFormat reference) {
  return {limits::lane_precision.least,
          std::min(limits::lane_precision.most, reference.precision())};
}

Limits lane_fixed_bits(FloatFormat reference) {
  return {limits::fixed_bits.least, std::min(limits::fixed_bits.most, reference.precision())};
}

bool allow(Limits lane_fixed_bits, const FixedPoint& format) {
  return lane_fixed_bits.allow(format.bits) && lane_fixed_bits.allow(format.operand_bits());
}

}  // namespace mixcmp::settings
