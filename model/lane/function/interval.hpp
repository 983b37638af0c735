#pragma once

#include <gmpxx.h>
#include <mpfi.h>

#include <utility>

#include "model/comparison/expression/range.hpp"

namespace mixcmp::function {

/// A closed interval of real numbers with ends of 192 digits. Results are rounded outward, so that
/// they enclose those of all numbers of the operands (MPFI).
class Interval {
public:
  static constexpr int digits = 192;
  /// Beyond the numbers of formats with 15 exponent bits.
  static constexpr int most_exponent = 1 << 15;

  Interval();
  Interval(int value) : Interval() { mpfi_set_si(value_, value); }
  Interval(const mpq_class& value) : Interval() { mpfi_set_q(value_, value.get_mpq_t()); }
  explicit Interval(const Range& range);
  /// All numbers.
  static Interval unbounded();
  Interval(const Interval& other) : Interval() { mpfi_set(value_, other.value_); }
  Interval(Interval&& other) noexcept : value_(std::exchange(other.value_, nullptr)) {}
  Interval& operator=(const Interval& other);
  Interval& operator=(Interval&& other) noexcept;
  ~Interval();

  mpfi_srcptr get() const { return value_; }
  mpfi_ptr get() { return value_; }

  /// Whether both ends are below 2^most_exponent in magnitude. They are infinite where an operation
  /// has no enclosure; then there is no range.
  bool is_bounded() const;
  /// The ends. Those below 2^-most_exponent in magnitude are rounded outward, to that or to 0.
  Range range() const;
  /// The largest magnitude, as an interval of one number.
  Interval magnitude() const;
  /// A number roughly in the middle; 0 if that is below 2^-most_exponent in magnitude.
  mpf_class middle() const;

  friend Interval operator+(const Interval& a, const Interval& b);
  friend Interval operator-(const Interval& a, const Interval& b);
  friend Interval operator*(const Interval& a, const Interval& b);
  friend Interval operator/(const Interval& a, const Interval& b);

private:
  mpfi_ptr value_;  ///< none after a move
};

/// Interval::is_bounded and Interval::range for intervals of other precisions.
bool is_bounded(mpfi_srcptr interval);
Range range_of(mpfi_srcptr interval);
/// A finite number; one below 2^-most_exponent in magnitude is rounded up or down (outward: 1 or
/// -1), to that or to 0.
mpq_class rational(mpfr_srcptr number, int outward);

}  // namespace mixcmp::function
