#include "model/plan/optimise/candidates.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/design/design.hpp"
#include "model/design/request_beats.hpp"
#include "model/plan/optimise/exact_lanes.hpp"
#include "model/plan/optimise/second_tier.hpp"

namespace mixcmp::optimise {
namespace {

template <class Choice>
bool allows(const std::vector<Choice>& allowed, const Choice& word) {
  return allowed.empty() || std::find(allowed.begin(), allowed.end(), word) != allowed.end();
}

/// A datapath without a product has no kind of multipliers, and any choice admits it.
bool allows(const OptimiseOptions& options, const std::optional<scene::Multipliers>& multipliers) {
  return !multipliers || allows(options.multipliers, *multipliers);
}

/// The lane of a row of lanes as the scene's systems contain them: in segments, or one by one.
const measured::Lane* lane_in(const PlanningInputs& inputs, const measured::ComponentKey& key) {
  if (!inputs.has_engine()) return std::get_if<measured::Lane>(&key);
  const auto* segment = std::get_if<measured::Segment>(&key);
  const int lanes = inputs.scene.system.engine.lanes_per_segment();
  return segment != nullptr && segment->lanes == lanes ? &segment->lane : nullptr;
}

/// In a system of streams, lanes may precede the second tier if they have fewer digits. A table may
/// have other lanes: at least that of the second tier.
bool is_before_second_tier(const PlanningInputs& inputs, int precision) {
  return !inputs.has_second_lanes() || precision < rate_key(*inputs.second_tier).precision;
}

/// Lanes with a measured, unproven bound are used for scenes that ask for them, and only for those.
bool is_trusted(const PlanningInputs& inputs, const measured::Lane& lane) {
  return lane.bound.is_profiled() == inputs.scene.reduced.is_profiled;
}

bool is_wanted(const PlanningInputs& inputs, const measured::Lane& lane) {
  const OptimiseOptions& options = inputs.options;
  const int precision = lane.format.precision();
  return options.first_precision <= precision && precision <= options.last_precision &&
         is_before_second_tier(inputs, precision) &&
         (!lane.inputs || allows(options.inputs, *lane.inputs)) &&
         allows(options.bounds, lane.bound) && allows(options, lane.multipliers) &&
         is_trusted(inputs, lane);
}

/// Whether the scene, whose references have this format, asks for one: by format and sums, its
/// initiation interval unless that is "auto", and its target if it has one. A folded reference must
/// not be faster than the scene's requests.
bool is_wanted(const PlanningInputs& inputs, const LaneFormat& format,
               const measured::Reference& reference) {
  const scene::Scene& scene = inputs.scene;
  const auto& [multipliers, interval, target] = scene.reference_structure;
  const double target_mhz = reference.target_mhz.value_or(scene.system.target_mhz);
  return reference.format == format && reference.sums == scene.reference.sums &&
         allows(inputs.options, reference.multipliers) &&
         design::check_request_beats(scene.system, reference.initiation_interval).ok() &&
         (!interval || *interval == reference.initiation_interval) &&
         (!target || *target == target_mhz);
}

bool has_a_clock(const Rows& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const auto* row) { return row->clock; });
}

void erase_untimed(Rows& rows, const char* what, Findings& findings) {
  if (std::erase_if(rows, [](const auto* row) { return !row->clock; }) == 0) return;
  findings.notes.insert(fmt::format(
      "{0}s without a clock are left out, since others have one; --{0}-mhz counts all", what));
}

}  // namespace

Candidates candidates_of(const PlanningInputs& inputs, Findings& findings) {
  Candidates found;
  Rows all_lanes;
  const LaneFormat format = design::datapath_format(inputs.scene);
  const bool has_references = inputs.scene.reference_count() != 0;
  // A chain of comparisons cannot continue after one that stays undecided.
  const bool decides_all = inputs.engine() == scene::EngineKind::arg_min && !has_references;
  for (const measured::Measurement& row : inputs.table.rows) {
    const auto* reference = std::get_if<measured::Reference>(&row.key);
    if (has_references && reference != nullptr && is_wanted(inputs, format, *reference)) {
      found.references.push_back(&row);
    }
    const measured::Lane* lane = lane_in(inputs, row.key);
    if (lane == nullptr || !is_wanted(inputs, *lane)) continue;
    if (!decides_all || is_exact(inputs.scene, *lane)) all_lanes.push_back(&row);
  }
  const ClockChoice& clocks = inputs.options.clocks;
  if (!clocks.lane_mhz && has_a_clock(all_lanes)) erase_untimed(all_lanes, "lane", findings);
  if (!clocks.reference_mhz && has_a_clock(found.references)) {
    erase_untimed(found.references, "reference", findings);
  }
  for (const measured::Measurement* row : all_lanes) {
    found.lanes[measured::lane_of(row->key)->format.precision()].push_back(row);
  }
  return found;
}

}  // namespace mixcmp::optimise
