#pragma once

#include <optional>

#include "model/comparison/expression/function.hpp"
#include "model/comparison/expression/range.hpp"

/// Errors of functions in fixed point. Proof: docs/fixed_point.md, theorem 10.
namespace mixcmp::fixed {

/// The real numbers that the computed ones of a range may stand for.
Range stood_for(const Range& computed, const Range& error);

/// By how much a function's value changes if its argument does by an error: the slopes between the
/// computed argument and the real one, times the error. None if there is no bound.
std::optional<Range> moved_by(const Function& function, const Range& computed, const Range& error);

/// The unit of a function's values. As for a root, it is the power of two at or below half of the
/// error that results from the argument's error.
int unit_exponent_for(const Range& values, const mpq_class& effect, int bits);

}  // namespace mixcmp::fixed
