#include "generator/present/report/plan_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/present/report/plan_fields.hpp"
#include "generator/present/report/plan_shares.hpp"
#include "generator/present/report/units.hpp"
#include "model/cost/performance/performance.hpp"

namespace mixcmp::report {

using devices::Area;
using devices::bounded_resources;
using devices::Resource;
using measured::Measurement;
using optimise::Allocation;
using optimise::baseline_per_s;
using optimise::ClockDomains;
using optimise::Infeasible;
using optimise::LaneImplementation;
using optimise::Optimisation;
using optimise::PlanSummary;
using optimise::PrecisionPlan;

namespace {

using table::Fields;
using table::Json;
using table::Table;

std::string why_infeasible(const PrecisionPlan& plan) {
  return "infeasible: " + std::get<Infeasible>(plan.result).message;
}

/// The used shares of the area that the slack leaves: "lut 97 %, ff 40 %, dsp 100 %".
std::string shares(const Area& used, const Optimisation& optimisation) {
  const Area all = performance::usable(optimisation.device.available, optimisation.slack);
  std::string text;
  for (const Resource& resource : bounded_resources) {
    if (all.*resource.amount == 0) continue;
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", resource.name,
                        100.0 * used.*resource.amount / all.*resource.amount);
  }
  return text;
}

/// The columns that people read, in their order.
Fields<PlanSummary> shown_fields() {
  return pick(plan_fields(), {"precision", "lanes", "references", "recomputation_rate", "clock_mhz",
                              "throughput_per_s", "kinds"});
}

/// All columns of a plan, with those of its area before the kinds.
Fields<PlanSummary> with_area(const Fields<PlanSummary>& area) {
  return plan_figures() + area + pick(plan_fields(), {"kinds"});
}

/// The plan at every precision. Infeasible ones have only their precision, and say why.
Table plans_by(const Fields<PlanSummary>& fields, const Optimisation& optimisation) {
  Table table = table_of(fields, {});
  table.remark_name = "infeasible";
  for (const PrecisionPlan& plan : optimisation.plans) {
    const bool feasible = plan.allocation() != nullptr;
    table.rows.push_back(feasible
                             ? row_of(fields, summary_of(plan))
                             : row_of(fields, {.precision = plan.precision}, why_infeasible(plan)));
  }
  return table;
}

/// The areas that a plan of an engine counts, one line per part.
std::string counted_text(const PrecisionPlan& plan) {
  std::string text = fmt::format("  {:<36}", "counts");
  for (const Resource& resource : bounded_resources) text += fmt::format(" {:>8}", resource.name);
  for (const PartShare& part : shares_of(plan)) {
    text += fmt::format("\n    {:<34}", part.name);
    for (const Resource& resource : bounded_resources) {
      text += fmt::format(" {:>8}", part.area.*resource.amount);
    }
  }
  return text + "\n";
}

/// The paper's baseline; empty if there are no references.
std::string references_text(const Optimisation& optimisation) {
  if (optimisation.references.empty()) return "";
  const auto* alone = std::get_if<Allocation>(&optimisation.reference_only);
  if (alone == nullptr) return "references alone: none fits\n";
  return fmt::format("references alone: {} of them, {:.3g} G comparisons/s\n", alone->lane_count(),
                     baseline_per_s(optimisation) / giga);
}

std::string no_plan_text(const Optimisation& optimisation) {
  const bool is_any = std::any_of(optimisation.plans.begin(), optimisation.plans.end(),
                                  [](const auto& plan) { return plan.allocation() != nullptr; });
  if (!is_any) return "no precision has a feasible plan\n" + references_text(optimisation);
  return fmt::format(
      "no plan: lanes of these precisions cost more than references, which alone have {:.3g} G "
      "comparisons/s\n",
      baseline_per_s(optimisation) / giga);
}

std::string best_text(const Optimisation& optimisation) {
  const PrecisionPlan* best = optimisation.best();
  if (best == nullptr) return no_plan_text(optimisation);
  const PlanSummary s = summary_of(*best);
  std::string text = fmt::format(
      "best: L = {}, p_L = {}, p_H = {}: {:.3g} G comparisons/s\n  {}\n  uses {} of what R_S "
      "leaves\n",
      s.precision, s.lanes, s.references, s.throughput_per_s / giga, s.kinds,
      shares(s.used, optimisation));
  if (is_in_engine(*best)) text += counted_text(*best);
  text += references_text(optimisation);
  const double baseline = baseline_per_s(optimisation);
  if (baseline == 0) return text;
  text.insert(text.size() - 1, fmt::format("; gain {:.2f}", s.throughput_per_s / baseline));
  if (s.throughput_per_s >= baseline) return text;
  return text + "note: references alone are faster than this plan\n";
}

Json json_of_kinds(const PrecisionPlan& plan) {
  Json kinds = Json::array();
  for (std::size_t k = 0; k < plan.lanes.size(); ++k) {
    const LaneImplementation& lane = plan.lanes[k];
    kinds.push_back({{"name", lane.kind.name},
                     {"lanes", plan.allocation()->lanes[k]},
                     {"throughput_per_s", optimise::throughput_per_s(lane.kind)},
                     {"recomputation_rate", lane.kind.recomputation_rate},
                     {"area", object_of(area_fields(), lane.with_streams)}});
  }
  return kinds;
}

Json json_of_plans(const Optimisation& optimisation) {
  const Fields<PlanSummary> used = {
      {{"used"}, [](const PlanSummary& s) { return object_of(area_fields(), s.used); }}};
  Json plans = to_json(plans_by(with_area(used), optimisation));
  for (std::size_t k = 0; k < plans.size(); ++k) {
    Json& plan = plans[k];
    if (plan.contains("kinds")) plan["kinds"] = json_of_kinds(optimisation.plans[k]);
  }
  return plans;
}

/// The areas that the plan counts, by the names of its parts.
Json counted_json(const PrecisionPlan& plan) {
  Json parts = Json::array();
  for (const PartShare& part : shares_of(plan)) {
    parts.push_back({{"part", part.name}, {"area", object_of(area_fields(), part.area)}});
  }
  return parts;
}

}  // namespace

table::Table plan_table(const Optimisation& optimisation) {
  return plans_by(shown_fields(), optimisation);
}

std::string to_text(const Optimisation& optimisation) {
  std::string text = fmt::format("{} on {}, slack {:g}, {}; clocks: {}\n", optimisation.scene,
                                 optimisation.device.name, optimisation.slack,
                                 optimisation.clocks.domains == ClockDomains::single
                                     ? "one clock domain"
                                     : "lanes and references on clocks of their own",
                                 describe_clocks(optimisation));
  const int best = summary_of(optimisation).precision;
  const Fields<PlanSummary> mark = {
      {{"", "", 1, 0}, [best](const PlanSummary& s) { return s.precision == best ? "*" : ""; }}};
  text += to_text(plans_by(mark + shown_fields(), optimisation));
  text += best_text(optimisation);
  if (optimisation.crossover) {
    text +=
        fmt::format("crossover precision: {} (a lane costs more than a reference from there on)\n",
                    *optimisation.crossover);
  }
  for (const std::string& note : optimisation.notes) text += "note: " + note + "\n";
  return text;
}

Json to_json(const Optimisation& optimisation) {
  Json report = {{"scene", optimisation.scene},
                 {"device", optimisation.device.name},
                 {"slack", optimisation.slack},
                 {"clock_basis", describe_clocks(optimisation)},
                 {"one_clock_domain", optimisation.clocks.domains == ClockDomains::single},
                 {"plans", json_of_plans(optimisation)},
                 {"best", nullptr},
                 {"reference_only_per_s", baseline_per_s(optimisation)},
                 {"crossover_precision", nullptr},
                 {"notes", optimisation.notes}};
  if (const PrecisionPlan* best = optimisation.best()) {
    report["best"] = best->precision;
    report["counted"] = counted_json(*best);
  }
  if (optimisation.crossover) report["crossover_precision"] = *optimisation.crossover;
  return report;
}

std::string figure9_csv(const Optimisation& optimisation) {
  return to_csv(plans_by(with_area(table::within<PlanSummary>(area_fields(), &PlanSummary::used)),
                         optimisation));
}

std::string figure7_csv(const Optimisation& optimisation) {
  Table table = table::named_table({"precision", "inputs", "bound", "multipliers", "lut", "ff",
                                    "dsp", "latency_cycles", "clock_mhz", "clock_source"});
  table.columns[8].in_csv = "{:.2f}";
  for (const PrecisionPlan& plan : optimisation.plans) {
    for (const LaneImplementation& lane : plan.lanes) {
      const Measurement& m = lane.measured;
      const measured::Lane& key = lane.lane();
      table.rows.push_back({{plan.precision, to_string(key.inputs), to_string(key.bound),
                             to_string(key.multipliers), m.area.luts, m.area.registers, m.area.dsps,
                             m.latency_cycles, m.clock ? Json(m.clock->mhz) : Json(),
                             m.clock ? Json(to_string(m.clock->source)) : Json()}});
    }
  }
  return to_csv(table);
}

}  // namespace mixcmp::report
