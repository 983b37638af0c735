#pragma once

#include "model/design/design.hpp"
#include "model/expression/graph.hpp"
#include "tests/support/graphs.hpp"

/// The paper's comparison, built without the parser.
namespace mixcmp::test {

inline model::Graph sphere_graph() {
  using model::NodeId;
  using model::Operation;
  model::Graph graph;
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

/// p_H of one kind.
inline std::vector<model::ReferenceGroup> references_of(int count) {
  if (count == 0) return {};
  return {{.count = count}};
}

/// A certified system with exact inputs.
inline model::Design sphere_design(model::FloatFormat lane, model::FloatFormat reference, int lanes,
                                   int references) {
  const model::Graph graph = sphere_graph();
  const model::Arithmetic reduced = {lane, model::Rounding::nearest_even, model::Subnormals::flush};
  const std::vector<bool> any_sign(graph.inputs().size(), false);
  model::Lane certified =
      relative_lane(model::lane_graph(graph, reference, reduced, model::LaneInputs::exact),
                    any_sign)
          .value();
  return {.name = "sphere",
          .inputs = graph.inputs(),
          .lanes = {{.lane = std::move(certified), .count = lanes}},
          .reference = model::reference_graph(graph, {reference}),
          .references = references_of(references),
          .system = {}};
}

inline model::FloatFormat format(const char* name) {
  return model::FloatFormat::parse(name).value();
}

}  // namespace mixcmp::test
