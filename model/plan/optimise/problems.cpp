#include "model/plan/optimise/problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/cost/performance/pairwise.hpp"
#include "model/cost/performance/performance.hpp"
#include "model/cost/performance/streams.hpp"
#include "model/design/request_beats.hpp"
#include "model/design/slots.hpp"
#include "model/plan/optimise/engine_area.hpp"
#include "model/plan/optimise/exact_lanes.hpp"
#include "model/plan/optimise/pairwise_busy.hpp"
#include "model/plan/optimise/second_tier.hpp"
#include "model/plan/optimise/throughput_bound.hpp"
#include "model/plan/profile/schemes.hpp"

namespace mixcmp::optimise {
namespace {

using measured::Lane;
using measured::Measurement;

/// The search for the best plan of one precision.
struct PrecisionSearch {
  const PlanningInputs& inputs;
  const PlanParts& parts;
  int precision;
  Findings& findings;
  std::string left_out = {};  ///< why no lane is usable, for the user
  double known_per_s = 0;     ///< of the fastest plan so far

  const scene::SystemSpec& system() const { return inputs.scene.system; }
  const OptimiseOptions& options() const { return inputs.options; }
};

/// The lane of a row that depends on one.
const Lane& lane_in(const Measurement& row) {
  return *measured::lane_of(row.key);
}

std::string lane_name(const Lane& lane) {
  std::string name = lane.format.name();
  for (const std::string& trait :
       {to_string(lane.inputs), to_string(lane.bound), std::string(to_string(lane.multipliers))}) {
    if (!trait.empty()) name += " " + trait;
  }
  return name;
}

/// Lanes in fixed point have one rate for all kinds of inputs, so the name leaves these out.
std::string name_of(const RateKey& key) {
  const std::string bound = to_string(key.bound);
  return key.bound.is_fixed_point() ? bound : fmt::format("{} {}", to_string(key.inputs), bound);
}

std::string reference_name(const measured::Reference& reference) {
  std::string name = reference.format.name();
  if (reference.multipliers) name += fmt::format(" {}", to_string(*reference.multipliers));
  if (reference.sums == Sums::fused) name += " fused";
  const int interval = reference.initiation_interval;
  if (interval > 1) name += fmt::format(" ii{}", interval);
  return reference.target_mhz ? fmt::format("{} for {} MHz", name, *reference.target_mhz) : name;
}

ClockBasis basis_of(const measured::Clock& clock) {
  switch (clock.source) {
    case measured::ClockSource::estimate_before_routing: return ClockBasis::estimate_before_routing;
    case measured::ClockSource::routed: return ClockBasis::routed;
  }
  MIXCMP_CHECK(false);
}

/// The clock of a row in MHz: the given one, else the measured one, else the target.
double own_mhz(const PlanningInputs& inputs, const Measurement& row,
               const std::optional<double>& given, Findings& findings) {
  if (given) return *given;
  findings.basis = std::max(findings.basis, row.clock ? basis_of(*row.clock) : ClockBasis::target);
  return row.clock ? row.clock->mhz : inputs.scene.system.target_mhz;
}

/// A lane without a given clock is no faster than the streams around it and the slowest crossbar.
double lane_mhz(const PrecisionSearch& search, const Measurement& row,
                const std::optional<double>& streams_mhz) {
  const std::optional<double>& given = search.options().clocks.lane_mhz;
  const double own = own_mhz(search.inputs, row, given, search.findings);
  if (given) return own;
  const double mhz = std::min(own, streams_mhz.value_or(own));
  const double crossbar = search.parts.crossbars.mhz;
  if (crossbar >= mhz) return mhz;
  search.findings.notes.insert(
      fmt::format("clocks are limited by the slowest crossbar measured, {:.4g} MHz", crossbar));
  return crossbar;
}

std::optional<Rate> known_rate(const PrecisionSearch& search, const Lane& lane) {
  const RateKey key = rate_key(lane);
  std::optional<Rate> rate = search.inputs.rates.find(key);
  // A system with references has one at least, even if its lanes are exact.
  const scene::Scene& scene = search.inputs.scene;
  if (rate) rate->is_exact = scene.reference_count() == 0 && is_exact(scene, lane);
  if (!rate) {
    search.findings.notes.insert(fmt::format("{}: no recomputation rate is known", name_of(key)));
  }
  return rate;
}

/// Whether the rates hold for this lane. If it has fewer exponent bits than the counted lanes had,
/// more comparisons may be undecided, unless the inputs' ranges say that fewer bits suffice.
bool has_enough_exponents(const PrecisionSearch& search, const Lane& lane) {
  const std::optional<FloatFormat>& format = lane.format.floating;
  if (!format || search.inputs.scene.reduced.exponent_bits_from_ranges) return true;
  const int counted = profile::profiled_exponent_bits(search.inputs.scene);
  if (format->exponent_bits() >= counted) return true;
  search.findings.notes.insert(
      fmt::format("{}: left out, recomputation rates were counted with {} exponent bits",
                  lane.format.name(), counted));
  return false;
}

/// Why lanes of this rate are left out: `otherwise`, unless none of the comparisons was undecided.
/// The rate is then the rule of three's (Rate::value), so the comparisons are too few.
std::string why_too_high(const Rate& rate, std::string otherwise) {
  if (rate.undecided > 0) return otherwise;
  return fmt::format(
      "too few comparisons for a rate: none of {} is undecided, so that the rate may be up to "
      "{:.0f} % (rule of three)",
      rate.comparisons, 100 * rate.value());
}

/// How often a lane asks.
struct LaneRates {
  Rate reference;  ///< a reference, directly or through the second tier
  Rate stream;     ///< on the lane's own stream of requests
};

/// None if a rate is unknown, if an engine's second tier would not keep up, if the stream of
/// requests allows no such lane, or if the rates do not hold for the lane.
std::optional<LaneRates> rates_of(PrecisionSearch& search, const Lane& lane) {
  const std::optional<Rate> first = known_rate(search, lane);
  if (!first) return std::nullopt;
  const PlanningInputs& inputs = search.inputs;
  const int engine_lanes = search.system().engine.lanes_per_group;
  if (inputs.second_tier && inputs.has_engine() && !keeps_up(*first, engine_lanes)) {
    search.left_out = why_too_high(
        *first,
        fmt::format("{} lanes leave more than {} pairs a cycle undecided, too many for one of the "
                    "second tier",
                    engine_lanes, most_undecided_per_cycle));
    return std::nullopt;
  }
  const std::optional<Rate> rate =
      inputs.second_tier ? known_rate(search, *inputs.second_tier) : first;
  if (!rate) return std::nullopt;
  const LaneRates rates{*rate, inputs.has_engine() ? *rate : *first};
  const int group = search.system().lanes_per_group;
  const int beats = search.system().request_beats.value_or(1);
  if (performance::highest_lane_throughput(group * rates.stream.value(), beats) < 1) {
    search.left_out = why_too_high(
        rates.stream,
        group == 1 ? "every lane leaves more than half undecided: references without lanes are "
                     "faster"
                   : "every group of lanes asks more often than its one stream of requests allows");
    return std::nullopt;
  }
  return has_enough_exponents(search, lane) ? std::optional(rates) : std::nullopt;
}

/// A lane with the streams around it, or its share of a segment.
struct Surrounded {
  devices::Area area;                 ///< of a lane, rounded up
  devices::Area group;                ///< of the lanes that share it
  int lanes;                          ///< of a group
  std::optional<double> streams_mhz;  ///< the clock of the streams around it, if measured
};

/// The area of a lane by itself; none if it was not measured.
std::optional<devices::Area> area_alone(const PrecisionSearch& search, const Lane& lane) {
  const Measurement* row = search.inputs.table.find_datapath(lane);
  return row == nullptr ? std::nullopt : std::optional(row->area);
}

void add_lane(PrecisionPlan& plan, const PrecisionSearch& search, const Measurement& row,
              const LaneRates& rates, Surrounded surrounded) {
  double mhz = lane_mhz(search, row, surrounded.streams_mhz);
  if (plan.second_lanes) {
    mhz = std::min(mhz, lane_mhz(search, plan.second_lanes->measured, {}));
    surrounded.group += plan.second_lanes->area_per_group;
  }
  LaneImplementation& added = plan.lanes.emplace_back();
  added.measured = row;
  added.with_streams = surrounded.area;
  added.rate = rates.reference;
  added.kind = {.name = lane_name(lane_in(row)),
                .clock_hz = mhz * hertz_per_mhz,
                .initiation_interval = cycles_per_word(search.inputs.scene, rates.stream.value()),
                .recomputation_rate = rates.reference.value(),
                .area = surrounded.group,
                .group = surrounded.lanes};
  added.datapath = area_alone(search, lane_in(row));
  const PlanningInputs& inputs = search.inputs;
  if (inputs.second_tier && inputs.has_engine()) {
    added.second_tier = area_alone(search, *inputs.second_tier);
  }
}

/// The clock of a reference whose latency needs more slots than the second lane has. No plan is so
/// slow, so the program never chooses that reference.
constexpr double out_of_reach_hz = 1;

/// Each reference is charged a second lane: rounding the number of second lanes up to a multiple of
/// p_H adds fewer than p_H + 1 to groups / groups_served.
void add_references(PrecisionPlan& plan, const PrecisionSearch& search) {
  for (const ReferenceImplementation& reference : search.parts.references) {
    ReferenceKind& kind = plan.problem.references.emplace_back(reference.kind);
    if (!search.options().clocks.reference_mhz) {
      kind.clock_hz = std::min(kind.clock_hz, search.parts.crossbars.mhz * hertz_per_mhz);
    }
    if (!plan.second_lanes) continue;
    const Measurement& second = plan.second_lanes->measured;
    kind.area += plan.second_lanes->area;
    const int slots = design::second_tier_slots_for(search.system(), second.latency_cycles,
                                                    reference.measured.latency_cycles);
    if (slots > std::get<measured::SecondLane>(second.key).slots) kind.clock_hz = out_of_reach_hz;
  }
}

PrecisionPlan empty_plan(const PrecisionSearch& search) {
  PrecisionPlan plan{
      .precision = search.precision, .lanes = {}, .problem = {}, .result = Infeasible{}};
  const OptimiseOptions& options = search.options();
  plan.problem.communication = {options.fixed_communication.value_or(devices::Area{}),
                                search.parts.crossbars.shares};
  plan.problem.available = search.parts.device.available;
  plan.problem.slack = search.system().slack;
  plan.problem.clocks = options.clocks.domains;
  return plan;
}

void solve(PrecisionPlan& plan, PrecisionSearch& search) {
  for (const LaneImplementation& lane : plan.lanes) plan.problem.lanes.push_back(lane.kind);
  add_references(plan, search);
  if (plan.lanes.empty()) return;
  const double wanted = std::max(search.options().at_least_per_s, search.known_per_s);
  if (wanted > 0) plan.bound_per_s = throughput_bound(plan.problem);
  if (plan.bound_per_s >= wanted) {
    plan.problem.at_least_per_s = wanted;
    plan.problem.effort = search.options().effort;
    plan.result = allocate(plan.problem);
    plan.problem.at_least_per_s = 0;
    search.known_per_s = std::max(search.known_per_s, plan.throughput_per_s());
  } else {
    plan.result = Infeasible{.shortages = {}, .message = "slower than a plan that is known"};
  }
}

/// The slots that a lane needs.
int slots_of(const PrecisionSearch& search, const Measurement& lane) {
  return design::slots_for(lane.latency_cycles + search.system().input_registers,
                           search.system().references.value_or(1) > 0);
}

/// The scoreboard of lanes: all lanes of a system have the slots that the lane with the longest
/// latency needs.
measured::Fifo fifo_for(const PrecisionSearch& search, const Rows& lanes) {
  int most = 0;
  for (const Measurement* lane : lanes) most = std::max(most, slots_of(search, *lane));
  return {most};
}

/// The sets of lanes that may be in one plan, by rising numbers of slots: all, and those that a
/// smaller scoreboard of the table serves.
std::vector<Rows> rows_by_slots(const PrecisionSearch& search, const Rows& lanes) {
  std::map<int, Rows> by_slots;
  for (const Measurement* lane : lanes) by_slots[slots_of(search, *lane)].push_back(lane);
  std::vector<Rows> sets;
  Rows served;
  for (const auto& [slots, rows] : by_slots) {
    served.insert(served.end(), rows.begin(), rows.end());
    const bool is_all = served.size() == lanes.size();
    const bool is_smaller = !search.options().fixed_communication &&
                            search.inputs.table.find(measured::Fifo{slots}) != nullptr;
    if (is_all) sets.push_back(lanes);
    if (!is_all && is_smaller) sets.push_back(served);
  }
  return sets;
}

/// `fifo` is null if the table lacks it, or if the area of streams is given.
Surrounded with_fifo(const PrecisionSearch& search, const Measurement& lane,
                     const Measurement* fifo) {
  const int lanes = search.system().lanes_per_group;
  if (fifo == nullptr) return {lane.area, lanes * lane.area, lanes, {}};
  const auto mhz = fifo->clock ? std::optional(fifo->clock->mhz) : std::nullopt;
  return {lane.area + share(fifo->area, lanes), lanes * lane.area + fifo->area, lanes, mhz};
}

/// Whether the lanes that the plan uses have a smaller scoreboard in the table than the one that
/// was counted: the system would have that one, and the lanes that it serves have a plan of their
/// own.
bool counts_another_fifo(const PrecisionSearch& search, const PrecisionPlan& plan,
                         const measured::Fifo& counted) {
  if (plan.allocation() == nullptr) return false;
  int most = 0;
  for (std::size_t k = 0; k < plan.lanes.size(); ++k) {
    if (plan.allocation()->lanes[k] == 0) continue;
    most = std::max(most, slots_of(search, plan.lanes[k].measured));
  }
  return most < counted.slots && search.inputs.table.find(measured::Fifo{most}) != nullptr;
}

/// Lanes with streams; each group asks a reference, or a lane of the second tier.
PrecisionPlan plan_streams(PrecisionSearch& search, const Rows& rows,
                           const std::optional<SecondLanes>& second) {
  PrecisionPlan plan = empty_plan(search);
  plan.second_lanes = second;
  if (second) plan.problem.communication.crossbar.clear();  // second lanes count with their ports
  const bool is_given = search.options().fixed_communication.has_value();
  const measured::Fifo wanted = fifo_for(search, rows);
  const Measurement* fifo = is_given ? nullptr : search.inputs.table.find(wanted);
  for (const Measurement* row : rows) {
    const std::optional<LaneRates> rates = rates_of(search, lane_in(*row));
    if (rates) add_lane(plan, search, *row, *rates, with_fifo(search, *row, fifo));
  }
  if (!plan.lanes.empty() && fifo == nullptr && !is_given) {
    search.findings.missing.insert(fmt::format("a fifo of {} slots", wanted.slots));
  }
  const auto most = settings::limits::lanes_in_groups(search.system().lanes_per_group).most;
  plan.problem.max_lanes = most;
  const double known_per_s = search.known_per_s;
  solve(plan, search);
  if (!is_given && counts_another_fifo(search, plan, wanted)) {
    plan.result = Infeasible{.shortages = {}, .message = "its lanes have a smaller scoreboard"};
    search.known_per_s = known_per_s;
  }
  return plan;
}

/// The groups that a second lane serves, by this lane's rate and the measured crossbars.
int served_by_second_lane(const PrecisionSearch& search, const Measurement& lane) {
  const std::optional<Rate> rate = search.inputs.rates.find(rate_key(lane_in(lane)));
  if (!rate) return 0;
  const int served = groups_served(*rate, search.system().lanes_per_group);
  const int measured = static_cast<int>(search.parts.crossbars.shares.size()) - 1;
  return search.options().fixed_communication ? served : std::min(served, std::max(measured, 0));
}

/// The kinds of second lanes that may stand behind groups of which each serves `served`.
std::vector<SecondLanes> second_lane_kinds(const PrecisionSearch& search, int served) {
  const Lane& tier = *search.inputs.second_tier;
  const Crossbars& crossbars = search.parts.crossbars;
  std::vector<SecondLanes> all;
  for (const auto& [slots, row] : sizes_of(search.inputs.table, measured::SecondLane{tier})) {
    devices::Area area = row->area + largest_port(crossbars);
    if (!crossbars.shares.empty()) area += crossbars.shares[served];
    all.push_back({.measured = *row,
                   .area = area,
                   .groups_served = served,
                   .area_per_group = share(area, served)});
  }
  if (all.empty()) search.findings.missing.insert("a second_lane in " + tier.format.name());
  return all;
}

/// The program charged each group a part of a second lane and each reference a whole one, which is
/// an upper bound. This charges the actual number instead.
void count_second_lanes(PrecisionPlan& plan) {
  auto* const chosen = std::get_if<Allocation>(&plan.result);
  if (chosen == nullptr) return;
  SecondLanes& second = *plan.second_lanes;
  const int groups = chosen->lane_count() / lanes_per_port(plan.problem);
  const int references = chosen->reference_count();
  second.count = second_lanes_for(groups, second.groups_served, references);
  for (const devices::Resource& resource : devices::bounded_resources) {
    const auto amount = resource.amount;
    chosen->used.*amount += second.count * second.area.*amount -
                            groups * second.area_per_group.*amount -
                            references * second.area.*amount;
  }
}

/// Rows of lanes that may be in one plan: those with the same trait.
template <class Trait>
std::map<int, Rows> rows_by(const Rows& lanes, Trait trait) {
  std::map<int, Rows> alike;
  for (const Measurement* lane : lanes) alike[trait(*lane)].push_back(lane);
  return alike;
}

/// Streams with second lanes, each of which serves the same number of groups.
std::vector<PrecisionPlan> plans_of_tiers(PrecisionSearch& search, const Rows& lanes) {
  std::vector<PrecisionPlan> plans;
  const auto served_by = [&](const Measurement& lane) {
    return served_by_second_lane(search, lane);
  };
  for (const auto& [served, rows] : rows_by(lanes, served_by)) {
    if (served == 0) {
      const std::optional<Rate> rate = search.inputs.rates.find(rate_key(lane_in(*rows.front())));
      search.left_out =
          why_too_high(rate.value_or(Rate{1, 1}),
                       "every lane leaves too much undecided for a lane of the second tier");
      continue;
    }
    for (const SecondLanes& second : second_lane_kinds(search, served)) {
      for (const Rows& each : rows_by_slots(search, rows)) {
        count_second_lanes(plans.emplace_back(plan_streams(search, each, second)));
      }
    }
  }
  return plans;
}

/// Segments in one engine. Its own area goes into the plan's communication: the largest that any of
/// the plan's lanes needs.
PrecisionPlan plan_segments(PrecisionSearch& search, const Rows& rows) {
  PrecisionPlan plan = empty_plan(search);
  plan.problem.recomputations_per_cycle = engine_recomputations_per_cycle;
  devices::Area& own = plan.problem.communication.fixed;
  for (const Measurement* row : rows) {
    const std::optional<LaneRates> rates = rates_of(search, lane_in(*row));
    if (!rates) continue;
    const std::optional<EngineArea> engine =
        engine_area(search.inputs.table, *row,
                    {.kind = search.inputs.engine(),
                     .recomputes = search.inputs.scene.reference_count() != 0,
                     .arrives_in_fixed_point = search.inputs.scene.has_fixed_operands()},
                    search.findings.missing);
    if (!engine) continue;
    for (const devices::Resource& resource : devices::bounded_resources) {
      if (search.options().fixed_communication) break;
      own.*resource.amount = std::max(own.*resource.amount, engine->own.*resource.amount);
    }
    const int lanes = std::get<measured::Segment>(row->key).lanes;
    add_lane(plan, search, *row, *rates, {engine->lane, engine->group, lanes, engine->mhz});
  }
  return plan;
}

PrecisionPlan plan_of_pairwise_engine(PrecisionSearch& search, const Rows& rows) {
  PrecisionPlan plan = plan_segments(search, rows);
  if (plan.lanes.empty()) return plan;
  const scene::EngineSpec& engine = search.system().engine;
  plan.problem.sharing = ReferenceSharing::pooled;  // whichever is free takes the next pair
  plan.problem.min_lanes = engine.report_streams * engine.lanes_per_segment();
  plan.problem.max_lanes = most_useful_groups(plan, search.inputs) * engine.lanes_per_segment();
  solve(plan, search);
  count_idle_cycles(plan, search.inputs);
  return plan;
}

/// Chains, each of lanes with the number of slots with which they were measured.
std::vector<PrecisionPlan> plans_of_arg_min_engines(PrecisionSearch& search, const Rows& lanes) {
  std::vector<PrecisionPlan> plans;
  const bool recomputes = search.inputs.scene.reference_count() != 0;
  const auto slots = [&](const Measurement& lane) {
    return design::chain_slots_for(lane.latency_cycles, recomputes);
  };
  for (const auto& [count, rows] : rows_by(lanes, slots)) {
    PrecisionPlan& plan = plans.emplace_back(plan_segments(search, rows));
    // With fewer lanes candidates would be missing; more lanes would have no candidate.
    plan.problem.min_lanes = plan.problem.max_lanes = *search.inputs.scene.lane_count();
    solve(plan, search);
  }
  return plans;
}

std::vector<PrecisionPlan> plans_of_streams(PrecisionSearch& search, const Rows& lanes) {
  std::vector<PrecisionPlan> plans;
  for (const Rows& rows : rows_by_slots(search, lanes)) {
    plans.push_back(plan_streams(search, rows, std::nullopt));
  }
  return plans;
}

std::vector<PrecisionPlan> plans_of(PrecisionSearch& search, const Rows& lanes) {
  switch (search.inputs.engine()) {
    case scene::EngineKind::none:
      return search.inputs.second_tier ? plans_of_tiers(search, lanes)
                                       : plans_of_streams(search, lanes);
    case scene::EngineKind::pairwise: return {plan_of_pairwise_engine(search, lanes)};
    case scene::EngineKind::arg_min: return plans_of_arg_min_engines(search, lanes);
  }
  MIXCMP_CHECK(false);
}

}  // namespace

double cycles_per_word(const scene::Scene& scene, double recomputation_rate) {
  const scene::SystemSpec& system = scene.system;
  const bool refetches = system.operands == scene::OperandStore::refetched &&
                         system.references.value_or(1) > 0 &&
                         system.engine.kind == scene::EngineKind::none;
  if (!refetches) return 1;
  return 1 + performance::undecided_words(recomputation_rate, system.lanes_per_group);
}

std::vector<ReferenceImplementation> references_of(const PlanningInputs& inputs, const Rows& rows,
                                                   Findings& findings) {
  const std::optional<double>& given = inputs.options.clocks.reference_mhz;
  const int beats = inputs.scene.system.request_beats.value_or(1);
  std::vector<ReferenceImplementation> all;
  for (const Measurement* row : rows) {
    const auto& reference = std::get<measured::Reference>(row->key);
    const double mhz = own_mhz(inputs, *row, given, findings);
    const devices::Area area =
        area_with_port(inputs.table, *row, inputs.engine(), findings.missing);
    all.push_back({*row,
                   {reference_name(reference), mhz * hertz_per_mhz,
                    design::planned_service_cycles(reference.initiation_interval, beats), area,
                    row->latency_cycles, reference.target_mhz.has_value()}});
  }
  return all;
}

std::optional<PrecisionPlan> best_plan(const PlanningInputs& inputs, const PlanParts& parts,
                                       int precision, const Rows& lanes, Findings& findings) {
  PrecisionSearch search{inputs, parts, precision, findings};
  std::optional<PrecisionPlan> best;
  double bound_per_s = 0;
  for (PrecisionPlan& plan : plans_of(search, lanes)) {
    if (plan.lanes.empty()) continue;
    bound_per_s = std::max(bound_per_s, plan.bound_per_s);
    if (!best || is_better(plan, *best, parts.device)) best = std::move(plan);
  }
  if (best) {
    best->bound_per_s = bound_per_s;
    note_largest_crossbar(*best, parts.crossbars, findings);
    return best;
  }
  if (search.left_out.empty()) return std::nullopt;
  return PrecisionPlan{.precision = precision,
                       .lanes = {},
                       .problem = {},
                       .result = Infeasible{.shortages = {}, .message = search.left_out}};
}

}  // namespace mixcmp::optimise
