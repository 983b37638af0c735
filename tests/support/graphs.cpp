#include "tests/support/graphs.hpp"

#include "model/expression/parser.hpp"

namespace mixcmp::test {

model::Graph graph_of(const std::string& f, const std::string& g) {
  model::Graph graph;
  const model::NodeId left = parse_expression(graph, f, {}).value();
  const model::NodeId right = parse_expression(graph, g, {}).value();
  graph.compare(left, right);
  return graph;
}

const model::UlpDistanceDecision& certified_decision(const model::Lane& lane) {
  MIXCMP_CHECK(lane.certified());
  return std::get<model::UlpDistanceDecision>(lane.decision);
}

}  // namespace mixcmp::test
