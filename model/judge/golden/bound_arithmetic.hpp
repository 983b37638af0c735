#pragma once

#include "model/lane/error/bound_graph.hpp"

/// The golden model of rtl_templates/bound, by MPFR with results rounded up.
/// model/lane/error/bound_graph.hpp has the rules.
namespace mixcmp::golden {

Bits bound_constant(BoundFormat format, const mpq_class& value);
Bits bound_magnitude(BoundFormat format, FloatFormat operand, Bits x);
Bits bound_binade(BoundFormat format, FloatFormat operand, Bits x);
Bits bound_reciprocal(BoundFormat format, FloatFormat operand, Bits x);
Bits bound_add(BoundFormat format, Bits a, Bits b);
Bits bound_multiply(BoundFormat format, Bits a, Bits b);

/// Whether bound <= |x|.
bool bound_is_at_most(BoundFormat format, Bits bound, FloatFormat operand, Bits x);

}  // namespace mixcmp::golden
