#include "generator/faces/cli/new_formats.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/base/number/double.hpp"
#include "model/base/settings/limits.hpp"
#include "model/comparison/data/input_sources.hpp"
#include "model/design/design.hpp"
#include "model/plan/profile/profile.hpp"

namespace mixcmp::cli {
namespace {

bool is_integer(const OperandFormat& type) {
  return type.fixed() != nullptr;
}

}  // namespace

Numbers numbers_of(const data::Comparisons& data, std::size_t input) {
  const data::Comparisons::Source& source = data.sources()[input];
  const data::Table& table = data.tables()[source.table];
  Numbers numbers;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double value = to_double(table.format, table.at(row, source.column));
    numbers.are_whole = numbers.are_whole && std::isfinite(value) && value == std::trunc(value);
    if (!std::isfinite(value)) continue;
    numbers.low = std::min(numbers.low, value);
    numbers.high = std::max(numbers.high, value);
  }
  return numbers;
}

std::vector<OperandFormat> types_of_data(const LoadedScene& loaded) {
  std::vector<OperandFormat> types;
  if (!loaded.data) return types;
  for (const data::InputSource& input :
       data::input_sources(*loaded.data, loaded.scene.graph.inputs())) {
    if (!input.column.type) return {};
    types.push_back(*input.column.type);
  }
  return types;
}

bool are_integers(const std::vector<OperandFormat>& types) {
  return !types.empty() && std::all_of(types.begin(), types.end(), is_integer);
}

bool are_single(const std::vector<OperandFormat>& types) {
  return !types.empty() && std::all_of(types.begin(), types.end(), [](const OperandFormat& type) {
    return type.floating() != nullptr && type.floating()->precision() <= 24;
  });
}

std::optional<OperandFormat> narrowest_integers(const LoadedScene& loaded) {
  double low = 0, high = 0;
  for (std::size_t input = 0; input < loaded.scene.graph.inputs().size(); ++input) {
    const Numbers numbers = numbers_of(*loaded.data, input);
    if (!numbers.any() || !numbers.are_whole) return std::nullopt;
    low = std::min(low, numbers.low);
    high = std::max(high, numbers.high);
  }
  FixedFormat format = FixedFormat::holding(mpz_class(low), mpz_class(high), 0);
  if (format.is_signed) format.width = std::max(format.width, 2);
  if (format.width > OperandFormat::most_fixed_bits) return std::nullopt;
  return OperandFormat(format);
}

std::vector<NewFormats> integer_formats(const LoadedScene& loaded) {
  if (!loaded.data) return {};
  std::vector<NewFormats> choices;
  const std::vector<OperandFormat> types = types_of_data(loaded);
  if (are_integers(types)) {
    NewFormats& own = choices.emplace_back(NewFormats{.reference = "exact"});
    for (std::size_t k = 0; k < types.size(); ++k) {
      own.operands.emplace(loaded.scene.graph.inputs()[k], types[k].name());
    }
  }
  if (const std::optional<OperandFormat> narrowest = narrowest_integers(loaded)) {
    choices.push_back({.reference = "exact", .operands = {{"*", narrowest->name()}}});
  }
  return choices;
}

Result<Done> check_integers(const scene::Scene& scene) {
  MIXCMP_TRY(datapath, design::reference_datapath(scene));
  const settings::Limits precisions = settings::lane_precisions(scene.reference.format);
  return profile::check_profile(
      scene, {.first_precision = precisions.least, .last_precision = precisions.most});
}

bool arrive_as_integers(const scene::Scene& scene) {
  return scene.operand_formats.front().fixed() != nullptr;
}

}  // namespace mixcmp::cli
