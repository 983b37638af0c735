#include "model/scene/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <set>

#include "model/base/common/nearest.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/settings/section.hpp"
#include "model/comparison/expression/name.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/lane/error/exponent_range.hpp"
#include "model/lane/fixed/exact_lane.hpp"
#include "model/scene/chosen_formulation.hpp"
#include "model/scene/data_ranges.hpp"
#include "model/scene/expression_notes.hpp"
#include "model/scene/fixed_operands.hpp"
#include "model/scene/input_ranges.hpp"
#include "model/scene/override_error.hpp"
#include "model/scene/plan.hpp"
#include "model/scene/sections.hpp"
#include "model/scene/variant.hpp"

namespace mixcmp::scene {
namespace {

Result<Done> check_section_names(const settings::Settings& settings) {
  const std::vector<std::string> names = {"comparison", "variant", "let",    "inputs",
                                          "reference",  "reduced", "lanes",  "second_tier",
                                          "references", "system",  "engine", "data"};
  for (const settings::Setting& entry : settings.root.entries) {
    if (std::find(names.begin(), names.end(), entry.key) != names.end()) continue;
    const bool is_section = std::holds_alternative<settings::Setting::Table>(entry.value);
    return settings::mistake_at(entry, entry.key,
                                is_section ? "unknown section" : "a key outside of any section",
                                entry.key, list_with_nearest(entry.key, names));
  }
  return Done{};
}

Result<std::vector<LetDefinition>> read_lets(const settings::Settings& settings) {
  settings::Section section(settings, "let");
  std::vector<LetDefinition> lets;
  for (const settings::Setting& entry : section.entries()) {
    const std::string problem = is_function_name(entry.key)
                                    ? fmt::format("{} is a function", entry.key)
                                    : name_problem(entry.key);
    if (!problem.empty()) {
      section.fail(entry.key, problem, fmt::format("\"{}\"", entry.key),
                   std::string(accepted_names()) + ", no function");
    }
    section.text(entry.key, lets.emplace_back(LetDefinition{.name = entry.key}).text);
  }
  if (const auto error = section.finish()) return *error;
  return lets;
}

/// The parts as they are written; those of a move as they would be written.
std::vector<PartText> texts_of(const ComparisonSpec& comparison) {
  std::vector<PartText> texts;
  if (comparison.is_move) {
    constexpr std::size_t most_characters = 400;
    for (const auto& [f, g] : comparison.graph.parts()) {
      texts.push_back({to_text(comparison.graph, f, most_characters),
                       to_text(comparison.graph, g, most_characters)});
    }
    return texts;
  }
  for (const PartSettings& part : comparison.parts) {
    std::string where;
    for (const IndexValue& index : part.indices) {
      where += fmt::format(" where {} = {}", index.name, index.value);
    }
    texts.push_back({on_one_line(std::get<std::string>(part.f->value)) + where,
                     on_one_line(std::get<std::string>(part.g->value)) + where});
  }
  return texts;
}

std::vector<LetDefinition> texts_of_lets(const ComparisonSpec& comparison,
                                         std::span<const LetDefinition> lets) {
  std::vector<LetDefinition> texts;
  for (const LetDefinition& let : lets) {
    if (comparison.used_lets.contains(let.name)) texts.push_back({let.name, on_one_line(let.text)});
  }
  return texts;
}

/// Chooses the exponent bits of a format written as "s17". A profiled lane checks no range, so it
/// needs the reference's exponent bits.
void choose_exponent_bits(ReducedSpec& reduced, const Graph& graph, FloatFormat reference,
                          const std::vector<std::optional<Range>>& ranges) {
  if (!reduced.exponent_bits_from_ranges || reduced.is_profiled || graph.first_function()) return;
  const Arithmetic arithmetic{*reduced.format, reduced.rounding, reduced.subnormals};
  const LaneInputs inputs = reduced.inputs_beside(reference);
  const int bits = error::lane_exponent_bits(graph, reference, arithmetic, inputs, ranges);
  reduced.format = FloatFormat::make(reduced.format->precision(), bits).value();
}

/// Chooses the bits of a format written as "exact", or explains why no lane is exact. Where
/// operands arrive in floating point, the default bound becomes `grid`.
Result<Done> choose_exact_bits(ReducedSpec& reduced, const Graph& graph, FloatFormat reference,
                               fixed::FixedOptions operands) {
  if (!reduced.is_exact) return Done{};
  const bool all_fixed =
      std::all_of(operands.operand_formats.begin(), operands.operand_formats.end(),
                  [](const OperandFormat& format) { return format.fixed() != nullptr; });
  if (!all_fixed) reduced.error_bound = reduced.error_bound.value_or(BoundKind::grid);
  if (all_fixed && reduced.error_bound == BoundKind::grid) {
    return Error{.field = "reduced.error_bound",
                 .message = "all operands arrive in fixed point: there is no grid to rely on",
                 .received = "grid",
                 .accepted = "auto, constant"};
  }
  operands.bound = reduced.error_bound;
  const auto bits =
      fixed::exact_bits(graph, reference, std::move(operands), settings::limits::fixed_bits.most);
  if (bits.ok()) {
    reduced.fixed_point = FixedPoint{.bits = *bits};
    return Done{};
  }
  const Error& error = bits.error();
  return Error{.field = error.field,
               .message = "no lane is exact: " + error.message,
               .received = "\"exact\" with " + error.received,
               .accepted = error.accepted + ", or a format such as q13"};
}

Error at_format(const settings::Settings& settings, const Error& error) {
  if (!error.file.empty()) return error;
  return settings::Section(settings, "reduced")
      .mistake("format", error.message, error.received, error.accepted);
}

/// The error at the format of one of [[lanes]].
Error in_list(Error error, const Place& place) {
  error.file = place.file;
  error.line = place.line;
  error.field = "lanes.format";
  return error;
}

struct LaneSpecs {
  ReducedSpec reduced;
  std::vector<LaneGroupSpec> groups;
};

/// The ranges, grids and formats of operands, for lanes in fixed point.
fixed::FixedOptions operands_of(const InputDeclarations& declared,
                                const std::vector<OperandFormat>& formats) {
  return {.ranges = declared.ranges, .grids = declared.grids, .operand_formats = formats};
}

/// Reads [reduced] and [[lanes]], and chooses their exponent bits and the bits of exact lanes.
Result<LaneSpecs> read_lanes(const settings::Settings& settings, const Graph& graph,
                             FloatFormat reference, const fixed::FixedOptions& operands) {
  MIXCMP_TRY(reduced, read_reduced(settings, reference));
  MIXCMP_TRY(groups, read_lane_groups(settings, reference, reduced));
  for (LaneGroupSpec& group : groups) {
    choose_exponent_bits(group.reduced, graph, reference, operands.ranges);
    const auto chosen = choose_exact_bits(group.reduced, graph, reference, operands);
    if (!chosen.ok()) return in_list(chosen.error(), group.place);
  }
  if (groups.empty()) {
    const auto chosen = choose_exact_bits(reduced, graph, reference, operands);
    if (!chosen.ok()) return at_format(settings, chosen.error());
  }
  choose_exponent_bits(reduced, graph, reference, operands.ranges);
  return LaneSpecs{std::move(reduced), std::move(groups)};
}

/// Notes keys that no lane reads.
void note_unused_keys(const Scene& scene, const settings::Settings& settings,
                      std::vector<std::string>& notes) {
  for (const std::string& key : overridden_keys(settings)) {
    notes.push_back(fmt::format("reduced.{} is not used: each of [[lanes]] has its own", key));
  }
  bool errors_given = false;
  for (const LaneGroupSpec& group : scene.lane_groups()) {
    const ReducedSpec& reduced = group.reduced;
    if (reduced.is_profiled) return;
    errors_given = errors_given || reduced.relative_error_f || reduced.relative_error_g;
  }
  if (errors_given) {
    notes.emplace_back(
        "reduced.relative_error_f and _g are not used: a certified bound proves its own");
  }
}

/// Refuses tags that cannot name a group's lanes.
Result<Done> check_tag_bits(const settings::Settings& settings, const SystemSpec& system) {
  const int name_bits = std::bit_width(static_cast<unsigned>(system.lanes_per_group - 1));
  if (system.operands != OperandStore::refetched || system.tag_bits >= name_bits) return Done{};
  const settings::Section section(settings, "system");
  return section.mistake("tag_bits", "too few to name the lanes of a group",
                         fmt::format("{}", system.tag_bits),
                         fmt::format("at least {}, or a smaller system.lanes_per_group than {}",
                                     name_bits, system.lanes_per_group));
}

/// Notes keys of a system of streams that an engine does not read.
void note_stream_keys(const SystemSpec& system, const EngineSpec& engine,
                      std::vector<std::string>& notes) {
  if (system.input_registers > 0) {
    notes.emplace_back("system.input_registers is not used: an engine stores what its ports bring");
  }
  if (system.lanes_per_group > 1) {
    notes.emplace_back(
        engine.kind == EngineKind::pairwise
            ? "system.lanes_per_group is not used: groups are those of engine.lanes_per_group"
            : "system.lanes_per_group is not used: each lane of a chain holds a candidate by "
              "itself");
  }
}

/// Notes the ends of ranges that an operand's format rounds out of the range: data with exactly
/// that decimal are then out of range.
void note_missed_ends(const std::vector<std::optional<Range>>& ranges, FloatFormat reference,
                      std::span<const OperandFormat> formats, std::vector<std::string>& notes) {
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const std::optional<Range>& range = ranges[k];
    if (!range) continue;
    const FloatFormat format =
        formats[k].floating() == nullptr ? reference : *formats[k].floating();
    for (const mpq_class& end : {range->low, range->high}) {
      const Bits bits = from_rational(format, end);
      if (!format.is_finite(bits)) continue;
      const mpq_class rounded = to_rational(format, bits);
      if (range->low <= rounded && rounded <= range->high) continue;
      const std::string note = fmt::format(
          "the range end {} rounds out of its range in {}: data of just that value are out of "
          "range",
          to_text(end), format.name());
      if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
    }
  }
}

/// Checks the keys of streams, or notes those that the engine does not read.
Result<Done> check_streams(const settings::Settings& settings, const SystemSpec& system,
                           const EngineSpec& engine, std::vector<std::string>& notes) {
  if (engine.kind == EngineKind::none) return check_tag_bits(settings, system);
  note_stream_keys(system, engine, notes);
  return Done{};
}

/// One per input: its own format, or that of the reference.
std::vector<OperandFormat> formats_of_operands(const InputDeclarations& declared,
                                               FloatFormat reference) {
  std::vector<OperandFormat> formats;
  for (const std::optional<OperandFormat>& each : declared.formats) {
    formats.push_back(each.value_or(OperandFormat(reference)));
  }
  return formats;
}

/// Declares the inputs that arrive in another format than the reference's.
void declare_arrival(Graph& graph, std::span<const OperandFormat> formats, FloatFormat reference) {
  for (std::size_t k = 0; k < formats.size(); ++k) {
    if (formats[k] == OperandFormat(reference)) continue;
    graph.arrives_in(static_cast<int>(k), formats[k]);
  }
}

/// The formats in which operands arrive. The graph then knows of them, data that are drawn have
/// their ranges, and ranges that follow from data are known.
Result<std::vector<OperandFormat>> settle_operands(const settings::Settings& settings,
                                                   FloatFormat reference, Graph& graph,
                                                   InputDeclarations& declared,
                                                   std::optional<data::DataSpec>& data,
                                                   std::vector<std::string>& notes) {
  if (data) MIXCMP_DO(draw_from_ranges(settings, graph.inputs(), declared, *data));
  std::vector<OperandFormat> formats = formats_of_operands(declared, reference);
  MIXCMP_DO(check_operand_formats(settings, graph.inputs(), formats, reference, data));
  declare_arrival(graph, formats, reference);
  MIXCMP_DO(
      take_ranges_from_data(data ? &*data : nullptr, graph.inputs(), reference, formats, declared));
  note_missed_ends(declared.ranges, reference, formats, notes);
  return formats;
}

/// Whether a lane for operands in fixed point rounds nothing.
bool is_exact_lane(const Scene& scene, const ReducedSpec& reduced) {
  const auto lane = fixed::fixed_lane(scene.graph, scene.reference.format,
                                      {.format = *reduced.fixed_point,
                                       .bound = reduced.error_bound,
                                       .ranges = scene.ranges,
                                       .grids = scene.grids,
                                       .operand_formats = scene.operand_formats});
  return lane.ok() && fixed::is_exact(*lane);
}

/// Whether all lanes are exact and so leave nothing to references; nullopt while a format is open.
std::optional<bool> has_exact_lanes(const Scene& scene) {
  if (!scene.has_fixed_operands()) return false;
  const std::vector<LaneGroupSpec> groups = scene.lane_groups();
  const auto is_open = [](const LaneGroupSpec& group) { return !group.reduced.fixed_point; };
  if (std::any_of(groups.begin(), groups.end(), is_open)) return std::nullopt;
  return std::all_of(groups.begin(), groups.end(), [&](const LaneGroupSpec& group) {
    return is_exact_lane(scene, group.reduced);
  });
}

/// Sets what a scene leaves open of references in fixed point. They are not folded. If all operands
/// arrive in fixed point, there are none behind exact lanes or if no lane is exact, otherwise one.
/// An arg-min engine has one behind all other lanes; if there is no exact lane, the design refuses
/// it. While formats of lanes are open, so is the number.
void choose_references(Scene& scene) {
  if (!scene.has_fixed_references()) return;
  const auto close = [](ReferenceStructureSpec& structure) {
    structure.initiation_interval = structure.initiation_interval.value_or(1);
  };
  close(scene.reference_structure);
  for (ReferenceGroupSpec& group : scene.references) close(group.structure);
  if (!scene.has_only_fixed_operands()) return;
  if (!scene.references.empty() || scene.system.references) return;
  const std::optional<bool> are_exact = has_exact_lanes(scene);
  if (!are_exact) return;
  const bool can_have_some =
      scene.reference_fixed_point ||
      fixed::exact_bits(scene.graph, scene.reference.format,
                        {.ranges = {}, .operand_formats = scene.operand_formats},
                        settings::limits::fixed_bits.most)
          .ok();
  const bool needs_some = scene.system.engine.kind == EngineKind::arg_min;
  scene.system.references = !*are_exact && (can_have_some || needs_some) ? 1 : 0;
}

/// Refuses an arg-min engine without references, unless its lanes are exact: its chain of
/// comparisons cannot continue after one that stays undecided.
Result<Done> check_chain_decides(const settings::Settings& settings, const Scene& scene) {
  const bool is_chain = scene.system.engine.kind == EngineKind::arg_min;
  if (!is_chain || scene.reference_count() != 0 || has_exact_lanes(scene).value_or(true)) {
    return Done{};
  }
  std::string accepted = fmt::format("1..{}", max_references);
  if (scene.has_only_fixed_operands()) accepted += ", or 0 with reduced.format = \"exact\"";
  return settings::Section(settings, "system")
      .mistake("references", "the arg-min engine needs every verdict", "0", accepted);
}

/// Notes what rules out lanes in fixed point, if the format of lanes is open.
void note_open_format(Scene& scene) {
  const ReducedSpec& reduced = scene.reduced;
  const bool is_open = !reduced.format && !reduced.fixed_point && scene.lanes.empty();
  if (!is_open || reduced.is_profiled || scene.has_fixed_operands()) return;
  const auto note = fixed_point_note(scene.graph, scene.reference.format, scene.ranges);
  if (note) scene.notes.push_back(*note);
}

/// Tells for each input whether its range is that of its data.
std::vector<bool> are_from_data(const InputDeclarations& declared) {
  std::vector<bool> from_data;
  for (const settings::Setting* entry : declared.from_data) from_data.push_back(entry != nullptr);
  return from_data;
}

/// Sets and checks what depends on several sections of a scene that has been read.
Result<Done> complete(const settings::Settings& settings, Scene& scene) {
  choose_references(scene);
  MIXCMP_DO(check_chain_decides(settings, scene));
  MIXCMP_DO(check_fixed_operands(settings, scene));
  note_open_format(scene);
  if (scene.reference_count() != 0) {
    if (auto note = divider_note(scene.graph)) scene.notes.push_back(std::move(*note));
  }
  note_unused_keys(scene, settings, scene.notes);
  return Done{};
}

Result<Scene> load_with(const SceneSource& source, std::span<const std::string> overrides) {
  MIXCMP_TRY(read, read_scene_settings(source, overrides));
  MIXCMP_TRY(scene, interpret(std::move(read)));
  scene.settings.assign(overrides.begin(), overrides.end());
  return scene;
}

}  // namespace

Result<Scene> interpret(SceneSettings read) {
  MIXCMP_DO(check_section_names(read.settings));
  MIXCMP_TRY(formulations, read_formulations(read.settings));
  const settings::Settings& settings = formulations.all[formulations.chosen].settings;
  std::vector<std::string> notes;
  MIXCMP_TRY(lets, read_lets(settings));
  std::vector<Graph> graphs;
  MIXCMP_TRY(comparison, read_formulation(formulations, lets, notes, graphs));
  Graph& graph = comparison.graph;
  MIXCMP_TRY(declared, read_inputs(settings, graph.inputs()));
  MIXCMP_TRY(reference,
             read_possible_reference(settings, formulations, graphs, declared, comparison, notes));
  const FloatFormat format = reference.arithmetic.format;
  MIXCMP_DO(check_reference_holds(settings, graph, reference, notes));
  MIXCMP_TRY(data, read_data(settings));
  MIXCMP_TRY(operand_formats, settle_operands(settings, format, graph, declared, data, notes));
  MIXCMP_TRY(variants, settle_move(read.settings, formulations, reference, declared,
                                   operand_formats, comparison, notes));
  MIXCMP_TRY(lanes, read_lanes(settings, graph, format, operands_of(declared, operand_formats)));
  MIXCMP_TRY(references, read_reference_groups(settings, reference.structure));
  MIXCMP_TRY(system, read_system(settings));
  if (data) {
    for (std::string& note : pairing_notes(graph, data->pairing)) notes.push_back(std::move(note));
  }
  MIXCMP_TRY(engine, read_engine(settings, graph.inputs(), data));
  MIXCMP_DO(check_streams(settings, system, engine, notes));
  MIXCMP_TRY(second_tier, read_second_tier(settings, format, engine.kind));
  const bool has_no_tier = engine.kind != EngineKind::arg_min && !second_tier.reduced;
  Scene scene{.path = settings.path,
              .name = comparison.name,
              .variant = comparison.variant,
              .variants = std::move(variants),
              .variants_are_moves = formulations.all.size() == 1,
              .parts = texts_of(comparison),
              .lets = texts_of_lets(comparison, lets),
              .graph = std::move(graph),
              .ranges = std::move(declared.ranges),
              .grids = std::move(declared.grids),
              .data_ranges = are_from_data(declared),
              .operand_formats = std::move(operand_formats),
              .reference = reference.arithmetic,
              .reference_fixed_point = reference.fixed_point,
              .reference_structure = reference.structure,
              .reduced = std::move(lanes.reduced),
              .lanes = std::move(lanes.groups),
              .second_tier = std::move(second_tier.reduced),
              .second_tier_count = second_tier.count,
              .leaves_out_second_tier = has_no_tier && settings.root.find("second_tier") != nullptr,
              .references = std::move(references),
              .system = with_engine(std::move(system), engine),
              .data = std::move(data),
              .plan = std::move(read.plan),
              .notes = std::move(notes)};
  MIXCMP_DO(complete(settings, scene));
  return scene;
}

Result<Scene> load_scene(const SceneSource& source, std::span<const std::string> overrides) {
  Result<Scene> scene = load_with(source, overrides);
  if (scene.ok()) return scene;
  return with_setting(scene.error(), overrides, [&](std::span<const std::string> some) {
    const Result<Scene> attempt = load_with(source, some);
    return attempt.ok() ? std::nullopt : std::optional(attempt.error());
  });
}

LaneInputs ReducedSpec::inputs_beside(FloatFormat reference) const {
  if (fixed_point) return LaneInputs::exact;
  return format ? inputs.in_lane(format->precision(), reference.precision()) : inputs;
}

std::string ReducedSpec::format_name() const {
  if (fixed_point) return fixed_point->name();
  return format ? format->name() : "auto";
}

}  // namespace mixcmp::scene
