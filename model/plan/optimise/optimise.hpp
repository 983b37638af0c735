#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/cost/measured/measurement.hpp"
#include "model/cost/performance/pairwise.hpp"
#include "model/plan/optimise/allocation.hpp"
#include "model/plan/optimise/rates.hpp"
#include "model/plan/optimise/second_tier.hpp"
#include "model/scene/scene.hpp"

/// Algorithm 1 of the paper: finds the best p_L and p_H for each L, and the best L.
namespace mixcmp::optimise {

inline constexpr double hertz_per_mhz = 1e6;

/// The clocks behind T(L) and T(H), at an initiation interval of one cycle. A clock that is not set
/// is the table's, or the scene's target if the table has none.
struct ClockChoice {
  std::optional<double> lane_mhz;       ///< of all lanes
  std::optional<double> reference_mhz;  ///< of all references
  ClockDomains domains = ClockDomains::single;
};

struct OptimiseOptions {
  int first_precision = settings::limits::lane_precision.least;
  int last_precision = settings::limits::lane_precision.most;
  /// A row of the table is used only if its value is listed here; an empty list admits all.
  std::vector<LaneInputs> inputs;
  std::vector<Bound> bounds;
  std::vector<scene::Multipliers> multipliers;
  ClockChoice clocks;
  /// A fixed C(com), as the paper's, instead of our measured scoreboards and crossbar.
  std::optional<devices::Area> fixed_communication;
  /// A search that only wants plans with so many comparisons per second: precisions that surely
  /// have none (throughput_bound) are not solved, nor is the system without lanes. 0: all are.
  double at_least_per_s = 0;
  /// Programs of many kinds are solved in seconds where the last 0.1 % would take minutes.
  Effort effort = {};
  /// Counts frequently undecided lanes of few digits on a sample of large data, with a standard
  /// error of at most 1 %.
  bool samples_rates = false;
  /// The size of a pairwise engine's set: a plan then counts the cycles in which lanes have no
  /// item. None: it counts only those in which words wait, beyond the paper's T(equ).
  std::optional<performance::ItemSet> set = {};
};

/// The limits of a clock that a user may give.
inline constexpr double least_mhz = 0.001;
inline constexpr double most_mhz = 1e6;

/// The names of the options in errors, as the caller's user knows them.
struct OptionNames {
  std::string first_precision = "first_precision";
  std::string last_precision = "last_precision";
  std::string lane_mhz = "lane_mhz";
  std::string reference_mhz = "reference_mhz";
};
/// Refuses precisions that no lane has and clocks beyond their limits.
Result<Done> check_options(const OptimiseOptions& options, const OptionNames& names = {});

/// The source of a plan's clock, the most reliable source first.
enum class ClockBasis {
  given,                    ///< by the user, such as the paper's clocks
  routed,                   ///< after place and route
  estimate_before_routing,  ///< Yosys' sta
  target,                   ///< nothing measured: the scene's target_mhz counts as met
};
std::string_view to_string(ClockBasis basis);

/// A lane of the table, its recomputation rate, and the kind that represents it in the integer
/// program.
struct LaneImplementation {
  measured::Measurement measured;
  devices::Area with_streams;  ///< C(L): the lane and the scoreboard, or its share of a segment
  Rate rate;
  LaneKind kind;
  /// The area of the lane itself; none if only its segment was measured.
  std::optional<devices::Area> datapath;
  /// The area of the second tier's lane itself, behind a segment, if it was measured.
  std::optional<devices::Area> second_tier;

  const measured::Lane& lane() const { return *measured::lane_of(measured.key); }
};
struct ReferenceImplementation {
  measured::Measurement measured;
  ReferenceKind kind;

  const measured::Reference& reference() const { return *measured::reference_of(measured.key); }
};

/// The best plan for one L: a point of figure 9.
struct PrecisionPlan {
  int precision = 0;
  std::vector<LaneImplementation> lanes;
  /// The lanes of a second tier behind a crossbar; none in plans without one, or of an engine.
  std::optional<SecondLanes> second_lanes = {};
  AllocationProblem problem;
  AllocationResult result;
  double bound_per_s = 0;  ///< see throughput_bound; 0 without OptimiseOptions::at_least_per_s
  double busy = 1;         ///< part of their cycles in which lanes compare
  /// `busy` counts lanes that have no item, not only waiting words.
  bool counts_idle_lanes = false;
  bool fills_streams = false;  ///< more lanes would wait for the streams of reports

  const Allocation* allocation() const { return std::get_if<Allocation>(&result); }
  double throughput_per_s() const;    ///< T(equ) times `busy`; 0 where infeasible
  double recomputation_rate() const;  ///< R_R over all lanes of the plan
  double clock_mhz() const;           ///< of the lanes used; with separate clocks their mean
};

/// Whether plan `a` has more comparisons per second than plan `b`, or as many with less of the
/// device.
bool is_better(const PrecisionPlan& a, const PrecisionPlan& b, const devices::Device& device);

struct Optimisation {
  std::string scene;
  devices::Device device;
  double slack = 0;
  double target_mhz = 0;  ///< the clock for which registers were placed
  ClockChoice clocks;
  ClockBasis basis = ClockBasis::target;  ///< the least reliable source of any clock not given
  std::vector<ReferenceImplementation> references;
  std::vector<PrecisionPlan> plans;  ///< by precision; without usable lanes: left out
  AllocationResult reference_only;   ///< as many references as fit: the paper's baseline
  std::optional<int> crossover;      ///< from this L on a lane is dearer than a reference
  std::vector<std::string> notes;    ///< for the user: omissions and limits

  /// The plan with the highest T(equ) below L_max, the crossover precision; null if none is
  /// feasible. Among equally fast plans it is the one that takes the smallest part of the device.
  const PrecisionPlan* best() const;
  /// The highest bound of a precision below L_max: no plan that best() may return is faster.
  double bound_per_s() const;
};

/// Describes the source of the clocks: "estimate before routing", or "given for lanes; for
/// references: estimate before routing" if one clock is given and the other is not.
std::string describe_clocks(const Optimisation& optimisation);

/// Runs Algorithm 1. The number of an arg-min engine's lanes is the scene's. It is an error if
/// check_options refuses the options, if the table has no lane or no reference for these options,
/// or if none of its lanes has a known rate.
Result<Optimisation> optimise(const scene::Scene& scene, const devices::Device& device,
                              const measured::Characterisation& table, const Rates& rates,
                              const OptimiseOptions& options);

}  // namespace mixcmp::optimise
