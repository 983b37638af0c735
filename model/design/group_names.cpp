#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "model/design/design.hpp"
#include "model/scene/bound_choice.hpp"

namespace mixcmp::design {
namespace {

/// The bounds of a lane's parts, each once: "relative", "relative_running_4".
std::string bound_name(const error::Lane& lane) {
  std::string name;
  std::set<std::string> told;
  for (const error::LanePart& part : lane.parts) {
    const std::string bound = to_string(scene::bound_choice(part));
    if (told.insert(bound).second) name += (name.empty() ? "" : "_") + bound;
  }
  return name;
}

/// The traits in which a group may differ from another of its format, in words.
std::vector<std::string> traits_of(const LaneGroup& group) {
  const Arithmetic& arithmetic = group.lane.graph.arithmetic;
  return {std::string(to_string(group.inputs)), bound_name(group.lane),
          std::string(to_string(arithmetic.rounding)),
          std::string(to_string(arithmetic.subnormals)), std::string(to_string(group.multipliers))};
}

/// "RE_f_0.001_RE_g_0.002" for profiled lanes; empty for others.
std::string relative_errors_of(const LaneGroup& group) {
  const auto* interval = std::get_if<error::IntervalDecision>(&group.lane.parts.front().decision);
  if (interval == nullptr) return "";
  return fmt::format("RE_f_{}_RE_g_{}", interval->relative_error_f.get_d(),
                     interval->relative_error_g.get_d());
}

/// Appends their relative errors to names that are still equal: profiled lanes may differ in
/// nothing else.
void tell_errors_apart(std::vector<std::string>& names, const Design& design) {
  const std::vector<std::string> before = names;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string own = relative_errors_of(design.lanes[k]);
    for (std::size_t other = 0; other < names.size(); ++other) {
      if (before[other] != before[k] || relative_errors_of(design.lanes[other]) == own) continue;
      names[k] += "_" + own;
      break;
    }
  }
}

FloatFormat format_of(const LaneGroup& group) {
  return group.lane.graph.arithmetic.format;
}

}  // namespace

std::vector<std::string> lane_group_names(const Design& design) {
  std::vector<std::string> names;
  for (const LaneGroup& group : design.lanes) {
    const std::vector<std::string> traits = traits_of(group);
    std::string& name = names.emplace_back(format_of(group).name());
    for (std::size_t k = 0; k < traits.size(); ++k) {
      const bool tells_apart =
          std::any_of(design.lanes.begin(), design.lanes.end(), [&](const LaneGroup& other) {
            return format_of(other) == format_of(group) && traits_of(other)[k] != traits[k];
          });
      if (tells_apart) name += "_" + traits[k];
    }
  }
  tell_errors_apart(names, design);
  return names;
}

std::vector<std::string> reference_group_names(const Design& design) {
  const auto& groups = design.references;
  const bool alike = std::all_of(groups.begin(), groups.end(), [&](const ReferenceGroup& group) {
    return group.multipliers == groups.front().multipliers;
  });
  std::vector<std::string> names;
  for (const ReferenceGroup& group : groups) {
    std::string& name = names.emplace_back(design.reference.arithmetic.format.name());
    if (!alike) name += fmt::format("_{}", to_string(group.multipliers));
  }
  return names;
}

}  // namespace mixcmp::design
