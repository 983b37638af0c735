#pragma once

#include <cstdint>
#include <vector>

#include "model/number/verdict.hpp"

namespace mixcmp::project {

/// A comparison that the test bench sends, and the word in which the result must return.
struct TestVector {
  std::vector<std::uint8_t> tdata;  ///< s_axis_tdata of one lane, the lowest byte first
  ResultWord expected;
};

}  // namespace mixcmp::project
