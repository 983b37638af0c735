#pragma once

#include "model/comparison/expression/graph.hpp"
#include "model/design/design.hpp"
#include "tests/support/graphs.hpp"

/// The paper's comparison, built without the parser.
namespace mixcmp::test {

inline Graph sphere_graph() {
  Graph graph;
  NodeId f = -1;
  for (const char* axis : {"cx", "cy", "cz"}) {
    const NodeId i = graph.input(std::string(axis) + "i");
    const NodeId j = graph.input(std::string(axis) + "j");
    const NodeId square = graph.apply(Operation::square, graph.apply(Operation::subtract, i, j));
    f = f < 0 ? square : graph.apply(Operation::add, f, square);
  }
  const NodeId ri = graph.input("ri");
  const NodeId rj = graph.input("rj");
  const NodeId radii = graph.apply(Operation::add, ri, rj);
  graph.compare(f, graph.apply(Operation::square, radii));
  return graph;
}

/// `count` references of one kind.
inline std::vector<design::ReferenceGroup> references_of(int count) {
  if (count == 0) return {};
  return {{.count = count}};
}

/// A certified system with exact inputs.
inline design::Design sphere_design(FloatFormat lane, FloatFormat reference, int lanes,
                                    int references) {
  const Graph graph = sphere_graph();
  const Arithmetic reduced = {lane, Rounding::nearest_even, Subnormals::flush};
  const std::vector<bool> any_sign(graph.inputs().size(), false);
  error::Lane certified =
      relative_lane(lane_graph(graph, reference, reduced, LaneInputs::exact), any_sign).value();
  return {.name = "sphere",
          .inputs = graph.inputs(),
          .lanes = {{.lane = std::move(certified), .count = lanes}},
          .reference = reference_graph(graph, {reference}),
          .references = references_of(references),
          .system = {}};
}

inline FloatFormat format(const char* name) {
  return FloatFormat::parse(name).value();
}

/// The lane in fixed point for operands in [0, 100].
inline fixed::FixedLane fixed_spheres(FixedPoint point, FloatFormat reference) {
  const std::vector<std::optional<Range>> ranges(8, Range{0, 100});
  return fixed::fixed_lane(sphere_graph(), reference, {.format = point, .ranges = ranges}).value();
}

}  // namespace mixcmp::test
