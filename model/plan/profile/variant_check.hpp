#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "model/base/number/verdict.hpp"
#include "model/comparison/data/comparisons.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::profile {

/// The result of checking on data that a variant has the same verdicts as [comparison].
struct VariantCheck {
  /// A comparison with different verdicts.
  struct Difference {
    std::uint64_t index;
    Verdict given;  ///< [comparison]'s
    Verdict variant;
  };

  std::string variant;
  std::uint64_t comparisons = 0;
  /// Comparisons of a move that are not checked, since an operand is outside of its range.
  std::uint64_t out_of_range = 0;
  /// The first comparison on which the variant's verdict differs, by the real numbers f and g;
  /// none: all verdicts agree.
  std::optional<Difference> first_difference;
  std::uint64_t differences = 0;
  /// Comparisons whose order `checked_bits` bits cannot determine in [comparison], in the variant
  /// or in both. Most are ties of sums of several roots. They do not count as differences.
  std::uint64_t undetermined = 0;
  /// Comparisons on which the two references differ. They may differ, since they round.
  std::uint64_t reference_differences = 0;
};

constexpr int checked_bits = 512;
constexpr std::uint64_t checked_comparisons = 250'000;

/// Checks all comparisons, or `most` of them at even distances. Both scenes have the same inputs in
/// the same order. `progress` is called with the completed fraction.
VariantCheck check_variant(const scene::Scene& given, const scene::Scene& variant,
                           const data::Comparisons& data, std::uint64_t most = checked_comparisons,
                           const std::function<void(double)>& progress = {});

}  // namespace mixcmp::profile
