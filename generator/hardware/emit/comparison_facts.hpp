#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/design/design.hpp"

namespace mixcmp::emit {

/// Lines for the header of a top: `introduction`, then f, g and the lets that they need, as the
/// scene writes them. "the sign of f - g", or the words for several parts, must be able to follow
/// the introduction. The list is empty for a design that was made without a scene.
std::vector<std::string> formula_facts(const design::Design& design,
                                       const std::string& introduction);

/// Lines that tell how numbers are packed side by side, the first lowest: which bits of the packed
/// word each name has, and then what the bits of each format mean.
std::vector<std::string> layout_facts(const std::vector<std::string>& names,
                                      std::span<const OperandFormat> formats);

/// "10 bits each", or for several widths "8 to 20 bits each".
std::string widths_text(std::span<const OperandFormat> formats);

}  // namespace mixcmp::emit
