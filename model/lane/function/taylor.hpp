#pragma once

#include <vector>

#include "model/comparison/expression/function.hpp"
#include "model/lane/function/interval.hpp"

namespace mixcmp::function {

/// Encloses the Taylor coefficients f^(k)(x) / k! of a function, k = 0 .. count - 1, for every x of
/// the interval, by the recurrences of Moore (Methods and Applications of Interval Analysis, 1979).
/// An interval that leaves the function's domain has unbounded ones. With a slope they are those of
/// f(slope t), in t.
std::vector<Interval> taylor(const Function& function, const Interval& x, int count);
std::vector<Interval> taylor(const Function& function, const Interval& x, int count,
                             const mpq_class& slope);

/// The same on a range. A formula may read its variable twice, which makes an enclosure of all its
/// values at once too wide: its coefficients are the hull of those on 128 parts of the range.
std::vector<Interval> taylor_on(const Function& function, const Range& x, int count);

/// Makes the series of f(t) that of f(slope t).
void scale(std::vector<Interval>& series, const mpq_class& slope);

/// Encloses the function's values, in the precision of y. Beyond a closed end of its domain a
/// function has the value of the end, a formula what its operations make of it.
void enclose(const Function& function, mpfi_ptr y, mpfi_srcptr x);
Interval value(const Function& function, const Interval& x);
/// The same on a range, as by `taylor_on`.
Interval value_on(const Function& function, const Range& x);

}  // namespace mixcmp::function
