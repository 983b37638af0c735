#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "model/cost/devices/device.hpp"

/// The rule by which a program that reads a system's counters chooses among the plans of a set.
namespace mixcmp::optimise {

/// All plans on data on which the loaded plan counts this recomputation rate.
struct RatePoint {
  double rate = 0;
  std::vector<double> seconds;  ///< per comparison, of each plan
};

/// Rates of one plan at which it is the fastest of its set.
using RateRange = std::pair<double, double>;

/// Decides after each reading of the counters which plan to load. The counted rate of the loaded
/// plan tells the data: between two points seconds are interpolated, beyond the outer ones they are
/// those of the outer ones. So the rule knows how long each plan would have taken for the
/// comparisons since the last reading. For each plan it keeps the seconds that the plan would have
/// saved; the sum never falls below zero. When a sum reaches the time of a reconfiguration, the
/// rule loads the plan with the largest sum.
///
/// Before a switch at most the time of a reconfiguration and of one reading is lost. A switch has
/// paid for itself when the data have stayed as they are for as long again.
class SwitchingRule {
public:
  /// `points`: of each plan when it is loaded, in any order. Points with the same rate count as
  /// one, their mean. The first plan is loaded. Each plan has at least one point, each point the
  /// seconds of each plan.
  SwitchingRule(std::vector<std::vector<RatePoint>> points, double reconfiguration_seconds);

  /// The plan to load after so many comparisons and recomputations since the last call.
  std::size_t next(std::uint64_t comparisons, std::uint64_t recomputations);

  std::size_t loaded() const { return loaded_; }
  double reconfiguration_seconds() const { return reconfiguration_seconds_; }
  /// The points of each plan when it is loaded: their rates rise, and none is there twice.
  const std::vector<std::vector<RatePoint>>& points() const { return points_; }
  /// The plan's own rates, from 0 to 1, at which it is the fastest.
  std::vector<RateRange> best_rates(std::size_t plan) const;

private:
  std::vector<double> seconds_at(double rate) const;

  std::vector<std::vector<RatePoint>> points_;
  double reconfiguration_seconds_;
  std::size_t loaded_ = 0;
  std::vector<double> ahead_seconds_;  ///< of the loaded plan, by plan
};

/// Seconds in which a device is configured: 600 bits for each of its LUTs, 3.2 Gbit/s (32 bits at
/// 100 MHz, the port of Xilinx' devices). Their large devices have 390 (Virtex-6 LX760) to 580 bits
/// (Artix-7 200T). A system that is loaded from serial memory takes longer.
double configuration_seconds(const devices::Device& device);

}  // namespace mixcmp::optimise
