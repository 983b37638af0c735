#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "model/comparison/expression/graph.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::test {

/// A comparison, the ranges of its inputs in the order of the graph, and formats of its operands if
/// they are in fixed point.
struct FunctionComparison {
  std::string name;
  std::vector<std::pair<std::string, std::string>> parts;
  std::vector<Range> ranges;
  std::vector<const char*> formats = {};
  int functions = 100;  ///< tuples of operands and nodes, at least

  Graph graph() const;
  std::vector<OperandFormat> operand_formats() const;  ///< none: all are in `format` of a lane
  Result<fixed::FixedLane> lane(FloatFormat format, int bits, bool is_reference = false) const;
};

/// Functions by themselves, of each other, of constants, in every operation, near the ends of their
/// domains.
std::vector<FunctionComparison> function_comparisons();

/// Numbers at which functions, formats or limits change: in the range, its ends, small ones, and
/// some beyond.
double hard_operand(const Range& range, std::mt19937_64& random);

}  // namespace mixcmp::test
