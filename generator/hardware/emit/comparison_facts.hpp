#pragma once

#include <string>
#include <vector>

#include "model/design/design.hpp"

namespace mixcmp::emit {

/// Lines for the header of a top: `introduction`, then f, g and the lets that they need, as the
/// scene writes them. "the sign of f - g", or the words for several parts, must be able to follow
/// the introduction. The list is empty for a design that was made without a scene.
std::vector<std::string> formula_facts(const design::Design& design,
                                       const std::string& introduction);

/// Lines that tell how numbers of one format are packed side by side: which bits of the packed word
/// each name has, and then which bits of a number are its sign, exponent and fraction.
std::vector<std::string> layout_facts(const std::vector<std::string>& names, FloatFormat format);

}  // namespace mixcmp::emit
