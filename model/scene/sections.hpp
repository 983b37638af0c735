#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "model/settings/settings.hpp"

/// The parts of a scene whose keys stand for themselves, one function each: what load_scene puts
/// together. Errors name file, line and key.
namespace mixcmp::model {

/// The settings of one part's two expressions; they live as long as the settings they are from.
struct PartSettings {
  const Setting* f;
  const Setting* g;
  std::vector<IndexValue> indices = {};  ///< what the index of `for` is in this part
};

struct ComparisonSpec {
  std::string name;
  Combination combination = Combination::all;
  std::vector<PartSettings> parts;
  const Setting* index = nullptr;  ///< `for`, whose values are the parts; null: there is none
  Graph graph = {};                ///< once the expressions have been parsed
};

/// [comparison], its expressions not parsed yet.
Result<ComparisonSpec> read_comparison(const Settings& settings,
                                       std::span<const LetDefinition> lets);

/// Replaces comparison.parts by a copy of them for each value of the index of `for`; does nothing
/// where the comparison has no `for`.
Result<Done> expand_parts(const Settings& settings, std::span<const LetDefinition> lets,
                          ComparisonSpec& comparison);

/// The parts in one graph whose inputs begin with `inputs`; the lets that they need are added to
/// `used_lets`.
Result<Graph> read_graph(const Settings& settings, const ComparisonSpec& comparison,
                         std::span<const LetDefinition> lets,
                         const std::vector<std::string>& inputs, std::set<std::string>& used_lets);

/// The mistakes of lets that are none of `used`.
Result<Done> check_unused_lets(const Settings& settings, std::span<const LetDefinition> lets,
                               const std::set<std::string>& used);

struct ReferenceSpec {
  Arithmetic arithmetic;
  Multipliers multipliers = Multipliers::embedded;
};

Result<ReferenceSpec> read_reference(const Settings& settings);

/// [reduced]; exponent bits that depend on ranges are not chosen yet, here and in [[lanes]].
Result<ReducedSpec> read_reduced(const Settings& settings, FloatFormat reference);

/// Reads [[lanes]]; a key that a table leaves out has its value in `defaults`. Empty where there is
/// no [[lanes]].
Result<std::vector<LaneGroupSpec>> read_lane_groups(const Settings& settings, FloatFormat reference,
                                                    const ReducedSpec& defaults);

/// [[references]]; empty where there is none.
Result<std::vector<ReferenceGroupSpec>> read_reference_groups(const Settings& settings,
                                                              Multipliers defaults);

/// Keys of [reduced] that every one of [[lanes]] has, too.
std::vector<std::string> overridden_keys(const Settings& settings);

Result<SystemSpec> read_system(const Settings& settings);

/// Reads [engine] and checks that it fits the inputs, [data] and [system]. Where the section is
/// absent, the kind is EngineKind::none.
Result<EngineSpec> read_engine(const Settings& settings, const std::vector<std::string>& inputs,
                               const std::optional<DataSpec>& data);

Result<std::optional<DataSpec>> read_data(const Settings& settings);

}  // namespace mixcmp::model
