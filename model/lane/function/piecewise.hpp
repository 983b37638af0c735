#pragma once

#include <gmpxx.h>

#include <bit>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "model/base/number/fixed_format.hpp"
#include "model/comparison/expression/function.hpp"
#include "model/comparison/expression/range.hpp"

/// Functions as polynomials of pieces, in fixed point. Proof: docs/fixed_point.md, theorem 10.
namespace mixcmp::function {

/// The words of a table, which its copies share.
class Words {
public:
  Words() = default;
  explicit Words(std::vector<mpz_class> words)
      : words_(std::make_shared<const std::vector<mpz_class>>(std::move(words))) {}

  /// A power of two, or 0: there is no table.
  std::size_t size() const { return words_ ? words_->size() : 0; }
  const mpz_class& operator[](std::size_t address) const { return (*words_)[address]; }
  /// The bits of an address. There is a table.
  int address_bits() const { return std::countr_zero(words_->size()); }

  friend bool operator==(const Words& a, const Words& b) {
    return a.words_ == b.words_ || (a.words_ && b.words_ && *a.words_ == *b.words_);
  }

private:
  std::shared_ptr<const std::vector<mpz_class>> words_;
};

/// The polynomials' coefficients of t^k, one word for each piece.
struct CoefficientTable {
  FixedFormat format;
  Words words;  ///< in units, [address]

  friend bool operator==(const CoefficientTable&, const CoefficientTable&) = default;
};

/// Numbers above 0 as integers that grow with them: the code k 2^fraction_bits + F, F below
/// 2^fraction_bits, stands for 2^(k + exponent_of_0) (1 + F / 2^fraction_bits).
struct FloatingEncoding {
  int fraction_bits;
  int exponent_bits;    ///< of k
  int exponent_of_0;    ///< that of the numbers whose k is 0
  int least_field = 0;  ///< a smaller k stands for the number 0

  /// The codes. The unit is that of F / 2^fraction_bits.
  FixedFormat format() const;
  /// The real number that a code stands for.
  mpq_class number(const mpz_class& code) const;
  friend auto operator<=>(const FloatingEncoding&, const FloatingEncoding&) = default;
};

/// A number without a sign as a floating-point one: for X = 2^e (1 + F / 2^(w - 1)) of w bits, the
/// integer (e + offset) 2^(w - 1) + F, whose exponent field ends at all ones. 0 has the next
/// smaller field. It grows with X.
struct FloatingCode {
  int width;  ///< w, 2 or more

  int fraction_bits() const { return width - 1; }
  int exponent_bits() const { return std::bit_width(static_cast<unsigned>(width)); }
  int offset() const { return (1 << exponent_bits()) - width; }
  /// The encoding of the numbers X 2^unit_exponent.
  FloatingEncoding encoding(int unit_exponent) const;
  FixedFormat format() const { return encoding(0).format(); }
  mpz_class of(const mpz_class& number) const;
};

/// The numbers that a function is computed of: those of a fixed-point format, or of an encoding,
/// whose codes the format holds.
struct Argument {
  FixedFormat format;
  std::optional<FloatingEncoding> encoding = {};

  friend bool operator==(const Argument&, const Argument&) = default;
};

/// A function of an argument X. C is X itself, which may be a code or, if the pieces shrink towards
/// 0, a fixed-point X as a FloatingCode. The upper bits of C, in two's complement if it is signed,
/// are the address of a piece; t is what the `piece_bits` lower bits count, in C's units. Pieces
/// with `starts` begin at the points of a table: the address is the number of starts but the first
/// that are at or below X, and t is X less the start. With the words c[k] at the address,
///   s[degree] = c[degree],  s[k] = c[k] + (s[k + 1] t, cut to the unit of c[k]),
/// and the result is s[0] cut to `result`. Words of pieces that no argument reaches are those of
/// others.
struct Piecewise {
  Argument argument;
  bool is_floating = false;  ///< C is the FloatingCode of X
  int piece_bits = 0;
  std::vector<mpz_class> starts = {};          ///< in units of the argument, growing
  std::vector<CoefficientTable> coefficients;  ///< [k], at least one
  FixedFormat result;
  /// Encloses the result less the function's real value at X, for every X of the arguments.
  Range error;

  /// The format of C.
  FixedFormat code() const;
  int degree() const { return static_cast<int>(coefficients.size()) - 1; }
  int address_bits() const;
  friend bool operator==(const Piecewise&, const Piecewise&) = default;
};

/// The result of hardware for the argument X, in units of the result; X is one of the arguments.
mpz_class evaluate(const Piecewise& piecewise, const mpz_class& argument);

/// The hardware of a product of coefficients and t.
enum class ProductKind {
  embedded,  ///< the device's multiplier blocks
  logic,     ///< rows of carry chains
};

/// A piecewise polynomial whose error is less than a unit of 2^unit_exponent, of the least area
/// among degrees and numbers of pieces by a rough model. `arguments`: the least and the greatest
/// X, in units of the format, or codes. None if the function has no value somewhere between them,
/// or if more pieces would be needed than 2^most_address_bits. Equal calls are answered from
/// memory.
std::optional<Piecewise> approximate(const Function& function, const Argument& argument,
                                     const mpz_class& least, const mpz_class& greatest,
                                     int unit_exponent,
                                     ProductKind products = ProductKind::embedded);

inline constexpr int most_address_bits = 10;
/// Each start costs a comparison.
inline constexpr std::size_t most_starts = 128;

}  // namespace mixcmp::function
