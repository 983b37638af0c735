#include "model/base/number/fixed_format.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "model/base/number/dyadic.hpp"

namespace mixcmp::inline number {

FixedFormat FixedFormat::holding(const mpz_class& low, const mpz_class& high, int unit_exponent) {
  // -2^k needs no more bits than 2^k - 1 does.
  const mpz_class below = low < 0 ? mpz_class(-low - 1) : mpz_class(0);
  const mpz_class farthest = std::max<mpz_class>(below, high);
  const bool is_signed = low < 0;
  return {.width = digits_of(farthest) + (is_signed ? 1 : 0),
          .unit_exponent = unit_exponent,
          .is_signed = is_signed};
}

mpq_class FixedFormat::unit() const {
  return power_of_two(unit_exponent);
}

mpz_class FixedFormat::smallest() const {
  return is_signed ? mpz_class(-shifted_left(1, width - 1)) : mpz_class(0);
}

mpz_class FixedFormat::largest() const {
  return shifted_left(1, is_signed ? width - 1 : width) - 1;
}

std::string FixedFormat::name() const {
  return fmt::format("{}fix{}_E{}{}", is_signed ? "s" : "u", width, unit_exponent < 0 ? "n" : "",
                     std::abs(unit_exponent));
}

}  // namespace mixcmp::inline number
