#pragma once

#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "model/base/number/exact.hpp"
#include "model/plan/profile/profile.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Scenes and data for the tests of model/plan/profile.
namespace mixcmp::test {

inline scene::Scene scene_of(Graph graph, FloatFormat reference, const Arithmetic& reduced) {
  scene::Scene scene{.graph = std::move(graph), .reference = {.format = reference}};
  scene.ranges.resize(scene.graph.inputs().size());
  scene.reduced.format = reduced.format;
  scene.reduced.rounding = reduced.rounding;
  scene.reduced.subnormals = reduced.subnormals;
  return scene;
}

/// One column an input.
inline data::Comparisons rows_of(const Graph& graph, FloatFormat format, std::vector<Bits> values) {
  data::Table table{.format = format, .columns = graph.inputs(), .values = std::move(values)};
  return data::Comparisons::rows(std::move(table), graph.inputs()).value();
}

/// Where operands come from; each is hard for the envelope in another way.
enum class Family {
  uniform,     ///< in [1, 2): nothing exceptional
  small_grid,  ///< small integers: ties, zeros, cancellation
  neighbours,  ///< one value and its neighbours: differences of a few last places
  cancelling,  ///< 3/4 and a little, of any size: differences of every magnitude
  lowest,      ///< just above the lane's smallest normal number
  wide,        ///< exponents from end to end of the lane's
  encodings,   ///< any encoding, specials among them
};
inline constexpr Family all_families[] = {
    Family::uniform, Family::small_grid, Family::neighbours, Family::cancelling,
    Family::lowest,  Family::wide,       Family::encodings};

inline Bits random_operand(Family family, FloatFormat format, FloatFormat lane,
                           std::mt19937_64& random) {
  const auto below = [&](int end) {
    return static_cast<int>(random() % static_cast<unsigned>(end));
  };
  const int fraction_bits = format.fraction_bits();
  const Bits fraction = random() & low_mask(fraction_bits);
  const Bits one = format.pack(false, format.bias(), 0);
  switch (family) {
    case Family::uniform: return one | fraction;
    case Family::small_grid: return from_rational(format, mpq_class(below(9) - 2, 4));
    case Family::neighbours: return one + Bits(below(40)) * (below(4) == 0 ? 1 : 1000);
    case Family::cancelling: {
      const Bits three_quarters =
          format.pack(false, format.bias() - 1, Bits{1} << (fraction_bits - 1));
      return three_quarters + ((fraction >> 1) >> below(fraction_bits));
    }
    case Family::lowest: {
      const int biased = lane.min_exponent() + below(4) + format.bias();
      return format.pack(false, biased, fraction);
    }
    case Family::wide: {
      const int exponent =
          lane.min_exponent() - 3 + below(lane.max_exponent() - lane.min_exponent());
      const int biased = std::clamp(exponent + format.bias(), 0, format.max_biased_exponent() - 1);
      return format.pack(below(4) == 0, biased, below(2) == 0 ? fraction : 0);
    }
    case Family::encodings:
      return below(5) == 0 ? special_encodings(format)[random() % special_encodings(format).size()]
                           : random_encoding_near(format, one, random);
  }
  return one;
}

inline data::Comparisons random_rows(const scene::Scene& scene, Family family, std::size_t count,
                                     std::mt19937_64& random) {
  std::vector<Bits> values;
  for (std::size_t k = 0; k < count * scene.graph.inputs().size(); ++k) {
    values.push_back(random_operand(family, scene.reference.format, *scene.reduced.format, random));
  }
  return rows_of(scene.graph, scene.reference.format, std::move(values));
}

inline const std::vector<std::pair<std::string, std::string>> expressions = {
    {"(a - b)^2 + (c - d)^2", "(a + d)^2"},
    {"a * b", "c + d"},
    {"a - b", "c - d"},
    {"(a - b) * (c - d)", "a * d - b * c"},
    {"a / b", "c / d"},
    {"a / (b - c)", "d"},
    {"sqrt(a * b)", "sqrt(c) + d"},
    {"sqrt(a - b)", "c"},
    {"min(a, b) + 0.1", "max(c, d) * 0.7"},
    {"abs(a - b)", "abs(c) + 0"},
    {"min(a - b, c)", "max(a * c, -d)"},
    {"a", "b"},
    {"a", "0"},
    {"-a * 3", "b^2 - 0.5"},
    {"((a - b)^2)^2", "((c - d)^2)^2 + 1"},
    {"((a - b) + (c - d))^2", "1 / 1024"},
    {"within(a - b, -1, 1)^2", "within(c, 0.5, 2)"},
};

}  // namespace mixcmp::test
