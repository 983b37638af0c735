#pragma once

#include <string>
#include <vector>

#include "model/comparison/expression/function.hpp"
#include "model/comparison/expression/range.hpp"

namespace mixcmp::test {

/// A table of points from -6 to 9.
Function measured(int degree);

/// The functions without a parameter, powers and tables.
std::vector<Function> tested_functions();

/// Functions of which each is an expression of one variable, with values everywhere.
std::vector<Function> tested_formulas();
/// The expression of one variable, which is known to be valid, as a function.
Function parsed_formula(const std::string& expression);

/// Encloses a function's value at a dyadic number, by MPFR with both roundings at so many digits.
/// The function has a value there.
Range value_at(const Function& function, const mpq_class& x, int digits = 300);

/// Encloses the function's values on a range with dyadic ends, on which its slope is below 2^40.
/// The range is narrower than 2^-200.
Range value_near(const Function& function, const Range& x);

}  // namespace mixcmp::test
