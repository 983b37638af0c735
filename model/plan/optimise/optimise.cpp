#include "model/plan/optimise/optimise.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "model/base/settings/limits.hpp"
#include "model/cost/performance/performance.hpp"
#include "model/design/design.hpp"
#include "model/plan/optimise/crossover.hpp"
#include "model/plan/optimise/problems.hpp"
#include "model/plan/optimise/second_tier.hpp"
#include "model/plan/optimise/throughput_bound.hpp"

namespace mixcmp::optimise {
namespace {

bool is_chain(const scene::Scene& scene) {
  return scene.system.engine.kind == scene::EngineKind::arg_min;
}

/// Solves the baseline: references replace the lanes, have no streams around them and need no
/// recomputation. If they replace a chain, there are at most as many of them as it has lanes.
AllocationResult fill_with_references(const scene::Scene& scene, const devices::Device& device,
                                      const std::vector<ReferenceImplementation>& references,
                                      ClockDomains domains) {
  AllocationProblem problem;
  for (const ReferenceImplementation& reference : references) {
    const ReferenceKind& kind = reference.kind;
    problem.lanes.push_back({kind.name, kind.clock_hz,
                             double(reference.reference().initiation_interval), 0,
                             reference.measured.area});
  }
  problem.available = device.available;
  problem.slack = scene.system.slack;
  problem.clocks = domains;
  // References are the baseline: no limit of streams stops them.
  problem.max_lanes = settings::limits::engine_lanes.most;
  if (is_chain(scene)) problem.max_lanes = *scene.lane_count();
  return allocate(problem);
}

/// The crossover precision of the datapaths. A folded reference costs as many areas as it takes
/// cycles for a comparison. As in the paper, C(com) does not count.
std::optional<int> crossover_of(const Optimisation& found) {
  std::map<int, std::vector<devices::Area>> lanes;
  for (const PrecisionPlan& plan : found.plans) {
    for (const LaneImplementation& lane : plan.lanes) {
      lanes[plan.precision].push_back(lane.datapath.value_or(lane.with_streams));
    }
  }
  std::vector<devices::Area> references;
  for (const ReferenceImplementation& reference : found.references) {
    references.push_back(reference.kind.initiation_interval * reference.measured.area);
  }
  return crossover_precision(lanes, references,
                             performance::usable(found.device.available, found.slack));
}

/// Notes for how many chains like the best plan's the device has room. A chain has the lanes that
/// its candidates need, however large the device is.
void note_room(Optimisation& found) {
  const PrecisionPlan* best = found.best();
  if (best == nullptr) return;
  const devices::Area room = performance::usable(found.device.available, found.slack);
  int chains = std::numeric_limits<int>::max();
  for (const devices::Resource& resource : devices::bounded_resources) {
    const int used = best->allocation()->used.*resource.amount;
    if (used > 0) chains = std::min(chains, room.*resource.amount / used);
  }
  found.notes.push_back(
      fmt::format("there is room for {} such engine{}; the plan, and what generate writes, is one",
                  chains, chains == 1 ? "" : "s"));
}

/// The lowest clock, in MHz, of the kinds of which a plan has any.
template <class Kinds>
double lowest_mhz(const Kinds& kinds, const std::vector<int>& counts) {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (counts[k] > 0) lowest = std::min(lowest, kinds[k].clock_hz / hertz_per_mhz);
  }
  return lowest;
}

/// Notes it if a measured reference sets the clock of the best plan.
void note_slow_reference(Optimisation& found) {
  const PrecisionPlan* best = found.best();
  const bool measured = !found.clocks.reference_mhz && found.basis != ClockBasis::target;
  if (best == nullptr || !measured || found.clocks.domains != ClockDomains::single) return;
  const double lanes = lowest_mhz(best->problem.lanes, best->allocation()->lanes);
  const double references = lowest_mhz(best->problem.references, best->allocation()->references);
  if (references >= lanes) return;
  found.notes.push_back(
      fmt::format("a reference sets the clock: {:.4g} MHz, where the lanes reach {:.4g}; `mixcmp "
                  "characterise --reference-targets` measures references with more registers",
                  references, lanes));
}

/// Notes it if streams of reports are what keeps the best plan from more lanes.
void note_full_streams(const scene::Scene& scene, const Rates& rates, Optimisation& found) {
  const PrecisionPlan* best = found.best();
  if (best == nullptr || !best->fills_streams) return;
  const scene::EngineSpec& engine = scene.system.engine;
  found.notes.push_back(fmt::format(
      "more lanes would wait for the streams of reports, of which engine.report_streams gives {}: "
      "each takes one word a cycle, {:.3g} % of the pairs are reported and {:.3g} % recomputed",
      engine.report_streams, 100 * rates.reported_share().value_or(0),
      100 * best->recomputation_rate()));
}

/// Rates that do not know their pairs get a set of the scene's size in which nothing is reported.
Rates known_pairs(const scene::Scene& scene, const Rates& rates, const OptimiseOptions& options,
                  Findings& findings) {
  Rates known = rates;
  const scene::EngineSpec& engine = scene.system.engine;
  if (engine.kind != scene::EngineKind::pairwise || rates.reported_share()) return known;
  if (engine.report_as != scene::ReportForm::count) {
    findings.notes.insert(
        "how many pairs are reported is not known: streams of reports are taken to suffice");
  }
  if (options.set) known.assume_nothing_reported(*options.set);
  return known;
}

/// Names the precisions whose plan may not be the best.
void note_unproven(Optimisation& found) {
  std::vector<std::string> unproven;
  for (const PrecisionPlan& plan : found.plans) {
    if (plan.allocation() == nullptr || plan.allocation()->is_proven) continue;
    const double more = throughput_bound(plan.problem) / plan.throughput_per_s() - 1;
    unproven.push_back(fmt::format("{} ({:.0f} %)", plan.precision, std::ceil(100 * more)));
  }
  if (unproven.empty()) return;
  found.notes.push_back(
      fmt::format("the search for mixes of lanes was cut short for L = {}; there a faster plan may "
                  "exist, by at most the part in brackets",
                  fmt::join(unproven, ", ")));
}

/// Notes it if the scene leaves the interval of references open and the table has only one.
void note_one_interval(const scene::Scene& scene, const measured::Characterisation& table,
                       Optimisation& found) {
  const std::vector<scene::ReferenceGroupSpec> groups = scene.reference_groups();
  const bool is_open = std::any_of(groups.begin(), groups.end(), [](const auto& group) {
    return !group.structure.initiation_interval;
  });
  std::set<int> measured;
  for (const measured::Measurement& row : table.rows) {
    const auto* reference = std::get_if<measured::Reference>(&row.key);
    if (reference != nullptr) measured.insert(reference->initiation_interval);
  }
  if (!is_open || measured.size() != 1 || scene.has_only_fixed_operands()) return;
  found.notes.push_back(
      fmt::format("reference.initiation_interval is \"auto\", but the table has references of "
                  "only interval {}; `mixcmp characterise --initiation-intervals 1,4,16` measures "
                  "others",
                  *measured.begin()));
}

Error nothing_to_choose_from(const scene::Scene& scene, const std::string& what) {
  return {.file = scene.path.string(),
          .field = {},
          .message =
              fmt::format("the characterisation has no {} for this scene and these options", what),
          .received = "none",
          .accepted = "a table made by mixcmp characterise"};
}

Error no_reference(const scene::Scene& scene, const measured::Characterisation& table) {
  const std::string wanted = design::datapath_format(scene).name();
  std::set<std::string> found;
  for (const measured::Measurement& row : table.rows) {
    const auto* reference = std::get_if<measured::Reference>(&row.key);
    if (reference != nullptr) found.insert(reference->format.name());
  }
  Error error = nothing_to_choose_from(scene, "reference in " + wanted);
  if (!found.empty() && !found.contains(wanted)) {
    error.received = fmt::format("references in {}", fmt::join(found, ", "));
  }
  return error;
}

/// With reduced.bound = "profiled" certified lanes are left out, and vice versa.
Error no_lane(const scene::Scene& scene) {
  Error error = nothing_to_choose_from(scene, "lane");
  error.accepted =
      fmt::format("a table of {0} lanes, as reduced.bound is \"{0}\"", scene.reduced.bound_word());
  return error;
}

Error incomplete(const scene::Scene& scene, const std::set<std::string>& missing) {
  return {.file = scene.path.string(),
          .field = {},
          .message = fmt::format("the characterisation lacks what the systems have: {}",
                                 fmt::join(missing, ", ")),
          .received = "a table without it",
          .accepted = "one that `mixcmp characterise` without --components completed"};
}

Result<Done> check_precision(int precision, const std::string& name) {
  if (settings::limits::lane_precision.allow(precision)) return Done{};
  return Error{.field = name,
               .message = "no precision of a lane",
               .received = std::to_string(precision),
               .accepted = settings::to_string(settings::limits::lane_precision)};
}

/// Accepts an absent clock, and refuses NaN.
Result<Done> check_clock(std::optional<double> mhz, const std::string& name) {
  if (!mhz || (*mhz >= least_mhz && *mhz <= most_mhz)) return Done{};
  return Error{.field = name,
               .message = "no clock",
               .received = fmt::format("{} MHz", *mhz),
               .accepted = fmt::format("{}..{} MHz", least_mhz, most_mhz)};
}

}  // namespace

std::string_view to_string(ClockBasis basis) {
  switch (basis) {
    case ClockBasis::given: return "given";
    case ClockBasis::routed: return "placed and routed";
    case ClockBasis::estimate_before_routing: return "estimate before routing";
    case ClockBasis::target: return "target, not measured";
  }
  MIXCMP_CHECK(false);
}

std::string describe_clocks(const Optimisation& optimisation) {
  const std::string basis(to_string(optimisation.basis));
  const bool lanes = optimisation.clocks.lane_mhz.has_value();
  const bool references = optimisation.clocks.reference_mhz.has_value();
  if (lanes == references) return basis;
  return lanes ? "given for lanes; for references: " + basis
               : "given for references; for lanes: " + basis;
}

double PrecisionPlan::throughput_per_s() const {
  const Allocation* chosen = allocation();
  return chosen == nullptr ? 0 : busy * chosen->throughput_per_s;
}

double PrecisionPlan::recomputation_rate() const {
  const Allocation* chosen = allocation();
  if (chosen == nullptr) return 0;
  const bool one_clock = problem.clocks == ClockDomains::single;
  const double clock = one_clock ? clock_mhz() * hertz_per_mhz : any_clock;
  double all = 0, recomputed = 0;
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    const double throughput = chosen->lanes[k] * optimise::throughput_per_s(lanes[k].kind, clock);
    all += throughput;
    recomputed += throughput * lanes[k].kind.recomputation_rate;
  }
  return recomputed / all;
}

double PrecisionPlan::clock_mhz() const {
  const Allocation* chosen = allocation();
  if (chosen == nullptr) return 0;
  double per_cycle = 0;
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    per_cycle += chosen->lanes[k] / lanes[k].kind.initiation_interval;
  }
  return chosen->throughput_per_s / per_cycle / hertz_per_mhz;
}

bool is_better(const PrecisionPlan& a, const PrecisionPlan& b, const devices::Device& device) {
  if (a.throughput_per_s() != b.throughput_per_s()) {
    return a.throughput_per_s() > b.throughput_per_s();
  }
  if (a.allocation() == nullptr || b.allocation() == nullptr) return false;
  return device_share(a.allocation()->used, device.available) <
         device_share(b.allocation()->used, device.available);
}

const PrecisionPlan* Optimisation::best() const {
  const PrecisionPlan* best = nullptr;
  for (const PrecisionPlan& plan : plans) {
    if (plan.allocation() == nullptr || (crossover && plan.precision >= *crossover)) continue;
    if (best == nullptr || is_better(plan, *best, device)) best = &plan;
  }
  return best;
}

double Optimisation::bound_per_s() const {
  double most = 0;
  for (const PrecisionPlan& plan : plans) {
    if (!crossover || plan.precision < *crossover) most = std::max(most, plan.bound_per_s);
  }
  return most;
}

Result<Done> check_options(const OptimiseOptions& options, const OptionNames& names) {
  MIXCMP_DO(check_precision(options.first_precision, names.first_precision));
  MIXCMP_DO(check_precision(options.last_precision, names.last_precision));
  if (options.first_precision > options.last_precision) {
    return Error{.field = names.first_precision,
                 .message = fmt::format("is above {}", names.last_precision),
                 .received = std::to_string(options.first_precision),
                 .accepted = fmt::format("at most {}", options.last_precision)};
  }
  MIXCMP_DO(check_clock(options.clocks.lane_mhz, names.lane_mhz));
  return check_clock(options.clocks.reference_mhz, names.reference_mhz);
}

Result<Optimisation> optimise(const scene::Scene& scene, const devices::Device& device,
                              const measured::Characterisation& table, const Rates& rates,
                              const OptimiseOptions& options) {
  MIXCMP_DO(check_options(options));
  MIXCMP_TRY(known_chain, design::with_chain_lanes(scene, nullptr));
  MIXCMP_TRY(second_tier, second_tier_lane(scene));
  Findings findings;
  const Rates known = known_pairs(scene, rates, options, findings);
  const PlanningInputs inputs{scene, table, known, options, second_tier};
  const Candidates candidates = candidates_of(inputs, findings);
  if (candidates.lanes.empty()) return no_lane(scene);
  const bool has_references = scene.reference_count() != 0;
  if (has_references && candidates.references.empty()) {
    return no_reference(scene, table);
  }
  const Crossbars crossbars = crossbars_of(inputs, findings);
  Optimisation all{.scene = scene.name,
                   .device = device,
                   .slack = scene.system.slack,
                   .target_mhz = scene.system.target_mhz,
                   .clocks = options.clocks,
                   .references = references_of(inputs, candidates.references, findings),
                   .plans = {},
                   .reference_only = Infeasible{},
                   .crossover = {},
                   .notes = {}};
  if (options.at_least_per_s == 0) {
    all.reference_only =
        fill_with_references(scene, device, all.references, options.clocks.domains);
  }
  for (const auto& [precision, rows] : candidates.lanes) {
    const PlanParts parts{device, crossbars, all.references};
    auto plan = best_plan(inputs, parts, precision, rows, findings);
    if (plan) all.plans.push_back(*std::move(plan));
  }
  all.crossover = crossover_of(all);
  all.basis = findings.basis;
  all.notes.assign(findings.notes.begin(), findings.notes.end());
  if (is_chain(scene)) note_room(all);
  note_slow_reference(all);
  note_full_streams(scene, rates, all);
  note_one_interval(scene, table, all);
  note_unproven(all);
  if (!findings.missing.empty()) return incomplete(scene, findings.missing);
  if (all.plans.empty()) return nothing_to_choose_from(scene, "lane with a known rate");
  return all;
}

}  // namespace mixcmp::optimise
