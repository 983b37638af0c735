#include "generator/hardware/datapath/fused_sum.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "generator/hardware/datapath/stage_list.hpp"
#include "model/lane/error/sign.hpp"

namespace mixcmp::datapath {
namespace {

using scene::Multipliers;

/// Which kinds of terms a fused sum has.
struct Kinds {
  bool squared_sums = false;  ///< sums that the sum's own unit squares
  bool squares = false;       ///< squares of operands
  bool products = false;
};

Kinds kinds_of(const TypedGraph& graph, const TypedNode& node, SquaredSums squared) {
  Kinds kinds;
  for (const FusedTerm& term : node.terms) {
    const bool together =
        squared == SquaredSums::together && term.is_square() && is_only_squared(graph, term.a);
    kinds.squared_sums |= together;
    kinds.squares |= term.is_square() && !together;
    kinds.products |= term.is_product() && !term.is_square();
  }
  return kinds;
}

/// Adds the stages of fp_unnormalised_sum; they are only wires if no sum is squared.
void add_sums(StageList& stages, FloatFormat format, Subnormals subnormals, const Kinds& kinds) {
  if (kinds.squared_sums) return add_unnormalised_sum(stages, format, subnormals);
  for (const char* stage :
       {"compare", "swap", "align by fours", "align operands", "sum", "select", "round sum"}) {
    stages.add(stage, 0);
  }
}

/// The stages "count" and "normalise" of a squared sum. Only its exponent is normalised. During
/// "normalise" its significand goes to the multipliers.
StageList count_of_squared_sum(const FusedSum& sum, FloatFormat format, Multipliers multipliers,
                               const DelayTable& delays) {
  StageList stages(delays);
  const double exponent = stages.carry(sum.exponent_bits());
  stages.add("count", std::max(stages.lut_delay_ns(count_levels(format.precision())), exponent));
  stages.add("normalise",
             std::max(exponent + stages.lut_delay_ns(2), stages.factors_ns(multipliers)));
  return stages;
}

/// The tree that finds the largest exponent of the terms, then their distances from it.
StageList exponent_stages(const FusedSum& sum, int candidates, const DelayTable& delays) {
  StageList stages(delays);
  for (int level = 0; level < FusedSum::levels; ++level) {
    const bool compares = FusedSum::is_used(level, candidates);
    stages.add("exponents " + std::to_string(level),
               compares ? stages.carry(sum.exponent_bits()) + stages.lut_delay_ns(1) : 0);
  }
  stages.add("distances", stages.carry(sum.exponent_bits()) + stages.lut_delay_ns(2));
  return stages;
}

/// Adds the stages of the terms beside those of the search for the largest exponent.
void add_terms(StageList& stages, const TypedNode& node, const Kinds& kinds, Subnormals subnormals,
               Multipliers multipliers, const DelayTable& delays) {
  const FusedSum sum(node.format, node.terms.size());
  const bool gradual = subnormals == Subnormals::gradual;
  add_sums(stages, node.format, subnormals, kinds);
  const bool normalises = gradual && (kinds.products || (kinds.squares && !sum.squares_vanish()));
  std::vector<StageList> operands(1, StageList(delays));
  operands[0].add_operand(node.format, normalises ? Subnormals::gradual : Subnormals::flush);
  if (kinds.squared_sums) {
    operands.push_back(count_of_squared_sum(sum, node.format, multipliers, delays));
  }
  stages.add_side_by_side(operands);
  const int candidates = static_cast<int>(node.terms.size()) + (gradual ? 1 : 0);
  std::vector<StageList> beside = {exponent_stages(sum, candidates, delays)};
  for (const auto kind : {LogicProduct::Kind::product, LogicProduct::Kind::square}) {
    const bool occurs =
        kind == LogicProduct::Kind::square ? kinds.squares || kinds.squared_sums : kinds.products;
    if (!occurs) continue;
    beside.emplace_back(delays);
    beside.back().add_product_behind_factors(node.format.precision(), kind, multipliers);
    // fp_fused_term has no cut in front of its multipliers.
    if (kinds.products || kinds.squares)
      beside.back().begin_with(beside.back().factors_ns(multipliers));
  }
  stages.add_side_by_side(beside);
}

/// Adds the stages of fp_cut_sum.
void add_cut_sum(StageList& stages, const TypedGraph& graph, const TypedNode& node,
                 SquaredSums squared, Multipliers multipliers, const DelayTable& delays) {
  const int terms = static_cast<int>(node.terms.size());
  const FusedSum sum(node.format, node.terms.size());
  add_terms(stages, node, kinds_of(graph, node, squared), graph.arithmetic.subnormals, multipliers,
            delays);
  // The exponents of squares are even, and so are the distances between them.
  const bool even = std::all_of(node.terms.begin(), node.terms.end(),
                                [](const FusedTerm& term) { return term.is_square(); });
  const int low_bits = FusedSum::low_amount_bits;
  stages.add("align coarsely", stages.lut_delay_ns(shift_levels(sum.amount_bits() - low_bits)));
  stages.add("align", stages.lut_delay_ns(shift_levels(even ? low_bits - 1 : low_bits)));
  for (int level = 0; level < FusedSum::levels; ++level) {
    stages.add("sum " + std::to_string(level),
               FusedSum::is_used(level, terms) ? stages.carry(sum.sum_bits() + 2) : 0);
  }
}

/// Tells whether the terms of a fused sum may have unlike signs.
bool may_cancel(const TypedGraph& graph, const std::vector<FusedTerm>& terms) {
  const std::vector<bool> no_ranges(static_cast<std::size_t>(graph.input_count), false);
  const error::Sign sign = error::sum_sign(terms, error::analyse_signs(graph, no_ranges));
  return !sign.nonnegative && !sign.nonpositive;
}

Unit on_device(Unit unit, Multipliers multipliers, const DelayTable& delays) {
  unit.multipliers = multipliers;
  unit.multiplier = delays.multiplier_size;
  return with_sum_selects(std::move(unit), delays);
}

}  // namespace

Unit fused_sum_unit(const TypedGraph& graph, const TypedNode& node, SquaredSums squared,
                    Multipliers multipliers, const DelayTable& delays) {
  const FusedSum sum(node.format, node.terms.size());
  const bool cancels = may_cancel(graph, node.terms);
  StageList stages(delays, StageList::WideSums::whole);
  add_cut_sum(stages, graph, node, squared, multipliers, delays);
  stages.add("magnitude", cancels ? stages.carry(sum.sum_bits()) : 0);
  const int counted = cancels ? sum.sum_bits() : sum.growth_bits() + 1;
  stages.add("count", stages.lut_delay_ns(count_levels(counted)));
  const bool limits = cancels && graph.arithmetic.subnormals == Subnormals::gradual;
  const double limit = limits ? stages.carry(sum.exponent_bits()) + stages.lut_delay_ns(1) : 0;
  stages.add("normalise", limit + stages.lut_delay_ns(shift_levels(bits_for(counted))));
  stages.add_round(node.format, false, 0);
  return on_device(std::move(stages).unit("fp_fused_sum"), multipliers, delays);
}

Unit fused_comparison_unit(const TypedGraph& graph, const TypedNode& node, SquaredSums squared,
                           Multipliers multipliers, const DelayTable& delays) {
  const FusedSum sum(node.format, node.terms.size());
  StageList stages(delays, StageList::WideSums::whole);
  add_cut_sum(stages, graph, node, squared, multipliers, delays);
  stages.add("decide", stages.lut_delay_ns(reduction_levels(sum.sum_bits()) + 1));
  return on_device(std::move(stages).unit("fp_fused_comparison"), multipliers, delays);
}

}  // namespace mixcmp::datapath
