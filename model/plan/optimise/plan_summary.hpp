#pragma once

#include <string>

#include "model/plan/optimise/optimise.hpp"

namespace mixcmp::optimise {

/// The figures of a plan that tables show.
struct PlanSummary {
  int precision = 0;  ///< 0: no plan is feasible
  int lanes = 0;
  int references = 0;
  double clock_mhz = 0;
  double recomputation_rate = 0;
  double throughput_per_s = 0;
  devices::Area used;
  /// "95 x s12e8 exact relative embedded, 12 x s12e8 exact relative logic". If any reference is
  /// folded or has its own target, the references follow: "2 x s53e8 embedded ii16".
  std::string kinds;
};
PlanSummary summary_of(const PrecisionPlan& plan);
/// Summarises the best plan.
PlanSummary summary_of(const Optimisation& optimisation);

/// Comparisons per second of a device filled only with references; 0 if none fits.
double baseline_per_s(const Optimisation& optimisation);

}  // namespace mixcmp::optimise
