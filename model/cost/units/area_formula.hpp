#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/cost/units/unit.hpp"

namespace mixcmp::units {

/// One factor of a term: a function of one parameter.
struct Factor {
  enum class Kind {
    size,   ///< Parameter::size
    log,    ///< its base-2 logarithm; 0 below 1
    power,  ///< two to the power of it
    bit,    ///< one bit of a literal
    many,   ///< 1 above one, else 0: a single stream needs no multiplexer
  };
  std::size_t parameter = 0;  ///< index in Unit::parameters
  Kind kind = Kind::size;
  int index = 0;  ///< of the bit

  double of(const Unit& unit) const;
};

/// A product of factors; 1 without any.
using Term = std::vector<Factor>;
double value(const Term& term, const Unit& unit);

/// "PRECISION*lg(PRECISION)", "CUTS[3]*WIDTH", "1".
std::string to_string(const Term& term, const Unit& unit);

/// A sum of terms with coefficients: an amount of one resource as a function of parameters.
struct Formula {
  std::vector<Term> terms;
  std::vector<double> coefficients;

  double of(const Unit& unit) const;
};

/// The terms that a formula of these units may have: products of up to two sizes, also times a
/// parameter that is only 0 or 1, sizes times logarithms, powers of two of parameters that count
/// address bits, bits of literals times sizes, and sizes where a count that starts at one is above
/// it. Parameters that do not vary, and exponents of limits, are left out. The units are of one
/// template.
std::vector<Term> possible_terms(const std::vector<Unit>& units);

/// Fits a formula to measured amounts by orthogonal least squares: the term that explains most of
/// the remaining error comes next (Chen, Billings and Luo, "Orthogonal least squares methods and
/// their application to non-linear system identification", 1989). Errors count relative to `whole`,
/// the amounts of which these are a part. The number of terms is the one whose error on units left
/// out is the least (five folds).
Formula fit(const std::vector<Unit>& units, const std::vector<double>& amounts,
            const std::vector<double>& whole);

}  // namespace mixcmp::units
