#pragma once

#include <optional>
#include <span>

#include "model/golden/enclosure.hpp"

namespace mixcmp::golden {

/// The real values of f and g, computed with 500 bits, or with more where cancellation would leave
/// fewer than 128 bits right.
class TrueValues {
public:
  /// Refers to `graph` as long as it lives.
  TrueValues(const Graph& graph, Sides part);

  /// False where f or g has no value, and where last_precision(format) bits do not determine it, as
  /// for a zero that cannot be proven.
  bool compute(FloatFormat format, std::span<const Bits> inputs);

  /// f and g, right to 128 bits, a zero exactly; valid after compute() has returned true.
  const BigFloat& f() const { return enclosure().f().low; }
  const BigFloat& g() const { return enclosure().g().low; }

private:
  const Enclosure& enclosure() const { return wider_ ? *wider_ : first_; }

  const Graph& graph_;
  Sides part_;
  Enclosure first_;
  std::optional<Enclosure> wider_;  ///< used where first_ is not precise enough
};

}  // namespace mixcmp::golden
