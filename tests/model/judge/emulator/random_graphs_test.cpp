#include <gtest/gtest.h>

#include "tests/model/judge/emulator/random_lanes.hpp"
#include "tests/support/float_samples.hpp"

/// Tests random graphs in random formats with random decisions, checks and operands.
namespace mixcmp::test::random_graphs_test {
namespace {

class RandomLanes : public testing::TestWithParam<int> {};

TEST_P(RandomLanes, AreEmulatedBitForBit) {
  Random random(static_cast<unsigned>(GetParam()));
  for (int k = 0; k < 250 && !HasFailure(); ++k) {
    const Graph graph = random_graph(random);
    const FloatFormat reference = random_reference(random);
    const Arithmetic reduced = random_reduced(reference, random);
    const error::Lane lane =
        random_lane(lane_graph(graph, reference, reduced, random_inputs(random)), random);
    const Operands operands = random_operands(lane.graph.input_count, reference, 200, random);
    expect_golden(lane, operands);
  }
}

TEST_P(RandomLanes, SoAreReferences) {
  Random random(static_cast<unsigned>(GetParam()));
  for (int k = 0; k < 100 && !HasFailure(); ++k) {
    const Graph graph = random_graph(random);
    const FloatFormat format = random_reference(random);
    for (const Arithmetic& arithmetic : every_arithmetic(format)) {
      const TypedGraph reference = reference_graph(graph, arithmetic);
      expect_golden(reference, random_operands(reference.input_count, format, 100, random));
    }
  }
}

TEST_P(RandomLanes, SoAreThoseOfSeveralParts) {
  Random random(static_cast<unsigned>(GetParam()));
  for (int k = 0; k < 150 && !HasFailure(); ++k) {
    const Graph graph = random_graph_of_parts(random);
    const FloatFormat format = random_reference(random);
    const Arithmetic reduced = random_reduced(format, random);
    const LaneInputs inputs = random_inputs(random);
    const TypedGraph typed = lane_graph(graph, format, reduced, inputs);
    const error::Lane lane =
        error::lane_of_parts(typed, [&](const TypedGraph& part) -> Result<error::Lane> {
          return random_lane(part, random);
        }).value();
    const Operands operands =
        random_operands(static_cast<int>(graph.inputs().size()), format, 200, random);
    expect_golden_decisions(lane, operands);
    expect_golden_decisions(reference_graph(graph, {format, reduced.rounding, reduced.subnormals}),
                            operands);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomLanes, testing::Range(1, 9));

}  // namespace
}  // namespace mixcmp::test::random_graphs_test
