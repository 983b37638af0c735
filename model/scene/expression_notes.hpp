#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/base/number/float_format.hpp"
#include "model/comparison/data/pairing.hpp"
#include "model/comparison/expression/graph.hpp"

namespace mixcmp::scene {

/// Notes for the user about probable mistakes in how f and g name items i and j. If both items are
/// rows of one table, a note names each input of one item whose column is no input of the other
/// ("cxi" without "cxj"). With arg_min, a note says if g is not f with j instead of i.
std::vector<std::string> pairing_notes(const Graph& graph, data::Pairing pairing);

/// Tells the user who leaves the lanes' format open which operation of f or g keeps all lanes in
/// fixed point out of the choice: a quotient, or a root whose radicand may be negative in these
/// ranges. None if no operation does.
std::optional<std::string> fixed_point_note(const Graph& graph, FloatFormat reference,
                                            const std::vector<std::optional<Range>>& ranges);

/// Tells of the first division by a constant that is no power of two: references have a divider for
/// it. None without one.
std::optional<std::string> divider_note(const Graph& graph);

}  // namespace mixcmp::scene
