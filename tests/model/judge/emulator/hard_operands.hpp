#pragma once

#include <random>
#include <utility>

#include "model/base/number/float_format.hpp"
#include "model/comparison/expression/graph.hpp"

namespace mixcmp::test {

/// Operands of `operation` in `format` (at most 53 digits) whose result lies half way between two
/// neighbours of `digits` digits, or so close that rounding to 53 digits first may hide the
/// difference. The second one is unused for one operand.
std::pair<Bits, Bits> hard_operands(Operation operation, FloatFormat format, int digits,
                                    std::mt19937_64& random);

/// The comparison of `operation` applied to a and b with b - a (for one operand: to a, with a).
Graph graph_of(Operation operation);

}  // namespace mixcmp::test
