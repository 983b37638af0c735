#pragma once

#include <string>
#include <vector>

#include "generator/hardware/rtl/datapath_builder.hpp"
#include "model/comparison/expression/combination.hpp"

namespace mixcmp::rtl {

/// The signals of one part's decision; with a single part they are the module's own outputs.
struct PartDecision {
  Signal verdict;
  Signal decided;  ///< null in a reference, which always decides
};

/// The unit that decides a part.
struct DecisionUnit {
  std::string what;  ///< a text for its comment
  std::vector<Parameter> parameters;
  std::vector<Connection> operands;  ///< in the cycle in which it starts
};

enum class Decides { sometimes, always };

/// Adds the decision of a part, with its nets.
PartDecision build_decision(DatapathBuilder& datapath, const datapath::Step& step, std::size_t part,
                            std::size_t parts, Decides decides, DecisionUnit unit);

/// Combines the parts' verdicts into one. A single part needs no combination.
void build_combination(DatapathBuilder& datapath, Combination combination,
                       const std::vector<PartDecision>& parts, const datapath::Step& step);

}  // namespace mixcmp::rtl
