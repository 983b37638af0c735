#include "model/lane/fixed/encoded_range.hpp"

#include <algorithm>
#include <bit>

#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/function_error.hpp"

namespace mixcmp::fixed {
namespace {

/// The encoding of a normal number, rounded down.
mpz_class encoding_of(FloatFormat format, int fraction_bits, const mpq_class& number) {
  const auto exponent = static_cast<int>(floor_log2(number));
  const mpz_class significand = floor_of(scaled(number, fraction_bits - exponent));
  return shifted_left(exponent + format.bias() - 1, fraction_bits) + significand;
}

int exponent_field(const mpz_class& encoding, int fraction_bits) {
  return static_cast<int>(floor_of(scaled(mpq_class(encoding), -fraction_bits)).get_si());
}

}  // namespace

EncodedRange EncodedRange::of(FloatFormat format, int fraction_bits, int exact_fraction_bits,
                              const Range& numbers) {
  return {.format = format,
          .fraction_bits = fraction_bits,
          .exact_fraction_bits = exact_fraction_bits,
          .least = encoding_of(format, fraction_bits, numbers.low),
          .greatest = encoding_of(format, fraction_bits, numbers.high)};
}

EncodedRange EncodedRange::with_whole_binades() const {
  EncodedRange whole = *this;
  whole.least = shifted_left(exponent_field(least, fraction_bits), fraction_bits);
  whole.greatest = shifted_left(exponent_field(greatest, fraction_bits) + 1, fraction_bits) - 1;
  return whole;
}

int EncodedRange::exponent_bits() const {
  const int first = exponent_field(least, fraction_bits);
  const int last = exponent_field(greatest, fraction_bits);
  return static_cast<int>(std::bit_width(static_cast<unsigned>(last - first)));
}

/// A multiple of the highest power of two: if 2^exponent_bits divides it, the code is the low bits
/// of the encoding.
int EncodedRange::first_exponent() const {
  const int first = exponent_field(least, fraction_bits);
  const int last = exponent_field(greatest, fraction_bits);
  const int count = 1 << exponent_bits();
  for (int step = count; step > 1; step /= 2) {
    const int multiple = first / step * step;
    if (last < multiple + count) return multiple;
  }
  return first;
}

function::FloatingEncoding EncodedRange::encoding() const {
  return {.fraction_bits = fraction_bits,
          .exponent_bits = exponent_bits(),
          .exponent_of_0 = first_exponent() - format.bias()};
}

mpz_class EncodedRange::first_code() const {
  return least - shifted_left(first_exponent(), fraction_bits);
}

mpz_class EncodedRange::last_code() const {
  return greatest - shifted_left(first_exponent(), fraction_bits);
}

Range EncodedRange::numbers() const {
  return {encoding().number(first_code()), encoding().number(last_code())};
}

std::optional<Range> EncodedRange::moved_by(const Function& function) const {
  const function::FloatingEncoding floating = encoding();
  std::optional<Range> all;
  for (mpz_class code = first_code(); code <= last_code();) {
    const mpz_class next = shifted_left(exponent_field(code, fraction_bits) + 1, fraction_bits);
    const mpz_class last = std::min<mpz_class>(next - 1, last_code());
    const Range binade = {floating.number(code), floating.number(last)};
    const auto exponent = static_cast<int>(floor_log2(binade.low));
    const mpq_class lost =
        power_of_two(exponent - fraction_bits) - power_of_two(exponent - exact_fraction_bits);
    const auto moved = fixed::moved_by(function, binade, {-lost, 0});
    if (!moved) return std::nullopt;
    all = all ? Range{std::min(all->low, moved->low), std::max(all->high, moved->high)} : *moved;
    code = next;
  }
  return all;
}

}  // namespace mixcmp::fixed
