#include "model/lane/error/lane.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/expression/text.hpp"

namespace mixcmp::error {
namespace {

/// The largest difference that a constant bound leaves undecided. As in the hardware, it is the
/// bound rounded up to the bound's digits, plus the guard.
std::string describe_constant(const AbsoluteBoundCriterion& criterion, FloatFormat format) {
  const BoundFormat bound_format = criterion.bound.format;
  const Bits bound = encode_bound(bound_format, criterion.bound.nodes.back().constant);
  const Bits magnitude =
      (bound << (format.precision() - bound_format.precision)) + criterion.guard_ulp;
  if (magnitude >= format.infinity(false)) return "the largest number";
  return rounded_text(to_rational(format, magnitude), 4);
}

std::string describe_bound(const AbsoluteBoundCriterion& criterion, FloatFormat format) {
  const BoundGraph& bound = criterion.bound;
  if (bound.nodes.back().operation == BoundOperation::constant) {
    return describe_constant(criterion, format) + ", a constant";
  }
  if (bound.format.precision == 1) return "a running bound of only exponents";
  return fmt::format("a running bound of {} digits", bound.format.precision);
}

std::string describe(const Criterion& criterion, FloatFormat format) {
  if (const auto* interval = std::get_if<IntervalCriterion>(&criterion)) {
    return fmt::format("profiled, not certified: RE_f = {}, RE_g = {}",
                       rounded_text(interval->relative_error_f, 4),
                       rounded_text(interval->relative_error_g, 4));
  }
  if (const auto* absolute = std::get_if<AbsoluteBoundCriterion>(&criterion)) {
    return "certified: where |f - g| exceeds " + describe_bound(*absolute, format);
  }
  const Bits guard = std::get<UlpDistanceCriterion>(criterion).guard_ulp;
  if (guard == 0) return "certified: everywhere, f and g are exact";
  return fmt::format("certified: where f and g are {} ulp apart or more", guard);
}

/// Node numbers of one graph, by their numbers in another.
using Renumbering = std::vector<NodeId>;

/// Renumbers the nodes that a criterion names.
struct Renumber {
  const Renumbering& ids;

  Criterion operator()(const UlpDistanceCriterion& criterion) const { return criterion; }
  Criterion operator()(AbsoluteBoundCriterion criterion) const {
    criterion.difference = ids[criterion.difference];
    for (BoundNode& node : criterion.bound.nodes) {
      if (node.value >= 0) node.value = ids[node.value];
    }
    for (BoundCondition& condition : criterion.conditions) condition.value = ids[condition.value];
    return criterion;
  }
  Criterion operator()(IntervalCriterion criterion) const {
    criterion.minimum = ids[criterion.minimum];
    criterion.maximum = ids[criterion.maximum];
    return criterion;
  }
};

/// The nodes that a criterion names, besides f and g.
struct NodesNamed {
  std::vector<NodeId> operator()(const UlpDistanceCriterion&) const { return {}; }
  std::vector<NodeId> operator()(const AbsoluteBoundCriterion& criterion) const {
    std::vector<NodeId> nodes = {criterion.difference};
    for (const BoundNode& node : criterion.bound.nodes) {
      if (node.value >= 0) nodes.push_back(node.value);
    }
    for (const BoundCondition& condition : criterion.conditions) nodes.push_back(condition.value);
    return nodes;
  }
  std::vector<NodeId> operator()(const IntervalCriterion& criterion) const {
    return {criterion.minimum, criterion.maximum};
  }
};

TypedNode renumbered(TypedNode node, const Renumbering& ids) {
  for (int k = 0; k < arity(node.operation); ++k) node.operands[k] = ids[node.operands[k]];
  return node;
}

Hazards hazards_of_both(const Hazards& a, const Hazards& b) {
  return {.special_operand = a.special_operand || b.special_operand,
          .overflow = a.overflow || b.overflow,
          .underflow = a.underflow || b.underflow,
          .cancellation = a.cancellation || b.cancellation};
}

Hazards hazards_at(const Lane& lane, std::size_t id) {
  return lane.hazards.empty() ? Hazards{} : lane.hazards[id];
}

std::size_t add_check(std::vector<RangeCheck>& checks, const RangeCheck& check) {
  const auto known = std::find(checks.begin(), checks.end(), check);
  const auto index = static_cast<std::size_t>(known - checks.begin());
  if (known == checks.end()) checks.push_back(check);
  return index;
}

/// Adds to `whole` a lane of one part, whose first nodes are those of `ids`.
void add_part(Lane& whole, std::vector<bool>& has_hazards, const Lane& part, Renumbering ids) {
  for (std::size_t id = ids.size(); id < part.graph.nodes.size(); ++id) {
    ids.push_back(add_node(whole.graph, renumbered(part.graph.nodes[id], ids)));
  }
  has_hazards.resize(whole.graph.nodes.size(), false);
  whole.hazards.resize(whole.graph.nodes.size());
  for (std::size_t id = 0; id < ids.size(); ++id) {
    const auto node = static_cast<std::size_t>(ids[id]);
    const Hazards own = hazards_at(part, id);
    whole.hazards[node] = has_hazards[node] ? hazards_of_both(whole.hazards[node], own) : own;
    has_hazards[node] = true;
  }
  LanePart& added =
      whole.parts.emplace_back(LanePart{std::visit(Renumber{ids}, part.criterion()), {}});
  for (const RangeCheck& check : part.checks) {
    added.checks.push_back(add_check(whole.checks, check));
  }
}

}  // namespace

const Criterion& Lane::criterion() const {
  MIXCMP_CHECK(parts.size() == 1);
  return parts.front().criterion;
}

Criterion& Lane::criterion() {
  MIXCMP_CHECK(parts.size() == 1);
  return parts.front().criterion;
}

bool Lane::certified() const {
  return std::all_of(parts.begin(), parts.end(),
                     [](const LanePart& part) { return part.certified(); });
}

Lane one_part_lane(TypedGraph graph, Criterion criterion, std::vector<RangeCheck> checks) {
  MIXCMP_CHECK(graph.parts.size() == 1);
  Lane lane{std::move(graph), {{std::move(criterion)}}, std::move(checks)};
  for (std::size_t k = 0; k < lane.checks.size(); ++k) lane.parts.front().checks.push_back(k);
  return lane;
}

Result<Lane> lane_of_parts(const TypedGraph& graph, const MakePart& make_part) {
  if (graph.parts.size() == 1) return make_part(graph);
  Lane whole{graph, {}};
  std::vector<bool> has_hazards;
  for (std::size_t k = 0; k < graph.parts.size(); ++k) {
    const GraphPart part = part_of(graph, k);
    const Result<Lane> lane = make_part(part.graph);
    if (!lane.ok()) return of_part(lane.error(), k, graph.parts.size());
    add_part(whole, has_hazards, *lane, part.ids);
  }
  return whole;
}

Error of_part(Error error, std::size_t part, std::size_t parts) {
  if (parts > 1) error.message = fmt::format("of f[{0}] and g[{0}], {1}", part, error.message);
  return error;
}

std::vector<bool> nodes_of_part(const Lane& lane, std::size_t part) {
  std::vector<NodeId> roots = std::visit(NodesNamed{}, lane.parts[part].criterion);
  roots.push_back(lane.graph.parts[part].f);
  roots.push_back(lane.graph.parts[part].g);
  return needed_nodes(lane.graph, roots);
}

Lane part_of(const Lane& lane, std::size_t part) {
  if (lane.parts.size() == 1) return lane;
  GraphPart alone = part_of(lane.graph, part);
  Renumbering ids(lane.graph.nodes.size(), -1);
  for (std::size_t id = 0; id < alone.ids.size(); ++id) {
    ids[alone.ids[id]] = static_cast<NodeId>(id);
  }
  // The criterion's nodes follow those of f and g, as in the original lane.
  const std::vector<bool> needed = nodes_of_part(lane, part);
  for (std::size_t id = 0; id < needed.size(); ++id) {
    if (!needed[id] || ids[id] >= 0) continue;
    ids[id] = static_cast<NodeId>(alone.graph.nodes.size());
    alone.graph.nodes.push_back(renumbered(lane.graph.nodes[id], ids));
    alone.ids.push_back(static_cast<NodeId>(id));
  }
  std::vector<RangeCheck> checks;
  for (const std::size_t check : lane.parts[part].checks) checks.push_back(lane.checks[check]);
  Lane made =
      one_part_lane(std::move(alone.graph), std::visit(Renumber{ids}, lane.parts[part].criterion),
                    std::move(checks));
  for (const NodeId id : alone.ids) {
    made.hazards.push_back(hazards_at(lane, static_cast<std::size_t>(id)));
  }
  return made;
}

std::string describe_criterion(const Lane& lane) {
  if (lane.parts.size() == 1) return describe(lane.criterion(), lane.graph.arithmetic.format);
  std::vector<std::string> texts;
  for (const LanePart& part : lane.parts)
    texts.push_back(describe(part.criterion, lane.graph.arithmetic.format));
  const bool alike = std::all_of(texts.begin(), texts.end(),
                                 [&](const std::string& text) { return text == texts.front(); });
  std::string text = fmt::format("{} of {} parts", to_string(lane.graph.combination), texts.size());
  if (alike) return fmt::format("{}, each {}", text, texts.front());
  for (std::size_t k = 0; k < texts.size(); ++k) text += fmt::format("; part {} {}", k, texts[k]);
  return text;
}

}  // namespace mixcmp::error
