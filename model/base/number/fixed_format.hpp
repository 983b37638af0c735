#pragma once

#include <gmpxx.h>

#include <string>

namespace mixcmp::inline number {

/// A fixed-point format: integers of `width` bits, in two's complement if signed, in units of
/// 2^unit_exponent.
struct FixedFormat {
  int width = 1;
  int unit_exponent = 0;
  bool is_signed = false;

  /// The narrowest format that holds the integers from `low` to `high`; at least one bit wide.
  static FixedFormat holding(const mpz_class& low, const mpz_class& high, int unit_exponent);

  int magnitude_bits() const { return is_signed ? width - 1 : width; }
  mpq_class unit() const;
  mpz_class smallest() const;  ///< in units
  mpz_class largest() const;   ///< in units
  /// "sfix14_En6": signed, 14 bits, a unit of 2^-6; "ufix13_E2": unsigned, 13 bits, a unit of 2^2.
  std::string name() const;

  friend bool operator==(const FixedFormat&, const FixedFormat&) = default;
};

}  // namespace mixcmp::inline number
