#pragma once

#include <gmpxx.h>

#include <span>

#include "model/base/number/verdict.hpp"
#include "model/judge/golden/arithmetic.hpp"

/// The second judge of model/judge/golden/arithmetic.hpp: the same rules on exact integers, rounded
/// by hand. It shares the result type with the golden model and no arithmetic.
namespace mixcmp::test::integer_float {

using golden::Rounded;

Rounded add(const Arithmetic& result, FloatFormat operands, Bits a, Bits b);
Rounded subtract(const Arithmetic& result, FloatFormat operands, Bits a, Bits b);
Rounded multiply(const Arithmetic& result, FloatFormat operands, Bits a, Bits b);
Rounded square(const Arithmetic& result, FloatFormat operands, Bits a);
Rounded divide(const Arithmetic& result, FloatFormat operands, Bits a, Bits b);
Rounded square_root(const Arithmetic& result, FloatFormat operands, Bits a);
Rounded convert(const Arithmetic& result, FloatFormat operands, Bits a);
Rounded fused_sum(const Arithmetic& result, FloatFormat operands,
                  std::span<const golden::FusedOperands> terms);
Verdict fused_comparison(const Arithmetic& arithmetic, FloatFormat operands,
                         std::span<const golden::FusedOperands> terms);
Rounded minimum(const Arithmetic& result, Bits a, Bits b);
Rounded maximum(const Arithmetic& result, Bits a, Bits b);
Verdict compare(FloatFormat format, Subnormals subnormals, Bits a, Bits b);
Rounded from_rational(const Arithmetic& result, const mpq_class& value);

}  // namespace mixcmp::test::integer_float
