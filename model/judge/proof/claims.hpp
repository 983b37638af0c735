#pragma once

#include <optional>
#include <vector>

#include "model/base/number/dyadic.hpp"
#include "model/lane/error/error_analysis.hpp"
#include "model/lane/error/lane.hpp"

namespace mixcmp::proof {

/// The statement of the error analysis about one node, for Gappa to prove (docs/error_bounds.md).
/// `relative` says that true value = computed value * t, low <= t <= high; `unrounded` says that
/// true value = x * t, where x is the operation's exact result, before its own rounding.
struct NodeClaim {
  std::optional<error::RelativeBound> relative;
  std::optional<error::RelativeBound> unrounded;
  bool nonnegative = false;
  bool nonpositive = false;

  bool is_exact() const { return relative && relative->low == 1 && relative->high == 1; }
};

/// One claim per node, from an error analysis that assumes only the input signs that the lane
/// checks.
std::vector<NodeClaim> relative_claims(const error::Lane& lane);

/// Whether a check keeps the lane from deciding if this input's sign bit is set.
bool is_checked_nonnegative(const std::vector<error::RangeCheck>& checks, int input);

/// Moves the ends of `bound` outward by a relative 2^(2 depth - 400) and shortens them to dyadic
/// rationals of some 460 binary digits; [1, 1] stays as it is. Gappa's own interval ends are dyadic
/// and rounded outward. So it could not prove an end like 1/3, nor a chain of such ends, to the
/// last digit.
error::RelativeBound provable(const error::RelativeBound& bound, int depth);

/// Both functions round a value >= 0 to some 460 binary digits.
mpq_class rounded_down(const mpq_class& value);
mpq_class rounded_up(const mpq_class& value);

/// The widening at depth 0 is 2^-widening_bits.
constexpr long widening_bits = 400;
/// An estimate of floor(log2(value)), for a positive value: that number, or one more.
long binade_of(const mpq_class& value);

/// The deepest graph for which `provable` moves ends by less than one part in 2^300.
constexpr int max_provable_depth = 50;

}  // namespace mixcmp::proof
