#pragma once

#include <random>

#include "model/error/lane.hpp"
#include "tests/model/emulator/against_golden.hpp"

/// Lanes of every kind, sound or not: the emulator has to say what the golden model says.
namespace mixcmp::test {

using Random = std::mt19937_64;

int below(Random& random, int end);

/// One to four inputs, every operation, constants that fit and some that do not.
model::Graph random_graph(Random& random);

/// Two to four parts over the nodes of a random graph.
model::Graph random_graph_of_parts(Random& random);

model::LaneInputs random_inputs(Random& random);
/// Up to 53 digits and 11 exponent bits.
model::FloatFormat random_reference(Random& random);
model::Arithmetic random_reduced(model::FloatFormat reference, Random& random);

/// With a decision and range checks made up.
model::Lane random_lane(model::TypedGraph graph, Random& random);
model::AbsoluteBoundDecision random_absolute_bound(model::TypedGraph& graph, Random& random);

/// Encodings of `format`, mostly of one scale.
Operands random_operands(int input_count, model::FloatFormat format, std::size_t count,
                         Random& random);

}  // namespace mixcmp::test
