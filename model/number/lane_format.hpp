#pragma once

#include <optional>
#include <string_view>

#include "model/common/result.hpp"
#include "model/number/float_format.hpp"

namespace mixcmp::inline number {

/// The format of a lane, as tables and signatures name it: "s17e8", or "q13" in fixed point.
struct LaneFormat {
  std::optional<FloatFormat> floating;  ///< none: fixed point
  int precision = 0;                    ///< L; of fixed point W

  static Result<LaneFormat> parse(std::string_view name);
};

}  // namespace mixcmp::inline number
