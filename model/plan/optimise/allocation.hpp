#pragma once

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/base/settings/limits.hpp"
#include "model/cost/devices/area.hpp"
#include "model/plan/optimise/integer_program.hpp"

/// Step 3 of the paper's Algorithm 1: finds how many datapaths of each kind give a device its
/// highest throughput.
namespace mixcmp::optimise {

/// One way to build a lane. Its area includes the scoreboard around the lane. Lanes in lock step
/// come in whole groups, which share the streams around them.
struct LaneKind {
  std::string name;                ///< "s12e8 exact relative embedded"
  double clock_hz = 0;             ///< the highest that it runs at
  double initiation_interval = 1;  ///< cycles from one comparison to the next, on average
  double recomputation_rate = 0;   ///< R_R
  devices::Area area;              ///< C(L), of a whole group
  int group = 1;                   ///< lanes of a group: a plan has a multiple of them
};
/// The area of `lanes` such lanes; `lanes` is a multiple of `kind.group`.
devices::Area area_of(const LaneKind& kind, int lanes);

struct ReferenceKind {
  std::string name;             ///< "s53e8 embedded ii16"
  double clock_hz = 0;          ///< the highest that it runs at
  int initiation_interval = 1;  ///< cycles from one comparison to the next
  devices::Area area;           ///< C(H)
  int latency_cycles = 0;
  bool has_own_target = false;  ///< its registers are not placed for the system's target
};

/// Recomputations per cycle that a lane asks for: R_R divided by its initiation interval.
double asked_per_cycle(const LaneKind& lane);

inline constexpr double any_clock = std::numeric_limits<double>::infinity();

/// T(L) or T(H), in comparisons per second, in a system that runs at `system_hz` at most.
template <class Kind>
double throughput_per_s(const Kind& kind, double system_hz = any_clock) {
  return std::min(kind.clock_hz, system_hz) / kind.initiation_interval;
}

/// The part of C(com), the area of communication, that is not in the areas of lanes and references.
struct Communication {
  devices::Area fixed;  ///< independent of the counts, as the paper's C(com)
  /// Element k is the area of the crossbar's share at a reference that serves k groups of lanes;
  /// reference i mod p_H serves group i. If empty, the crossbar costs nothing and has any number of
  /// ports. Otherwise a reference serves fewer groups than there are elements.
  std::vector<devices::Area> crossbar;
};

enum class ClockDomains {
  single,    ///< one clock, the lowest of all datapaths used: `generate` writes this
  separate,  ///< each datapath runs at its own clock, as the paper assumes
};

/// Which references may serve a lane, and whether equation 10 holds at each reference or in total.
enum class ReferenceSharing {
  /// Only reference i mod p_H serves lane i, as in our crossbar, so equation 10 holds at each
  /// reference. Lanes are numbered by falling T(L) R_R, references by falling T(H). If lanes come
  /// in groups, all of one size, it serves group i.
  round_robin,
  pooled,  ///< any reference, as the paper assumes: equation 10 holds in total
};

struct AllocationProblem {
  std::vector<LaneKind> lanes;
  std::vector<ReferenceKind> references;
  Communication communication;
  devices::Area available;  ///< A, of the device
  double slack = 0.2;       ///< R_S
  ClockDomains clocks = ClockDomains::single;
  ReferenceSharing sharing = ReferenceSharing::round_robin;
  /// Recomputations per cycle of the lanes' clock that the whole system can start, whatever the
  /// number of references.
  double recomputations_per_cycle = std::numeric_limits<double>::infinity();
  double at_least_per_s = 0;  ///< slower plans are not wanted
  Effort effort = {};
  int min_lanes = 1;  ///< a multiple of the groups' lanes
  int max_lanes = settings::limits::lanes.most;
  int max_references = settings::limits::references.most;
};

/// Lanes that share one port of the crossbar: those of a group, if lanes have ports.
int lanes_per_port(const AllocationProblem& problem);

struct Allocation {
  std::vector<int> lanes;       ///< p_L of each kind
  std::vector<int> references;  ///< p_H of each kind
  double throughput_per_s = 0;  ///< T(equ), equation 12
  devices::Area used;
  bool is_proven = true;  ///< no plan is faster, up to Effort::may_lose
  int lane_count() const;
  int reference_count() const;
};

/// No plan is feasible, not even the fewest lanes with the references that they need.
struct Infeasible {
  struct Shortage {
    std::string resource;
    int usable = 0;
    int needed = 0;  ///< by the smallest systems; see `explain_infeasible`
  };
  std::vector<Shortage> shortages;  ///< empty: area is not the reason
  std::string message;              ///< a sentence for the user
};

using AllocationResult = std::variant<Allocation, Infeasible>;

/// The order in which a plan lists its kinds of lanes (falling T(L) R_R) and of references (falling
/// T(H)). The hardware assigns lanes to references in this order, for which equation 10 was
/// checked.
std::vector<int> lane_order(const AllocationProblem& problem);
std::vector<int> reference_order(const AllocationProblem& problem);

/// Finds the best plan by integer linear programming (CBC): maximises equation 12 of the paper
/// under its equations 10 and 11, as far as the effort goes. Every solution of CBC is checked again
/// without CBC's tolerances. Among plans of the same throughput, the best one has the fewest
/// references, then the fewest lanes, LUTs, registers, DSPs and memories, then more of the kinds
/// listed first.
AllocationResult allocate(const AllocationProblem& problem);

/// Finds the best plan by trying all of them, for small problems: the oracle of the tests.
AllocationResult allocate_exhaustively(const AllocationProblem& problem);

/// The program that `allocate` solves, in the LP format that CBC, GLPK and SCIP read. It is the
/// exact program for the best plan's p_H and, in a single clock domain, its clock. If no plan is
/// feasible, it is the relaxation at the lowest clock, which may still be feasible.
std::string to_lp(const AllocationProblem& problem);

}  // namespace mixcmp::optimise
