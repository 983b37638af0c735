#pragma once

#include <vector>

#include "model/comparison/expression/function.hpp"
#include "model/lane/function/series.hpp"

namespace mixcmp::function {

/// The series of f(u). It is unbounded where the first coefficient of u leaves the domain of f.
Series taylor(const Function& function, const Series& u);
/// Encloses the Taylor coefficients of f(x + slope h) in h, k = 0 .. count - 1, for every x of the
/// interval: with slope 1 they are f^(k)(x) / k!.
Series taylor(const Function& function, const Interval& x, int count, const mpq_class& slope = 1);

/// `taylor` on a range, with slope 1. An enclosure of all values at once is too wide if a formula
/// reads its variable twice: a formula has the hull of its coefficients on 128 parts of the range.
Series taylor_on(const Function& function, const Range& x, int count);

/// Encloses the function's values, in the precision of y. Beyond a closed end of its domain a
/// function has the value of the end, a formula what its operations make of it.
void enclose(const Function& function, mpfi_ptr y, mpfi_srcptr x);
Interval value(const Function& function, const Interval& x);
/// The first coefficient of `taylor_on`.
Interval value_on(const Function& function, const Range& x);

}  // namespace mixcmp::function
