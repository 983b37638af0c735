#include "tests/support/integer_float.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace mixcmp::test::integer_float {
namespace {

enum class Kind {
  finite,
  infinite,
  nan,
};

/// The number (-1)^negative * (integer + t) * 2^exponent with t = 0, or 0 < t < 1 where `more` is
/// set.
struct Value {
  Kind kind = Kind::finite;
  bool negative = false;
  mpz_class integer = 0;
  long exponent = 0;
  bool more = false;

  bool is_zero() const { return kind == Kind::finite && integer == 0 && !more; }
};

const Value nan_value = {.kind = Kind::nan};

Value infinite_value(bool negative) {
  return {.kind = Kind::infinite, .negative = negative};
}

mpz_class to_integer(Bits bits) {
  mpz_class value = static_cast<unsigned long>(bits >> 64);
  value <<= 64;
  value += static_cast<unsigned long>(bits);
  return value;
}

Bits to_bits(const mpz_class& value) {
  const mpz_class high = value >> 64;
  const mpz_class low = value - (high << 64);
  return Bits{high.get_ui()} << 64 | low.get_ui();
}

long bit_count(const mpz_class& value) {
  return value == 0 ? 0 : static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2));
}

mpz_class power_of_two(long exponent) {
  return mpz_class(1) << exponent;
}

struct Operand {
  Value value;
  bool exceptional = false;
};

Operand read(FloatFormat format, Subnormals subnormals, Bits bits) {
  const mpz_class whole = to_integer(bits);
  const int fraction_bits = format.precision() - 1;
  const bool negative = mpz_tstbit(whole.get_mpz_t(), format.width() - 1) != 0;
  const mpz_class biased_exponent = (whole >> fraction_bits) % power_of_two(format.exponent_bits());
  const mpz_class fraction = whole % power_of_two(fraction_bits);
  if (biased_exponent == power_of_two(format.exponent_bits()) - 1) {
    return {fraction == 0 ? infinite_value(negative) : nan_value, true};
  }
  Value value{.negative = negative, .integer = fraction};
  value.exponent = format.min_exponent() - fraction_bits;
  const bool subnormal = biased_exponent == 0 && fraction != 0;
  if (subnormal && subnormals == Subnormals::flush) {
    value.integer = 0;
    return {value, true};
  }
  if (biased_exponent > 0) {
    value.integer += power_of_two(fraction_bits);
    value.exponent += biased_exponent.get_si() - 1;
  }
  return {value, false};
}

struct Quantised {
  mpz_class count;
  bool inexact;
};

/// |value| as a whole number of 2^quantum.
Quantised quantise(const Value& value, long quantum, Rounding rounding) {
  const long drop = quantum - value.exponent;
  if (drop <= 0) {
    MIXCMP_CHECK(!value.more);
    return {value.integer << -drop, false};
  }
  mpz_class count = value.integer >> drop;
  const mpz_class twice_rest = 2 * (value.integer - (count << drop));
  const mpz_class whole = power_of_two(drop);
  const bool inexact = twice_rest != 0 || value.more;
  const bool above_half = twice_rest > whole || (twice_rest == whole && value.more);
  const bool tie = twice_rest == whole && !value.more;
  const bool odd = mpz_odd_p(count.get_mpz_t()) != 0;
  if (rounding == Rounding::nearest_even && (above_half || (tie && odd))) count += 1;
  return {count, inexact};
}

Bits with_sign(FloatFormat format, bool negative, Bits magnitude) {
  return magnitude | Bits{negative} << (format.precision() + format.exponent_bits() - 1);
}

Rounded tiny(const Arithmetic& result, const Value& value) {
  const FloatFormat format = result.format;
  if (result.subnormals == Subnormals::flush) return {with_sign(format, value.negative, 0), true};
  const long quantum = format.min_exponent() - format.precision() + 1;
  const Quantised rounded = quantise(value, quantum, result.rounding);
  // A count that reaches 2^(P-1) is the encoding of the smallest normal number.
  return {with_sign(format, value.negative, to_bits(rounded.count)), rounded.inexact};
}

Rounded finish(const Arithmetic& result, const Value& value) {
  const FloatFormat format = result.format;
  const int precision = format.precision();
  const mpz_class infinity = (power_of_two(format.exponent_bits()) - 1) << (precision - 1);
  if (value.kind == Kind::nan) return {to_bits(infinity + power_of_two(precision - 2)), true};
  if (value.kind == Kind::infinite) {
    return {with_sign(format, value.negative, to_bits(infinity)), true};
  }
  if (value.is_zero()) return {with_sign(format, value.negative, 0), false};
  long exponent = value.exponent + bit_count(value.integer) - 1;
  mpz_class significand = quantise(value, exponent - precision + 1, result.rounding).count;
  if (significand == power_of_two(precision)) {
    significand = power_of_two(precision - 1);
    exponent += 1;
  }
  if (exponent < format.min_exponent()) return tiny(result, value);
  if (exponent > format.max_exponent()) {
    const bool to_infinity = result.rounding == Rounding::nearest_even;
    const mpz_class magnitude = to_infinity ? infinity : mpz_class(infinity - 1);
    return {with_sign(format, value.negative, to_bits(magnitude)), true};
  }
  const mpz_class field = exponent + format.bias() - 1;
  const mpz_class magnitude = (field << (precision - 1)) + significand;
  return {with_sign(format, value.negative, to_bits(magnitude)), false};
}

mpz_class signed_integer(const Value& value, long exponent) {
  const mpz_class magnitude = value.integer << (value.exponent - exponent);
  return value.negative ? mpz_class(-magnitude) : magnitude;
}

Value sum(const Value& a, const Value& b) {
  if (a.kind == Kind::nan || b.kind == Kind::nan) return nan_value;
  if (a.kind == Kind::infinite && b.kind == Kind::infinite && a.negative != b.negative) {
    return nan_value;
  }
  if (a.kind == Kind::infinite) return a;
  if (b.kind == Kind::infinite) return b;
  const long exponent = std::min(a.exponent, b.exponent);
  const mpz_class total = signed_integer(a, exponent) + signed_integer(b, exponent);
  const bool negative = total < 0 || (total == 0 && a.negative && b.negative);
  return {.negative = negative, .integer = abs(total), .exponent = exponent};
}

Value product(const Value& a, const Value& b) {
  const bool negative = a.negative != b.negative;
  if (a.kind == Kind::nan || b.kind == Kind::nan) return nan_value;
  if (a.kind == Kind::infinite || b.kind == Kind::infinite) {
    return a.is_zero() || b.is_zero() ? nan_value : infinite_value(negative);
  }
  return {
      .negative = negative, .integer = a.integer * b.integer, .exponent = a.exponent + b.exponent};
}

/// Extra digits of quotients and roots: beyond any precision, so that `more` lies below a half.
constexpr long spare_bits = 2 * (FloatFormat::max_precision + 3);

Value finite_quotient(const Value& a, const Value& b) {
  const mpz_class scaled = a.integer << (spare_bits + bit_count(b.integer));
  const mpz_class whole = scaled / b.integer;
  return {.negative = a.negative != b.negative,
          .integer = whole,
          .exponent = a.exponent - b.exponent - spare_bits - bit_count(b.integer),
          .more = scaled != whole * b.integer};
}

Value quotient(const Value& a, const Value& b) {
  const bool negative = a.negative != b.negative;
  if (a.kind == Kind::nan || b.kind == Kind::nan) return nan_value;
  if (a.kind == b.kind && (a.kind == Kind::infinite || (a.is_zero() && b.is_zero()))) {
    return nan_value;
  }
  if (a.kind == Kind::infinite || b.is_zero()) return infinite_value(negative);
  if (b.kind == Kind::infinite || a.is_zero()) return {.negative = negative};
  return finite_quotient(a, b);
}

Value root(const Value& a) {
  if (a.kind == Kind::nan || a.is_zero()) return a;
  if (a.negative) return nan_value;
  if (a.kind == Kind::infinite) return a;
  const long shift = spare_bits + (a.exponent - spare_bits) % 2;
  const mpz_class scaled = a.integer << shift;
  const mpz_class whole = sqrt(scaled);
  return {.integer = whole, .exponent = (a.exponent - shift) / 2, .more = scaled != whole * whole};
}

Value negated(Value value) {
  value.negative = !value.negative;
  return value;
}

Value add_values(const Value& a, const Value& b) {
  return sum(a, b);
}
Value subtract_values(const Value& a, const Value& b) {
  return sum(a, negated(b));
}

template <class Operate>
Rounded apply(const Arithmetic& result, FloatFormat operands, Bits a, Bits b, Operate operate) {
  const Operand first = read(operands, result.subnormals, a);
  const Operand second = read(operands, result.subnormals, b);
  const Rounded rounded = finish(result, operate(first.value, second.value));
  return {rounded.bits, rounded.exceptional || first.exceptional || second.exceptional};
}

/// -1, 0 or 1; neither is a NaN.
int order(const Value& a, const Value& b) {
  const auto rank = [](const Value& value) {
    if (value.kind == Kind::finite) return 0;
    return value.negative ? -1 : 1;
  };
  if (rank(a) != rank(b)) return rank(a) < rank(b) ? -1 : 1;
  if (rank(a) != 0) return 0;
  const long exponent = std::min(a.exponent, b.exponent);
  return sgn(mpz_class(signed_integer(a, exponent) - signed_integer(b, exponent)));
}

/// Orders -0 below +0.
bool is_below(const Value& a, const Value& b) {
  const int by_value = order(a, b);
  return by_value != 0 ? by_value < 0 : a.negative && !b.negative;
}

long leading_exponent(const Value& value) {
  return value.exponent + bit_count(value.integer) - 1;
}

Value without_digits_below(Value value, long exponent) {
  if (value.kind != Kind::finite || value.exponent >= exponent) return value;
  value.integer >>= exponent - value.exponent;
  value.exponent = exponent;
  return value;
}

}  // namespace

Rounded add(const Arithmetic& result, FloatFormat operands, Bits a, Bits b) {
  return apply(result, operands, a, b, add_values);
}

Rounded subtract(const Arithmetic& result, FloatFormat operands, Bits a, Bits b) {
  return apply(result, operands, a, b, subtract_values);
}

Rounded multiply(const Arithmetic& result, FloatFormat operands, Bits a, Bits b) {
  return apply(result, operands, a, b, product);
}

Rounded square(const Arithmetic& result, FloatFormat operands, Bits a) {
  return apply(result, operands, a, a, product);
}

Rounded divide(const Arithmetic& result, FloatFormat operands, Bits a, Bits b) {
  return apply(result, operands, a, b, quotient);
}

Rounded square_root(const Arithmetic& result, FloatFormat operands, Bits a) {
  return apply(result, operands, a, a,
               [](const Value& value, const Value&) { return root(value); });
}

Rounded convert(const Arithmetic& result, FloatFormat operands, Bits a) {
  return apply(result, operands, a, a, [](const Value& value, const Value&) { return value; });
}

namespace {

/// The exact sum of the cut terms, negative zeros as fused sums have them.
struct CutSum {
  Value total;
  bool exceptional;
};

CutSum cut_sum(const Arithmetic& result, FloatFormat operands,
               std::span<const golden::FusedOperands> terms) {
  std::vector<Value> values;
  bool exceptional = false, all_down = true;
  long largest = result.subnormals == Subnormals::gradual ? result.format.min_exponent()
                                                          : std::numeric_limits<int>::min();
  for (const auto& [a, b, minus] : terms) {
    const Operand first = read(operands, result.subnormals, a);
    const Operand second = read(operands, result.subnormals, b);
    exceptional |= first.exceptional || second.exceptional;
    values.push_back(product(first.value, second.value));
    if (minus) values.back().negative = !values.back().negative;
    all_down &= values.back().negative;
    if (values.back().is_zero()) continue;
    largest = std::max(largest, leading_exponent(first.value) + leading_exponent(second.value));
  }
  // Five digits, and the digits of the number of terms.
  const long guard = 5 + bit_count(mpz_class(static_cast<unsigned long>(terms.size()) - 1));
  const long last = largest - result.format.precision() - guard;
  Value total = values.front();
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Value cut = without_digits_below(values[k], last);
    total = k == 0 ? cut : sum(total, cut);
  }
  if (total.is_zero()) total.negative = all_down;
  return {total, exceptional};
}

}  // namespace

Rounded fused_sum(const Arithmetic& result, FloatFormat operands,
                  std::span<const golden::FusedOperands> terms) {
  const CutSum sum = cut_sum(result, operands, terms);
  const Rounded rounded = finish(result, sum.total);
  return {rounded.bits, rounded.exceptional || sum.exceptional};
}

Verdict fused_comparison(const Arithmetic& arithmetic, FloatFormat operands,
                         std::span<const golden::FusedOperands> terms) {
  const Value total = cut_sum(arithmetic, operands, terms).total;
  if (total.kind == Kind::nan) return Verdict::unordered;
  if (total.is_zero()) return Verdict::equal;
  return total.negative ? Verdict::less : Verdict::greater;
}

Rounded minimum(const Arithmetic& result, Bits a, Bits b) {
  return apply(result, result.format, a, b, [](const Value& first, const Value& second) {
    if (first.kind == Kind::nan || second.kind == Kind::nan) return nan_value;
    return is_below(second, first) ? second : first;
  });
}

Rounded maximum(const Arithmetic& result, Bits a, Bits b) {
  return apply(result, result.format, a, b, [](const Value& first, const Value& second) {
    if (first.kind == Kind::nan || second.kind == Kind::nan) return nan_value;
    return is_below(first, second) ? second : first;
  });
}

Verdict compare(FloatFormat format, Subnormals subnormals, Bits a, Bits b) {
  const Value first = read(format, subnormals, a).value;
  const Value second = read(format, subnormals, b).value;
  if (first.kind == Kind::nan || second.kind == Kind::nan) return Verdict::unordered;
  const int by_value = order(first, second);
  if (by_value == 0) return Verdict::equal;
  return by_value < 0 ? Verdict::less : Verdict::greater;
}

Rounded from_rational(const Arithmetic& result, const mpq_class& value) {
  const Value numerator{.negative = value < 0, .integer = abs(value.get_num())};
  const Value denominator{.integer = value.get_den()};
  return finish(result, quotient(numerator, denominator));
}

}  // namespace mixcmp::test::integer_float
