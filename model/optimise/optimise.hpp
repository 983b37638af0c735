#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/characterise/measurement.hpp"
#include "model/optimise/allocation.hpp"
#include "model/optimise/rates.hpp"
#include "model/scene/scene.hpp"

/// Algorithm 1 of the paper: for each L the best p_L and p_H, and among all L the best.
namespace mixcmp::model {

/// T(L) and T(H): an initiation interval of one cycle at these clocks.
struct ClockChoice {
  std::optional<double> lane_mhz;       ///< of all lanes, whatever the table says
  std::optional<double> reference_mhz;  ///< of all references
  ClockDomains domains = ClockDomains::single;
};

struct OptimiseOptions {
  int first_precision = limits::lane_precision.least;
  int last_precision = limits::lane_precision.most;
  /// What may be used; empty: all that the table has.
  std::vector<std::string> inputs;
  std::vector<BoundChoice> bounds;
  std::vector<std::string> multipliers;
  ClockChoice clocks;
  /// A fixed C(com) instead of our measured scoreboards and crossbar: the paper's numbers.
  std::optional<Area> fixed_communication;
};

/// What a clock of a plan is made of, from the best founded to the least.
enum class ClockBasis {
  given,                    ///< by the user: the paper's
  routed,                   ///< after place and route
  estimate_before_routing,  ///< Yosys' sta
  target,                   ///< nothing measured: the scene's target_mhz is taken as met
};
std::string_view to_string(ClockBasis basis);

/// A row of the table with what it stands for in the integer program.
struct LaneImplementation {
  Measurement measured;
  Area with_streams;  ///< C(L): and the scoreboard around it
  Rate rate;
  LaneKind kind;
};
struct ReferenceImplementation {
  Measurement measured;
  ReferenceKind kind;
};

/// One point of figure 9.
struct PrecisionPlan {
  int precision = 0;
  std::vector<LaneImplementation> lanes;
  AllocationProblem problem;
  AllocationResult result;

  const Allocation* allocation() const { return std::get_if<Allocation>(&result); }
  double throughput_per_s() const;    ///< T(equ); 0 where infeasible
  double recomputation_rate() const;  ///< R_R over all lanes of the plan
  double clock_mhz() const;           ///< of the lanes used; of several domains the lanes' mean
};

struct Optimisation {
  std::string scene;
  Device device;
  double slack = 0;
  double target_mhz = 0;  ///< that registers are placed for
  ClockChoice clocks;
  ClockBasis basis = ClockBasis::target;
  std::vector<ReferenceImplementation> references;
  std::vector<PrecisionPlan> plans;  ///< by precision; those without a row are left out
  AllocationResult reference_only;   ///< as many references as fit: the paper's baseline
  std::optional<int> crossover;      ///< from this L on a lane is dearer than a reference
  std::vector<std::string> notes;    ///< rows that were missing, for the user's eye

  /// The plan with the highest T(equ) up to L_max, the crossover precision; null: none is feasible.
  const PrecisionPlan* best() const;
};

/// Errors where the table has no lane or no reference, or the rates do not know its lanes.
Result<Optimisation> optimise(const Scene& scene, const Device& device,
                              const Characterisation& table, const Rates& rates,
                              const OptimiseOptions& options);

}  // namespace mixcmp::model
