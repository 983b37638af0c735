#include "tests/support/graphs.hpp"

#include "model/comparison/expression/parser.hpp"
#include "tests/support/function_values.hpp"

namespace mixcmp::test {

namespace {

Result<Interpolation> measured_points(const std::string& /*file*/, int degree) {
  return measured(degree).interpolation();
}

}  // namespace

Graph graph_of(const std::string& f, const std::string& g) {
  return graph_of({{f, g}}, Combination::all);
}

Graph graph_of(const std::vector<std::pair<std::string, std::string>>& parts,
               Combination combination) {
  Graph graph;
  std::vector<Sides> sides;
  for (const auto& [f, g] : parts) {
    const NodeId left = parse_expression(graph, f, {}, nullptr, {}, measured_points).value();
    const NodeId right = parse_expression(graph, g, {}, nullptr, {}, measured_points).value();
    sides.push_back({left, right});
  }
  graph.compare(std::move(sides), combination);
  return graph;
}

const error::UlpDistanceCriterion& certified_decision(const error::Lane& lane) {
  MIXCMP_CHECK(lane.certified());
  return std::get<error::UlpDistanceCriterion>(lane.criterion());
}

Result<error::Lane> relative_lane(TypedGraph graph, const std::vector<bool>& nonnegative) {
  error::CertifiedOptions options{.kind = BoundKind::relative,
                                  .hazards = error::HazardRemoval::keep};
  for (const bool input : nonnegative) {
    options.ranges.push_back(input ? std::optional(Range{0, 1}) : std::nullopt);
  }
  return certified_lane(graph, options);
}

}  // namespace mixcmp::test
