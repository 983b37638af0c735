#include "tests/model/judge/emulator/hard_operands.hpp"

#include <cmath>

#include "model/base/number/exact.hpp"
#include "tests/model/judge/emulator/random_lanes.hpp"

namespace mixcmp::test {
namespace {

double unit(Random& random) {
  return 1 + static_cast<double>(random() >> 12) * 0x1p-52;
}

/// A number in [1, 2) of digits + 1 digits whose last digit is 1, so it lies half way. One in four
/// has only `digits` digits.
double half_way(int digits, Random& random) {
  const double scale = std::ldexp(1, digits - 1);
  const double significand = std::floor(unit(random) * scale);
  return (significand + (below(random, 4) == 0 ? 0 : 0.5)) / scale;
}

double tiny(int digits, Random& random) {
  const double sign = below(random, 2) == 0 ? 1 : -1;
  const double share = below(random, 2) == 0 ? 1 : unit(random);
  return sign * share * std::ldexp(1, -digits + 1 - below(random, 110));
}

Bits rounded(FloatFormat format, double value) {
  return value == 0 ? Bits{0} : from_rational(format, mpq_class(value));
}

/// Two numbers whose sum lies half way, or off it by less than 53 digits show.
std::pair<double, double> hard_sum(int digits, Random& random) {
  const double middle = half_way(digits, random);
  switch (below(random, 3)) {
    case 0: return {middle, tiny(digits, random)};
    case 1: {  // number + half a step, and a little
      const double step = std::ldexp(1, 1 - digits);
      const double number = std::floor(middle / step) * step;
      return {number, (middle - number) + tiny(digits, random) * 0x1p-20};
    }
    default: {
      const double part = std::ldexp(unit(random), below(random, 8) - 4);
      return {middle - part, part};
    }
  }
}

std::pair<double, double> hard_doubles(Operation operation, int digits, Random& random) {
  const double middle = half_way(digits, random), other = unit(random);
  switch (operation) {
    case Operation::add: return hard_sum(digits, random);
    case Operation::subtract: {
      const auto [x, y] = hard_sum(digits, random);
      return {x, -y};
    }
    case Operation::multiply: {
      const double few_digits = std::ldexp(std::floor(std::ldexp(other, 8)), -8);
      const double factor = below(random, 2) == 0 ? other : few_digits;
      return {middle / factor, factor};
    }
    case Operation::square: return {std::sqrt(middle), 0};
    case Operation::divide: return {middle * other, other};
    case Operation::square_root: return {middle * middle, 0};
    default: return {middle, below(random, 2) == 0 ? middle : other};
  }
}

}  // namespace

std::pair<Bits, Bits> hard_operands(Operation operation, FloatFormat format, int digits,
                                    Random& random) {
  auto [x, y] = hard_doubles(operation, digits, random);
  const bool negative = below(random, 2) == 0 && operation != Operation::square_root;
  const int exponent = 2 * (below(random, 5) - 2);
  x = std::ldexp(negative ? -x : x, exponent);
  if (operation == Operation::add || operation == Operation::subtract) {
    y = std::ldexp(negative ? -y : y, exponent);
  }
  // One operand in eight becomes a neighbour, so that the result is half way in double but not
  // quite half way in truth.
  Bits first = rounded(format, x);
  if (below(random, 8) == 0) ++first;
  return {first, rounded(format, y)};
}

Graph graph_of(Operation operation) {
  Graph graph;
  const NodeId a = graph.input("a");
  if (arity(operation) == 1) {
    graph.compare(graph.apply(operation, a), a);
  } else {
    const NodeId b = graph.input("b");
    graph.compare(graph.apply(operation, a, b), graph.apply(Operation::subtract, b, a));
  }
  return graph;
}

}  // namespace mixcmp::test
