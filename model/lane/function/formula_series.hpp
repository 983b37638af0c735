#pragma once

#include "model/comparison/expression/formula.hpp"
#include "model/lane/function/series.hpp"

namespace mixcmp::function {

/// `taylor` of a formula: the series of its nodes, one after the other.
Series taylor(const Formula& formula, const Series& variable);

/// Encloses the formula's values.
Interval value(const Formula& formula, const Interval& x);

}  // namespace mixcmp::function
