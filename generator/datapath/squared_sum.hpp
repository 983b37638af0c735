#pragma once

#include <optional>

#include "generator/datapath/units.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::datapath {

/// Recognises the square of a sum or difference that nothing else reads, in one format and rounded
/// to nearest: fp_squared_sum computes both with the same bits in fewer gates. Returns the node of
/// the sum, else nullopt. Its unit has no `exceptional` output, so lanes do not use it.
std::optional<NodeId> squared_sum_of(const TypedGraph& graph, NodeId square);

/// fp_squared_sum, of operands and result in `format`.
Unit squared_sum_unit(FloatFormat format, Subnormals subnormals, scene::Multipliers multipliers,
                      const DelayTable& delays);

}  // namespace mixcmp::datapath
