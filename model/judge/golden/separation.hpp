#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <set>

#include "model/comparison/expression/graph.hpp"
#include "model/judge/golden/big_float.hpp"

namespace mixcmp::golden {

/// How close to zero the value of an expression can be without being zero. The value is
/// 2^exponent U/L, where U and L are algebraic integers, every conjugate of U is at most
/// 2^numerator_bits in magnitude and every conjugate of L at most 2^denominator_bits. U has at most
/// 2^r conjugates, r = |roots|, whose product is a nonzero integer unless U = 0, so that the value
/// is zero or at least 2^(exponent - denominator_bits - (2^r - 1) numerator_bits) in magnitude.
///
/// Source: Burnikel, Funke, Mehlhorn, Schirra, Schmitt, "A separation bound for real algebraic
/// expressions", ESA 2001, with powers of two kept apart as in Pion, Yap, "Constructive root bound
/// for k-ary rational input numbers", SoCG 2003.
struct Separation {
  /// False once a member would reach 2^40: then there is no bound on the value.
  bool bounded = true;
  std::int64_t numerator_bits = 0;  ///< 0 only for an exact zero
  std::int64_t denominator_bits = 0;
  std::int64_t exponent = 0;
  std::set<NodeId> roots;  ///< square roots in the expression, except those of known value

  /// e such that the value is zero or at least 2^e in magnitude; none if no such bound is known.
  std::optional<std::int64_t> least_exponent() const;
};

/// The separation of a value that is not algebraic: none is known.
Separation no_separation();
/// The separation of a finite number from zero.
Separation separation_of(const BigFloat& number);
Separation separation_of(const mpq_class& number);
/// The separation of a sum or a difference, and of a product.
Separation separation_of_sum(const Separation& a, const Separation& b);
Separation separation_of_product(const Separation& a, const Separation& b);
/// The separation of a / b, where b is not zero.
Separation separation_of_quotient(const Separation& a, const Separation& b);
/// The separation of a square root; `id`, its node in the graph, tells equal roots from others.
Separation separation_of_root(const Separation& radicand, NodeId id);
/// The separation of a minimum or a maximum: it holds for either value.
Separation separation_of_either(const Separation& a, const Separation& b);

}  // namespace mixcmp::golden
