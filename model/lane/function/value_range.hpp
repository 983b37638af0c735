#pragma once

#include <optional>

#include "model/comparison/expression/graph.hpp"

namespace mixcmp::function {

/// Whether a function has a value for all arguments of a range.
bool has_value_in(const Function& function, const Range& arguments);

/// Encloses the real values of an operation on operands in the ranges a and b; none if it may have
/// no value, jumps, or an operand that it has is in no known range. Not for inputs and constants.
std::optional<Range> value_range(const Node& node, const std::optional<Range>& a,
                                 const std::optional<Range>& b);

}  // namespace mixcmp::function
