#pragma once

#include <optional>

#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::emulator {

/// Magnitudes from 2^low up to 2^high; 0 is not among them.
struct SafeOperands {
  int low;
  int high;
};

/// Trusted magnitudes of a format: 0 and [2^least, 2^limit).
struct TrustedExponents {
  int least;
  int limit;
};
TrustedExponents trusted_exponents(FloatFormat format);

/// A range such that, if all operands of a comparison lie within it, every node is provably 0 or
/// within the trusted exponents of its format, no divisor is 0 and no radicand is negative. None if
/// no range around 1 can be proven so, as for small formats. The graph must have inputs.
std::optional<SafeOperands> safe_operands(const TypedGraph& graph);

}  // namespace mixcmp::emulator
