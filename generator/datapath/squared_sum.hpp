#pragma once

#include <optional>

#include "generator/datapath/stage_list.hpp"
#include "generator/datapath/units.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::datapath {

/// Whether a sum and its square share a unit. It has no `exceptional` output, so lanes keep them
/// apart.
enum class SquaredSums { apart, together };

/// Tells whether a node is a sum or difference of one format, rounded to nearest, that nothing
/// reads but one square, a node of its own or a term of a fused sum: their unit squares it with its
/// leading zeros, which gives the same bits in fewer gates.
bool is_only_squared(const TypedGraph& graph, NodeId sum);
/// The sum that the node `square` is of, if it is only squared.
std::optional<NodeId> squared_sum_of(const TypedGraph& graph, NodeId square);

/// The stages of fp_unnormalised_sum.
void add_unnormalised_sum(StageList& stages, FloatFormat format, Subnormals subnormals);

/// fp_squared_sum, of operands and result in `format`.
Unit squared_sum_unit(FloatFormat format, Subnormals subnormals, scene::Multipliers multipliers,
                      const DelayTable& delays);

}  // namespace mixcmp::datapath
