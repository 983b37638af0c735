#include "generator/present/report/plan_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "generator/present/report/plan_shares.hpp"
#include "generator/present/report/units.hpp"
#include "model/cost/performance/performance.hpp"
#include "model/plan/optimise/plan_summary.hpp"

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

using Json = nlohmann::ordered_json;

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

std::string row(const PrecisionPlan& plan, bool best) {
  const PlanSummary s = summary_of(plan);
  if (s.precision == 0) {
    return fmt::format("  {:>2}  {}\n", plan.precision, why_infeasible(plan));
  }
  return fmt::format("{} {:>2} {:>5} {:>4} {:>10.3e} {:>7.1f} {:>8.2f}  {}\n", best ? '*' : ' ',
                     s.precision, s.lanes, s.references, s.recomputation_rate, s.clock_mhz,
                     s.throughput_per_s / giga, s.kinds);
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

std::string best_text(const Optimisation& optimisation) {
  const PrecisionPlan* best = optimisation.best();
  if (best == nullptr) return "no precision has a feasible plan\n";
  const PlanSummary s = summary_of(*best);
  std::string text = fmt::format(
      "best: L = {}, p_L = {}, p_H = {}: {:.3g} G comparisons/s\n  {}\n  uses {} of what R_S "
      "leaves\n",
      s.precision, s.lanes, s.references, s.throughput_per_s / giga, s.kinds,
      shares(s.used, optimisation));
  if (is_in_engine(*best)) text += counted_text(*best);
  const double baseline = baseline_per_s(optimisation);
  if (baseline == 0) return text + "references alone: none fits\n";
  const auto& alone = std::get<Allocation>(optimisation.reference_only);
  return text + fmt::format("references alone: {} of them, {:.3g} G comparisons/s; gain {:.2f}\n",
                            alone.lane_count(), baseline / giga, s.throughput_per_s / baseline);
}

Json json_of(const Area& area) {
  return {
      {"lut", area.luts}, {"ff", area.registers}, {"dsp", area.dsps}, {"memory", area.memories}};
}

Json json_of(const PrecisionPlan& plan) {
  const PlanSummary s = summary_of(plan);
  if (s.precision == 0)
    return {{"precision", plan.precision}, {"infeasible", why_infeasible(plan)}};
  Json kinds = Json::array();
  for (std::size_t k = 0; k < plan.lanes.size(); ++k) {
    const LaneImplementation& lane = plan.lanes[k];
    kinds.push_back({{"name", lane.kind.name},
                     {"lanes", plan.allocation()->lanes[k]},
                     {"throughput_per_s", optimise::throughput_per_s(lane.kind)},
                     {"recomputation_rate", lane.kind.recomputation_rate},
                     {"area", json_of(lane.with_streams)}});
  }
  return {{"precision", s.precision},
          {"lanes", s.lanes},
          {"references", s.references},
          {"clock_mhz", s.clock_mhz},
          {"recomputation_rate", s.recomputation_rate},
          {"throughput_per_s", s.throughput_per_s},
          {"used", json_of(s.used)},
          {"kinds", std::move(kinds)}};
}

/// The areas that the plan counts, by the names of its parts.
Json counted_json(const PrecisionPlan& plan) {
  Json parts = Json::array();
  for (const PartShare& part : shares_of(plan)) {
    parts.push_back({{"part", part.name}, {"area", json_of(part.area)}});
  }
  return parts;
}

}  // namespace

std::string to_text(const Optimisation& optimisation) {
  std::string text = fmt::format(
      "{} on {}, slack {:g}, {}; clocks: {}\n"
      "   L   p_L  p_H        R_R     MHz      G/s  lanes\n",
      optimisation.scene, optimisation.device.name, optimisation.slack,
      optimisation.clocks.domains == ClockDomains::single
          ? "one clock domain"
          : "lanes and references on clocks of their own",
      describe_clocks(optimisation));
  for (const PrecisionPlan& plan : optimisation.plans) {
    text += row(plan, &plan == optimisation.best());
  }
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
                 {"plans", Json::array()},
                 {"best", nullptr},
                 {"reference_only_per_s", baseline_per_s(optimisation)},
                 {"crossover_precision", nullptr},
                 {"notes", optimisation.notes}};
  for (const PrecisionPlan& plan : optimisation.plans) report["plans"].push_back(json_of(plan));
  if (const PrecisionPlan* best = optimisation.best()) {
    report["best"] = best->precision;
    report["counted"] = counted_json(*best);
  }
  if (optimisation.crossover) report["crossover_precision"] = *optimisation.crossover;
  return report;
}

std::string figure9_csv(const Optimisation& optimisation) {
  std::string text =
      "precision,lanes,references,clock_mhz,recomputation_rate,throughput_per_s,lut,ff,dsp,memory,"
      "kinds\n";
  for (const PrecisionPlan& plan : optimisation.plans) {
    const PlanSummary s = summary_of(plan);
    const std::string kinds = s.precision == 0 ? why_infeasible(plan) : s.kinds;
    text +=
        fmt::format("{},{},{},{:.6g},{:.6g},{:.6g},{},{},{},{},\"{}\"\n", plan.precision, s.lanes,
                    s.references, s.clock_mhz, s.recomputation_rate, s.throughput_per_s,
                    s.used.luts, s.used.registers, s.used.dsps, s.used.memories, kinds);
  }
  return text;
}

std::string figure7_csv(const Optimisation& optimisation) {
  std::string text =
      "precision,inputs,bound,multipliers,lut,ff,dsp,latency_cycles,clock_mhz,clock_source\n";
  for (const PrecisionPlan& plan : optimisation.plans) {
    for (const LaneImplementation& lane : plan.lanes) {
      const Measurement& m = lane.measured;
      text += fmt::format("{},{},{},{},{},{},{},{},", plan.precision, to_string(m.key.inputs),
                          to_string(m.key.bound), m.key.multipliers, m.area.luts, m.area.registers,
                          m.area.dsps, m.latency_cycles);
      text +=
          m.clock ? fmt::format("{:.2f},{}\n", m.clock->mhz, to_string(m.clock->source)) : ",\n";
    }
  }
  return text;
}

}  // namespace mixcmp::report
