#include "generator/faces/cli/costs.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/synthesis/components/component_maker.hpp"
#include "generator/synthesis/components/synthesis_jobs.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/common/scratch_folder.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/plan/profile/profile.hpp"
#include "model/plan/profile/profiled_error.hpp"
#include "model/plan/profile/schemes.hpp"
#include "model/scene/lane_bound.hpp"

namespace mixcmp::cli {
namespace {

using devices::Area;
using scene::ReducedSpec;
using scene::Scene;

/// The area of one lane, without streams, on the scene's device.
Result<Area> lane_area(const Scene& scene, const design::Lane& lane,
                       scene::Multipliers multipliers) {
  MIXCMP_DO(design::check_multipliers(lane, multipliers));
  MIXCMP_TRY(device, devices::find_device(scene.system.device));
  MIXCMP_TRY(tools, characterise::tool_versions(device, characterise::TimingEffort::area_only));
  MIXCMP_TRY(built, components::lane_rtl(scene.graph.inputs(), lane, multipliers, scene.system));
  MIXCMP_TRY(scratch, ScratchFolder::make());
  const auto result =
      characterise::synthesise(components::module_job(built.module), device,
                               {.effort = characterise::TimingEffort::area_only}, scratch.path());
  if (result.ok()) return result->area;
  scratch.keep_for(result.error());
  return result.error();
}

/// The area of the lane with every hazard built and no operand checked, except for signs; none
/// where that lane does not exist.
Result<std::optional<Area>> area_of_all_built(const Scene& scene, const ReducedSpec& reduced,
                                              const error::Lane& lane) {
  const auto all_built =
      error::certified_lane(lane_graph(scene.graph, scene.reference.format, lane.graph.arithmetic,
                                       reduced.inputs_beside(scene.reference.format)),
                            {.kind = *reduced.error_bound,
                             .bound_digits = reduced.bound_digits,
                             .ranges = scene.ranges,
                             .hazards = error::HazardRemoval::keep});
  if (!all_built.ok()) return std::optional<Area>();
  MIXCMP_TRY(area, lane_area(scene, *all_built, reduced.multipliers));
  return std::optional(area);
}

/// Tells whether `generate` takes the bound of `tried`, whose lane has this decision.
bool is_chosen(const LoadedScene& loaded, const ReducedSpec& tried, const std::string& decision) {
  const ReducedSpec& reduced = loaded.scene.reduced;
  if (reduced.is_profiled != tried.is_profiled || reduced.fixed_point != tried.fixed_point)
    return false;
  if (reduced.is_profiled) return true;
  const auto taken = design::design_lane(loaded.scene, reduced, nullptr);
  return taken.ok() && design::describe_criterion(*taken) == decision;
}

/// Adds the area of a lane, and of one in floating point with all that its ranges make unnecessary.
Result<Done> add_areas(const Scene& scene, const ReducedSpec& reduced, const design::Lane& lane,
                       BoundCost& cost) {
  show_progress(fmt::format("Yosys maps the lane with the {} bound", cost.name));
  MIXCMP_TRY(area, lane_area(scene, lane, reduced.multipliers));
  cost.area = area;
  const auto* floating = std::get_if<error::Lane>(&lane);
  if (floating == nullptr || !floating->certified()) return Done{};
  MIXCMP_TRY(all_built, area_of_all_built(scene, reduced, *floating));
  cost.all_built = all_built;
  return Done{};
}

BoundCost cost_of(const LoadedScene& loaded, const ReducedSpec& compared, const Bound& bound) {
  const Scene& scene = loaded.scene;
  const ReducedSpec reduced = with_bound(compared, bound);
  BoundCost cost{.name = to_string(bound)};
  const auto lane = design::design_lane(scene, reduced, loaded.data ? &*loaded.data : nullptr,
                                        profile::profile_error);
  if (!lane.ok()) {
    cost.decision = "does not exist: " + lane.error().message;
    return cost;
  }
  cost.decision = design::describe_criterion(*lane);
  cost.chosen = is_chosen(loaded, reduced, cost.decision);
  if (const auto added = add_areas(scene, reduced, *lane, cost); !added.ok()) {
    cost.why_no_area = added.error();
  }
  return cost;
}

/// The scene's lane. A lane in fixed point is replaced by one in floating point, with W bits of
/// significand.
Result<ReducedSpec> lane_in_floating_point(const Scene& scene) {
  ReducedSpec reduced = scene.reduced;
  if (reduced.fixed_point) {
    MIXCMP_TRY(format, FloatFormat::make(reduced.fixed_point->bits,
                                         profile::profiled_exponent_bits(scene)));
    reduced.format = format;
  }
  if (reduced.format) return reduced;
  return Error{.field = "reduced.format",
               .message = "--costs compares the bounds of one lane",
               .received = in_quotes(reduced.format_name()),
               .accepted = "a format, such as --format s17 or q13"};
}

void add_rates(const LoadedScene& loaded, int precision, BoundCosts& costs) {
  const Scene& scene = loaded.scene;
  if (!loaded.data) {
    costs.why_no_rate = "the scene has no data";
    return;
  }
  profile::ProfileOptions options{.first_precision = precision, .last_precision = precision};
  if (const auto possible = check_profile(scene, options); !possible.ok()) {
    costs.why_no_rate = possible.error().to_string();
    return;
  }
  show_progress("measuring recomputation rates");
  const auto errors = profile_errors(scene, *loaded.data, {scene.reduced.inputs}, options);
  const auto rates = profile_rates(scene, *loaded.data, errors.front(), options);
  for (const profile::SchemeProfile& scheme : rates.schemes) {
    for (BoundCost& cost : costs.bounds) {
      if (cost.name != scheme.name || !scheme.counts.front().exists) continue;
      cost.recomputation_rate = static_cast<double>(scheme.counts.front().undecided) /
                                static_cast<double>(rates.comparisons);
    }
  }
}

std::string shown(const std::optional<Area>& area) {
  if (!area) return "-";
  const std::string memories = area->memories > 0 ? fmt::format(", {} memory", area->memories) : "";
  return fmt::format("{} LUT, {} DSP{}", area->luts, area->dsps, memories);
}

nlohmann::json json_of(const std::optional<Area>& area) {
  if (!area) return nullptr;
  return {{"luts", area->luts},
          {"registers", area->registers},
          {"dsps", area->dsps},
          {"memories", area->memories}};
}

}  // namespace

Result<BoundCosts> measure_costs(const LoadedScene& loaded) {
  MIXCMP_TRY(compared, lane_in_floating_point(loaded.scene));
  BoundCosts costs;
  for (const Bound& bound : counted_bounds()) {
    costs.bounds.push_back(cost_of(loaded, compared, bound));
  }
  add_rates(loaded, compared.format->precision(), costs);
  show_progress("");
  return costs;
}

std::string to_text(const BoundCosts& costs) {
  std::string text = "what each bound costs (* is taken; areas of one lane, before placement)\n";
  for (const BoundCost& cost : costs.bounds) {
    const std::string name = (cost.chosen ? "* " : "  ") + cost.name;
    if (!cost.area && !cost.recomputation_rate) {
      text += fmt::format("{:<16} {}\n", name, cost.decision);
      continue;
    }
    const std::string rate = cost.recomputation_rate
                                 ? fmt::format("recomputes {:.3e}", *cost.recomputation_rate)
                                 : "rate unknown";
    text += fmt::format("{:<16} {}; {}; {}", name, rate, shown(cost.area), cost.decision);
    if (cost.all_built) text += fmt::format("; all built: {}", shown(cost.all_built));
    text += "\n";
  }
  for (const BoundCost& cost : costs.bounds) {
    if (!cost.why_no_area) continue;
    text += fmt::format("  no areas, {}: {}\n", cost.name, cost.why_no_area->to_string());
  }
  if (!costs.why_no_rate.empty()) text += fmt::format("  no rates: {}\n", costs.why_no_rate);
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
    if (cost.why_no_area) report.back()["why_no_area"] = cost.why_no_area->to_string();
  }
  return report;
}

}  // namespace mixcmp::cli
