#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/base/number/decimal.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/lane/fixed/fixed_lane.hpp"
#include "tests/support/float_samples.hpp"

namespace mixcmp::test {

inline constexpr const char* spheres = "(cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2";

/// The lane of a graph whose inputs all have one range and arrive as doubles of 8 exponent bits.
inline fixed::FixedLane lane_of(const Graph& graph, int bits, const Range& range,
                                std::optional<BoundKind> bound = {}) {
  const std::vector<std::optional<Range>> ranges(graph.inputs().size(), range);
  return fixed::fixed_lane(graph, format_of(53, 8),
                           {.format = {bits}, .bound = bound, .ranges = ranges})
      .value();
}

/// [node]: its operation and format, "subtract sfix14_En6".
inline std::vector<std::string> formats_of(const fixed::FixedLane& lane) {
  std::vector<std::string> names;
  for (const fixed::FixedNode& node : lane.nodes) {
    names.push_back(std::string(to_string(node.operation)) + " " + node.format.name());
  }
  return names;
}

/// [node]: its integer, as the golden model computes it from operands in decimal or hexadecimal.
inline std::vector<std::optional<mpz_class>> integers_of(const fixed::FixedLane& lane,
                                                         const std::vector<const char*>& operands) {
  std::vector<Bits> inputs;
  for (const char* operand : operands) {
    inputs.push_back(from_text(lane.input_format, operand).value());
  }
  return golden::evaluate(lane, inputs);
}

}  // namespace mixcmp::test
