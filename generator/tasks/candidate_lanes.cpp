#include "generator/tasks/candidate_lanes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "model/design/slots.hpp"
#include "model/plan/optimise/exact_lanes.hpp"
#include "model/plan/optimise/second_tier.hpp"
#include "model/scene/lane_bound.hpp"

namespace mixcmp::tasks {

using components::ComponentQuery;
using measured::Characterisation;
using measured::ComponentKind;
using measured::Measurement;
using scene::Multipliers;

namespace {

/// The intervals of references where the scene leaves them open: one that is not folded, those with
/// few units, and about the smallest one.
constexpr std::array usual_intervals = {1, 2, 4, 8, 16};
/// Plans interpolate between these crossbars.
constexpr std::array usual_ports = {1, 4, 8, 16, 32, 64, 128};

/// A kind of lane: all but its digits.
using Kind = std::tuple<Bound, std::optional<LaneInputs>, std::optional<Multipliers>>;

Kind kind_of_lane(const measured::Lane& lane) {
  return {lane.bound, lane.inputs, lane.multipliers};
}

}  // namespace

std::vector<Bound> bounds_for(const optimise::OptimiseOptions& choice, const scene::Scene& scene) {
  std::vector<Bound> bounds = choice.bounds;
  if (bounds.empty()) {
    bounds = scene::counted_bounds_of(scene);
    bounds.push_back({.kind = BoundKind::profiled});
  }
  std::erase_if(
      bounds, [&](const Bound& bound) { return bound.is_profiled() != scene.reduced.is_profiled; });
  return bounds;
}

std::vector<LaneInputs> inputs_for(const optimise::OptimiseOptions& choice) {
  if (!choice.inputs.empty()) return choice.inputs;
  return {LaneInputs::exact, LaneInputs::rounded};
}

ComponentQuery query_for(const optimise::OptimiseOptions& choice, const scene::Scene& scene,
                         const optimise::OpenKeys& open) {
  const settings::Limits allowed = settings::lane_precisions(scene.reference.format);
  const auto& [multipliers, interval, target] = scene.reference_structure;
  ComponentQuery query{.kinds = {ComponentKind::lane, ComponentKind::reference},
                       .precisions = {},
                       .bounds = bounds_for(choice, scene),
                       .inputs = inputs_for(choice),
                       .multipliers = choice.multipliers,
                       .reference_targets = {target},
                       .crossbars = {usual_ports.begin(), usual_ports.end()},
                       .exponents = {}};
  const int last = std::min(choice.last_precision, allowed.most);
  for (int k = std::max(choice.first_precision, allowed.least); k <= last; ++k) {
    query.precisions.push_back(k);
  }
  if (query.multipliers.empty()) {
    query.multipliers = {Multipliers::embedded, Multipliers::logic, Multipliers::memory};
  }
  if (open.initiation_interval || !interval) {
    query.initiation_intervals.assign(usual_intervals.begin(), usual_intervals.end());
  } else {
    query.initiation_intervals = {*interval};
  }
  return query;
}

measured::Lane as_asked(measured::Lane lane) {
  if (!lane.multipliers) lane.multipliers = Multipliers::embedded;
  return lane;
}

Result<std::set<measured::Lane>> useful_lanes(const scene::Scene& scene,
                                              const ComponentQuery& query,
                                              const optimise::Rates& rates) {
  MIXCMP_TRY(lanes, lanes_of(scene, query));
  std::map<Kind, int> certain;  // the fewest digits that left nothing undecided
  const auto rate_of = [&](const measured::Lane& lane) {
    return rates.find(optimise::rate_key(lane));
  };
  for (const measured::Lane& lane : lanes) {
    const auto rate = rate_of(lane);
    if (!rate || rate->undecided > 0) continue;
    const int digits = lane.format.precision();
    const auto [place, added] = certain.emplace(kind_of_lane(lane), digits);
    if (!added) place->second = std::min(place->second, digits);
  }
  std::set<measured::Lane> useful;
  for (const measured::Lane& lane : lanes) {
    const auto most = certain.find(kind_of_lane(lane));
    const bool is_longer = most != certain.end() && lane.format.precision() > most->second;
    if (rate_of(lane) && !is_longer) useful.insert(lane);
  }
  return useful;
}

Result<std::vector<ReferenceChoice>> reference_choices(const scene::Scene& scene,
                                                       ComponentQuery query,
                                                       const optimise::OpenKeys& open) {
  if (!scene.has_only_fixed_operands())
    return std::vector{ReferenceChoice{scene, std::move(query)}};
  MIXCMP_TRY(lanes, lanes_of(scene, query));
  std::set<measured::Lane> exact, rounding;
  for (const measured::Lane& lane : lanes) {
    (optimise::is_exact(scene, lane) ? exact : rounding).insert(lane);
  }
  const bool may_have_none = open.references || scene.reference_count() == 0;
  std::vector<ReferenceChoice> choices;
  if (may_have_none && !exact.empty()) {
    ReferenceChoice& none = choices.emplace_back(ReferenceChoice{scene, query});
    none.scene.system.references = 0;
    none.query.lanes = exact;
    none.settings = {"system.references=0"};
  }
  const Result<design::ReferenceDatapath> reference = design::reference_datapath(scene);
  const bool may_have_some = open.references || scene.reference_count() != 0;
  if (may_have_some && reference.ok()) {
    if (!may_have_none) rounding.merge(exact);
    ReferenceChoice& some = choices.emplace_back(ReferenceChoice{scene, query});
    if (open.references) some.scene.system.references.reset();
    some.query.lanes = std::move(rounding);
  }
  if (!choices.empty()) return choices;
  if (!reference.ok()) {
    Error error = reference.error();
    error.file = scene.path.string();
    return error;
  }
  return Error{.file = scene.path.string(),
               .field = "system.references",
               .message = "only exact lanes have no references, and none has so few bits",
               .received = "0",
               .accepted = "at least 1, or lanes of more bits"};
}

Result<LeftOutLanes> left_out_lanes(const scene::Scene& scene, const ComponentQuery& query,
                                    const optimise::Rates& rates,
                                    const std::set<measured::Lane>& lanes, std::string why) {
  MIXCMP_TRY(all, lanes_of(scene, query));
  LeftOutLanes left_out{.precisions = {}, .why = std::move(why)};
  for (const measured::Lane& lane : all) {
    const bool is_known = rates.find(optimise::rate_key(lane)).has_value();
    if (is_known && !lanes.contains(lane)) left_out.precisions.insert(lane.format.precision());
  }
  return left_out;
}

void tell_of(const LeftOutLanes& left_out, optimise::Optimisation& found) {
  std::vector<int> told;
  for (optimise::PrecisionPlan& plan : found.plans) {
    if (!left_out.precisions.contains(plan.precision)) continue;
    told.push_back(plan.precision);
    if (auto* none = std::get_if<optimise::Infeasible>(&plan.result)) {
      none->message =
          fmt::format("some lanes are left out ({}), the others: {}", left_out.why, none->message);
    }
  }
  if (told.empty()) return;
  found.notes.push_back(fmt::format(
      "some lanes of L = {} are left out ({}); the plans there, and a crossover precision, are of "
      "the others",
      fmt::join(told, ", "), left_out.why));
}

std::set<measured::Lane> lanes_by_slots(const Characterisation& table, const scene::Scene& scene) {
  const bool recomputes = scene.system.references.value_or(1) > 0;
  std::map<int, measured::Lane> found;
  for (const Measurement& row : table.rows) {
    const auto* lane = std::get_if<measured::Lane>(&row.key);
    if (lane == nullptr) continue;
    const int cycles = row.latency_cycles + scene.system.input_registers;
    found.emplace(design::slots_for(cycles, recomputes), as_asked(*lane));
  }
  std::set<measured::Lane> lanes;
  for (const auto& [slots, lane] : found) lanes.insert(lane);
  return lanes;
}

Result<std::set<measured::Lane>> with_longer(const std::set<measured::Lane>& promising,
                                             const scene::Scene& scene,
                                             const ComponentQuery& query) {
  constexpr int most_digits_more = 3;
  std::map<Kind, int> longest;
  for (const measured::Lane& lane : promising) {
    int& digits = longest[kind_of_lane(lane)];
    digits = std::max(digits, lane.format.precision());
  }
  MIXCMP_TRY(lanes, lanes_of(scene, query));
  std::set<measured::Lane> all = promising;
  for (const measured::Lane& lane : lanes) {
    const auto known = longest.find(kind_of_lane(lane));
    if (known == longest.end()) continue;
    const int more = lane.format.precision() - known->second;
    if (0 < more && more <= most_digits_more) all.insert(lane);
  }
  return all;
}

}  // namespace mixcmp::tasks
