#include "model/plan/optimise/crossbars.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/cost/performance/performance.hpp"
#include "model/plan/optimise/engine_area.hpp"

namespace mixcmp::optimise {
namespace {

/// Interpolates linearly between two areas, at part / whole of the way; rounds up.
devices::Area between(const devices::Area& low, const devices::Area& high, int part, int whole) {
  devices::Area area;
  for (const devices::Resource& resource : devices::bounded_resources) {
    const std::int64_t rise = std::int64_t{high.*resource.amount} - low.*resource.amount;
    const std::int64_t step = rise >= 0 ? (rise * part + whole - 1) / whole : rise * part / whole;
    area.*resource.amount = static_cast<int>(low.*resource.amount + step);
  }
  return area;
}

}  // namespace

Crossbars crossbars_of(const PlanningInputs& inputs, Findings& findings) {
  const bool has_crossbar =
      inputs.scene.system.references != 0 && inputs.engine() != scene::EngineKind::pairwise;
  if (inputs.options.fixed_communication || !has_crossbar) return {};
  const auto measured = sizes_of(inputs.table, measured::Crossbar{});
  if (measured.empty()) {
    findings.missing.insert("a crossbar");
    return {};
  }
  Crossbars found;
  found.shares.resize(static_cast<std::size_t>(measured.rbegin()->first) + 1);
  int below = 0;
  for (const auto& [ports, row] : measured) {
    const devices::Area low = below == 0 ? row->area : found.shares[below];
    for (int k = below + 1; k <= ports; ++k) {
      found.shares[k] = between(low, row->area, k - below, ports - below);
    }
    if (ports - below > 1) {
      findings.notes.insert("crossbar port counts between measured ones are interpolated");
    }
    if (row->clock) found.mhz = std::min(found.mhz, row->clock->mhz);
    below = ports;
  }
  return found;
}

devices::Area largest_port(const Crossbars& crossbars) {
  devices::Area most;
  for (std::size_t ports = 1; ports < crossbars.shares.size(); ++ports) {
    const devices::Area port = share(crossbars.shares[ports], static_cast<int>(ports));
    for (const devices::Resource& resource : devices::bounded_resources) {
      most.*resource.amount = std::max(most.*resource.amount, port.*resource.amount);
    }
  }
  return most;
}

void note_largest_crossbar(const PrecisionPlan& plan, const Crossbars& crossbars,
                           Findings& findings) {
  const Allocation* chosen = plan.allocation();
  const std::size_t known = crossbars.shares.size();
  if (chosen == nullptr || known == 0 || chosen->reference_count() == 0) return;
  if (plan.second_lanes) return;  // these have as many ports as they need
  const int group = lanes_per_port(plan.problem);
  const int served =
      performance::lanes_of_references(chosen->lane_count() / group, chosen->reference_count())
          .front();
  if (static_cast<std::size_t>(served) + 1 < known) return;
  if (served == plan.problem.max_lanes / group) return;  // it serves all possible lanes
  findings.notes.insert(
      fmt::format("L = {}: a reference serves {} {}, since no larger crossbar was measured",
                  plan.precision, served, group == 1 ? "lanes" : "groups"));
}

}  // namespace mixcmp::optimise
