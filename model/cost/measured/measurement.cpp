#include "model/cost/measured/measurement.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "model/base/common/check.hpp"

namespace mixcmp::measured {

std::string_view to_string(ClockSource source) {
  switch (source) {
    case ClockSource::estimate_before_routing: return "estimate_before_routing";
    case ClockSource::routed: return "routed";
  }
  MIXCMP_CHECK(false);
}

std::string_view to_string(AreaStage stage) {
  switch (stage) {
    case AreaStage::predicted: return "predicted";
    case AreaStage::mapped: return "mapped";
    case AreaStage::synthesised: return "synthesised";
    case AreaStage::placed: return "placed";
    case AreaStage::routed: return "placed_and_routed";
  }
  MIXCMP_CHECK(false);
}

const Measurement* Characterisation::find(const ComponentKey& key) const {
  const auto row = std::lower_bound(rows.begin(), rows.end(), key,
                                    [](const Measurement& measured, const ComponentKey& wanted) {
                                      return measured.key < wanted;
                                    });
  return row != rows.end() && row->key == key ? &*row : nullptr;
}

const Measurement* Characterisation::find_datapath(const ComponentKey& key) const {
  const Measurement* row = find(key);
  return row == nullptr ? find(without_multipliers(key)) : row;
}

namespace {

std::string pairwise_text(const scene::Scene& scene) {
  const scene::EngineSpec& engine = scene.system.engine;
  std::string text = fmt::format(
      "pairwise, {} items, segments of {}, {} as {} by {} stream{}", engine.capacity,
      engine.lanes_per_group, fmt::join(reported_verdicts(engine), " "),
      to_string(engine.report_as), engine.report_streams, engine.report_streams == 1 ? "" : "s");
  if (scene.second_tier) {
    text += fmt::format(", second tier {} {}", scene.second_tier->format_name(),
                        to_string(scene.second_tier->multipliers));
  }
  return text;
}

}  // namespace

std::string engine_text(const scene::Scene& scene) {
  const scene::EngineSpec& engine = scene.system.engine;
  switch (engine.kind) {
    case scene::EngineKind::none: return "";
    case scene::EngineKind::pairwise: return pairwise_text(scene);
    case scene::EngineKind::arg_min:
      return fmt::format("arg_min, {} candidates, row tags of {} bit{}",
                         scene.lane_count().value_or(0) + 1, engine.row_tag_bits,
                         engine.row_tag_bits == 1 ? "" : "s");
  }
  MIXCMP_CHECK(false);
}

Result<Done> check_groups(const Characterisation& table, const std::filesystem::path& path,
                          const scene::Scene& scene) {
  const std::string wanted = std::to_string(scene.system.lanes_per_group);
  std::string measured = "1";
  for (const auto& [name, text] : table.spec) {
    if (name == "lanes_per_group") measured = text;
  }
  if (measured == wanted) return Done{};
  return Error{.file = path.string(),
               .field = "lanes_per_group",
               .message = "its scoreboards are around groups of other sizes",
               .received = measured,
               .accepted = fmt::format("{}, as the scene says, or another path", wanted)};
}

}  // namespace mixcmp::measured
