#pragma once

#include <string>
#include <vector>

#include "model/comparison/data/comparisons.hpp"

namespace mixcmp::data {

/// The column of an input's operands.
struct InputSource {
  std::string input;
  FileColumn column;
  std::string source;  ///< name of the file or of the generator
  std::string item;    ///< item of the number: "item i", "row"; empty without pairs

  /// `column 2 "cz" of 1A8O.pdb, item i`.
  std::string shown() const;
};

/// Returns one per input, in their order; empty if the data come from no file and no generator.
std::vector<InputSource> input_sources(const Comparisons& data,
                                       const std::vector<std::string>& inputs);

}  // namespace mixcmp::data
