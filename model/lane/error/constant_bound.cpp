#include "model/lane/error/constant_bound.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "model/comparison/expression/text.hpp"
#include "model/lane/error/hazards.hpp"
#include "model/lane/error/range_analysis.hpp"

namespace mixcmp::error {
namespace {

/// The largest power of two that is at most a positive number.
mpq_class binade(const mpq_class& value) {
  mpq_class power = 1;
  while (power > value) power /= 2;
  while (power * 2 <= value) power *= 2;
  return power;
}

mpq_class greatest_magnitude(const Range& range) {
  return std::max<mpq_class>(abs(range.low), abs(range.high));
}

mpq_class least_magnitude(const Range& range) {
  if (range.low <= 0 && range.high >= 0) return 0;
  return std::min<mpq_class>(abs(range.low), abs(range.high));
}

class ConstantFolding {
public:
  ConstantFolding(const TypedGraph& graph, ErrorAnalysis analysis,
                  const std::vector<RangeCheck>& checks)
      : graph_(graph),
        analysis_(std::move(analysis)),
        ranges_(analyse_ranges(graph, checked_ranges(graph, checks))) {}

  Result<Done> check_divisors() const {
    for (const TypedNode& node : graph_.nodes) {
      if (node.operation != Operation::divide) continue;
      const NodeId divisor = node.operands[1];
      if (least_magnitude(range(divisor)) == 0) return stands_in_the_way(divisor, "may be zero");
    }
    return Done{};
  }

  Result<mpq_class> run(const AbsoluteError& bound) const {
    if (bound.bound == no_bound_node) return mpq_class(0);
    MIXCMP_TRY(value, fold(bound.bound));
    for (const BoundCondition& condition : analysis_.conditions) {
      MIXCMP_TRY(limit, fold(condition.bound));
      if (limit > least_magnitude(range(condition.value))) {
        return stands_in_the_way(condition.value, "may be closer to zero than its own error");
      }
    }
    return mpq_class(value * bound.inflation);
  }

private:
  const Range& range(NodeId id) const { return ranges_[static_cast<std::size_t>(id)].value; }

  Result<mpq_class> fold(BoundId id) const {
    const BoundNode& node = analysis_.bounds[id];
    switch (node.operation) {
      case BoundOperation::constant: return node.constant;
      case BoundOperation::magnitude:
      case BoundOperation::binade: return fold_magnitude(node);
      case BoundOperation::reciprocal: return fold_reciprocal(node.value);
      case BoundOperation::add:
      case BoundOperation::multiply:
      case BoundOperation::maximum: return fold_operation(node);
    }
    MIXCMP_CHECK(false);
  }

  Result<mpq_class> fold_operation(const BoundNode& node) const {
    MIXCMP_TRY(a, fold(node.operands[0]));
    MIXCMP_TRY(b, fold(node.operands[1]));
    if (node.operation == BoundOperation::add) return mpq_class(a + b);
    if (node.operation == BoundOperation::multiply) return mpq_class(a * b);
    return std::max(a, b);
  }

  Result<mpq_class> fold_magnitude(const BoundNode& node) const {
    const std::vector<int>& open = ranges_[static_cast<std::size_t>(node.value)].rangeless_inputs;
    if (!open.empty()) {
      return Error{
          .field = "inputs",
          .message = fmt::format("no constant bound can be proven: the error grows with {}",
                                 text(node.value)),
          .received = fmt::format("no range of {}", graph_.input_names[open.front()]),
          .accepted = fmt::format("{} = {{ range = [low, high] }}, reduced.error_bound = "
                                  "\"running\"",
                                  graph_.input_names[open.front()])};
    }
    const mpq_class greatest = greatest_magnitude(range(node.value));
    if (node.operation == BoundOperation::magnitude || greatest == 0) return greatest;
    return binade(greatest);
  }

  Result<mpq_class> fold_reciprocal(NodeId id) const {
    const mpq_class least = least_magnitude(range(id));
    if (least == 0) return stands_in_the_way(id, "may be zero");
    return mpq_class(1 / least);
  }

  Error stands_in_the_way(NodeId id, const char* what) const {
    return {.field = "inputs",
            .message = fmt::format("no constant bound can be proven: {} {}", text(id), what),
            .received =
                fmt::format("values in [{}, {}]", to_text(range(id).low), to_text(range(id).high)),
            .accepted =
                "ranges that keep it away from zero, reduced.error_bound = \"running\", "
                "reduced.bound = \"profiled\", or a formulation without this operation"};
  }

  std::string text(NodeId id) const {
    constexpr std::size_t readable_length = 60;
    return to_text(graph_.nodes, graph_.input_names, id, readable_length);
  }

  const TypedGraph& graph_;
  ErrorAnalysis analysis_;
  std::vector<NodeRange> ranges_;
};

}  // namespace

Result<Done> check_divisors(const TypedGraph& graph, const std::vector<RangeCheck>& checks) {
  return ConstantFolding(graph, {}, checks).check_divisors();
}

Result<mpq_class> constant_bound(const TypedGraph& graph, const ErrorAnalysis& analysis,
                                 const AbsoluteError& bound,
                                 const std::vector<RangeCheck>& checks) {
  return ConstantFolding(graph, analysis, checks).run(bound);
}

}  // namespace mixcmp::error
