#include "model/lane/error/hazards.hpp"

#include <algorithm>

#include "model/base/number/exact.hpp"
#include "model/lane/error/range_analysis.hpp"
#include "model/lane/error/sign.hpp"

namespace mixcmp::error {
namespace {

std::vector<bool> nonnegative(const std::vector<std::optional<Range>>& ranges) {
  std::vector<bool> result;
  for (const auto& range : ranges) result.push_back(range && range->low >= 0);
  return result;
}

/// Whether a sum's operands are not proven to lie on the same side of zero. Operations other than
/// sums have no logic for cancellation; true leaves their flag as it is by default.
bool may_cancel(const TypedGraph& graph, const std::vector<Sign>& signs, NodeId id) {
  const TypedNode& node = graph.nodes[id];
  if (node.operation == Operation::fused_sum) {
    return !signs[id].nonnegative && !signs[id].nonpositive;
  }
  const bool subtracts = node.operation == Operation::subtract;
  if (!subtracts && node.operation != Operation::add) return true;
  const Sign& second = signs[node.operands[1]];
  const Sign sum = sum_sign(signs[node.operands[0]], subtracts ? second.negated() : second);
  return !sum.nonnegative && !sum.nonpositive;
}

/// Tells for each input whether the graph uses it: a part of a comparison may use only some.
std::vector<bool> used_inputs(const TypedGraph& graph) {
  std::vector<bool> used(static_cast<std::size_t>(graph.input_count), false);
  for (const TypedNode& node : graph.nodes) {
    if (node.operation == Operation::input) used[static_cast<std::size_t>(node.input)] = true;
  }
  return used;
}

class HazardAnalysis {
public:
  HazardAnalysis(const TypedGraph& graph, const std::vector<std::optional<Range>>& checked)
      : graph_(graph),
        checked_(checked),
        ranges_(analyse_ranges(graph, checked)),
        signs_(analyse_signs(graph, nonnegative(checked))) {}

  std::vector<Hazards> run() {
    std::vector<Hazards> hazards;
    for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
      hazards.push_back(hazards_of(id));
      special_.push_back(is_special(id, hazards.back()));
    }
    return hazards;
  }

private:
  const TypedNode& node(NodeId id) const { return graph_.nodes[id]; }
  const NodeRange& range(NodeId id) const { return ranges_[static_cast<std::size_t>(id)]; }

  template <typename Predicate>
  bool any_operand(NodeId id, Predicate predicate) const {
    const auto operands = node(id).operands.begin();
    return std::any_of(operands, operands + arity(node(id).operation), predicate);
  }

  Hazards hazards_of(NodeId id) const {
    // With gradual underflow a sum below the smallest normal number is exact. So it is no
    // Event::underflow, but it is still subnormal.
    const bool subnormal =
        may_be_subnormal(id) || any_operand(id, [&](NodeId k) { return may_be_subnormal(k); });
    return {.special_operand = any_operand(id, [&](NodeId k) { return special_[k]; }),
            .overflow = range(id).may(Event::overflow) || range(id).may(Event::division_by_zero),
            .underflow = range(id).may(Event::underflow) || subnormal,
            .cancellation = may_cancel(graph_, signs_, id)};
  }

  bool is_special(NodeId id, const Hazards& hazards) const {
    if (node(id).operation == Operation::input) return !checked_[node(id).input];
    if (node(id).operation == Operation::constant) {
      return node(id).format.is_infinite(node(id).constant);
    }
    return hazards.special_operand || hazards.overflow || range(id).may(Event::root_of_negative);
  }

  bool may_be_subnormal(NodeId id) const {
    if (graph_.arithmetic.subnormals == Subnormals::flush && is_computed(id)) return false;
    const mpq_class normal = to_rational(node(id).format, node(id).format.smallest_normal(false));
    const Range& value = range(id).value;
    const bool only_zero = value.low == 0 && value.high == 0;
    return !only_zero && value.low < normal && value.high > -normal;
  }

  /// Whether the value is always the result of an operation, never an input or a constant passed on
  /// by a sign change or a selection. If subnormals are flushed, the result of an operation is
  /// never subnormal.
  bool is_computed(NodeId id) const {
    switch (node(id).operation) {
      case Operation::input:
      case Operation::constant: return false;
      case Operation::negate:
      case Operation::absolute:
      case Operation::minimum:
      case Operation::maximum: return !any_operand(id, [&](NodeId k) { return !is_computed(k); });
      case Operation::convert:
      case Operation::add:
      case Operation::subtract:
      case Operation::multiply:
      case Operation::square:
      case Operation::divide:
      case Operation::square_root:
      case Operation::fused_sum: return true;
      case Operation::function:
      case Operation::look_up: break;
    }
    MIXCMP_CHECK(false);
  }

  const TypedGraph& graph_;
  const std::vector<std::optional<Range>>& checked_;
  std::vector<NodeRange> ranges_;
  std::vector<Sign> signs_;
  std::vector<bool> special_;
};

}  // namespace

bool has_unit(Operation operation) {
  if (operation == Operation::fused_sum) return true;
  return arity(operation) > 0 && operation != Operation::negate && operation != Operation::absolute;
}

std::vector<RangeCheck> full_range_checks(const TypedGraph& graph,
                                          const std::vector<std::optional<Range>>& ranges) {
  const std::vector<bool> used = used_inputs(graph);
  std::vector<RangeCheck> checks;
  for (std::size_t input = 0; input < ranges.size(); ++input) {
    if (!ranges[input] || !used[input]) continue;
    checks.push_back(range_check(static_cast<int>(input), graph.input_format, *ranges[input]));
  }
  return checks;
}

std::vector<std::optional<Range>> checked_ranges(const TypedGraph& graph,
                                                 const std::vector<RangeCheck>& checks) {
  std::vector<std::optional<Range>> ranges(static_cast<std::size_t>(graph.input_count));
  for (const RangeCheck& check : checks) {
    if (check.leading_bits > 0) {
      ranges[check.input] = checked_range(check, graph.input_format);
    }
  }
  return ranges;
}

std::vector<Hazards> structural_hazards(const TypedGraph& graph) {
  const std::vector<Sign> signs =
      analyse_signs(graph, std::vector<bool>(static_cast<std::size_t>(graph.input_count), false));
  std::vector<Hazards> hazards(graph.nodes.size());
  for (NodeId id = 0; id < static_cast<NodeId>(hazards.size()); ++id) {
    hazards[static_cast<std::size_t>(id)].cancellation = may_cancel(graph, signs, id);
  }
  return hazards;
}

void remove_hazards(Lane& lane, const std::vector<std::optional<Range>>& ranges) {
  lane.hazards = structural_hazards(lane.graph);
  std::vector<RangeCheck> checks = full_range_checks(lane.graph, ranges);
  const std::vector<std::optional<Range>> checked = checked_ranges(lane.graph, checks);
  std::vector<Hazards> hazards = HazardAnalysis(lane.graph, checked).run();
  bool useful = false;
  for (std::size_t id = 0; id < hazards.size(); ++id) {
    useful |= has_unit(lane.graph.nodes[id].operation) && hazards[id] != lane.hazards[id];
  }
  if (!useful) return;
  const Criterion criterion = lane.criterion();
  lane = one_part_lane(std::move(lane.graph), criterion, std::move(checks));
  lane.hazards = std::move(hazards);
}

}  // namespace mixcmp::error
