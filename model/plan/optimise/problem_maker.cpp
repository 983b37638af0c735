#include "model/plan/optimise/problem_maker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/lane_format.hpp"
#include "model/cost/performance/performance.hpp"
#include "model/cost/performance/streams.hpp"
#include "model/design/request_beats.hpp"
#include "model/design/slots.hpp"
#include "model/plan/optimise/engine_area.hpp"
#include "model/plan/optimise/second_tier.hpp"
#include "model/plan/profile/schemes.hpp"

namespace mixcmp::optimise {
namespace {

template <class Choice>
bool allows(const std::vector<Choice>& allowed, const Choice& word) {
  return allowed.empty() || std::find(allowed.begin(), allowed.end(), word) != allowed.end();
}

bool allows_multipliers(const OptimiseOptions& options,
                        const std::optional<scene::Multipliers>& multipliers) {
  return !multipliers || allows(options.multipliers, *multipliers);
}

/// The lane of a row that depends on one.
const measured::Lane& lane_in(const measured::Measurement& row) {
  return *measured::lane_of(row.key);
}

std::string lane_name(const measured::Lane& lane) {
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

/// The clock of a reference whose latency needs more slots than the second lane has. No plan is so
/// slow, so the program never chooses that reference.
constexpr double out_of_reach_hz = 1;

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

bool has_a_clock(const std::vector<const measured::Measurement*>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const auto* row) { return row->clock; });
}

/// Interpolates linearly between two areas, at part / whole of the way; rounds up.
devices::Area between(const devices::Area& low, const devices::Area& high, int part, int whole) {
  devices::Area area;
  for (const devices::Resource& resource : devices::bounded_resources) {
    const std::int64_t rise = std::int64_t{high.*resource.amount} - low.*resource.amount;
    const std::int64_t step = rise >= 0 ? (rise * part + whole - 1) / whole : rise * part / whole;
    area.*resource.amount = static_cast<int>(low.*resource.amount + step);
  }
  return area;
}

}  // namespace

ProblemMaker::ProblemMaker(const scene::Scene& scene, const measured::Characterisation& table,
                           const Rates& rates, const OptimiseOptions& options,
                           std::optional<measured::Lane> second_tier)
    : scene_(scene),
      table_(table),
      rates_(rates),
      options_(options),
      second_tier_(std::move(second_tier)) {
  communication_.fixed = options.fixed_communication.value_or(devices::Area{});
  sort_rows();
  leave_out_untimed();
  const bool has_crossbar = scene.system.references != 0 && engine() != scene::EngineKind::pairwise;
  if (!options_.fixed_communication && has_crossbar) add_crossbar();
}

std::vector<int> ProblemMaker::precisions() const {
  std::vector<int> precisions;
  for (const auto& [precision, rows] : lanes_) precisions.push_back(precision);
  return precisions;
}

std::vector<ReferenceImplementation> ProblemMaker::references() {
  std::vector<ReferenceImplementation> all;
  for (const measured::Measurement* row : references_) {
    const auto& reference = std::get<measured::Reference>(row->key);
    const double mhz = clock_of(*row, options_.clocks.reference_mhz, {});
    const int interval = design::planned_service_cycles(reference.initiation_interval,
                                                        scene_.system.request_beats.value_or(1));
    all.push_back({*row,
                   {reference_name(reference), mhz * hertz_per_mhz, interval, area_with_port(*row),
                    reference.target_mhz.has_value()}});
  }
  return all;
}

std::optional<PrecisionPlan> ProblemMaker::plan(
    int precision, const devices::Device& device,
    const std::vector<ReferenceImplementation>& references) {
  std::optional<PrecisionPlan> best;
  left_out_.clear();
  for (const Rows& rows : plannable_together(lanes_.at(precision))) {
    for (const std::optional<SecondLanes>& tier : second_lanes_of(rows)) {
      PrecisionPlan plan = plan_of(precision, rows, device, references, tier);
      if (plan.lanes.empty()) continue;
      if (!best || is_better(plan, *best, device)) best = std::move(plan);
    }
  }
  if (!best && left_out_.empty()) return std::nullopt;
  if (!best) {
    best = PrecisionPlan{.precision = precision,
                         .lanes = {},
                         .problem = {},
                         .result = Infeasible{.shortages = {}, .message = left_out_}};
  }
  note_largest_crossbar(*best);
  return best;
}

PrecisionPlan ProblemMaker::plan_of(int precision, const Rows& rows, const devices::Device& device,
                                    const std::vector<ReferenceImplementation>& references,
                                    const std::optional<SecondLanes>& tier) {
  PrecisionPlan plan{.precision = precision, .lanes = {}, .problem = {}, .result = Infeasible{}};
  plan.problem.communication = communication_;
  plan.second_lanes = tier;
  if (tier) plan.problem.communication.crossbar.clear();  // second lanes count with their ports
  const int slots = slots_for(rows);
  const measured::Measurement* fifo = fifo_of(slots);
  for (const measured::Measurement* row : rows) add_lane(plan, *row, fifo);
  const bool has_fifos = !has_engine() && !options_.fixed_communication;
  if (!plan.lanes.empty() && fifo == nullptr && has_fifos) {
    missing_.insert(fmt::format("a fifo of {} slots", slots));
  }
  for (const LaneImplementation& lane : plan.lanes) plan.problem.lanes.push_back(lane.kind);
  add_references(plan, references);
  limit_engine(plan.problem);
  plan.problem.available = device.available;
  plan.problem.slack = scene_.system.slack;
  plan.problem.clocks = options_.clocks.domains;
  if (!plan.lanes.empty()) plan.result = allocate(plan.problem);
  if (tier) count_second_lanes(plan);
  return plan;
}

/// Each reference is charged a second lane: rounding the number of second lanes up to a multiple of
/// p_H adds fewer than p_H + 1 to groups / groups_served.
void ProblemMaker::add_references(PrecisionPlan& plan,
                                  const std::vector<ReferenceImplementation>& references) {
  for (const ReferenceImplementation& reference : references) {
    ReferenceKind& kind = plan.problem.references.emplace_back(reference.kind);
    if (!options_.clocks.reference_mhz) {
      kind.clock_hz = std::min(kind.clock_hz, crossbar_mhz_ * hertz_per_mhz);
    }
    if (!plan.second_lanes) continue;
    const measured::Measurement& second = plan.second_lanes->measured;
    kind.area += plan.second_lanes->area;
    const int slots = design::second_tier_slots_for(scene_.system, second.latency_cycles,
                                                    reference.measured.latency_cycles);
    if (slots > std::get<measured::SecondLane>(second.key).slots) kind.clock_hz = out_of_reach_hz;
  }
}

/// The groups that a second lane serves, by this lane's rate and the measured crossbars.
int ProblemMaker::served_by_second_lane(const measured::Measurement& lane) const {
  const std::optional<Rate> rate = rates_.find(rate_key(lane_in(lane)));
  if (!rate) return 0;
  const int served = groups_served(*rate, scene_.system.lanes_per_group);
  const int measured = static_cast<int>(communication_.crossbar.size()) - 1;
  return options_.fixed_communication ? served : std::min(served, std::max(measured, 0));
}

/// The largest area of a port of any crossbar.
devices::Area ProblemMaker::crossbar_port() const {
  devices::Area most;
  for (std::size_t ports = 1; ports < communication_.crossbar.size(); ++ports) {
    const devices::Area port = share(communication_.crossbar[ports], static_cast<int>(ports));
    for (const devices::Resource& resource : devices::bounded_resources) {
      most.*resource.amount = std::max(most.*resource.amount, port.*resource.amount);
    }
  }
  return most;
}

std::vector<std::optional<SecondLanes>> ProblemMaker::second_lanes_of(const Rows& rows) {
  if (!has_second_lanes()) return {std::nullopt};
  const int served = served_by_second_lane(*rows.front());
  if (served == 0) {
    left_out_ = "every lane leaves too much undecided for a lane of the second tier";
    return {};
  }
  std::vector<std::optional<SecondLanes>> all;
  for (const auto& [slots, row] : sizes_of(table_, measured::SecondLane{*second_tier_})) {
    devices::Area area = row->area + crossbar_port();
    if (!communication_.crossbar.empty()) area += communication_.crossbar[served];
    all.emplace_back(SecondLanes{.measured = *row,
                                 .area = area,
                                 .groups_served = served,
                                 .area_per_group = share(area, served)});
  }
  if (all.empty()) missing_.insert("a second_lane in " + second_tier_->format.name());
  return all;
}

/// Limits a plan's numbers by the kind of engine.
void ProblemMaker::limit_engine(AllocationProblem& problem) const {
  switch (engine()) {
    case scene::EngineKind::none:
      problem.max_lanes = settings::limits::lanes_in_groups(scene_.system.lanes_per_group).most;
      return;
    case scene::EngineKind::pairwise:
      problem.sharing = ReferenceSharing::pooled;  // whichever is free takes the next pair
      problem.max_lanes = settings::limits::engine_lanes.most;
      // Each stream of reports has a group of lanes.
      problem.min_lanes =
          scene_.system.engine.report_streams * scene_.system.engine.lanes_per_segment();
      break;
    case scene::EngineKind::arg_min:
      // With fewer lanes candidates would be missing; more lanes would have no candidate.
      problem.min_lanes = problem.max_lanes = *scene_.lane_count();
      break;
  }
  problem.recomputations_per_cycle = engine_recomputations_per_cycle;
}

void ProblemMaker::sort_rows() {
  for (const measured::Measurement& row : table_.rows) {
    const auto* reference = std::get_if<measured::Reference>(&row.key);
    if (reference != nullptr && is_wanted_reference(*reference)) references_.push_back(&row);
    if (!is_lane(row.key)) continue;
    const measured::Lane& lane = lane_in(row);
    if (is_wanted(lane)) lanes_[lane.format.precision()].push_back(&row);
  }
}

/// Whether this is a row of lanes as the scene's systems contain them: in segments, or one by one.
bool ProblemMaker::is_lane(const measured::ComponentKey& key) const {
  if (!has_engine()) return std::holds_alternative<measured::Lane>(key);
  const auto* segment = std::get_if<measured::Segment>(&key);
  return segment != nullptr && segment->lanes == scene_.system.engine.lanes_per_segment();
}

/// Whether this is a row of a reference that the scene asks for: of its format and sums, of its
/// initiation interval unless that is "auto", and of its target if it has one. A folded reference
/// must not be faster than the scene's requests.
bool ProblemMaker::is_wanted_reference(const measured::Reference& reference) const {
  const auto& [multipliers, interval, target] = scene_.reference_structure;
  const double target_mhz = reference.target_mhz.value_or(scene_.system.target_mhz);
  return allows_multipliers(options_, reference.multipliers) &&
         reference.format == scene_.reference.format && reference.sums == scene_.reference.sums &&
         design::check_request_beats(scene_.system, reference.initiation_interval).ok() &&
         (!interval || *interval == reference.initiation_interval) &&
         (!target || *target == target_mhz);
}

bool ProblemMaker::is_wanted(const measured::Lane& lane) const {
  const int precision = lane.format.precision();
  const bool wanted_inputs = !lane.inputs || allows(options_.inputs, *lane.inputs);
  return allows_multipliers(options_, lane.multipliers) && options_.first_precision <= precision &&
         precision <= options_.last_precision && is_before_second_tier(precision) &&
         wanted_inputs && allows(options_.bounds, lane.bound) && is_trusted(lane);
}

/// In a system of streams, lanes may precede the second tier if they have fewer digits. A table may
/// have other lanes: at least that of the second tier.
bool ProblemMaker::is_before_second_tier(int precision) const {
  return !has_second_lanes() || precision < rate_key(*second_tier_).precision;
}

/// Lanes with a measured, unproven bound are used for scenes that ask for them, and only for those.
bool ProblemMaker::is_trusted(const measured::Lane& lane) const {
  return lane.bound.is_profiled() == scene_.reduced.is_profiled;
}

/// Whether the rates hold for this lane. If it has fewer exponent bits than the counted lanes had,
/// more comparisons may be undecided, unless the inputs' ranges say that fewer bits suffice.
bool ProblemMaker::has_enough_exponents(const measured::Lane& lane) {
  const std::optional<FloatFormat>& format = lane.format.floating;
  if (!format) return true;
  const int counted = profile::profiled_exponent_bits(scene_);
  if (format->exponent_bits() >= counted) return true;
  if (scene_.reduced.exponent_bits_from_ranges) return true;
  notes_.insert(fmt::format("{}: left out, recomputation rates were counted with {} exponent bits",
                            lane.format.name(), counted));
  return false;
}

/// If any lane has a measured clock, lanes without one are left out: their clock would be the
/// target, which would beat every measurement. The same holds for references.
void ProblemMaker::leave_out_untimed() {
  Rows all;
  for (const auto& [precision, rows] : lanes_) all.insert(all.end(), rows.begin(), rows.end());
  if (!options_.clocks.lane_mhz && has_a_clock(all)) {
    for (auto& [precision, rows] : lanes_) erase_untimed(rows, "lane");
    std::erase_if(lanes_, [](const auto& entry) { return entry.second.empty(); });
  }
  if (!options_.clocks.reference_mhz && has_a_clock(references_)) {
    erase_untimed(references_, "reference");
  }
}

void ProblemMaker::erase_untimed(Rows& rows, const std::string& what) {
  if (std::erase_if(rows, [](const auto* row) { return !row->clock; }) == 0) return;
  notes_.insert(fmt::format(
      "{0}s without a clock are left out, since others have one; --{0}-mhz counts all", what));
}

/// Shares between two measured port counts are interpolated. Below the smallest measured count its
/// area is used. Larger counts are not planned.
void ProblemMaker::add_crossbar() {
  const auto measured = sizes_of(table_, measured::Crossbar{});
  if (measured.empty()) {
    missing_.insert("a crossbar");
    return;
  }
  std::vector<devices::Area>& shares = communication_.crossbar;
  shares.resize(static_cast<std::size_t>(measured.rbegin()->first) + 1);
  int below = 0;
  for (const auto& [ports, row] : measured) {
    const devices::Area& low = below == 0 ? row->area : shares[below];
    for (int k = below + 1; k <= ports; ++k) {
      shares[k] = between(low, row->area, k - below, ports - below);
    }
    if (ports - below > 1) {
      notes_.insert("crossbar port counts between measured ones are interpolated");
    }
    if (row->clock) crossbar_mhz_ = std::min(crossbar_mhz_, row->clock->mhz);
    below = ports;
  }
}

void ProblemMaker::note_largest_crossbar(const PrecisionPlan& plan) {
  const Allocation* chosen = plan.allocation();
  const std::size_t known = communication_.crossbar.size();
  if (chosen == nullptr || known == 0 || chosen->reference_count() == 0) return;
  if (plan.second_lanes) return;  // these have as many ports as they need
  const int group = lanes_per_port(plan.problem);
  const int served =
      performance::lanes_of_references(chosen->lane_count() / group, chosen->reference_count())
          .front();
  if (static_cast<std::size_t>(served) + 1 < known) return;
  if (served == plan.problem.max_lanes / group) return;  // it serves all possible lanes
  notes_.insert(
      fmt::format("L = {}: a reference serves {} {}, since no larger crossbar was measured",
                  plan.precision, served, group == 1 ? "lanes" : "groups"));
}

std::vector<ProblemMaker::Rows> ProblemMaker::plannable_together(const Rows& lanes) const {
  const bool is_chain = engine() == scene::EngineKind::arg_min;
  if (!is_chain && !has_second_lanes()) return {lanes};
  std::map<int, Rows> alike;
  for (const measured::Measurement* lane : lanes) {
    const int trait =
        is_chain ? design::chain_slots_for(lane->latency_cycles) : served_by_second_lane(*lane);
    alike[trait].push_back(lane);
  }
  std::vector<Rows> all;
  for (auto& [trait, rows] : alike) all.push_back(std::move(rows));
  return all;
}

/// All lanes of a system have the slots that the lane with the longest latency needs.
int ProblemMaker::slots_for(const Rows& lanes) const {
  int slowest = 0;
  for (const measured::Measurement* lane : lanes) {
    slowest = std::max(slowest, lane->latency_cycles);
  }
  return design::slots_for(slowest + scene_.system.input_registers,
                           scene_.system.references.value_or(1) > 0);
}

/// The scoreboard's row; none if the table has none, or if the area of streams is given.
const measured::Measurement* ProblemMaker::fifo_of(int slots) const {
  if (options_.fixed_communication) return nullptr;
  return table_.find(measured::Fifo{slots});
}

/// The clock of a row in MHz: the given one, else the measured one, else the target. A lane without
/// a given clock is no faster than the streams around it and the slowest crossbar. `basis_` keeps
/// the least reliable source of all.
double ProblemMaker::clock_of(const measured::Measurement& row, const std::optional<double>& given,
                              const std::optional<double>& streams_mhz) {
  if (given) return *given;
  basis_ = std::max(basis_, row.clock ? basis_of(*row.clock) : ClockBasis::target);
  double mhz = row.clock ? row.clock->mhz : scene_.system.target_mhz;
  if (std::holds_alternative<measured::Reference>(row.key)) return mhz;
  mhz = std::min(mhz, streams_mhz.value_or(mhz));
  if (crossbar_mhz_ < mhz) {
    notes_.insert(fmt::format("clocks are limited by the slowest crossbar measured, {:.4g} MHz",
                              crossbar_mhz_));
  }
  return std::min(mhz, crossbar_mhz_);
}

std::optional<Rate> ProblemMaker::known_rate(const RateKey& key) {
  const std::optional<Rate> rate = rates_.find(key);
  if (!rate) notes_.insert(fmt::format("{}: no recomputation rate is known", name_of(key)));
  return rate;
}

/// How often a lane asks a reference, directly or through the second tier; none if that is unknown,
/// or if the second tier would not keep up.
std::optional<Rate> ProblemMaker::rate_of(const RateKey& lane) {
  const std::optional<Rate> rate = known_rate(lane);
  if (!rate || !second_tier_) return rate;
  const int lanes = scene_.system.engine.lanes_per_group;
  if (!has_engine() || keeps_up(*rate, lanes)) return known_rate(rate_key(*second_tier_));
  left_out_ = fmt::format(
      "{} lanes leave more than {} pairs a cycle undecided, too many for one of the second tier",
      lanes, most_undecided_per_cycle);
  return std::nullopt;
}

void ProblemMaker::add_lane(PrecisionPlan& plan, const measured::Measurement& row,
                            const measured::Measurement* fifo) {
  const measured::Lane& key = lane_in(row);
  const std::optional<Rate> first = known_rate(rate_key(key));
  const std::optional<Rate> rate = rate_of(rate_key(key));
  if (!first || !rate) return;
  const int beats = scene_.system.request_beats.value_or(1);
  const Rate& requests = has_engine() ? *rate : *first;  // on the lane's own stream
  const double asked = scene_.system.lanes_per_group * requests.value();
  if (performance::highest_lane_throughput(asked, beats) < 1) {
    left_out_ =
        scene_.system.lanes_per_group == 1
            ? "every lane leaves more than half undecided: references without lanes are faster"
            : "every group of lanes asks more often than its one stream of requests allows";
    return;
  }
  if (!has_enough_exponents(key)) return;
  const std::optional<Surrounded> lane =
      has_engine() ? in_segment(plan, row) : with_fifo(row, fifo);
  if (!lane) return;
  double mhz = clock_of(row, options_.clocks.lane_mhz, lane->streams_mhz);
  devices::Area group = lane->group;
  if (plan.second_lanes) {
    const SecondLanes& second = *plan.second_lanes;
    mhz = std::min(mhz, clock_of(second.measured, options_.clocks.lane_mhz, {}));
    group += second.area_per_group;
  }
  LaneImplementation& added = plan.lanes.emplace_back();
  added.measured = row;
  added.with_streams = lane->area;
  added.rate = *rate;
  added.kind = {.name = lane_name(key),
                .clock_hz = mhz * hertz_per_mhz,
                .initiation_interval = cycles_per_word(requests.value()),
                .recomputation_rate = rate->value(),
                .area = group,
                .group = lane->lanes};
  added.datapath = area_alone(key);
  if (second_tier_ && has_engine()) added.second_tier = area_alone(*second_tier_);
}

/// Cycles from one comparison to the next, or in groups from one word to the next. With refetched
/// operands the tags of a lane's stream are read once for each result and once more for each
/// request (rtl_templates/stream/README.md).
double ProblemMaker::cycles_per_word(double recomputation_rate) const {
  const scene::SystemSpec& system = scene_.system;
  const bool refetches = system.operands == scene::OperandStore::refetched &&
                         system.references.value_or(1) > 0 && !has_engine();
  if (!refetches) return 1;
  return 1 + performance::undecided_words(recomputation_rate, system.lanes_per_group);
}

/// The area of a lane by itself; none if it was not measured.
std::optional<devices::Area> ProblemMaker::area_alone(const measured::Lane& lane) const {
  const measured::Measurement* row = table_.find_datapath(lane);
  return row == nullptr ? std::nullopt : std::optional(row->area);
}

std::optional<ProblemMaker::Surrounded> ProblemMaker::with_fifo(
    const measured::Measurement& lane, const measured::Measurement* fifo) const {
  const int lanes = scene_.system.lanes_per_group;
  if (fifo == nullptr) return Surrounded{lane.area, lanes * lane.area, lanes, {}};
  const auto mhz = fifo->clock ? std::optional(fifo->clock->mhz) : std::nullopt;
  return Surrounded{lane.area + share(fifo->area, lanes), lanes * lane.area + fifo->area, lanes,
                    mhz};
}

/// The engine's own area goes into the plan's communication: the largest that any of the plan's
/// lanes needs.
std::optional<ProblemMaker::Surrounded> ProblemMaker::in_segment(PrecisionPlan& plan,
                                                                 const measured::Measurement& row) {
  const std::optional<EngineArea> engine = engine_area(table_, row, this->engine(), missing_);
  if (!engine) return std::nullopt;
  devices::Area& own = plan.problem.communication.fixed;
  for (const devices::Resource& resource : devices::bounded_resources) {
    if (options_.fixed_communication) break;
    own.*resource.amount = std::max(own.*resource.amount, engine->own.*resource.amount);
  }
  return Surrounded{engine->lane, engine->group, std::get<measured::Segment>(row.key).lanes,
                    engine->mhz};
}

/// A reference with the streams around it, and its share of an engine's memory. A table of a system
/// of streams may lack both.
devices::Area ProblemMaker::area_with_port(const measured::Measurement& row) {
  const measured::Measurement* port =
      table_.find(measured::ReferencePort{std::get<measured::Reference>(row.key)});
  devices::Area area = row.area + memory_share(table_, engine(), missing_);
  if (port != nullptr) return area + port->area;
  if (has_engine()) missing_.insert("the port of a reference");
  return area;
}

}  // namespace mixcmp::optimise
