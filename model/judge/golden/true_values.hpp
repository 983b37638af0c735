#pragma once

#include <optional>
#include <span>

#include "model/judge/golden/enclosure.hpp"

namespace mixcmp::golden {

/// The real values of f and g, computed with 500 bits, or with more if cancellation would leave
/// fewer than 128 correct bits.
class TrueValues {
public:
  /// `graph` must outlive this object.
  TrueValues(const Graph& graph, Sides part);

  /// False if f or g has no value, or if last_precision(format) bits do not determine it, as for a
  /// zero that cannot be proven.
  bool compute(FloatFormat format, std::span<const Bits> inputs);

  /// f and g, correct to 128 bits; a zero is exact. Valid after compute() has returned true.
  const BigFloat& f() const { return enclosure().f().low; }
  const BigFloat& g() const { return enclosure().g().low; }

private:
  const Enclosure& enclosure() const { return wider_ ? *wider_ : first_; }

  const Graph& graph_;
  Sides part_;
  Enclosure first_;
  std::optional<Enclosure> wider_;  ///< used if first_ is not precise enough
};

}  // namespace mixcmp::golden
