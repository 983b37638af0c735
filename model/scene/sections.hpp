#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/base/number/operand_format.hpp"
#include "model/base/settings/section.hpp"
#include "model/base/settings/settings.hpp"
#include "model/scene/input_ranges.hpp"
#include "model/scene/scene.hpp"

/// Readers of the sections of a scene, one function each; load_scene puts the results together.
/// Errors name file, line and key.
namespace mixcmp::scene {

/// The settings of one part's two expressions. They live as long as their settings::Settings.
struct PartSettings {
  const settings::Setting* f;
  const settings::Setting* g;
  std::vector<IndexValue> indices = {};  ///< the index of `for` and its value in this part
};

struct ComparisonSpec {
  std::string name;          ///< with that of the variant or move
  std::string variant = {};  ///< the name of the [[variant]] or move; empty: [comparison]
  bool is_move = false;      ///< a formulation that mixcmp has found, which no setting has written
  Combination combination = Combination::all;
  std::vector<PartSettings> parts;
  const settings::Setting* index =
      nullptr;                           ///< `for`, whose values are the parts; null: there is none
  Graph graph = {};                      ///< once the expressions have been parsed
  std::set<std::string> used_lets = {};  ///< names of the lets that f and g need
};

/// Reads [comparison] without parsing its expressions.
Result<ComparisonSpec> read_comparison(const settings::Settings& settings,
                                       std::span<const LetDefinition> lets);

/// Replaces comparison.parts by one copy for each value of the index of `for`; does nothing if the
/// comparison has no `for`.
Result<Done> expand_parts(const settings::Settings& settings, std::span<const LetDefinition> lets,
                          ComparisonSpec& comparison);

/// Parses all parts into one graph whose inputs begin with `inputs`; adds the lets that they need
/// to `used_lets`.
Result<Graph> read_graph(const settings::Settings& settings, const ComparisonSpec& comparison,
                         std::span<const LetDefinition> lets,
                         const std::vector<std::string>& inputs, std::set<std::string>& used_lets);

/// Parses the lets that are not in `used`, so that errors in them are found as well.
Result<Done> check_unused_lets(const settings::Settings& settings,
                               std::span<const LetDefinition> lets,
                               const std::set<std::string>& used);

struct ReferenceSpec {
  Arithmetic arithmetic;
  std::optional<FixedPoint> fixed_point;  ///< see Scene
  ReferenceStructureSpec structure;
};

/// Reads [reference]. With the format "exact", which is the default if every input arrives in fixed
/// point, the reference rounds nothing. With a format in fixed point, the floating-point format is
/// the smallest that holds all operands.
/// `graphs`: of all formulations, which share their data and so the reference format.
Result<ReferenceSpec> read_reference(const settings::Settings& settings,
                                     std::span<const Graph> graphs,
                                     const InputDeclarations& declared);

/// Reads [reduced]. Exponent bits that depend on ranges are chosen neither here nor in
/// read_lane_groups.
Result<ReducedSpec> read_reduced(const settings::Settings& settings, FloatFormat reference);

/// Reads [[lanes]]; a key that a table leaves out has its value in `defaults`. Empty if there is no
/// [[lanes]].
Result<std::vector<LaneGroupSpec>> read_lane_groups(const settings::Settings& settings,
                                                    FloatFormat reference,
                                                    const ReducedSpec& defaults);

/// [second_tier] as written.
struct SecondTier {
  std::optional<ReducedSpec> reduced;  ///< none: no second tier
  std::optional<int> count;  ///< none: "auto", or an engine's, which follows from its groups
};
/// Reads [second_tier], which has the keys of [reduced] and, without an engine, `count`.
Result<SecondTier> read_second_tier(const settings::Settings& settings, FloatFormat reference,
                                    EngineKind engine);

/// Reads the keys that [reference] and [[references]] share.
void read_structure(settings::Section& section, ReferenceStructureSpec& structure);

/// Reads [[references]]; empty if there is none.
Result<std::vector<ReferenceGroupSpec>> read_reference_groups(
    const settings::Settings& settings, const ReferenceStructureSpec& defaults);

/// The keys of [reduced] without effect, because each of [[lanes]] has its own.
std::vector<std::string> overridden_keys(const settings::Settings& settings);

Result<SystemSpec> read_system(const settings::Settings& settings);
/// The possible numbers of lanes: more with a pairwise engine, where lanes are cheap.
settings::Limits lane_limits(const settings::Settings& settings);

/// Reads [engine] and checks that it fits the inputs, [data] and [system]. Without the section, the
/// kind is EngineKind::none.
Result<EngineSpec> read_engine(const settings::Settings& settings,
                               const std::vector<std::string>& inputs,
                               const std::optional<data::DataSpec>& data);

Result<std::optional<data::DataSpec>> read_data(const settings::Settings& settings);

}  // namespace mixcmp::scene
