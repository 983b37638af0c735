#include "model/optimise/plan.hpp"

#include <fmt/format.h>

#include <map>

#include "model/scene/settings.hpp"

namespace mixcmp::model {
namespace {

/// The keys of [reduced] that a profile's name of a bound stands for.
std::string bound_keys(const std::string& bound) {
  constexpr std::string_view running = "running_";
  if (bound == "profiled") return "bound = \"profiled\"\n";
  std::string keys = "bound = \"certified\"\n";
  if (!bound.starts_with(running)) return keys + fmt::format("error_bound = \"{}\"\n", bound);
  return keys + fmt::format("error_bound = \"running\"\nbound_digits = {}\n",
                            bound.substr(running.size()));
}

/// The scene's key for the kind of multipliers; empty for datapaths without a product.
std::string multipliers_key(const ComponentKey& key) {
  return key.multipliers.empty() ? "" : fmt::format("multipliers = \"{}\"\n", key.multipliers);
}

std::string lanes_table(const ComponentKey& key, int count) {
  return fmt::format("\n[[lanes]]\ncount = {}\nformat = \"{}\"\ninputs = \"{}\"\n{}{}", count,
                     key.format, key.inputs, bound_keys(key.bound), multipliers_key(key));
}

using Section = std::map<std::string, std::string>;

/// The last setting "section.key=value" of each key, but for the keys that the plan sets itself.
std::map<std::string, Section> sections_of(const std::vector<std::string>& settings) {
  std::map<std::string, Section> sections;
  for (const std::string& setting : settings) {
    const std::size_t dot = setting.find('.'), equals = setting.find('=');
    const std::string key = setting.substr(dot + 1, equals - dot - 1);
    sections[setting.substr(0, dot)][key] = toml_value(setting.substr(equals + 1));
  }
  for (const char* chosen : {"device", "target_mhz", "lanes", "references"}) {
    sections["system"].erase(chosen);
  }
  return sections;
}

std::string lines_of(const Section& section) {
  std::string text;
  for (const auto& [key, value] : section) text += fmt::format("{} = {}\n", key, value);
  return text;
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
      optimisation.scene, optimisation.device.name, source.command, toml_string(source.scene_file),
      plan.throughput_per_s(), plan.clock_mhz(), to_string(optimisation.basis),
      plan.recomputation_rate(), optimisation.slack);
  for (const Resource& resource : bounded_resources) {
    text += fmt::format("{} = {}\n", resource.name, chosen.used.*resource.amount);
  }
  auto sections = sections_of(source.settings);
  text += fmt::format("\n[system]\ndevice = {}\ntarget_mhz = {:g}\n", toml_string(source.device),
                      optimisation.target_mhz);
  if (chosen.reference_count() == 0) text += "references = 0\n";
  text += lines_of(sections.extract("system").mapped());
  for (const auto& [name, section] : sections) {
    text += fmt::format("\n[{}]\n{}", name, lines_of(section));
  }
  for (const int k : lane_order(plan.problem)) {
    if (chosen.lanes[k] > 0) text += lanes_table(plan.lanes[k].measured.key, chosen.lanes[k]);
  }
  for (const int k : reference_order(plan.problem)) {
    if (chosen.references[k] == 0) continue;
    text += fmt::format("\n[[references]]\ncount = {}\n{}", chosen.references[k],
                        multipliers_key(optimisation.references[k].measured.key));
  }
  return text;
}

}  // namespace mixcmp::model
