#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "model/base/common/cases.hpp"
#include "model/design/design.hpp"
#include "model/scene/lane_bound.hpp"

namespace mixcmp::design {
namespace {

/// The bounds of a lane's parts, each once: "relative", "relative_running_4".
std::string bound_name(const error::Lane& lane) {
  std::string name;
  std::set<std::string> told;
  for (const error::LanePart& part : lane.parts) {
    const std::string bound = to_string(scene::bound_of(part));
    if (told.insert(bound).second) name += (name.empty() ? "" : "_") + bound;
  }
  return name;
}

/// The bounds of a lane's parts, each once: "norm", "norm_constant".
std::string bound_name(const fixed::FixedLane& lane) {
  const bool has_constant =
      std::any_of(lane.parts.begin(), lane.parts.end(), [](const fixed::FixedPart& part) {
        return std::holds_alternative<fixed::ConstantThresholds>(part.criterion);
      });
  const std::string name = has_norm(lane) ? "norm" : has_running(lane) ? "running" : "";
  if (name.empty()) return "constant";
  return has_constant ? name + "_constant" : name;
}

/// "exact", "rounded", "inputs_20".
std::string inputs_name(LaneInputs inputs) {
  return (inputs.number() ? "inputs_" : "") + to_string(inputs);
}

/// The traits in which a group may differ from another one of its format, in words.
std::vector<std::string> traits_of(const LaneGroup& group) {
  const std::string multipliers(to_string(group.multipliers));
  if (const auto* fixed = std::get_if<fixed::FixedLane>(&group.lane)) {
    return {bound_name(*fixed), multipliers};
  }
  const error::Lane& lane = float_lane(group.lane);
  const Arithmetic& arithmetic = lane.graph.arithmetic;
  return {inputs_name(group.inputs), bound_name(lane), std::string(to_string(arithmetic.rounding)),
          std::string(to_string(arithmetic.subnormals)), multipliers};
}

/// RE_f and RE_g of profiled lanes; none for others.
using RelativeErrors = std::optional<std::pair<mpq_class, mpq_class>>;

RelativeErrors relative_errors_of(const LaneGroup& group) {
  const auto* lane = std::get_if<error::Lane>(&group.lane);
  if (lane == nullptr) return std::nullopt;
  const auto* interval = std::get_if<error::IntervalCriterion>(&lane->parts.front().criterion);
  if (interval == nullptr) return std::nullopt;
  return std::pair(interval->relative_error_f, interval->relative_error_g);
}

/// Tells groups apart whose names are still equal: profiled lanes may differ only in RE_f and RE_g.
/// Each pair of errors gets a number, "_RE_1", "_RE_2", since the errors themselves cannot be part
/// of a module's name.
void tell_errors_apart(std::vector<std::string>& names, const Design& design) {
  const std::vector<std::string> before = names;
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::vector<RelativeErrors> different;
    for (std::size_t other = 0; other < names.size(); ++other) {
      const RelativeErrors errors = relative_errors_of(design.lanes[other]);
      if (before[other] != before[k]) continue;
      if (std::find(different.begin(), different.end(), errors) == different.end()) {
        different.push_back(errors);
      }
    }
    if (different.size() == 1) continue;
    const auto own =
        std::find(different.begin(), different.end(), relative_errors_of(design.lanes[k]));
    names[k] += fmt::format("_RE_{}", own - different.begin() + 1);
  }
}

}  // namespace

std::vector<std::string> lane_group_names(const Design& design) {
  std::vector<std::string> names;
  for (const LaneGroup& group : design.lanes) {
    const std::vector<std::string> traits = traits_of(group);
    std::string& name = names.emplace_back(format_name(group.lane));
    for (std::size_t k = 0; k < traits.size(); ++k) {
      const bool tells_apart =
          std::any_of(design.lanes.begin(), design.lanes.end(), [&](const LaneGroup& other) {
            return format_name(other.lane) == format_name(group.lane) &&
                   traits_of(other)[k] != traits[k];
          });
      if (tells_apart) name += "_" + traits[k];
    }
  }
  tell_errors_apart(names, design);
  return names;
}

std::string format_name(const ReferenceDatapath& reference) {
  return datapath_format(reference).name();
}

std::vector<std::string> reference_group_names(const Design& design) {
  const auto& groups = design.references;
  const auto alike = [&](auto trait) {
    return std::all_of(groups.begin(), groups.end(), [&](const ReferenceGroup& group) {
      return group.structure.*trait == groups.front().structure.*trait;
    });
  };
  using Structure = ReferenceStructure;
  const bool same_multipliers = alike(&Structure::multipliers);
  const bool same_target = alike(&Structure::target_mhz);
  std::vector<std::string> names;
  for (const ReferenceGroup& group : groups) {
    std::string& name = names.emplace_back(format_name(design.reference_datapath()));
    if (design.reference.arithmetic.sums == Sums::fused) name += "_fused";
    const auto& [multipliers, interval, target_mhz] = group.structure;
    if (!same_multipliers) name += fmt::format("_{}", to_string(multipliers));
    if (interval > 1) name += fmt::format("_ii{}", interval);
    if (!same_target && target_mhz) name += fmt::format("_{}mhz", *target_mhz);
  }
  return names;
}

std::vector<NamedLane> named_lanes(const Design& design) {
  std::vector<NamedLane> lanes;
  const std::vector<std::string> names = lane_group_names(design);
  for (std::size_t k = 0; k < names.size(); ++k) lanes.push_back({names[k], design.lanes[k].lane});
  if (design.second_tier) {
    const Lane& lane = design.second_tier->lane;
    lanes.push_back({"second_tier_" + format_name(lane), lane});
  }
  if (design.fixed_reference && design.requested_reference() == nullptr) {
    const Lane lane = *design.fixed_reference;
    lanes.push_back({"reference_" + format_name(lane), lane});
  }
  return lanes;
}

}  // namespace mixcmp::design
