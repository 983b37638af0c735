#pragma once

#include <limits>
#include <vector>

#include "model/plan/optimise/candidates.hpp"

namespace mixcmp::optimise {

/// The measured crossbars of the systems of a scene.
struct Crossbars {
  std::vector<devices::Area> shares;                     ///< see Communication::crossbar
  double mhz = std::numeric_limits<double>::infinity();  ///< of the slowest
};

/// No shares if the area of communication is given, or if the systems have no crossbar. Shares
/// between two measured port counts are interpolated. Below the smallest measured count its area is
/// used. Larger counts are not planned.
Crossbars crossbars_of(const PlanningInputs& inputs, Findings& findings);

/// The largest area of a port of any of these crossbars.
devices::Area largest_port(const Crossbars& crossbars);

/// Notes it if the plan would have larger crossbars, had any been measured.
void note_largest_crossbar(const PrecisionPlan& plan, const Crossbars& crossbars,
                           Findings& findings);

}  // namespace mixcmp::optimise
