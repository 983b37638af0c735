#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/base/settings/settings.hpp"

namespace mixcmp::scene {

/// The value of comparison.variant that takes [comparison] as it is written, and nothing else.
inline constexpr std::string_view no_variant = "none";

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
  std::size_t chosen = 0;        ///< index of the named variant; 0: [comparison] or a move
  /// The move that comparison.variant names; empty: none.
  std::string move = {};
  bool is_as_written = false;  ///< comparison.variant is no_variant
};

/// Reads [[variant]] and comparison.variant, and removes both from the returned settings.
Result<Formulations> read_formulations(const settings::Settings& settings);

}  // namespace mixcmp::scene
