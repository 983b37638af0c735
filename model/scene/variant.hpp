#pragma once

#include <string>
#include <vector>

#include "model/base/settings/settings.hpp"

namespace mixcmp::scene {

/// One formulation of the scene's comparison: the scene's settings, with the keys of a [[variant]]
/// in place of those of [comparison].
struct Formulation {
  std::string variant;  ///< empty: [comparison] itself
  settings::Settings settings;
  /// An error about the variant's name.
  Error name_mistake(std::string message, std::string received) const;

  std::string file = {};  ///< place of the variant's table
  int line = 0;
};

struct Formulations {
  std::vector<Formulation> all;  ///< [comparison]'s own first, then variants in the file's order
  std::size_t chosen = 0;        ///< index of comparison.variant's; 0: none is named
};

/// Reads [[variant]] and comparison.variant, and removes both from the returned settings.
Result<Formulations> read_formulations(const settings::Settings& settings);

}  // namespace mixcmp::scene
