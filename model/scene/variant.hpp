#pragma once

#include <string>
#include <vector>

#include "model/settings/settings.hpp"

namespace mixcmp::model {

/// One way to put the scene's comparison: its own settings, with the keys of a [[variant]] laid
/// over [comparison].
struct Formulation {
  std::string variant;  ///< empty: as [comparison] has it
  Settings settings;
  /// A mistake of the variant's name.
  Error name_mistake(std::string message, std::string received) const;

  std::string file = {};  ///< of the variant's table
  int line = 0;
};

struct Formulations {
  std::vector<Formulation> all;  ///< [comparison]'s own first, then variants in the file's order
  std::size_t chosen = 0;        ///< by comparison.variant; 0: none is named
};

/// Reads [[variant]] and comparison.variant; neither is left in the settings that come back.
Result<Formulations> read_formulations(const Settings& settings);

}  // namespace mixcmp::model
