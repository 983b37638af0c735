#pragma once

#include <optional>
#include <vector>

#include "model/plan/optimise/allocation.hpp"

namespace mixcmp::optimise {

/// The kinds of a problem once the clock of the system is fixed; with a clock of 0 each kind keeps
/// its own. Loads and capacities are in units of T(H) of the fastest reference that reaches the
/// clock.
class KindsAtClock {
public:
  KindsAtClock(const AllocationProblem& problem, double clock_per_s);

  /// Whether a kind is useful: it reaches the clock, and no other kind dominates it (at least as
  /// fast, no more load, no more of any resource).
  bool has_lane(int kind) const { return lanes_[kind].useful; }
  bool has_reference(int kind) const { return references_[kind].useful; }

  /// The throughput of a lane; none unless all useful kinds of lanes have the same.
  std::optional<double> common_throughput_per_s() const;
  double lane_throughput_per_s(int kind) const { return lanes_[kind].throughput_per_s; }
  /// T(L) R_R / T(H), or 0 if that is too small for the solver's tolerances.
  double load(int kind) const;
  /// T(H) of this kind relative to the fastest reference, at most 1.
  double capacity(int kind) const;
  /// The number of groups of lanes of this kind that the fastest reference can serve if it serves
  /// no other kind; at most those of `max_lanes`.
  int groups_served(int kind) const;

  /// The useful kinds, lanes by falling T(L) R_R, references by falling T(H): the order of dealing.
  const std::vector<int>& lane_order() const { return lane_order_; }
  const std::vector<int>& reference_order() const { return reference_order_; }

  /// Whether any reference reaches the clock.
  bool some_reference() const { return fastest_per_s_ > 0; }
  bool references_alike() const;

private:
  struct Kind {
    double throughput_per_s = 0;
    double asked_per_s = 0;  ///< T(L) R_R
    bool useful = false;
  };

  static std::vector<int> useful_by_falling(double Kind::*value, const std::vector<Kind>& kinds);

  const AllocationProblem& problem_;
  double fastest_per_s_ = 0;
  std::vector<Kind> lanes_;
  std::vector<Kind> references_;
  std::vector<int> lane_order_;
  std::vector<int> reference_order_;
};

}  // namespace mixcmp::optimise
