#include "model/optimise/optimise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "model/design/slots.hpp"
#include "model/optimise/crossover.hpp"
#include "model/performance/performance.hpp"
#include "model/performance/streams.hpp"
#include "model/profile/systems.hpp"

namespace mixcmp::model {
namespace {

constexpr double hertz_per_mhz = 1e6;

bool allows(const std::vector<std::string>& allowed, const std::string& word) {
  return allowed.empty() || std::find(allowed.begin(), allowed.end(), word) != allowed.end();
}

/// The table's reader has parsed it before.
FloatFormat format_of(const Measurement& row) {
  return FloatFormat::parse(row.key.format).value();
}

LaneInputs inputs_of(const std::string& word) {
  return word == to_string(LaneInputs::exact) ? LaneInputs::exact : LaneInputs::rounded;
}

ClockBasis basis_of(const Clock& clock) {
  switch (clock.source) {
    case ClockSource::estimate_before_routing: return ClockBasis::estimate_before_routing;
    case ClockSource::routed: return ClockBasis::routed;
  }
  MIXCMP_CHECK(false);
}

/// Collects the rows of a table into one problem a precision.
class ProblemMaker {
public:
  ProblemMaker(const Scene& scene, const Characterisation& table, const Rates& rates,
               const OptimiseOptions& options)
      : scene_(scene), table_(table), rates_(rates), options_(options) {
    sort_rows();
    leave_out_untimed();
    if (options_.fixed_communication) return;
    add_crossbar();
    slots_ = slots_for(slowest_lane_, scene_.system.references.value_or(1) > 0);
    fifo_ = find_fifo();
  }

  const std::map<int, std::vector<const Measurement*>>& lanes() const { return lanes_; }
  bool has_references() const { return !references_.empty(); }
  ClockBasis basis() const { return basis_; }
  std::vector<std::string> notes() { return {notes_.begin(), notes_.end()}; }

  std::vector<ReferenceImplementation> references() {
    std::vector<ReferenceImplementation> all;
    for (const Measurement* row : references_) {
      const double mhz = clock_of(*row, options_.clocks.reference_mhz);
      const std::string name = row->key.format + " " + row->key.multipliers;
      all.push_back({*row, {name, mhz * hertz_per_mhz, row->area}});
    }
    return all;
  }

  /// None where no lane has a known rate.
  std::optional<PrecisionPlan> plan(int precision, const Device& device,
                                    const std::vector<ReferenceImplementation>& references) {
    PrecisionPlan plan{.precision = precision, .lanes = {}, .problem = {}, .result = Infeasible{}};
    left_out_.clear();
    for (const Measurement* row : lanes_.at(precision)) add_lane(plan, *row);
    for (const LaneImplementation& lane : plan.lanes) plan.problem.lanes.push_back(lane.kind);
    for (const auto& reference : references) plan.problem.references.push_back(reference.kind);
    plan.problem.communication = communication_;
    plan.problem.available = device.available;
    plan.problem.slack = scene_.system.slack;
    plan.problem.clocks = options_.clocks.domains;
    if (plan.lanes.empty() && left_out_.empty()) return std::nullopt;
    plan.result = plan.lanes.empty() ? Infeasible{.shortages = {}, .message = left_out_}
                                     : allocate(plan.problem);
    return plan;
  }

private:
  void sort_rows() {
    for (const Measurement& row : table_.rows) {
      const ComponentKey& key = row.key;
      if (!key.multipliers.empty() && !allows(options_.multipliers, key.multipliers)) continue;
      if (key.kind == ComponentKind::reference) references_.push_back(&row);
      if (key.kind != ComponentKind::lane) continue;
      const int precision = format_of(row).precision();
      const bool wanted = options_.first_precision <= precision &&
                          precision <= options_.last_precision &&
                          allows(options_.inputs, key.inputs) &&
                          allows(options_.bounds, key.bound) && is_trusted(key.bound);
      if (!wanted) continue;
      lanes_[precision].push_back(&row);
      slowest_lane_ = std::max(slowest_lane_, row.latency_cycles);
    }
  }

  using Rows = std::vector<const Measurement*>;

  /// A target that is taken as met would win against every measured clock.
  void leave_out_untimed() {
    Rows all;
    for (const auto& [precision, rows] : lanes_) all.insert(all.end(), rows.begin(), rows.end());
    if (!options_.clocks.lane_mhz && has_a_clock(all)) {
      for (auto& [precision, rows] : lanes_) erase_untimed(rows, "lanes");
      std::erase_if(lanes_, [](const auto& entry) { return entry.second.empty(); });
    }
    if (!options_.clocks.reference_mhz && has_a_clock(references_)) {
      erase_untimed(references_, "references");
    }
  }

  static bool has_a_clock(const Rows& rows) {
    return std::any_of(rows.begin(), rows.end(), [](const auto* row) { return row->clock; });
  }

  void erase_untimed(Rows& rows, const std::string& what) {
    if (std::erase_if(rows, [](const auto* row) { return !row->clock; }) == 0) return;
    notes_.insert(
        fmt::format("{} without a clock are left out, since others have one; --{}-mhz counts all",
                    what, what.substr(0, what.size() - 1)));
  }

  /// Lanes whose bound is not proven are for scenes that ask for them.
  bool is_trusted(const std::string& bound) const {
    return (bound == "profiled") == (scene_.reduced.bound == BoundKind::profiled);
  }

  /// All lanes of a system have the slots that the slowest one needs.
  const Measurement* find_fifo() {
    for (const Measurement& row : table_.rows) {
      if (row.key.kind == ComponentKind::fifo && row.key.ports == slots_) return &row;
    }
    notes_.insert(fmt::format("no fifo of {} slots in the table: it is not counted", slots_));
    return nullptr;
  }

  /// What lies between two measured port counts is interpolated, rounded up.
  void add_crossbar() {
    std::map<int, const Measurement*> measured;
    for (const Measurement& row : table_.rows) {
      if (row.key.kind == ComponentKind::crossbar) measured[row.key.ports] = &row;
    }
    if (measured.empty()) {
      notes_.insert("no crossbar in the table: it is not counted");
      return;
    }
    std::vector<Area>& shares = communication_.crossbar;
    shares.resize(static_cast<std::size_t>(measured.rbegin()->first) + 1);
    int below = 0;
    for (const auto& [ports, row] : measured) {
      for (int k = below + 1; k <= ports; ++k) {
        shares[k] = between(shares[below], row->area, k - below, ports - below);
      }
      if (ports - below > 1) {
        notes_.insert("crossbar port counts between measured ones are interpolated");
      }
      if (row->clock) crossbar_mhz_ = std::min(crossbar_mhz_, row->clock->mhz);
      below = ports;
    }
  }

  static Area between(const Area& low, const Area& high, int part, int whole) {
    Area area;
    for (const Resource& resource : bounded_resources) {
      const int rise = high.*resource.amount - low.*resource.amount;
      area.*resource.amount = low.*resource.amount + (rise * part + whole - 1) / whole;
    }
    return area;
  }

  /// A lane's own clock, and not above that of what surrounds it.
  double clock_of(const Measurement& row, const std::optional<double>& given) {
    if (given) {
      basis_ = ClockBasis::given;
      return *given;
    }
    if (!row.clock) {
      basis_ = ClockBasis::target;
      return scene_.system.target_mhz;
    }
    basis_ = std::max(basis_, basis_of(*row.clock));
    double mhz = std::min(row.clock->mhz, crossbar_mhz_);
    if (fifo_ != nullptr && fifo_->clock) mhz = std::min(mhz, fifo_->clock->mhz);
    return mhz;
  }

  void add_lane(PrecisionPlan& plan, const Measurement& row) {
    const RateKey key{inputs_of(row.key.inputs), row.key.bound, plan.precision};
    const std::optional<Rate> rate = rates_.find(key);
    if (!rate) {
      notes_.insert(
          fmt::format("{} {}: no recomputation rate is known", row.key.inputs, row.key.bound));
      return;
    }
    if (highest_lane_throughput(rate->value()) < 1) {
      left_out_ = "every lane leaves more than half undecided: references alone are faster";
      return;
    }
    note_exponents(row);
    Area area = row.area;
    if (fifo_ != nullptr) area += fifo_->area;
    const std::string name = fmt::format("{} {} {} {}", row.key.format, row.key.inputs,
                                         row.key.bound, row.key.multipliers);
    const double mhz = clock_of(row, options_.clocks.lane_mhz);
    plan.lanes.push_back({row, area, *rate, {name, mhz * hertz_per_mhz, rate->value(), area}});
  }

  /// Fewer exponent bits than the rates were counted with may leave more undecided.
  void note_exponents(const Measurement& row) {
    const int counted = profiled_exponent_bits(scene_);
    if (format_of(row).exponent_bits() >= counted) return;
    notes_.insert(fmt::format("{}: recomputation rates were counted with {} exponent bits",
                              row.key.format, counted));
  }

  const Scene& scene_;
  const Characterisation& table_;
  const Rates& rates_;
  const OptimiseOptions& options_;
  std::map<int, std::vector<const Measurement*>> lanes_;
  std::vector<const Measurement*> references_;
  int slowest_lane_ = 0;
  int slots_ = 0;
  const Measurement* fifo_ = nullptr;
  Communication communication_{.fixed = options_.fixed_communication.value_or(Area{}),
                               .crossbar = {}};
  double crossbar_mhz_ = std::numeric_limits<double>::infinity();
  ClockBasis basis_ = ClockBasis::given;
  std::set<std::string> notes_;
  std::string left_out_;  ///< why the plan at hand may have no lane
};

/// References alone are lanes that need no recomputation.
AllocationResult fill_with_references(const Scene& scene, const Device& device,
                                      const std::vector<ReferenceImplementation>& references,
                                      ClockDomains domains) {
  AllocationProblem problem;
  for (const ReferenceImplementation& reference : references) {
    problem.lanes.push_back(
        {reference.kind.name, reference.kind.throughput_per_s, 0, reference.kind.area});
  }
  problem.available = device.available;
  problem.slack = scene.system.slack;
  problem.clocks = domains;
  return allocate(problem);
}

/// Of datapaths alone, without streams: the paper compares them so.
std::optional<int> crossover_of(const Optimisation& found) {
  std::map<int, std::vector<Area>> lanes;
  for (const PrecisionPlan& plan : found.plans) {
    for (const LaneImplementation& lane : plan.lanes) {
      lanes[plan.precision].push_back(lane.measured.area);
    }
  }
  std::vector<Area> references;
  for (const ReferenceImplementation& reference : found.references) {
    references.push_back(reference.measured.area);
  }
  return crossover_precision(lanes, references, usable(found.device.available, found.slack));
}

Error nothing_to_choose_from(const Scene& scene, const std::string& what) {
  return {.file = scene.path.string(),
          .field = {},
          .message =
              fmt::format("the characterisation has no {} for this scene and these options", what),
          .received = "none",
          .accepted = "a table made by mixcmp characterise"};
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

double PrecisionPlan::throughput_per_s() const {
  const Allocation* chosen = allocation();
  return chosen == nullptr ? 0 : chosen->throughput_per_s;
}

double PrecisionPlan::recomputation_rate() const {
  const Allocation* chosen = allocation();
  if (chosen == nullptr) return 0;
  double all = 0, recomputed = 0;
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    const double throughput = chosen->lanes[k] * lanes[k].kind.throughput_per_s;
    all += throughput;
    recomputed += throughput * lanes[k].kind.recomputation_rate;
  }
  return recomputed / all;
}

double PrecisionPlan::clock_mhz() const {
  const Allocation* chosen = allocation();
  return chosen == nullptr ? 0 : chosen->throughput_per_s / chosen->lane_count() / hertz_per_mhz;
}

const PrecisionPlan* Optimisation::best() const {
  const PrecisionPlan* best = nullptr;
  for (const PrecisionPlan& plan : plans) {
    if (plan.allocation() == nullptr || (crossover && plan.precision >= *crossover)) continue;
    if (best == nullptr || plan.throughput_per_s() > best->throughput_per_s()) best = &plan;
  }
  return best;
}

Result<Optimisation> optimise(const Scene& scene, const Device& device,
                              const Characterisation& table, const Rates& rates,
                              const OptimiseOptions& options) {
  ProblemMaker maker(scene, table, rates, options);
  if (maker.lanes().empty()) return nothing_to_choose_from(scene, "lane");
  if (!maker.has_references()) return nothing_to_choose_from(scene, "reference");
  Optimisation all{.scene = scene.name,
                   .device = device,
                   .slack = scene.system.slack,
                   .target_mhz = scene.system.target_mhz,
                   .clocks = options.clocks,
                   .references = maker.references(),
                   .plans = {},
                   .reference_only = Infeasible{},
                   .crossover = {},
                   .notes = {}};
  all.reference_only = fill_with_references(scene, device, all.references, options.clocks.domains);
  for (const auto& [precision, rows] : maker.lanes()) {
    auto plan = maker.plan(precision, device, all.references);
    if (plan) all.plans.push_back(*std::move(plan));
  }
  all.crossover = crossover_of(all);
  all.basis = maker.basis();
  all.notes = maker.notes();
  if (all.plans.empty()) return nothing_to_choose_from(scene, "lane with a known rate");
  return all;
}

}  // namespace mixcmp::model
