#include "model/plan/optimise/plan.hpp"

#include <fmt/format.h>

#include <variant>

#include "model/base/common/quote.hpp"
#include "model/base/settings/settings.hpp"
#include "model/scene/lane_bound.hpp"

namespace mixcmp::optimise {
namespace {

std::string bound_keys(const Bound& bound) {
  const scene::ReducedSpec reduced = scene::with_bound({}, bound);
  std::string keys = fmt::format("bound = \"{}\"\n", reduced.bound_word());
  if (!reduced.error_bound) return keys;
  keys += fmt::format("error_bound = \"{}\"\n", to_string(*reduced.error_bound));
  if (bound.is_fixed_point() || bound.digits == 0) return keys;
  return keys + fmt::format("bound_digits = {}\n", bound.digits);
}

/// The scene's key for the kind of multipliers; empty for datapaths without a product.
std::string multipliers_key(const std::optional<scene::Multipliers>& multipliers) {
  return multipliers ? fmt::format("multipliers = \"{}\"\n", to_string(*multipliers)) : "";
}

/// Always written, since the scene may leave the interval to the plan.
std::string references_table(const measured::Reference& reference, int count) {
  const std::string target =
      reference.target_mhz ? fmt::format("target_mhz = {}\n", *reference.target_mhz) : "";
  return fmt::format("\n[[references]]\ncount = {}\n{}initiation_interval = {}\n{}", count,
                     multipliers_key(reference.multipliers), reference.initiation_interval, target);
}

/// The scene's key for how operands enter a lane; empty in fixed point, which has no such choice.
std::string inputs_key(const measured::Lane& lane) {
  if (!lane.inputs) return "";
  const std::string value = to_string(*lane.inputs);
  return fmt::format("inputs = {}\n", lane.inputs->number() ? value : in_quotes(value));
}

std::string lanes_table(const measured::Lane& lane, int count) {
  return fmt::format("\n[[lanes]]\ncount = {}\nformat = \"{}\"\n{}{}{}", count, lane.format.name(),
                     inputs_key(lane), bound_keys(lane.bound), multipliers_key(lane.multipliers));
}

/// The overrides without the keys of [system] that the plan sets itself.
settings::Setting::Table without_chosen_keys(settings::Setting::Table overrides) {
  for (settings::Setting& section : overrides.entries) {
    if (section.key != "system") continue;
    std::erase_if(std::get<settings::Setting::Table>(section.value).entries,
                  [](const settings::Setting& entry) {
                    return entry.key == "device" || entry.key == "target_mhz" ||
                           entry.key == "lanes" || entry.key == "references";
                  });
  }
  return overrides;
}

/// The number of second lanes, as a setting of [second_tier].
void set_second_lanes(settings::Setting::Table& overrides, int count) {
  const auto section_of = [&](const std::string& name) -> settings::Setting& {
    for (settings::Setting& section : overrides.entries) {
      if (section.key == name) return section;
    }
    settings::Setting section;
    section.key = name;
    section.value = settings::Setting::Table{};
    return overrides.entries.emplace_back(std::move(section));
  };
  auto& entries = std::get<settings::Setting::Table>(section_of("second_tier").value).entries;
  std::erase_if(entries, [](const settings::Setting& entry) { return entry.key == "count"; });
  settings::Setting number;
  number.key = "count";
  number.value = std::int64_t{count};
  entries.push_back(std::move(number));
}

std::string lines_of(const settings::Setting::Table& section) {
  std::string text;
  for (const settings::Setting& entry : section.entries) {
    text += fmt::format("{} = {}\n", settings::toml_key(entry.key), settings::toml_value(entry));
  }
  return text;
}

std::string section_text(const settings::Setting& section) {
  const std::string heading =
      section.key == "system" ? "" : "\n[" + settings::toml_key(section.key) + "]\n";
  return heading + lines_of(std::get<settings::Setting::Table>(section.value));
}

}  // namespace

std::string plan_toml(const Optimisation& optimisation, const PrecisionPlan& plan,
                      const PlanSource& source) {
  const Allocation& chosen = *plan.allocation();
  std::string text = fmt::format(
      "# The best plan found for {} on {}, with:\n#   {}\n"
      "scene = {}\n\n"
      "[plan]\n"
      "throughput_per_s = {:.6g}\nclock_mhz = {:.6g}\nclock_basis = \"{}\"\n"
      "recomputation_rate = {:.6g}\nslack = {:g}\n",
      optimisation.scene, optimisation.device.name, source.command,
      settings::toml_string(source.scene_file), plan.throughput_per_s(), plan.clock_mhz(),
      describe_clocks(optimisation), plan.recomputation_rate(), optimisation.slack);
  if (!source.areas.empty()) text += fmt::format("areas = \"{}\"\n", source.areas);
  for (const devices::Resource& resource : devices::bounded_resources) {
    text += fmt::format("{} = {}\n", resource.name, chosen.used.*resource.amount);
  }
  settings::Setting::Table overrides = without_chosen_keys(source.overrides);
  if (plan.second_lanes) set_second_lanes(overrides, plan.second_lanes->count);
  text += fmt::format("\n[system]\ndevice = {}\ntarget_mhz = {}\n",
                      settings::toml_string(source.device), optimisation.target_mhz);
  if (chosen.reference_count() == 0) text += "references = 0\n";
  if (const settings::Setting* system = overrides.find("system")) text += section_text(*system);
  for (const settings::Setting& section : overrides.entries) {
    if (section.key != "system") text += section_text(section);
  }
  for (const int k : lane_order(plan.problem)) {
    if (chosen.lanes[k] > 0) text += lanes_table(plan.lanes[k].lane(), chosen.lanes[k]);
  }
  for (const int k : reference_order(plan.problem)) {
    const int count = chosen.references[k];
    if (count > 0) text += references_table(optimisation.references[k].reference(), count);
  }
  return text;
}

}  // namespace mixcmp::optimise
