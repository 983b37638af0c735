#include "model/optimise/plan.hpp"

#include <fmt/format.h>

namespace mixcmp::model {
namespace {

/// A basic string of TOML.
std::string in_toml(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

/// The keys of [reduced] that a profile's name of a bound stands for.
std::string bound_keys(const std::string& bound) {
  constexpr std::string_view running = "running_";
  if (bound == "profiled") return "bound = \"profiled\"\n";
  std::string keys = "bound = \"certified\"\n";
  if (!bound.starts_with(running)) return keys + fmt::format("error_bound = \"{}\"\n", bound);
  return keys + fmt::format("error_bound = \"running\"\nbound_digits = {}\n",
                            bound.substr(running.size()));
}

/// None without a product.
std::string multipliers_key(const ComponentKey& key) {
  return key.multipliers.empty() ? "" : fmt::format("multipliers = \"{}\"\n", key.multipliers);
}

std::string lanes_table(const ComponentKey& key, int count) {
  return fmt::format("\n[[lanes]]\ncount = {}\nformat = \"{}\"\ninputs = \"{}\"\n{}{}", count,
                     key.format, key.inputs, bound_keys(key.bound), multipliers_key(key));
}

}  // namespace

std::string plan_toml(const Optimisation& optimisation, const PrecisionPlan& plan,
                      const std::string& scene_file, const std::string& command) {
  const Allocation& chosen = *plan.allocation();
  std::string text = fmt::format(
      "# The best plan found for {} on {}, with:\n#   {}\n"
      "scene = {}\n\n"
      "[plan]\n"
      "throughput_per_s = {:.6g}\nclock_mhz = {:.6g}\nclock_basis = \"{}\"\n"
      "recomputation_rate = {:.6g}\nslack = {:g}\n",
      optimisation.scene, optimisation.device.name, command, in_toml(scene_file),
      plan.throughput_per_s(), plan.clock_mhz(), to_string(optimisation.basis),
      plan.recomputation_rate(), optimisation.slack);
  for (const Resource& resource : bounded_resources) {
    text += fmt::format("{} = {}\n", resource.name, chosen.used.*resource.amount);
  }
  text += fmt::format("\n[system]\ndevice = {}\ntarget_mhz = {:g}\n",
                      in_toml(optimisation.device.name), optimisation.target_mhz);
  if (chosen.reference_count() == 0) text += "references = 0\n";
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
