#pragma once

#include <gmpxx.h>

#include <optional>
#include <vector>

#include "model/comparison/expression/function.hpp"
#include "model/comparison/expression/range.hpp"
#include "model/lane/function/interval.hpp"

namespace mixcmp::function {

/// The line on which a piece's arguments lie: x = start + slope t.
struct Line {
  mpq_class start, slope;

  mpq_class at(const mpq_class& t) const { return start + slope * t; }
};

/// The coefficients of t^k.
using Polynomial = std::vector<Interval>;

/// The polynomial in t that has the function's values at Chebyshev's points of the places, by
/// Newton's divided differences. Its coefficients are near those numbers; no proof relies on them.
std::vector<mpf_class> interpolated(const Function& function, const Line& line, const Range& places,
                                    int degree);

/// Encloses polynomial less function for all real t of the places; none where the function has no
/// value.
std::optional<Range> difference_on_piece(const Function& function, const Polynomial& polynomial,
                                         const Line& line, const Range& places);

}  // namespace mixcmp::function
