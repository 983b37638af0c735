#include "generator/cli/costs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/error/certified_lane.hpp"
#include "model/profile/profile.hpp"

namespace mixcmp::cli {
namespace {

using model::BoundKind;
using model::ErrorBoundKind;
using model::Scene;

/// A kind of bound under the name that a profile gives it.
struct Variant {
  std::string name;
  BoundKind bound = BoundKind::certified;
  ErrorBoundKind kind = ErrorBoundKind::relative;
  int digits = 4;
};
const std::vector<Variant> variants = {
    {"relative", BoundKind::certified, ErrorBoundKind::relative},
    {"running_4", BoundKind::certified, ErrorBoundKind::running, 4},
    {"running_1", BoundKind::certified, ErrorBoundKind::running, 1},
    {"constant", BoundKind::certified, ErrorBoundKind::constant},
    {"profiled", BoundKind::profiled},
};

/// The scene with one kind of bound, as one lane and no reference.
Scene with_bound(const Scene& scene, const Variant& variant) {
  Scene copy = scene.with_one_kind();
  copy.reduced.bound = variant.bound;
  copy.reduced.error_bound = variant.kind;
  copy.reduced.bound_digits = variant.digits;
  copy.system.lanes = 1;
  copy.system.references = 0;
  return copy;
}

bool is_chosen(const Scene& scene, const Variant& variant, const std::string& decision) {
  if (scene.reduced.bound != variant.bound) return false;
  if (variant.bound == BoundKind::profiled) return true;
  const auto design = make_design(with_bound(scene, variant), nullptr);
  Scene plain = scene.with_one_kind();
  plain.system.lanes = 1;
  plain.system.references = 0;
  const auto taken = make_design(plain, nullptr);
  return design.ok() && taken.ok() && describe_decision(taken->lanes.front().lane) == decision;
}

/// The same lane with every hazard built and no operand checked, except for signs.
std::optional<Area> area_of_all_built(const Scene& scene, model::Design design) {
  const auto lane = certified_lane(lane_graph(scene.graph, scene.reference.format,
                                              design.lanes.front().lane.graph.arithmetic, scene.reduced.inputs),
                                   {.kind = scene.reduced.error_bound,
                                    .bound_digits = scene.reduced.bound_digits,
                                    .ranges = scene.ranges,
                                    .hazards = model::HazardRemoval::keep});
  if (!lane.ok()) return std::nullopt;
  design.lanes.front().lane = *lane;
  const auto area = lane_area(design);
  return area.ok() ? std::optional(*area) : std::nullopt;
}

void progress(const std::string& what) {
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K{}", what);
}

BoundCost cost_of(const LoadedScene& loaded, const Variant& variant, std::string& no_area) {
  BoundCost cost{.name = variant.name};
  const Scene scene = with_bound(loaded.scene, variant);
  const auto design = make_design(scene, loaded.data ? &*loaded.data : nullptr);
  if (!design.ok()) {
    cost.decision = "does not exist: " + design.error().message;
    return cost;
  }
  cost.decision = describe_decision(design->lanes.front().lane);
  cost.chosen = is_chosen(loaded.scene, variant, cost.decision);
  progress(fmt::format("Yosys maps the lane with the {} bound", variant.name));
  const auto area = lane_area(*design);
  if (!area.ok()) {
    no_area = area.error().to_string();
    return cost;
  }
  cost.area = *area;
  if (variant.bound == BoundKind::certified) cost.all_built = area_of_all_built(scene, *design);
  return cost;
}

void add_rates(const LoadedScene& loaded, BoundCosts& costs) {
  const Scene& scene = loaded.scene;
  if (!loaded.data) {
    costs.no_rate = "no data";
    return;
  }
  const int precision = scene.reduced.format->precision();
  model::ProfileOptions options{.first_precision = precision, .last_precision = precision};
  if (const auto possible = check_profile(scene, options); !possible.ok()) {
    costs.no_rate = possible.error().to_string();
    return;
  }
  progress("measuring recomputation rates");
  const auto errors = profile_errors(scene, *loaded.data, {scene.reduced.inputs}, options);
  const auto rates = profile_rates(scene, *loaded.data, errors.front(), options);
  for (const model::SystemProfile& system : rates.systems) {
    for (BoundCost& cost : costs.bounds) {
      if (cost.name != system.name || !system.counts.front().exists) continue;
      cost.recomputation_rate = static_cast<double>(system.counts.front().undecided) /
                                static_cast<double>(rates.comparisons);
    }
  }
}

std::string shown(const std::optional<Area>& area) {
  return area ? fmt::format("{} LUT, {} DSP", area->luts, area->dsps) : "-";
}

nlohmann::json json_of(const std::optional<Area>& area) {
  if (!area) return nullptr;
  return {{"luts", area->luts}, {"registers", area->registers}, {"dsps", area->dsps}};
}

}  // namespace

BoundCosts measure_costs(const LoadedScene& loaded) {
  BoundCosts costs;
  if (!loaded.scene.reduced.format) {
    costs.no_area = costs.no_rate = "reduced.format is \"auto\"";
    return costs;
  }
  for (const Variant& variant : variants) {
    costs.bounds.push_back(cost_of(loaded, variant, costs.no_area));
  }
  add_rates(loaded, costs);
  progress("");
  return costs;
}

std::string to_text(const BoundCosts& costs) {
  std::string text = "what each bound costs (* is taken; areas of one lane, before placement)\n";
  for (const BoundCost& cost : costs.bounds) {
    const std::string name = (cost.chosen ? "* " : "  ") + cost.name;
    if (!cost.area && !cost.recomputation_rate) {
      text += fmt::format("{:<13} {}\n", name, cost.decision);
      continue;
    }
    const std::string rate = cost.recomputation_rate
                                 ? fmt::format("recomputes {:.3e}", *cost.recomputation_rate)
                                 : "rate unknown";
    text += fmt::format("{:<13} {}; {}; {}", name, rate, shown(cost.area), cost.decision);
    if (cost.all_built) text += fmt::format("; all built: {}", shown(cost.all_built));
    text += "\n";
  }
  if (!costs.no_area.empty()) text += fmt::format("  no areas: {}\n", costs.no_area);
  if (!costs.no_rate.empty()) text += fmt::format("  no rates: {}\n", costs.no_rate);
  return text;
}

nlohmann::json to_json(const BoundCosts& costs) {
  nlohmann::json report = nlohmann::json::array();
  for (const BoundCost& cost : costs.bounds) {
    report.push_back({{"name", cost.name},
                      {"chosen", cost.chosen},
                      {"decision", cost.decision},
                      {"recomputation_rate", nullptr},
                      {"area", json_of(cost.area)},
                      {"area_all_built", json_of(cost.all_built)}});
    if (cost.recomputation_rate) report.back()["recomputation_rate"] = *cost.recomputation_rate;
  }
  return report;
}

}  // namespace mixcmp::cli
