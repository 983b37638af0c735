#pragma once

#include <optional>

#include "generator/hardware/datapath/stage_list.hpp"
#include "generator/hardware/datapath/units.hpp"
#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::datapath {

/// Whether a sum and its square share a unit. The shared unit has no `exceptional` output, so lanes
/// keep the two apart.
enum class SquaredSums { apart, together };

/// Tells whether a node is a sum or difference of one format, rounded to nearest, whose only reader
/// is one square: a node of its own or a term of a fused sum. The unit that they share squares the
/// sum with its leading zeros, which gives the same bits in fewer gates.
bool is_only_squared(const TypedGraph& graph, NodeId sum);
/// The operand of the node `square`, if it is a sum that is only squared.
std::optional<NodeId> squared_sum_of(const TypedGraph& graph, NodeId square);

/// The stages of fp_unnormalised_sum.
void add_unnormalised_sum(StageList& stages, FloatFormat format, Subnormals subnormals);

/// The unit fp_squared_sum, with operands and result in `format`.
Unit squared_sum_unit(FloatFormat format, Subnormals subnormals, scene::Multipliers multipliers,
                      const DelayTable& delays);

}  // namespace mixcmp::datapath
