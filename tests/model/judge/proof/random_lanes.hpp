#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>

#include "tests/model/judge/proof/proof_support.hpp"

namespace mixcmp::test {

/// A random expression over inputs a, b, c and a few constants, with every operation.
inline NodeId random_expression(Graph& graph, std::mt19937_64& random, int depth) {
  static constexpr std::array operations = {
      Operation::add,    Operation::subtract,    Operation::multiply, Operation::square,
      Operation::divide, Operation::square_root, Operation::minimum,  Operation::maximum,
      Operation::negate, Operation::absolute};
  static const std::array<mpq_class, 5> constants = {2, mpq_class(1, 10), 3, mpq_class(-7, 3), 0};
  const auto below = [&](std::size_t end) { return random() % end; };
  if (depth == 0 || below(8) == 0) {
    if (below(5) == 0) return graph.constant(constants[below(constants.size())]);
    return graph.input(std::string(1, static_cast<char>('a' + below(3))));
  }
  const Operation operation = operations[below(operations.size())];
  const NodeId first = random_expression(graph, random, depth - 1);
  if (arity(operation) == 1) return graph.apply(operation, first);
  return graph.apply(operation, first, random_expression(graph, random, depth - 1));
}

inline Graph random_comparison(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Graph graph;
  const NodeId f = random_expression(graph, random, 3);
  graph.compare(f, random_expression(graph, random, 3));
  return graph;
}

inline LaneOptions random_options(std::uint64_t seed) {
  static constexpr std::array formats = {"s4e8", "s8e8", "s11e5", "s17e8", "s24e8", "s52e11"};
  static constexpr std::array any_of_inputs = {LaneInputs::exact, LaneInputs::rounded,
                                               LaneInputs::of_digits(20)};
  std::mt19937_64 random(seed ^ 0x9e3779b97f4a7c15u);
  return {.format = formats[random() % formats.size()],
          .rounding = random() % 2 == 0 ? Rounding::nearest_even : Rounding::toward_zero,
          .inputs = any_of_inputs[random() % any_of_inputs.size()]};
}

}  // namespace mixcmp::test
