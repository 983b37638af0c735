#pragma once

#include <vector>

#include "model/comparison/expression/formula.hpp"
#include "model/lane/function/interval.hpp"

namespace mixcmp::function {

/// `taylor` of a formula: the series of its nodes, one after the other.
std::vector<Interval> taylor(const Formula& formula, const Interval& x, int count);

/// Encloses the formula's values.
Interval value(const Formula& formula, const Interval& x);

}  // namespace mixcmp::function
