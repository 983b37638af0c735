#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "generator/synthesis/components/component_maker.hpp"

namespace mixcmp::components {

/// How the number of a lane's exponent bits is chosen.
enum class LaneExponents {
  reference,  ///< the reference's number
  ranges,     ///< the fewest that the declared ranges allow
};

/// The components of a scene that are asked for.
struct ComponentQuery {
  std::set<measured::ComponentKind> kinds = {
      measured::ComponentKind::unit, measured::ComponentKind::lane,
      measured::ComponentKind::reference, measured::ComponentKind::fifo,
      measured::ComponentKind::crossbar};
  std::vector<int> precisions;  ///< of lanes: L, or W in fixed point
  std::vector<Bound> bounds;
  std::vector<LaneInputs> inputs = {LaneInputs::exact, LaneInputs::rounded};
  /// `memory` is only for lanes in fixed point.
  std::vector<scene::Multipliers> multipliers = {scene::Multipliers::embedded,
                                                 scene::Multipliers::logic};
  std::vector<int> initiation_intervals = {1};  ///< of references, in cycles
  /// MHz that the registers of references are placed for; none: the system's target.
  std::vector<std::optional<int>> reference_targets = {std::nullopt};
  std::vector<int> crossbars;  ///< numbers of lanes at a crossbar with one reference
  /// If present: only these of the lanes that the query asks for.
  std::optional<std::set<measured::Lane>> lanes = {};
  /// If present: only these of the components that the query asks for.
  std::optional<std::set<measured::ComponentKey>> only = {};
  /// If absent: as reduced.format says, or as many as the reference's where that is "auto".
  std::optional<LaneExponents> exponents;
};

/// The multipliers of references: those that the query asks for except memories; embedded ones if
/// it asks only for memories.
std::vector<scene::Multipliers> reference_multipliers(const ComponentQuery& query);

/// A lane that was asked for and does not exist.
struct MissingLane {
  measured::Lane key;
  Error reason;
};

/// The lanes that the query asks for, whether or not they exist.
Result<std::vector<measured::Lane>> lanes_of(const scene::Scene& scene,
                                             const ComponentQuery& query);

/// Calls `use` with every component of the query, each once. Returns the lanes that do not exist.
/// Fifos and units are those that the query's lanes need, whether or not the query asks for lanes.
/// An error names another component that the scene cannot have.
Result<std::vector<MissingLane>> for_each_component(
    ComponentMaker& maker, const ComponentQuery& query,
    const std::function<void(const Component&)>& use);

}  // namespace mixcmp::components
