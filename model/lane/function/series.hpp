#pragma once

#include <cstddef>
#include <vector>

#include "model/lane/function/interval.hpp"

/// Arithmetic of power series in a variable h, by the recurrences of Moore (Methods and
/// Applications of Interval Analysis, 1979).
namespace mixcmp::function {

/// Encloses the coefficients of h^k, k = 0 .. size() - 1. Operands of one operation have the same
/// size, which is its result's.
using Series = std::vector<Interval>;

/// The series of a number.
Series constant(const Interval& value, std::size_t count);
/// x + slope h.
Series line(const Interval& x, const Interval& slope, std::size_t count);

Series sum(const Series& a, const Series& b);
Series difference(const Series& a, const Series& b);
Series multiple(const Interval& factor, const Series& a);
Series product(const Series& a, const Series& b);
Series square(const Series& a);
Series quotient(const Series& a, const Series& b);
/// f(u), for the series f of a function around the first coefficient of u.
Series composed(const Series& f, const Series& u);

/// y, where y' = rate u' y.
Series exponential(const Interval& first, const Interval& rate, const Series& u);
/// y, where y' = a' / b.
Series integral_of_quotient(const Interval& first, const Series& a, const Series& b);
/// y, where y'' = sign y as a function of u.
Series oscillation(const Interval& first, const Interval& slope, int sign, const Series& u);
/// y, where y' = (1 + sign y^2) u'.
Series tangent(const Interval& first, int sign, const Series& u);

}  // namespace mixcmp::function
