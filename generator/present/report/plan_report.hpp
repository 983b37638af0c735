#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "generator/present/report/plot.hpp"
#include "generator/present/table/table.hpp"
#include "model/plan/optimise/optimise.hpp"

namespace mixcmp::report {

/// The plan at every precision, as people read it.
table::Table plan_table(const optimise::Optimisation& optimisation);
std::string to_text(const optimise::Optimisation& optimisation);
nlohmann::ordered_json to_json(const optimise::Optimisation& optimisation);

/// CSV with the columns precision, lanes, references, clock_mhz, recomputation_rate,
/// throughput_per_s, lut, ff, dsp, memory, kinds. An infeasible precision has 0 lanes; `kinds` says
/// why.
std::string figure9_csv(const optimise::Optimisation& optimisation);
/// CSV of figures 7 and 8, with the columns precision, inputs, bound, multipliers, lut, ff, dsp,
/// latency_cycles, clock_mhz, clock_source.
std::string figure7_csv(const optimise::Optimisation& optimisation);

/// The paper's figures. Figure 3: T(equ) over p_L / p_H of a full device; 7: LUTs of lanes; 8:
/// their clocks; 9: T(equ) and p_L over L.
Picture figure3(const optimise::Optimisation& optimisation);
Picture figure7(const optimise::Optimisation& optimisation);
Picture figure8(const optimise::Optimisation& optimisation);
Picture figure9(const optimise::Optimisation& optimisation);

}  // namespace mixcmp::report
