#include "model/scene/expression_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "model/base/settings/limits.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::scene {
namespace {

/// The same column's input for the other item: "ci_2" for "cj_2".
std::string fellow_of(const std::string& input, const data::ItemColumn& column) {
  const std::size_t letter = input.find_last_not_of("0123456789_");
  std::string fellow = input;
  fellow[letter] = column.second ? 'i' : 'j';
  return fellow;
}

bool has_input(const Graph& graph, const std::string& name) {
  const auto& inputs = graph.inputs();
  return std::find(inputs.begin(), inputs.end(), name) != inputs.end();
}

std::vector<std::string> lonely_inputs(const Graph& graph) {
  std::vector<std::string> lonely;
  for (const std::string& input : graph.inputs()) {
    const auto column = data::item_column(input);
    if (column && !has_input(graph, fellow_of(input, *column))) lonely.push_back(input);
  }
  return lonely;
}

std::vector<bool> cone_of(const Graph& graph, NodeId root) {
  std::vector<bool> needed(graph.nodes().size());
  needed[static_cast<std::size_t>(root)] = true;
  for (std::size_t id = needed.size(); id-- > 0;) {
    if (!needed[id]) continue;
    const Node& node = graph.nodes()[id];
    for (int k = 0; k < arity(node.operation); ++k) {
      needed[static_cast<std::size_t>(node.operands[static_cast<std::size_t>(k)])] = true;
    }
  }
  return needed;
}

/// Whether f uses no candidate except i, and g is f with j instead of i. A graph merges equal
/// nodes, so f rebuilt with j yields the node of g if and only if the two are equal.
bool is_one_cost(const Graph& graph, const Sides& part) {
  const std::vector<bool> of_f = cone_of(graph, part.f);
  Graph renamed = graph;
  std::vector<NodeId> image(of_f.size(), -1);
  for (std::size_t id = 0; id < of_f.size(); ++id) {
    if (!of_f[id]) continue;
    const Node& node = graph.nodes()[id];
    const auto operand = [&](std::size_t k) {
      return image[static_cast<std::size_t>(node.operands[k])];
    };
    if (node.operation == Operation::input) {
      const std::string& input = graph.inputs()[static_cast<std::size_t>(node.input)];
      const auto column = data::item_column(input);
      if (column && column->second) return false;
      image[id] = renamed.input(column ? fellow_of(input, *column) : input);
    } else if (node.operation == Operation::constant) {
      image[id] = static_cast<NodeId>(id);
    } else if (node.function) {
      image[id] = renamed.apply(*node.function, operand(0));
    } else {
      image[id] =
          renamed.apply(node.operation, operand(0), arity(node.operation) == 2 ? operand(1) : -1);
    }
  }
  return image[static_cast<std::size_t>(part.f)] == part.g;
}

constexpr std::size_t most_characters = 60;  ///< of an operation in a note

/// The first of these operations in f or g that `is_meant`, and its place; none without one.
template <class IsMeant>
std::optional<std::pair<NodeId, std::string>> first_of(const Graph& graph, Operation operation,
                                                       IsMeant is_meant) {
  const std::vector<Sides>& parts = graph.parts();
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (const auto& [name, side] :
         {std::pair("f", parts[part].f), std::pair("g", parts[part].g)}) {
      const std::vector<bool> needed = cone_of(graph, side);
      for (NodeId id = 0; id <= side; ++id) {
        const auto place = static_cast<std::size_t>(id);
        if (!needed[place] || graph.nodes()[place].operation != operation || !is_meant(id))
          continue;
        return std::pair(id, parts.size() == 1 ? name : fmt::format("{} of part {}", name, part));
      }
    }
  }
  return std::nullopt;
}

/// Why there is no lane in this format; empty if there is one.
std::string why_no_lane(const Graph& graph, FloatFormat reference,
                        const std::vector<std::optional<Range>>& ranges, FixedPoint format) {
  const auto lane = fixed::fixed_lane(graph, reference, {.format = format, .ranges = ranges});
  return lane.ok() ? "" : lane.error().message;
}

}  // namespace

std::optional<std::string> fixed_point_note(const Graph& graph, FloatFormat reference,
                                            const std::vector<std::optional<Range>>& ranges) {
  constexpr auto none = "no lane in fixed point can be planned: ";
  const auto quotient = first_of(graph, Operation::divide,
                                 [&](NodeId id) { return !fixed::divides_by_constant(graph, id); });
  const auto root = first_of(graph, Operation::square_root, [](NodeId) { return true; });
  const bool has_all_ranges = std::all_of(ranges.begin(), ranges.end(),
                                          [](const auto& range) { return range.has_value(); });
  if ((!root && !quotient) || !has_all_ranges) return std::nullopt;
  // More digits leave the radicand of a root or a divisor less room for errors below 0.
  const int most_bits = settings::lane_fixed_bits(reference).most;
  const auto why = [&](FixedPoint format) { return why_no_lane(graph, reference, ranges, format); };
  const std::string fixed = why({.bits = most_bits});
  const bool has_block = why({.bits = most_bits, .is_block = true}).empty();
  if (fixed.empty() || has_block) return std::nullopt;
  return none + fixed;
}

std::optional<std::string> divider_note(const Graph& graph) {
  const auto quotient = first_of(graph, Operation::divide,
                                 [&](NodeId id) { return fixed::divides_by_constant(graph, id); });
  if (!quotient) return std::nullopt;
  return fmt::format(
      "references have a divider for {} in {}, which rounds once; lanes multiply by the rounded "
      "reciprocal where it is a normal number of their format, as both do in x * (1 / 24)",
      to_text(graph, quotient->first, most_characters), quotient->second);
}

std::vector<std::string> pairing_notes(const Graph& graph, data::Pairing pairing) {
  if (pairing != data::Pairing::all && pairing != data::Pairing::arg_min) return {};
  const char* item = pairing == data::Pairing::all ? "item" : "candidate";
  std::vector<std::string> notes;
  for (const std::string& input : lonely_inputs(graph)) {
    const data::ItemColumn column = *data::item_column(input);
    notes.push_back(
        fmt::format("the input {} is a column of {} {} by its last letter, and there "
                    "is no {}: if that is not meant, give it another name",
                    input, item, column.second ? 'j' : 'i', fellow_of(input, column)));
  }
  const auto& parts = graph.parts();
  const bool one_cost = std::all_of(parts.begin(), parts.end(),
                                    [&](const Sides& part) { return is_one_cost(graph, part); });
  if (pairing == data::Pairing::arg_min && notes.empty() && !one_cost) {
    notes.emplace_back(
        "g is not f with candidate j in the place of i, as it is written: unless the two are equal "
        "otherwise, the contests are no arg-min of one cost");
  }
  return notes;
}

}  // namespace mixcmp::scene
