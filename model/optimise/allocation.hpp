#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/common/result.hpp"
#include "model/devices/area.hpp"
#include "model/settings/limits.hpp"

/// Step 3 of the paper's Algorithm 1: how many datapaths of each kind fill a device best.
namespace mixcmp::model {

/// One way to build a lane, with its streams: its area includes the scoreboard around it.
struct LaneKind {
  std::string name;               ///< "s12e8 exact relative embedded"
  double throughput_per_s = 0;    ///< T(L)
  double recomputation_rate = 0;  ///< R_R
  Area area;                      ///< C(L)
};

struct ReferenceKind {
  std::string name;
  double throughput_per_s = 0;  ///< T(H)
  Area area;                    ///< C(H)
};

/// C(com) beyond what lanes and references carry themselves.
struct Communication {
  Area fixed;  ///< the paper's C(com), or what a top has besides
  /// [k]: the share of the crossbar of one reference that serves k lanes, k = 0, 1, ...; lane i is
  /// served by reference i mod p_H. Empty: nothing. Otherwise it bounds the lanes a reference
  /// serves.
  std::vector<Area> crossbar;
};

enum class ClockDomains {
  single,    ///< the system runs at the lowest clock of what it is made of: what `generate` writes
  separate,  ///< lanes and references each at their own, as the paper assumes
};

/// Who may serve a lane; what equation 10 is asked of.
enum class ReferenceSharing {
  /// Lane i is served by reference i mod p_H alone: our crossbar; at each reference. Lanes are
  /// numbered by falling T(L) R_R, references by falling T(H): see `lane_order`.
  dealt,
  pooled,  ///< any reference, as the paper assumes; in total
};

struct AllocationProblem {
  std::vector<LaneKind> lanes;
  std::vector<ReferenceKind> references;
  Communication communication;
  Area available;      ///< A, of the device
  double slack = 0.2;  ///< R_S
  ClockDomains clocks = ClockDomains::single;
  ReferenceSharing sharing = ReferenceSharing::dealt;
  int max_lanes = limits::lanes.most;
  int max_references = limits::references.most;
};

struct Allocation {
  std::vector<int> lanes;       ///< p_L of each kind
  std::vector<int> references;  ///< p_H of each kind
  double throughput_per_s = 0;  ///< T(equ), equation 12
  Area used;
  int lane_count() const;
  int reference_count() const;
};

/// No plan has even one lane (and the references it needs).
struct Infeasible {
  struct Shortage {
    std::string resource;
    int usable = 0;
    int needed = 0;  ///< by the smallest system that has this resource's demand least
  };
  std::vector<Shortage> shortages;  ///< empty: equation 10 is what fails
  std::string message;              ///< a sentence for the user
};

using AllocationResult = std::variant<Allocation, Infeasible>;

/// The order in which a plan lists its kinds of lanes and of references, so that the hardware deals
/// them as equation 10 was checked.
std::vector<int> lane_order(const AllocationProblem& problem);
std::vector<int> reference_order(const AllocationProblem& problem);

/// Finds the best plan by integer linear programming (CBC): maximises equation 12 of the paper
/// under its equations 10 and 11. What CBC finds is checked without its tolerances. Among plans of
/// the same throughput: the fewest references, then the fewest lanes, LUTs, registers, DSPs and
/// memories, then kinds listed first.
AllocationResult allocate(const AllocationProblem& problem);

/// Finds the best plan by trying every one, for small problems: the oracle of the tests.
AllocationResult allocate_exhaustively(const AllocationProblem& problem);

/// The program that `allocate` solves, in the LP format that CBC, GLPK and SCIP read: that of the
/// best plan's p_H and, in a single clock domain, of its clock; where there is no plan, a
/// relaxation that has none either, if there is one.
std::string to_lp(const AllocationProblem& problem);

}  // namespace mixcmp::model
