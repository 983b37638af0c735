#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/rtl/datapath_builder.hpp"
#include "model/expression/combination.hpp"

namespace mixcmp::rtl {

/// The signals of one part's decision; with a single part they are the module's own outputs.
struct PartDecision {
  std::string instance;
  Signal verdict;
  Signal decided;  ///< null in a reference, which always decides
};

enum class Decides { sometimes, always };

/// Adds the nets of a part's decision under a comment: its cycles, then the given text.
PartDecision begin_decision(DatapathBuilder& datapath, const datapath::Step& step, std::size_t part,
                            std::size_t parts, Decides decides, std::string_view what);

/// Combines the parts' verdicts into one. A single part needs no combination.
void build_combination(DatapathBuilder& datapath, Combination combination,
                       const std::vector<PartDecision>& parts, const datapath::Step& step);

}  // namespace mixcmp::rtl
