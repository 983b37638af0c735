#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "model/comparison/expression/range.hpp"
#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::error {

/// Exceptional events of an operation, which its datapath must handle unless they are ruled out.
enum class Event {
  overflow,
  underflow,  ///< a non-zero result below the smallest normal number, flushed or inexact
  division_by_zero,
  root_of_negative,
};
constexpr std::array<Event, 4> all_events = {Event::overflow, Event::underflow,
                                             Event::division_by_zero, Event::root_of_negative};
std::string_view to_string(Event event);

/// Whether ranges include values computed from infinite operands, such as 1 / inf = 0. A certified
/// lane never uses them: it is undecided after an overflow. A reference goes on with them.
enum class Infinities { excluded, followed };

/// The values and events that the declared ranges leave possible for one node of a typed graph.
struct NodeRange {
  /// Encloses every finite value that the node can compute, its own rounding included. With
  /// Infinities::excluded, this holds as long as no operand below it is infinite.
  Range value;
  /// Which of all_events are not ruled out.
  std::array<bool, all_events.size()> may_happen = {};
  /// With Infinities::followed: whether the node may be infinite, of either sign, and whether it
  /// may be -inf.
  bool may_be_infinite = false, may_be_negative_infinite = false;
  /// Inputs under the node that have no declared range, sorted; they count as any finite number.
  std::vector<int> rangeless_inputs;

  bool may(Event event) const { return may_happen[static_cast<std::size_t>(event)]; }
};

/// Analyses every node by interval arithmetic in exact rationals. Every operation is correctly
/// rounded and rounding is monotone, so an exact enclosure rounded outward encloses the computed
/// value. Operands are treated as independent, except those of x - x and x / x. `ranges`: one per
/// input of the graph.
std::vector<NodeRange> analyse_ranges(const TypedGraph& graph,
                                      const std::vector<std::optional<Range>>& ranges,
                                      Infinities infinities = Infinities::excluded);

}  // namespace mixcmp::error
