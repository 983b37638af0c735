#pragma once

#include <optional>
#include <vector>

#include "model/optimise/allocation.hpp"

namespace mixcmp::model {

/// The kinds of a problem once the clock of the system is fixed; a clock of 0 leaves each at its
/// own. Loads and capacities are in units of T(H) of the fastest reference in reach.
class KindsAtClock {
public:
  KindsAtClock(const AllocationProblem& problem, double clock_per_s);

  /// Worth using: fast enough, and no other kind does the same for less of everything.
  bool has_lane(int kind) const { return lanes_[kind].useful; }
  bool has_reference(int kind) const { return references_[kind].useful; }

  /// The throughput of a lane, where that is the same for all kinds of lanes.
  std::optional<double> common_throughput_per_s() const;
  double lane_throughput_per_s(int kind) const { return lanes_[kind].throughput_per_s; }
  /// T(L) R_R / T(H); what is too small for a solver's tolerances counts as 0.
  double load(int kind) const;
  /// T(H) of this kind.
  double capacity(int kind) const;
  /// Lanes of this kind alone that the fastest reference can serve, at most `max_lanes`.
  int lanes_served(int kind) const;

  /// Kinds worth using of lanes, in the order in which they are dealt, and of references in theirs.
  const std::vector<int>& lane_order() const { return lane_order_; }
  const std::vector<int>& reference_order() const { return reference_order_; }

  /// Some reference is in reach.
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

}  // namespace mixcmp::model
