#pragma once

#include <optional>
#include <span>

#include "model/golden/enclosure.hpp"

namespace mixcmp::model::golden {

/// The real values of f and g, computed with 500 digits, or with more where so many cancel that
/// fewer than 128 would be right.
class TrueValues {
public:
  /// Looks at `graph` as long as it lives.
  TrueValues(const Graph& graph, Sides part);

  /// False where f or g has no value, and where last_precision(format) digits do not tell it: zeros
  /// that cannot be proven.
  bool compute(FloatFormat format, std::span<const Bits> inputs);

  /// Right to 128 digits, a zero exactly; after compute() returned true.
  const BigFloat& f() const { return enclosure().f().low; }
  const BigFloat& g() const { return enclosure().g().low; }

private:
  const Enclosure& enclosure() const { return wider_ ? *wider_ : first_; }

  const Graph& graph_;
  Sides part_;
  Enclosure first_;
  std::optional<Enclosure> wider_;  ///< where the first did not tell
};

}  // namespace mixcmp::model::golden
