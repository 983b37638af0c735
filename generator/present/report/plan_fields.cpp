#include "generator/present/report/plan_fields.hpp"

#include "generator/present/report/units.hpp"

namespace mixcmp::report {

using devices::Area;
using optimise::PlanSummary;

const table::Fields<PlanSummary>& plan_fields() {
  static const table::Fields<PlanSummary> fields = {
      {{"precision", "L", 2, 1}, &PlanSummary::precision},
      {{"lanes", "p_L", 5, 1}, &PlanSummary::lanes},
      {{"references", "p_H", 4, 1}, &PlanSummary::references},
      {{"clock_mhz", "MHz", 7, 1, "{:.1f}", 1, "{:.6g}"}, &PlanSummary::clock_mhz},
      {{"recomputation_rate", "R_R", 10, 1, "{:.3e}", 1, "{:.6g}"},
       &PlanSummary::recomputation_rate},
      {{"throughput_per_s", "G/s", 8, 1, "{:.2f}", giga, "{:.6g}"}, &PlanSummary::throughput_per_s},
      {{"kinds", "lanes", 0, 2, "{}", 1, "\"{}\""}, &PlanSummary::kinds}};
  return fields;
}

table::Fields<PlanSummary> plan_figures() {
  return {plan_fields().begin(), plan_fields().end() - 1};
}

table::Fields<PlanSummary> plan_choice() {
  return pick(plan_fields(), {"precision", "lanes", "references", "throughput_per_s"});
}

const table::Fields<Area>& area_fields() {
  static const table::Fields<Area> fields = {{{"lut"}, &Area::luts},
                                             {{"ff"}, &Area::registers},
                                             {{"dsp"}, &Area::dsps},
                                             {{"memory"}, &Area::memories}};
  return fields;
}

}  // namespace mixcmp::report
