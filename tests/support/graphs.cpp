#include "tests/support/graphs.hpp"

#include "model/expression/parser.hpp"

namespace mixcmp::test {

model::Graph graph_of(const std::string& f, const std::string& g) {
  return graph_of({{f, g}}, model::Combination::all);
}

model::Graph graph_of(const std::vector<std::pair<std::string, std::string>>& parts,
                      model::Combination combination) {
  model::Graph graph;
  std::vector<model::Sides> sides;
  for (const auto& [f, g] : parts) {
    const model::NodeId left = parse_expression(graph, f, {}).value();
    const model::NodeId right = parse_expression(graph, g, {}).value();
    sides.push_back({left, right});
  }
  graph.compare(std::move(sides), combination);
  return graph;
}

const model::UlpDistanceDecision& certified_decision(const model::Lane& lane) {
  MIXCMP_CHECK(lane.certified());
  return std::get<model::UlpDistanceDecision>(lane.decision);
}

model::Result<model::Lane> relative_lane(model::TypedGraph graph,
                                         const std::vector<bool>& nonnegative) {
  model::CertifiedOptions options{.kind = model::ErrorBoundKind::relative,
                                  .hazards = model::HazardRemoval::keep};
  for (const bool input : nonnegative) {
    options.ranges.push_back(input ? std::optional(model::Range{0, 1}) : std::nullopt);
  }
  return certified_lane(std::move(graph), options);
}

}  // namespace mixcmp::test
