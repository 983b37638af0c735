#pragma once

#include <random>

#include "model/lane/error/lane.hpp"
#include "tests/model/judge/emulator/against_golden.hpp"

/// Random lanes of every kind, sound or not. The emulator must agree with the golden model on all.
namespace mixcmp::test {

using Random = std::mt19937_64;

int below(Random& random, int end);

/// A graph with one to four inputs, every operation, constants that fit and some that do not.
Graph random_graph(Random& random);

/// A graph with two to four parts over the nodes of a random graph.
Graph random_graph_of_parts(Random& random);

LaneInputs random_inputs(Random& random);
/// A format of up to 53 digits and 11 exponent bits.
FloatFormat random_reference(Random& random);
Arithmetic random_reduced(FloatFormat reference, Random& random);

/// A lane with a made-up criterion and made-up range checks.
error::Lane random_lane(TypedGraph graph, Random& random);
error::AbsoluteBoundCriterion random_absolute_bound(TypedGraph& graph, Random& random);

/// Encodings of `format`, mostly of one scale.
Operands random_operands(int input_count, FloatFormat format, std::size_t count, Random& random);

}  // namespace mixcmp::test
