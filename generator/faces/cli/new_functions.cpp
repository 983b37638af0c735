#include "generator/faces/cli/new_functions.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <variant>

#include "model/base/number/dyadic.hpp"
#include "model/design/design.hpp"

namespace mixcmp::cli {
namespace {

constexpr std::array reference_bits = {24, 28, 32, 36};

/// The error of references below which no more bits are taken, relative to f or g.
constexpr int enough_exponent = -24;

/// The scene with the ranges that its file will have.
scene::Scene with_ranges(const LoadedScene& loaded) {
  scene::Scene scene = loaded.scene;
  for (std::size_t k = 0; k < scene.ranges.size(); ++k) {
    scene.ranges[k] = assumed_range();
    if (!loaded.data) continue;
    const Numbers numbers = numbers_of(*loaded.data, k);
    if (numbers.any()) scene.ranges[k] = Range{numbers.low, numbers.high};
  }
  return scene;
}

mpq_class most_of(const Range& range) {
  return absolute(range).high;
}

/// Whether f - g errs by little, beside the larger of f and g.
bool is_enough(const fixed::FixedLane& lane) {
  return std::all_of(lane.parts.begin(), lane.parts.end(), [&](const fixed::FixedPart& part) {
    const fixed::FixedNode& difference = lane.nodes[part.difference];
    mpq_class most = most_of(difference.value);
    if (difference.operation == Operation::subtract) {
      most = std::max<mpq_class>(most_of(lane.nodes[difference.operands[0]].value),
                                 most_of(lane.nodes[difference.operands[1]].value));
    }
    return most_of(difference.error) <= scaled(most, enough_exponent);
  });
}

}  // namespace

Range assumed_range() {
  return {mpq_class(1, 16), 1};
}

std::map<std::string, std::string> function_operands(const LoadedScene& loaded) {
  const std::vector<OperandFormat> types = types_of_data(loaded);
  if (types.empty()) {
    const bool keeps_all = !loaded.data || data::lost_numbers_of(*loaded.data).count == 0;
    return {{"*", keeps_all ? "binary32" : "binary64"}};
  }
  std::map<std::string, std::string> operands;
  for (std::size_t k = 0; k < types.size(); ++k) {
    operands.emplace(loaded.scene.graph.inputs()[k], types[k].name());
  }
  return operands;
}

Result<std::string> function_reference(const LoadedScene& loaded) {
  scene::Scene scene = with_ranges(loaded);
  std::optional<std::string> most;
  std::optional<Error> error;
  for (const int bits : reference_bits) {
    scene.reference_fixed_point = FixedPoint{.bits = bits};
    const auto datapath = design::reference_datapath(scene);
    if (!datapath.ok()) {
      if (!error) error = datapath.error();
      continue;
    }
    most = scene.reference_fixed_point->name();
    if (is_enough(std::get<fixed::FixedLane>(*datapath))) break;
  }
  if (!most) return *error;
  return *most;
}

}  // namespace mixcmp::cli
