#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "model/data/comparisons.hpp"
#include "model/golden/arithmetic.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::model {

/// Whether a variant decides as [comparison] does, on data.
struct VariantCheck {
  /// A comparison that the two decide differently.
  struct Difference {
    std::uint64_t index;
    golden::Verdict given;  ///< [comparison]'s
    golden::Verdict variant;
  };

  std::string variant;
  std::uint64_t comparisons = 0;
  /// Of the real numbers f and g, told by intervals of 2^14 bits or more where fewer do not
  /// (golden::true_verdict). None: they decide alike.
  std::optional<Difference> first_difference;
  std::uint64_t differences = 0;
  /// Rounded in the reference format the two need not agree; how often they do not.
  std::uint64_t reference_differences = 0;
};

constexpr std::uint64_t checked_comparisons = 250'000;

/// On all comparisons, or on that many spread over all. Both scenes have the same inputs in the
/// same order.
VariantCheck check_variant(const Scene& given, const Scene& variant, const Comparisons& data,
                           std::uint64_t most = checked_comparisons);

}  // namespace mixcmp::model
