#include "model/scene/fixed_operands.hpp"

#include <fmt/core.h>

#include <map>
#include <utility>

#include "model/base/common/quote.hpp"
#include "model/base/settings/section.hpp"
#include "model/comparison/data/pairing.hpp"
#include "model/scene/reference_model.hpp"

namespace mixcmp::scene {
namespace {

/// Refuses a reference format that rounds some operand of an input.
Result<Done> check_reference_format(const settings::Settings& settings,
                                    const std::vector<std::string>& inputs,
                                    std::span<const OperandFormat> formats, FloatFormat reference) {
  for (std::size_t k = 0; k < formats.size(); ++k) {
    if (formats[k].is_held_by(reference)) continue;
    const bool may_be_exact = formats[k].fixed() != nullptr;
    return settings::Section(settings, "reference")
        .mistake(
            "format",
            fmt::format("it does not hold every number of {} in {}", inputs[k], formats[k].name()),
            reference.name(),
            fmt::format("{}a format with more digits or exponent bits",
                        may_be_exact ? "\"exact\", or " : ""));
  }
  return Done{};
}

/// Refuses two formats for one column of the data, unless both are in fixed point: the column's
/// numbers are rounded to one format.
Result<Done> check_data(const settings::Settings& settings, const std::vector<std::string>& inputs,
                        std::span<const OperandFormat> formats, const data::DataSpec& data) {
  std::map<std::pair<std::size_t, std::string>, std::size_t> known;
  for (std::size_t k = 0; k < formats.size(); ++k) {
    const auto column = data::input_column(data.pairing, inputs[k]);
    if (!column.ok()) continue;  // load_tables reports it
    const std::size_t first =
        known.emplace(std::pair(column->table, column->name), k).first->second;
    const OperandFormat &one = formats[first], &other = formats[k];
    if (one == other || (one.fixed() != nullptr && other.fixed() != nullptr)) continue;
    return settings::Section(settings, "data")
        .mistake("pairs",
                 fmt::format("{} and {} are the same column of the data, in two formats",
                             inputs[first], inputs[k]),
                 fmt::format("{} and {}", one.name(), other.name()),
                 "one format for both, or rows that have a column for each");
  }
  return Done{};
}

/// Refuses lanes in floating point that cannot be.
Result<Done> check_lanes(const settings::Settings& settings, const Scene& scene) {
  const std::optional<std::string> message = scene.why_no_float_lane();
  if (!message) return Done{};
  const std::string accepted = "\"exact\", \"auto\", or qW such as q13";
  for (const LaneGroupSpec& group : scene.lane_groups()) {
    if (!group.reduced.format) continue;
    const std::string received = in_quotes(group.reduced.format_name());
    if (scene.lanes.empty()) {
      return settings::Section(settings, "reduced").mistake("format", *message, received, accepted);
    }
    return Error{.file = group.place.file,
                 .line = group.place.line,
                 .field = "lanes.format",
                 .message = *message,
                 .received = received,
                 .accepted = accepted};
  }
  return Done{};
}

/// Refuses folded references and fused sums.
Result<Done> check_references(const settings::Settings& settings, const Scene& scene) {
  const settings::Section section(settings, "reference");
  if (scene.reference.sums == Sums::fused) {
    return section.mistake("sums", "a reference in fixed point fuses no sums", "\"fused\"",
                           "\"composed\"");
  }
  for (const ReferenceGroupSpec& group : scene.reference_groups()) {
    const int interval = group.structure.initiation_interval.value_or(1);
    if (interval == 1) continue;
    return section.mistake("initiation_interval",
                           "a reference in fixed point takes a comparison in every cycle",
                           fmt::format("{}", interval), "1");
  }
  return Done{};
}

/// Checks the columns of an engine's items.
Result<Done> check_columns(const settings::Settings& settings, const Scene& scene) {
  std::map<std::string, std::size_t> known;
  for (std::size_t k = 0; k < scene.operand_formats.size(); ++k) {
    const std::vector<std::string>& inputs = scene.graph.inputs();
    const auto column = data::item_column(inputs[k]);
    if (!column) continue;
    const std::size_t first = known.emplace(column->name, k).first->second;
    const OperandFormat &one = scene.operand_formats[first], &other = scene.operand_formats[k];
    if (one == other) continue;
    return settings::Section(settings, "engine")
        .mistake("kind",
                 fmt::format("{} and {} are the same column of an engine's items, in two formats",
                             inputs[first], inputs[k]),
                 fmt::format("{} and {}", one.name(), other.name()),
                 "one format for both, or engine.kind = \"none\"");
  }
  return Done{};
}

}  // namespace

Result<Done> check_operand_formats(const settings::Settings& settings,
                                   const std::vector<std::string>& inputs,
                                   std::span<const OperandFormat> formats, FloatFormat reference,
                                   const std::optional<data::DataSpec>& data) {
  MIXCMP_DO(check_reference_format(settings, inputs, formats, reference));
  return data ? check_data(settings, inputs, formats, *data) : Done{};
}

Result<Done> check_fixed_operands(const settings::Settings& settings, const Scene& scene) {
  MIXCMP_DO(check_lanes(settings, scene));
  if (scene.has_fixed_references()) MIXCMP_DO(check_references(settings, scene));
  MIXCMP_DO(check_reference_model(settings, scene));
  if (scene.system.engine.kind == EngineKind::none) return Done{};
  return check_columns(settings, scene);
}

}  // namespace mixcmp::scene
