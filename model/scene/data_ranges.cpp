#include "model/scene/data_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/base/number/exact.hpp"
#include "model/base/settings/section.hpp"
#include "model/comparison/data/load_tables.hpp"

namespace mixcmp::scene {
namespace {

/// Whether the number a is less than b; neither is a NaN.
bool less(FloatFormat format, Bits a, Bits b) {
  if (format.sign(a) != format.sign(b)) return format.sign(a);
  return format.sign(a) ? format.magnitude(a) > format.magnitude(b) : a < b;
}

/// The least and the greatest finite number of a column; none if it has no such number.
std::optional<Range> range_of(const data::Table& table, std::size_t column) {
  std::vector<Bits> numbers;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Bits bits = table.at(row, column);
    if (!table.format.is_nan(bits) && !table.format.is_infinite(bits)) numbers.push_back(bits);
  }
  if (numbers.empty()) return std::nullopt;
  const auto [low, high] = std::minmax_element(
      numbers.begin(), numbers.end(), [&](Bits a, Bits b) { return less(table.format, a, b); });
  return Range{to_rational(table.format, *low), to_rational(table.format, *high)};
}

std::optional<Range> range_of(const std::vector<data::Table>& tables,
                              const data::InputColumn& wanted) {
  const data::Table& table = tables[wanted.table];
  const auto column = std::find(table.columns.begin(), table.columns.end(), wanted.name);
  return range_of(table, static_cast<std::size_t>(column - table.columns.begin()));
}

Error mistake_in(const settings::Setting& entry, std::string message) {
  return settings::mistake_at(entry, fmt::format("inputs.{}.range", entry.key), std::move(message),
                              "\"data\"", "[low, high], low <= high");
}

}  // namespace

Result<Done> take_ranges_from_data(const data::DataSpec* data,
                                   const std::vector<std::string>& inputs, FloatFormat format,
                                   std::span<const OperandFormat> arriving,
                                   InputDeclarations& declared) {
  const auto is_asked = [](const settings::Setting* entry) { return entry != nullptr; };
  const auto first = std::find_if(declared.from_data.begin(), declared.from_data.end(), is_asked);
  if (first == declared.from_data.end()) return Done{};
  if (data == nullptr) return mistake_in(**first, "the scene has no [data] to take it from");
  MIXCMP_TRY(tables, data::load_tables(*data, inputs, format, arriving));
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    if (declared.from_data[k] == nullptr) continue;
    MIXCMP_TRY(column, data::input_column(data->pairing, inputs[k]));
    declared.ranges[k] = range_of(tables, column);
    if (declared.ranges[k]) continue;
    return mistake_in(*declared.from_data[k],
                      fmt::format("the data have no finite number for {}", inputs[k]));
  }
  return Done{};
}

Result<Done> draw_from_ranges(const settings::Settings& settings,
                              const std::vector<std::string>& inputs,
                              const InputDeclarations& declared, data::DataSpec& data) {
  if (data.items != "uniform") return Done{};
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const std::optional<Range>& range = declared.ranges[k];
    if (!range) {
      return settings::Section(settings, "data")
          .mistake("items", fmt::format("the input {} has no range to draw from", inputs[k]),
                   "\"uniform\"",
                   fmt::format("{} = {{ range = [low, high] }} in [inputs], or data from a file",
                               inputs[k]));
    }
    data.numbers.push_back({range->low, range->high, declared.grids[k]});
  }
  return Done{};
}

}  // namespace mixcmp::scene
