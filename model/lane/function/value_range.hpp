#pragma once

#include <optional>
#include <vector>

#include "model/comparison/expression/graph.hpp"

namespace mixcmp::function {

/// None: not known, or without a bound.
using PossibleRange = std::optional<Range>;

/// Whether a function has a value for all arguments of a range.
bool has_value_in(const Function& function, const Range& arguments);

/// Encloses the real values of a node. None if it may have no value, jumps, or has an operand in no
/// known range. `inputs`: a range for each input, or none at all. `nodes`: the values of the nodes
/// before it, or more than these.
PossibleRange value_range(const Node& node, const std::vector<PossibleRange>& inputs,
                          const std::vector<PossibleRange>& nodes);

}  // namespace mixcmp::function
