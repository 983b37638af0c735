#pragma once

#include <optional>

#include "model/lane/fixed/fixed_lane.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/sphere.hpp"

/// A comparison of two operands of a byte each, so that every pair can be simulated, and lanes of
/// so few bits that they leave many pairs undecided.
namespace mixcmp::test {

inline design::LaneGroup few_bit_lanes(const Graph& graph, int bits, int count) {
  const std::optional<Range> range = Range{-6, 6};
  const fixed::FixedOptions options = {
      .format = {bits, false, 0}, .bound = {}, .ranges = {graph.inputs().size(), range}};
  return {.lane = fixed::fixed_lane(graph, format("s4e4"), options).value(), .count = count};
}

inline Graph byte_graph() {
  return graph_of({{"(a - b)^2 + b", "a * b"}}, Combination::any);
}

/// Three groups of `lanes_per_group` lanes, of two kinds.
inline design::Design byte_design(int lanes_per_group) {
  const Graph graph = byte_graph();
  design::Design design = {.name = "bytes",
                           .inputs = graph.inputs(),
                           .lanes = {few_bit_lanes(graph, 2, lanes_per_group),
                                     few_bit_lanes(graph, 4, 2 * lanes_per_group)},
                           .reference = reference_graph(graph, {format("s4e4")}),
                           .references = {},
                           .system = {}};
  design.system.lanes_per_group = lanes_per_group;
  return design;
}

inline data::Comparisons every_pair(const design::Design& design) {
  const FloatFormat format = design.reference.input_format;
  data::Table table{.format = format, .columns = {"a", "b"}, .values = {}, .labels = {}};
  for (unsigned a = 0; a < 256; ++a) {
    for (unsigned b = 0; b < 256; ++b) table.values.insert(table.values.end(), {Bits{a}, Bits{b}});
  }
  return data::Comparisons::rows(table, design.inputs).value();
}

}  // namespace mixcmp::test
