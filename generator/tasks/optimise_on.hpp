#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/tasks/optimise.hpp"
#include "model/cost/devices/device.hpp"
#include "model/plan/optimise/crossover.hpp"

/// The plans of one scene on many devices.
namespace mixcmp::tasks {

struct OptimiseOnRequest {
  /// The request for a plan on one device, by predicted areas: nothing is synthesised.
  OptimiseRequest optimise;
  std::vector<std::string> devices;  ///< names that find_device knows; at least one
};

/// The fastest plan on a device.
struct DevicePlan {
  devices::Device device;
  std::vector<std::string> alike;  ///< other devices of its family with the same resources
  double six_input_luts = 0;       ///< see components::six_input_luts
  optimise::PlanSummary plan;      ///< its precision is 0 if there is none
  optimise::LargestShare used;     ///< of what R_S leaves
  std::string interface;
  std::vector<std::string> settings;  ///< those that make its scene, beyond the request's
  std::string why_none;               ///< why there is no plan
};

struct OptimiseOnResult {
  std::vector<DevicePlan> devices;  ///< the smallest first, by LUTs of six inputs
  /// Devices that need no plan: each has as much as a smaller one of its family that is fast
  /// enough, or no more of anything than one that is too slow.
  int passed_over = 0;
  /// The smallest system that is fast enough, on the first such device; none without a least
  /// throughput.
  std::optional<OptimiseResult> smallest;
  std::vector<std::string> notes;  ///< for the user
};

/// Finds the fastest plan on each device and, if the request has a least throughput, the smallest
/// device on which one reaches it. Rates are counted once. It is an error if no device has a plan
/// that is wanted.
Result<OptimiseOnResult> optimise_on(const OptimiseOnRequest& request, const LoadedScene& loaded);

}  // namespace mixcmp::tasks
