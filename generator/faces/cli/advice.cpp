#include "generator/faces/cli/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "model/scene/lane_bound.hpp"

namespace mixcmp::cli {
namespace {

using components::LaneEstimate;

constexpr const char* basis =
    "recomputation rates counted on these data; areas of the rough model, LUTs and embedded "
    "multipliers before synthesis, without clocks";
/// How many kinds of lanes the text lists.
constexpr std::size_t most_listed = 4;

/// The lanes that a plan of the scene may use and that have rates.
components::ComponentQuery query_of(const scene::Scene& scene,
                                    const std::vector<profile::RateProfile>& rates) {
  components::ComponentQuery query;
  query.inputs.clear();
  const profile::SchemeKind wanted =
      scene.reduced.is_profiled ? profile::SchemeKind::profiled : profile::SchemeKind::certified;
  std::set<Bound> bounds;
  std::set<int> precisions;
  for (const profile::RateProfile& each : rates) {
    query.inputs.push_back(each.inputs);
    for (const profile::SchemeProfile& scheme : each.schemes) {
      if (scheme.kind != wanted || !scheme.bound) continue;
      bounds.insert(*scheme.bound);
      for (std::size_t k = 0; k < scheme.counts.size(); ++k) {
        if (scheme.counts[k].exists) precisions.insert(each.first_precision + static_cast<int>(k));
      }
    }
  }
  query.bounds = {bounds.begin(), bounds.end()};
  query.precisions = {precisions.begin(), precisions.end()};
  return query;
}

std::string kind_of(const LaneEstimate& lane) {
  std::string text = to_string(lane.key.bound);
  if (lane.key.inputs) text += " " + to_string(lane.key.inputs);
  const std::string multipliers(to_string(lane.key.multipliers));
  return multipliers.empty() ? text : text + ", multipliers " + multipliers;
}

/// `mixcmp VERB SCENE` with those of the settings that the advised lane does not replace.
CommandLine command_of(const std::string& verb, const SceneOptions& options,
                       const std::map<std::string, std::string>& replaced) {
  std::vector<std::string> settings = options.settings;
  std::erase_if(settings, [&](const std::string& setting) {
    return replaced.contains(setting.substr(0, setting.find('=')));
  });
  for (const auto& [key, value] : replaced) {
    if (!value.empty()) settings.push_back(key + "=" + value);
  }
  return {verb, options.scene, settings};
}

/// The keys that make lanes of this kind; an empty value: the key keeps its default.
std::map<std::string, std::string> keys_for(const LaneEstimate& lane, const scene::Scene& scene) {
  const scene::ReducedSpec reduced = scene::with_bound({}, lane.key.bound);
  const bool digits = lane.key.bound.kind == BoundKind::running && !lane.key.bound.is_fixed_point();
  return {
      {"reduced.format", lane.key.format.name()},
      {"reduced.inputs", to_string(lane.key.inputs)},
      {"reduced.bound", std::string(reduced.bound_word())},
      {"reduced.error_bound", reduced.is_profiled ? "" : std::string(reduced.error_bound_word())},
      {"reduced.bound_digits", digits ? std::to_string(reduced.bound_digits) : ""},
      {"reduced.multipliers", std::string(to_string(lane.key.multipliers))},
      {"system.lanes", "4"},
      // If all operands arrive in fixed point, the default follows from the lane.
      {"system.references", scene.has_only_fixed_operands() ? "" : "1"}};
}

/// The command that verifies a small system of such lanes; empty where the scene itself says of
/// which lanes a system consists.
std::string verify_command(const LaneEstimate& lane, const SceneOptions& options,
                           const LoadedScene& loaded) {
  const scene::Scene& scene = loaded.scene;
  const bool fixed_system = !scene.lanes.empty() || !scene.references.empty() ||
                            scene.system.engine.kind == scene::EngineKind::arg_min;
  if (fixed_system) return "";
  CommandLine line = command_of("verify", options, keys_for(lane, scene));
  constexpr std::uint64_t enough = 100'000;
  const bool selects =
      scene.system.engine.kind == scene::EngineKind::none && loaded.data->size() > enough;
  if (selects) line.add("--first", std::to_string(enough));
  return line.text();
}

nlohmann::ordered_json to_json(const LaneEstimate& lane) {
  return {{"format", lane.key.format.name()},
          {"precision", lane.precision},
          {"bound", to_string(lane.key.bound)},
          {"inputs", to_string(lane.key.inputs)},
          {"multipliers", to_string(lane.key.multipliers)},
          {"recomputation_rate", lane.rate},
          {"lane_luts", lane.area.luts},
          {"lane_dsps", lane.area.dsps},
          {"device_share", lane.share}};
}

}  // namespace

Result<Advice> advise(const SceneOptions& options, const LoadedScene& loaded,
                      const std::vector<profile::RateProfile>& rates) {
  MIXCMP_TRY(device, devices::find_device(loaded.scene.system.device));
  components::ComponentMaker maker(loaded.scene.with_one_kind(),
                                   loaded.data ? &*loaded.data : nullptr);
  MIXCMP_TRY(found, components::shortlist(maker, query_of(loaded.scene, rates), device,
                                          optimise::Rates::of(rates)));
  Advice advice{.best = std::move(found.best),
                .reference_share = found.reference_share,
                .device = device.name,
                .try_first = command_of("optimise", options, {}).add("-o", "plan.toml").text(),
                .try_now = ""};
  if (!advice.best.empty()) {
    advice.try_now = verify_command(advice.best.front(), options, loaded);
  }
  return advice;
}

std::string to_text(const Advice& advice) {
  std::string text = fmt::format("\nadvice, from {}; {}\n", basis, advice.device);
  if (advice.best.empty()) {
    return text + "  none of these lanes exists with a recomputation rate: nothing to advise\n";
  }
  const LaneEstimate& least = advice.best.front();
  const std::string recomputed =
      least.rate > 0 ? fmt::format("recomputations included (one in {:.3g})", 1 / least.rate)
                     : "and recompute nothing, since they are exact";
  text += fmt::format(
      "  L = {} costs least: lanes in {} ({}) take about {:.3g} % of the device each,\n"
      "  {}; a reference takes {:.3g} times as much\n",
      least.precision, least.key.format.name(), kind_of(least), 100 * least.share, recomputed,
      advice.reference_share / least.share);
  for (std::size_t k = 1; k < std::min(advice.best.size(), most_listed); ++k) {
    const LaneEstimate& other = advice.best[k];
    text += fmt::format("  {:.2f} times as much: L = {}, {} ({})\n", other.share / least.share,
                        other.precision, other.key.format.name(), kind_of(other));
  }
  text += fmt::format("  try: {}\n", advice.try_first);
  return advice.try_now.empty() ? text : text + fmt::format("  or at once: {}\n", advice.try_now);
}

nlohmann::ordered_json to_json(const Advice& advice) {
  nlohmann::ordered_json json = {{"basis", basis},
                                 {"device", advice.device},
                                 {"reference_device_share", advice.reference_share},
                                 {"lanes", nlohmann::ordered_json::array()},
                                 {"try", {advice.try_first}}};
  for (const LaneEstimate& lane : advice.best) json["lanes"].push_back(to_json(lane));
  if (!advice.try_now.empty()) json["try"].push_back(advice.try_now);
  return json;
}

}  // namespace mixcmp::cli
