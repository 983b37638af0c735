#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>
#include <vector>

#include "model/base/number/dyadic.hpp"
#include "model/lane/function/piecewise.hpp"

namespace mixcmp::function {

/// The pieces of the arguments: with so many lower bits of the code C, or with starts.
struct Pieces {
  Argument argument;
  bool is_floating;  ///< C is the FloatingCode of the argument
  std::optional<FloatingEncoding> encoding;
  int piece_bits;
  FixedFormat code;
  std::vector<mpz_class> starts = {};
  mpz_class least, greatest;  ///< C of the arguments
  mpz_class first, last;      ///< the pieces that hold arguments: C / 2^piece_bits, rounded down

  Pieces(const Argument& numbers, bool floating, int bits, const mpz_class& from,
         const mpz_class& to)
      : argument(numbers),
        is_floating(floating),
        encoding(encoding_of(numbers, floating)),
        piece_bits(bits),
        code(encoding ? encoding->format() : numbers.format),
        least(code_of(from)),
        greatest(code_of(to)),
        first(upper(least)),
        last(upper(greatest)) {}

  Pieces(const Argument& numbers, std::vector<mpz_class> all_starts, const mpz_class& from,
         const mpz_class& to)
      : argument(numbers),
        is_floating(false),
        piece_bits(0),
        code(numbers.format),
        starts(std::move(all_starts)),
        least(from),
        greatest(to),
        first(piece_of(from)),
        last(piece_of(to)) {
    piece_bits = digits_of(floor_of(scaled(span(), -code.unit_exponent)));
  }

  int address_bits() const {
    if (starts.empty()) return code.width - piece_bits;
    return static_cast<int>(std::bit_width(starts.size() - 1));
  }
  /// The piece of an argument.
  mpz_class of(const mpz_class& number) const {
    return starts.empty() ? upper(code_of(number)) : piece_of(number);
  }
  /// The least argument in a piece that holds arguments.
  mpz_class first_argument(const mpz_class& piece) const {
    const mpz_class from = std::max(first_code(piece), least);
    if (!is_floating) return from;
    return ceiling_of(scaled(encoding->number(from), -argument.format.unit_exponent));
  }
  /// The piece of an argument among those with starts.
  mpz_class piece_of(const mpz_class& number) const {
    const auto above = std::upper_bound(starts.begin() + 1, starts.end(), number);
    return static_cast<unsigned long>(above - starts.begin() - 1);
  }
  mpz_class code_of(const mpz_class& number) const {
    return is_floating ? FloatingCode{argument.format.width}.of(number) : number;
  }
  mpz_class upper(const mpz_class& number) const {
    return floor_of(scaled(mpq_class(number), -piece_bits));
  }
  std::size_t address(const mpz_class& piece) const {
    mpz_class address;
    mpz_fdiv_r_2exp(address.get_mpz_t(), piece.get_mpz_t(),
                    static_cast<mp_bitcnt_t>(address_bits()));
    return address.get_ui();
  }
  /// The exponent of the power of two that an argument grows by where C does by one.
  int step_exponent(const mpz_class& piece) const {
    if (!encoding) return argument.format.unit_exponent;
    return static_cast<int>(field_of(piece).get_si()) + encoding->exponent_of_0 -
           encoding->fraction_bits;
  }
  /// Whether the piece's only argument is 0, at t = 0.
  bool is_zero(const mpz_class& piece) const {
    return encoding && field_of(piece) < encoding->least_field;
  }
  /// The argument at t = 0.
  mpq_class start(const mpz_class& piece) const {
    const mpz_class number = first_code(piece);
    if (encoding) return encoding->number(number);
    return scaled(mpq_class(number), argument.format.unit_exponent);
  }
  /// By how much an argument grows where t does by one.
  mpq_class slope(const mpz_class& piece) const {
    return power_of_two(step_exponent(piece) - code.unit_exponent);
  }
  /// The t of the arguments in a piece.
  Range places(const mpz_class& piece) const {
    if (is_zero(piece)) return {0, 0};
    const mpz_class start = first_code(piece), most = first_code(piece + 1) - 1 - start;
    const mpz_class from = least - start, to = greatest - start;
    return {scaled(mpq_class(std::max<mpz_class>(0, from)), code.unit_exponent),
            scaled(mpq_class(std::min(most, to)), code.unit_exponent)};
  }
  /// The greatest t of any piece.
  mpq_class span() const {
    if (!starts.empty()) {
      mpq_class most = 0;
      for (mpz_class piece = first; piece <= last; ++piece) {
        most = std::max(most, places(piece).high);
      }
      return most;
    }
    return scaled(mpq_class(shifted_left(1, piece_bits) - 1), code.unit_exponent);
  }

  /// C where a piece begins; beyond the last start, one beyond the arguments.
  mpz_class first_code(const mpz_class& piece) const {
    if (starts.empty()) return shifted_left(piece, piece_bits);
    return piece < starts.size() ? starts[piece.get_ui()] : mpz_class(greatest + 1);
  }

private:
  static std::optional<FloatingEncoding> encoding_of(const Argument& numbers, bool floating) {
    if (!floating) return numbers.encoding;
    return FloatingCode{numbers.format.width}.encoding(numbers.format.unit_exponent);
  }
  /// The exponent field of the codes of a piece.
  mpz_class field_of(const mpz_class& piece) const {
    return floor_of(scaled(mpq_class(piece), piece_bits - encoding->fraction_bits));
  }
};

}  // namespace mixcmp::function
