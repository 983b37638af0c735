#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "model/comparison/data/comparisons.hpp"
#include "model/design/lane.hpp"
#include "model/design/reference_structure.hpp"
#include "model/lane/error/profiled_lane.hpp"
#include "model/lane/fixed/reference_datapath.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::design {

/// Lanes of one kind.
struct LaneGroup {
  Lane lane;
  LaneInputs inputs = LaneInputs::exact;
  scene::Multipliers multipliers = scene::Multipliers::embedded;
  int count = 1;
};

/// References of one kind: all have the same operations in the same format.
struct ReferenceGroup {
  ReferenceStructure structure;
  int count = 1;
};

using fixed::ReferenceDatapath;

/// The datapath of a scene's references: the comparison in the reference format, or a lane in fixed
/// point. That is the one that the scene asks for or, if operands arrive in fixed point, the exact
/// lane of the fewest bits, which has the verdicts of the reference format. It is an error if there
/// is no such lane.
Result<ReferenceDatapath> reference_datapath(const scene::Scene& scene);

/// The datapath of a scene's references; of a scene that can have none, the model of them.
ReferenceDatapath datapath_or_model(const scene::Scene& scene);
/// The format in which references compute: "s53e8", or in fixed point "q9".
LaneFormat datapath_format(const ReferenceDatapath& reference);
/// That of datapath_or_model.
LaneFormat datapath_format(const scene::Scene& scene);

/// A scene with every choice made. The generator builds it, and the golden model evaluates it.
/// Lanes and references are numbered consecutively across their groups.
struct Design {
  std::string name;
  std::vector<std::string> inputs;  ///< names in the order in which operands are packed
  std::vector<LaneGroup> lanes;     ///< at least one
  /// The lanes that decide comparisons which the first lanes leave undecided. None: a reference is
  /// asked at once. In a system of streams there are `count` of them, behind a crossbar; a pairwise
  /// engine has one for each of its groups.
  std::optional<LaneGroup> second_tier;
  std::vector<scene::PartText> parts;  ///< f and g of each part, as in the scene, for display
  std::vector<LetDefinition> lets;     ///< those that f and g need, as in the scene, for display
  std::string planned_clock;           ///< "312.5 MHz (placed and routed)", from a plan; or empty
  TypedGraph reference;  ///< the judges' model of references, unless these round in fixed point
  std::vector<ReferenceGroup> references;  ///< empty: p_H = 0
  scene::SystemSpec system;
  /// One per input: the format in which it arrives. Empty: all have the reference's format.
  std::vector<OperandFormat> operand_formats = {};
  /// The datapath of references in fixed point; also of a system without any, if it rounds.
  std::optional<fixed::FixedLane> fixed_reference = {};

  bool has_fixed_operands() const;  ///< whether any operand arrives in fixed point
  ReferenceDatapath reference_datapath() const;
  /// The datapath that judges evaluate as well, since it rounds; null: `reference` has its
  /// verdicts.
  const fixed::FixedLane* requested_reference() const;
  /// The same, with an entry for each input.
  std::vector<OperandFormat> formats_of_inputs() const;
  int lane_count() const;       ///< p_L
  int reference_count() const;  ///< p_H
  /// The group that lane number `lane` belongs to, as an index of `lanes`.
  std::size_t group_of_lane(int lane) const;
  bool certified() const;  ///< whether every lane's decision is certified
  /// Whether the second tier is behind a crossbar, in a system of streams. Its results are then
  /// marked as recomputed, like those of a reference.
  bool has_second_lanes() const;
};

/// Measures the relative errors of a lane on `sample_count` comparisons. It is profile_error of
/// model/plan/profile, which a design does not link.
using MeasureErrors = error::ProfiledError (*)(const Graph& graph, const TypedGraph& lane,
                                               const data::Comparisons& data,
                                               std::uint64_t sample_count, std::uint64_t seed);

/// Resolves the scene's choices. An unresolved "auto" is an error that names the option to give.
/// Constants of a profiled bound that the scene does not give are measured on `data`. Without data,
/// or without `measure`, their absence is an error.
Result<Design> make_design(const scene::Scene& scene, const data::Comparisons* data,
                           MeasureErrors measure = nullptr);

/// Makes one lane of a scene, as `reduced` wants it; `data` and `measure` as in make_design.
Result<Lane> design_lane(const scene::Scene& scene, const scene::ReducedSpec& reduced,
                         const data::Comparisons* data, MeasureErrors measure = nullptr);

/// The scene with the number of lanes of its arg-min engine. If that is "auto", it is one for each
/// of the data's candidates except the first. It is an error if that number is unknown, or too low
/// for the data. Other scenes are returned unchanged. `data` may be null.
Result<scene::Scene> with_chain_lanes(scene::Scene scene, const data::Comparisons* data);

/// Makes the lanes of a scene's [second_tier]; none if it has no such section. If their number is
/// "auto", it counts as 1.
Result<std::optional<LaneGroup>> design_second_tier(const scene::Scene& scene);

/// Checks that a lane can have such multipliers. A lane that reads squares from memories must be in
/// fixed point and have narrow squares.
Result<Done> check_multipliers(const Lane& lane, scene::Multipliers multipliers);

/// A short name for each group: its format, "s12e8". Groups that share a format also get the traits
/// in which they differ, "s12e8_rounded_logic". They have the same name only if they differ in no
/// trait.
std::vector<std::string> lane_group_names(const Design& design);
std::vector<std::string> reference_group_names(const Design& design);
/// "s53e11" or, in fixed point, "q9".
std::string format_name(const ReferenceDatapath& reference);

/// A lane of a design by the name of its group; "second_tier_q13" is a lane of the second tier,
/// "reference_q9" an exact lane that is the reference.
struct NamedLane {
  std::string name;
  Lane lane;
};
/// One for each group of lanes, then the second tier's and the exact reference, where there is one.
/// A reference that rounds is no lane.
std::vector<NamedLane> named_lanes(const Design& design);

}  // namespace mixcmp::design
