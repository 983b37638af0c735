#include "model/scene/chosen_formulation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "model/base/common/nearest.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/expression/name.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/lane/error/range_analysis.hpp"
#include "model/scene/moves.hpp"

namespace mixcmp::scene {
namespace {

/// Renames the field of an error in a variant: the key is in a [[variant]], not in [comparison].
Error in_variant(const std::string& variant, Error error) {
  constexpr std::string_view section = "comparison.";
  if (error.field.starts_with(section)) {
    error.field = fmt::format("variant {}, {}", variant, error.field.substr(section.size()));
  }
  return error;
}

std::string place_of_f(const settings::Settings& settings) {
  settings::Section comparison(settings, "comparison");
  const settings::Setting& f = *comparison.find("f");
  return f.line == 0 ? settings::file_of(f) : fmt::format("{}:{}", settings::file_of(f), f.line);
}

/// Describes how two sets of inputs differ: "z is none of them, y is missing".
std::string differences(const std::set<std::string>& named, const std::set<std::string>& wanted) {
  std::vector<std::string> told;
  for (const std::string& name : named) {
    if (!wanted.contains(name)) told.push_back(name + " is none of them");
  }
  for (const std::string& name : wanted) {
    if (!named.contains(name)) told.push_back(name + " is missing");
  }
  return fmt::format("{}", fmt::join(told, ", "));
}

/// Reads a variant instead of [comparison]. It must have the same inputs and gets them in the same
/// order, so that data and ports fit all variants.
Result<ComparisonSpec> read_variant(const Formulation& formulation,
                                    std::span<const LetDefinition> lets,
                                    const settings::Settings& given, const ComparisonSpec& base,
                                    std::set<std::string>& used_lets) {
  const settings::Settings& settings = formulation.settings;
  MIXCMP_TRY(variant, read_comparison(settings, lets));
  MIXCMP_TRY(alone, read_graph(settings, variant, lets, {}, used_lets));
  const std::set<std::string> named(alone.inputs().begin(), alone.inputs().end());
  const auto& inputs = base.graph.inputs();
  const std::set<std::string> wanted(inputs.begin(), inputs.end());
  if (named != wanted) {
    const settings::Section section(settings, "comparison");
    return section.mistake("f",
                           fmt::format("f and g have other inputs than those at {}: {}",
                                       place_of_f(given), differences(named, wanted)),
                           fmt::format("{}", fmt::join(named, ", ")),
                           fmt::format("{}", fmt::join(inputs, ", ")));
  }
  MIXCMP_TRY(graph, read_graph(settings, variant, lets, inputs, variant.used_lets));
  variant.graph = std::move(graph);
  variant.variant = formulation.variant;
  variant.name += "_" + formulation.variant;
  const std::string problem = name_problem(variant.name);
  if (problem.empty()) return variant;
  return formulation.name_mistake(problem + " behind the scene's name", variant.name);
}

/// Leaves out parts that repeat f and g of an earlier part: either combination of a verdict with
/// itself is that verdict.
void drop_repeated_parts(ComparisonSpec& comparison, std::vector<std::string>& notes) {
  std::vector<Sides> parts;
  std::vector<PartSettings> kept;
  for (std::size_t k = 0; k < comparison.parts.size(); ++k) {
    const Sides& sides = comparison.graph.parts()[k];
    const auto known = std::find(parts.begin(), parts.end(), sides);
    if (known == parts.end()) {
      parts.push_back(sides);
      kept.push_back(comparison.parts[k]);
    } else {
      notes.push_back(fmt::format("the part \"{}\" against \"{}\" is part {} again: left out",
                                  std::get<std::string>(comparison.parts[k].f->value),
                                  std::get<std::string>(comparison.parts[k].g->value),
                                  known - parts.begin()));
    }
  }
  comparison.parts = std::move(kept);
  comparison.graph.compare(std::move(parts), comparison.combination);
}

/// Notes constants that the reference format only approximates. A constant that it cannot hold at
/// all is an error in the choice of format.
Result<Done> check_constants(const settings::Settings& settings, const Graph& graph,
                             const ReferenceSpec& reference, std::vector<std::string>& notes) {
  if (reference.fixed_point) return Done{};
  const FloatFormat format = reference.arithmetic.format;
  for (const Node& node : graph.nodes()) {
    if (node.operation != Operation::constant) continue;
    const Bits bits = from_rational(format, node.value);
    const bool vanishes =
        format.is_zero(bits) ||
        (reference.arithmetic.subnormals == Subnormals::flush && format.is_subnormal(bits));
    if (format.is_infinite(bits) || (vanishes && node.value != 0)) {
      const settings::Section section(settings, "reference");
      return section.mistake("format",
                             fmt::format("it cannot hold the constant {}", to_text(node.value)),
                             format.name(), "a format with more exponent bits");
    }
    const mpq_class off = to_rational(format, bits) - node.value;
    if (off == 0) continue;
    notes.push_back(fmt::format("constant {} is inexact in {}: rounded, off by {}",
                                to_text(node.value), format.name(), to_text(off)));
  }
  return Done{};
}

/// Refuses fused sums with more terms than a unit has.
Result<Done> check_sums(const settings::Settings& settings, const Graph& graph, Sums sums) {
  if (sums == Sums::composed || longest_fused_sum(graph) <= max_fused_terms) return Done{};
  const settings::Section section(settings, "reference");
  return section.mistake("sums", fmt::format("a sum has more than {} terms", max_fused_terms),
                         in_quotes(std::string(to_string(sums))), "\"composed\"");
}

/// The exceptional events that ranges leave possible in references.
class Events {
public:
  /// `has_none`: the references do not round.
  Events(const ReferenceSpec& reference, bool has_none,
         const std::vector<std::optional<Range>>& ranges)
      : reference_(reference), has_none_(has_none || reference.fixed_point), ranges_(ranges) {}

  /// Whether one graph has an event that the other is free of.
  bool are_more(const Graph& graph, const Graph& other) const {
    if (has_none_) return false;
    const std::set<error::Event> those = of(graph);
    const std::set<error::Event> others = of(other);
    return !std::includes(others.begin(), others.end(), those.begin(), those.end());
  }

private:
  std::set<error::Event> of(const Graph& graph) const {
    std::set<error::Event> events;
    for (const error::NodeRange& node : error::analyse_ranges(
             reference_graph(graph, reference_.arithmetic), ranges_, error::Infinities::followed)) {
      for (const error::Event event : error::all_events) {
        if (node.may(event)) events.insert(event);
      }
    }
    return events;
  }

  const ReferenceSpec& reference_;
  bool has_none_;
  const std::vector<std::optional<Range>>& ranges_;
};

/// A formulation that mixcmp has found.
struct Move {
  std::string name;
  Graph graph;
};

/// None for scenes with [[variant]] or with comparison.variant = "none".
std::vector<Move> moves_of(const Formulations& formulations, const ComparisonSpec& comparison,
                           const std::vector<std::optional<Range>>& ranges) {
  const auto name_of = [](std::size_t k) { return fmt::format("moved_{}", k + 1); };
  const std::string longest = comparison.name + "_" + name_of(most_moves - 1);
  const bool may_move = formulations.all.size() == 1 && !formulations.is_as_written;
  std::vector<Move> moves;
  if (!may_move || comparison.is_move || !name_problem(longest).empty()) return moves;
  for (Graph& graph : moved(comparison.graph, ranges)) {
    moves.push_back({name_of(moves.size()), std::move(graph)});
  }
  return moves;
}

void take(Move move, ComparisonSpec& comparison) {
  comparison.name += "_" + move.name;
  comparison.variant = std::move(move.name);
  comparison.graph = std::move(move.graph);
  comparison.is_move = true;
  comparison.used_lets.clear();
}

std::vector<std::string> names_of(const Formulations& formulations) {
  std::vector<std::string> names;
  for (std::size_t k = 1; k < formulations.all.size(); ++k) {
    names.push_back(formulations.all[k].variant);
  }
  return names;
}

}  // namespace

Result<ComparisonSpec> read_formulation(const Formulations& formulations,
                                        std::span<const LetDefinition> lets,
                                        std::vector<std::string>& notes,
                                        std::vector<Graph>& graphs) {
  const settings::Settings& settings = formulations.all.front().settings;
  MIXCMP_TRY(base, read_comparison(settings, lets));
  std::set<std::string> used_lets;
  MIXCMP_TRY(graph, read_graph(settings, base, lets, {}, used_lets));
  base.used_lets = used_lets;
  MIXCMP_DO(check_unused_lets(settings, lets, used_lets));
  base.graph = std::move(graph);
  ComparisonSpec chosen = base;
  graphs = {base.graph};
  for (std::size_t k = 1; k < formulations.all.size(); ++k) {
    Result<ComparisonSpec> variant =
        read_variant(formulations.all[k], lets, settings, base, used_lets);
    if (!variant.ok()) return in_variant(formulations.all[k].variant, variant.error());
    graphs.push_back(variant->graph);
    if (k == formulations.chosen) chosen = std::move(variant).value();
  }
  drop_repeated_parts(chosen, notes);
  for (const LetDefinition& let : lets) {
    if (used_lets.contains(let.name)) continue;
    notes.push_back(fmt::format("let {} is not used by f or g", let.name));
  }
  return chosen;
}

Result<Done> check_reference_holds(const settings::Settings& settings, const Graph& graph,
                                   const ReferenceSpec& reference,
                                   std::vector<std::string>& notes) {
  MIXCMP_DO(check_constants(settings, graph, reference, notes));
  return check_sums(settings, graph, reference.arithmetic.sums);
}

Result<ReferenceSpec> read_possible_reference(const settings::Settings& settings,
                                              const Formulations& formulations,
                                              std::span<const Graph> graphs,
                                              const InputDeclarations& declared,
                                              ComparisonSpec& comparison,
                                              std::vector<std::string>& notes) {
  const auto as_written = read_reference(settings, graphs, declared);
  if (as_written.ok()) return as_written;
  for (Move& move : moves_of(formulations, comparison, declared.ranges)) {
    if (!formulations.move.empty() && formulations.move != move.name) continue;
    const auto reference = read_reference(settings, std::span(&move.graph, 1), declared);
    if (!reference.ok()) continue;
    notes.push_back(fmt::format("no reference computes [comparison] ({}): {} is used instead",
                                as_written.error().message, move.name));
    take(std::move(move), comparison);
    return reference;
  }
  return as_written;
}

Result<std::vector<std::string>> settle_move(const settings::Settings& settings,
                                             const Formulations& formulations,
                                             const ReferenceSpec& reference,
                                             const InputDeclarations& declared,
                                             std::span<const OperandFormat> operand_formats,
                                             ComparisonSpec& comparison,
                                             std::vector<std::string>& notes) {
  if (formulations.is_as_written) return std::vector<std::string>();
  std::vector<std::string> names = names_of(formulations);
  const bool rounds_nothing =
      std::all_of(operand_formats.begin(), operand_formats.end(),
                  [](const OperandFormat& each) { return each.fixed() != nullptr; });
  const Events events(reference, rounds_nothing, declared.ranges);
  const auto is_computed = [&](const Graph& graph) {
    std::vector<std::string> further_notes;
    return check_reference_holds(settings, graph, reference, further_notes).ok() &&
           !events.are_more(graph, comparison.graph);
  };
  const bool is_open = !comparison.is_move && !formulations.move.empty();
  std::optional<Move> chosen;
  for (Move& move : moves_of(formulations, comparison, declared.ranges)) {
    if (!is_computed(move.graph)) continue;
    names.push_back(move.name);
    if (is_open && move.name == formulations.move) chosen = std::move(move);
  }
  if (!is_open) return names;
  if (chosen) {
    notes.push_back(
        fmt::format("{} replaces [comparison]: within the ranges both order real numbers alike; "
                    "references may differ where f and g are nearly equal",
                    chosen->name));
    take(*std::move(chosen), comparison);
    return names;
  }
  const bool are_none = names.empty();
  names.emplace_back(no_variant);
  return settings::Section(settings, "comparison")
      .mistake("variant",
               are_none ? "the scene has no [[variant]], and mixcmp finds no other formulation"
                        : "no such variant",
               in_quotes(formulations.move), list_with_nearest(formulations.move, names));
}

}  // namespace mixcmp::scene
