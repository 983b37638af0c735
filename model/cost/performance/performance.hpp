#pragma once

#include <vector>

#include "model/cost/devices/area.hpp"

/// The analytical model of a mixed-precision comparison system: equations 5 to 12 of the paper,
/// with the names of its Table I. docs/theory.md says where we differ and why.
namespace mixcmp::performance {

/// A number of datapaths of one kind.
struct Datapaths {
  int count = 0;                  ///< p_L or p_H
  double throughput_per_s = 0;    ///< T(L) or T(H): comparisons per second of one datapath
  double recomputation_rate = 0;  ///< R_R, 0..1; for lanes only
};

/// Equations 5 and 6: T_A = sum of p T.
double aggregated_throughput(const std::vector<Datapaths>& kinds);

/// Equation 7: N_RR = T_A(L) R_R, summed over the kinds of lanes.
double recomputations_per_s(const std::vector<Datapaths>& lanes);

/// Equation 8: min(T_A(L), T_A(H) / R_R), with R_R the rate over all lanes.
double equivalent_throughput(const std::vector<Datapaths>& lanes,
                             const std::vector<Datapaths>& references);

/// Equation 9: p_L / p_H at which both sides are busy all the time; infinite for R_R = 0.
double optimal_ratio(double lane_throughput_per_s, double reference_throughput_per_s,
                     double recomputation_rate);

/// Equation 10, multiplied out: N_RR <= T_A(H).
bool references_suffice(const std::vector<Datapaths>& lanes,
                        const std::vector<Datapaths>& references);

/// Whether demand <= capacity, with a relative allowance of 1e-12 for rounding: 3 * 0.1 is within
/// 0.3.
bool is_within(double demand, double capacity);

/// The right side of equation 11: A (1 - R_S), rounded down, for each resource.
devices::Area usable(const devices::Area& available, double slack);

/// The number of lanes, out of `lanes`, that the crossbar connects to each of `references`
/// references: reference i mod p_H serves lane i.
std::vector<int> lanes_of_references(int lanes, int references);

/// Equation 7 for each reference by itself: recomputations per second that its lanes ask for if
/// they never stall. Lanes, in the order of their kinds, are dealt to references round robin.
std::vector<double> recomputations_of_references(const std::vector<Datapaths>& lanes,
                                                 int references);

/// Equation 10 for each reference by itself. This is stricter than `references_suffice` if lanes do
/// not divide evenly.
bool each_reference_suffices(const std::vector<Datapaths>& lanes,
                             const std::vector<Datapaths>& references);

/// Equation 8 for each reference by itself, summed. An overloaded reference serves its lanes in
/// turn. Lanes that ask for less than their turn get all that they ask for; the others share the
/// rest equally.
double round_robin_throughput(const std::vector<Datapaths>& lanes,
                              const std::vector<Datapaths>& references);

}  // namespace mixcmp::performance
