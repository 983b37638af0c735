#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/optimise/optimise.hpp"

namespace mixcmp::model {

/// What a reader wants of one plan.
struct PlanSummary {
  int precision = 0;  ///< 0: no plan is feasible
  int lanes = 0;
  int references = 0;
  double clock_mhz = 0;
  double recomputation_rate = 0;
  double throughput_per_s = 0;
  Area used;
  std::string kinds;  ///< "95 x s12e8 exact relative embedded, 12 x s12e8 exact relative logic"
};
PlanSummary summary_of(const PrecisionPlan& plan);
/// Summarises the best plan.
PlanSummary summary_of(const Optimisation& optimisation);

/// References alone: comparisons a second; 0 where none fits.
double baseline_per_s(const Optimisation& optimisation);

std::string to_text(const Optimisation& optimisation);
nlohmann::ordered_json to_json(const Optimisation& optimisation);

/// precision,lanes,references,clock_mhz,recomputation_rate,throughput_per_s,lut,ff,dsp,memory,kinds;
/// an infeasible precision has 0 lanes and says why in kinds.
std::string figure9_csv(const Optimisation& optimisation);
/// precision,inputs,bound,multipliers,lut,ff,dsp,latency_cycles,clock_mhz,clock_source: figures
/// 7, 8.
std::string figure7_csv(const Optimisation& optimisation);

/// Gnuplot scripts that write SVG to `path`. Figure 3: T(equ) over p_L / p_H of a full device;
/// 7: LUTs of lanes; 8: their clocks; 9: T(equ) and p_L over L.
std::string figure3_script(const Optimisation& optimisation);
std::string figure7_script(const Optimisation& optimisation);
std::string figure8_script(const Optimisation& optimisation);
std::string figure9_script(const Optimisation& optimisation);

}  // namespace mixcmp::model
