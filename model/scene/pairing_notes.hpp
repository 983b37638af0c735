#pragma once

#include <string>
#include <vector>

#include "model/comparison/data/pairing.hpp"
#include "model/comparison/expression/graph.hpp"

namespace mixcmp::scene {

/// Notes for the user about probable mistakes in how f and g name items i and j. If both items are
/// rows of one table, a note names each input of one item whose column is no input of the other
/// ("cxi" without "cxj"). With arg_min, a note says if g is not f with j instead of i.
std::vector<std::string> pairing_notes(const Graph& graph, data::Pairing pairing);

}  // namespace mixcmp::scene
