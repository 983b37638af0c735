#include "model/judge/golden/true_values.hpp"

namespace mixcmp::golden {
namespace {

constexpr mpfr_prec_t first_precision = 500;
constexpr mpfr_exp_t right_digits = 128;

/// Whether all numbers of the interval agree in the first right_digits digits, up to one unit in
/// the last of them.
bool tells_value(const Interval& x) {
  if (mpfr_equal_p(x.low.get(), x.high.get()) != 0) return true;
  if (mpfr_sgn(x.low.get()) * mpfr_sgn(x.high.get()) <= 0) return false;
  BigFloat width(right_digits);
  mpfr_sub(width.get(), x.high.get(), x.low.get(), MPFR_RNDU);
  return mpfr_get_exp(width.get()) <= mpfr_get_exp(x.low.get()) - right_digits;
}

}  // namespace

TrueValues::TrueValues(const Graph& graph, Sides part)
    : graph_(graph), part_(part), first_(graph, part, first_precision) {}

bool TrueValues::compute(FloatFormat format, std::span<const Bits> inputs) {
  wider_.reset();
  Knowledge knowledge = first_.compute(format, inputs);
  for (mpfr_prec_t precision = 2 * first_precision;; precision *= 2) {
    if (knowledge == Knowledge::undefined) return false;
    const bool enclosed = knowledge == Knowledge::enclosed;
    if (enclosed && tells_value(enclosure().f()) && tells_value(enclosure().g())) return true;
    if (precision > last_precision(format)) return false;
    wider_.emplace(graph_, part_, precision);
    knowledge = wider_->compute(format, inputs);
  }
}

}  // namespace mixcmp::golden
