#include "generator/hardware/rtl/engine_shape.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"

namespace mixcmp::rtl {
namespace {

/// Finds the column of the items or of the rows that holds this input; adds the column if it is
/// new.
EngineShape::Source source_of(const std::string& input, const OperandFormat& format,
                              EngineShape& engine) {
  const auto of_item = data::item_column(input);
  const bool pairwise = engine.spec.kind == scene::EngineKind::pairwise;
  MIXCMP_CHECK(of_item.has_value() || !pairwise);
  std::vector<std::string>& columns = of_item ? engine.columns : engine.row_columns;
  const std::string& name = of_item ? of_item->name : input;
  const auto known = std::find(columns.begin(), columns.end(), name);
  const auto column = static_cast<std::size_t>(known - columns.begin());
  std::vector<OperandFormat>& formats = of_item ? engine.column_formats : engine.row_column_formats;
  if (known == columns.end()) {
    columns.push_back(name);
    formats.push_back(format);
  }
  if (!of_item) return {column, data::Item::row};
  return {column, of_item->second ? data::Item::second : data::Item::first};
}

}  // namespace

std::optional<EngineShape> engine_shape(const SystemShape& system,
                                        const std::vector<std::string>& inputs,
                                        const scene::EngineSpec& spec) {
  if (spec.kind == scene::EngineKind::none) return std::nullopt;
  EngineShape engine{
      .top = system.top + "_" + std::string(to_string(spec.kind)),
      .spec = spec,
      .capacity = spec.kind == scene::EngineKind::pairwise ? spec.capacity : system.lanes + 1,
      .columns = {},
      .row_columns = {},
      .sources = {},
      .column_formats = {},
      .row_column_formats = {}};
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    engine.sources.push_back(source_of(inputs[k], system.input_formats[k], engine));
  }
  return engine;
}

}  // namespace mixcmp::rtl
