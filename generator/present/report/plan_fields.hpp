#pragma once

#include "generator/present/table/table.hpp"
#include "model/plan/optimise/plan_summary.hpp"

namespace mixcmp::report {

/// The columns of a plan, for every table that has plans: precision, lanes, references, clock_mhz,
/// recomputation_rate, throughput_per_s, kinds.
const table::Fields<optimise::PlanSummary>& plan_fields();
/// The columns of plan_fields() that hold numbers: all but kinds.
table::Fields<optimise::PlanSummary> plan_figures();
/// precision, lanes, references, throughput_per_s: what was chosen, and what it brings.
table::Fields<optimise::PlanSummary> plan_choice();
/// lut, ff, dsp, memory.
const table::Fields<devices::Area>& area_fields();

}  // namespace mixcmp::report
