#pragma once

#include <string>
#include <vector>

#include "model/data/comparisons.hpp"

namespace mixcmp::model {

/// The column that an input's operands are read from.
struct InputSource {
  std::string input;
  FileColumn column;
  std::string source;  ///< the file's name, or what the items are made of
  std::string item;    ///< whose number it is: "item i", "row"; empty without pairs

  /// `column 2 "cz" of 1A8O.pdb, item i`.
  std::string shown() const;
};

/// One per input, in their order; empty where the data come from no file and no generator.
std::vector<InputSource> input_sources(const Comparisons& data,
                                       const std::vector<std::string>& inputs);

}  // namespace mixcmp::model
