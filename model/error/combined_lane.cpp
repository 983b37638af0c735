#include "model/error/combined_lane.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/common/check.hpp"
#include "model/error/profiled_lane.hpp"

namespace mixcmp::error {
namespace {

Hazards either(const Hazards& a, const Hazards& b) {
  return {.special_operand = a.special_operand || b.special_operand,
          .overflow = a.overflow || b.overflow,
          .underflow = a.underflow || b.underflow,
          .cancellation = a.cancellation || b.cancellation};
}

/// Adds a part's hazards to those of the shared nodes. A shared node keeps a hazard unless every
/// part that uses it rules that hazard out.
void add_hazards(std::vector<Hazards>& all, const Lane& part, const std::vector<NodeId>& ids) {
  MIXCMP_CHECK(part.hazards.empty() || part.hazards.size() == ids.size());
  for (std::size_t id = 0; id < ids.size(); ++id) {
    const auto node = static_cast<std::size_t>(ids[id]);
    const Hazards hazards = part.hazards.empty() ? Hazards{} : part.hazards[id];
    if (node >= all.size()) {
      MIXCMP_CHECK(node == all.size());
      all.push_back(hazards);
    } else {
      all[node] = either(all[node], hazards);
    }
  }
}

std::vector<std::size_t> add_checks(std::vector<RangeCheck>& all, const Lane& part) {
  std::vector<std::size_t> indices;
  for (const RangeCheck& check : part.checks) {
    const auto known = std::find(all.begin(), all.end(), check);
    indices.push_back(static_cast<std::size_t>(known - all.begin()));
    if (known == all.end()) all.push_back(check);
  }
  return indices;
}

/// Renumbers the nodes that a decision names.
struct Renumber {
  const std::vector<NodeId>& ids;

  LaneDecision operator()(const UlpDistanceDecision& decision) const { return decision; }
  LaneDecision operator()(AbsoluteBoundDecision decision) const {
    decision.difference = ids[decision.difference];
    for (BoundNode& node : decision.bound.nodes) {
      if (node.value >= 0) node.value = ids[node.value];
    }
    for (BoundCondition& condition : decision.conditions) condition.value = ids[condition.value];
    return decision;
  }
  LaneDecision operator()(IntervalDecision decision) const {
    decision.minimum = ids[decision.minimum];
    decision.maximum = ids[decision.maximum];
    return decision;
  }
};

CombinedGraph graphs_of(const CombinedLane& lane) {
  std::vector<TypedGraph> graphs;
  for (const Lane& part : lane.parts) graphs.push_back(part.graph);
  return {lane.combination, std::move(graphs)};
}

}  // namespace

CombinedLane::CombinedLane(Combination combined, std::vector<Lane> lanes)
    : combination(combined), parts(std::move(lanes)) {
  MIXCMP_CHECK(!parts.empty());
}

bool CombinedLane::certified() const {
  return std::all_of(parts.begin(), parts.end(), [](const Lane& part) { return part.certified(); });
}

Error of_part(Error error, std::size_t part, std::size_t parts) {
  if (parts > 1) error.message = fmt::format("of f[{0}] and g[{0}], {1}", part, error.message);
  return error;
}

Result<CombinedLane> certified_lanes(const CombinedGraph& graph, const CertifiedOptions& options) {
  std::vector<Lane> parts;
  for (std::size_t k = 0; k < graph.parts.size(); ++k) {
    Result<Lane> part = certified_lane(graph.parts[k], options);
    if (!part.ok()) return of_part(part.error(), k, graph.parts.size());
    parts.push_back(std::move(part).value());
  }
  return CombinedLane(graph.combination, std::move(parts));
}

CombinedLane profiled_lanes(const CombinedGraph& graph, const mpq_class& relative_error_f,
                            const mpq_class& relative_error_g) {
  std::vector<Lane> parts;
  for (const TypedGraph& part : graph.parts) {
    parts.push_back(profiled_lane(part, relative_error_f, relative_error_g));
  }
  return {graph.combination, std::move(parts)};
}

std::vector<CandidateLanes> candidate_lanes(const CombinedGraph& graph,
                                            const std::vector<std::optional<Range>>& ranges) {
  std::vector<CandidateLanes> candidates;
  const auto add = [&](ErrorBoundKind kind, int digits) {
    const CertifiedOptions options{
        .kind = kind, .bound_digits = std::max(digits, 1), .ranges = ranges};
    candidates.push_back({kind, digits, certified_lanes(graph, options)});
  };
  add(ErrorBoundKind::relative, 0);
  add(ErrorBoundKind::running, 4);
  add(ErrorBoundKind::running, 1);
  add(ErrorBoundKind::constant, 0);
  return candidates;
}

std::string describe_decision(const CombinedLane& lane) {
  if (lane.parts.size() == 1) return describe_decision(lane.parts.front());
  std::vector<std::string> texts;
  for (const Lane& part : lane.parts) texts.push_back(describe_decision(part));
  const bool alike = std::all_of(texts.begin(), texts.end(),
                                 [&](const std::string& text) { return text == texts.front(); });
  std::string text = fmt::format("{} of {} parts", to_string(lane.combination), texts.size());
  if (alike) return fmt::format("{}, each {}", text, texts.front());
  for (std::size_t k = 0; k < texts.size(); ++k) text += fmt::format("; part {} {}", k, texts[k]);
  return text;
}

SharedLane share(const CombinedLane& lane) {
  SharedGraph all = share(graphs_of(lane));
  SharedLane shared{.graph = std::move(all.graph), .combination = lane.combination};
  for (std::size_t k = 0; k < lane.parts.size(); ++k) {
    const Lane& part = lane.parts[k];
    add_hazards(shared.hazards, part, all.ids[k]);
    shared.parts.push_back({.sides = all.sides[k],
                            .decision = std::visit(Renumber{all.ids[k]}, part.decision),
                            .checks = add_checks(shared.checks, part)});
  }
  return shared;
}

}  // namespace mixcmp::error
