#pragma once

#include <algorithm>

#include "model/cost/devices/device.hpp"

namespace mixcmp::datapath {

/// The sizes in rtl_templates/fp/fp_embedded_square.v, and the condition under which fp_product.v
/// instantiates that template. This class repeats both.
class EmbeddedSquare {
public:
  /// The links of the chain of products that have a cut of their own behind them.
  static constexpr int cut_links = 4;

  EmbeddedSquare(int precision, devices::MultiplierSize multiplier)
      : precision_(precision), multiplier_(multiplier) {}

  /// Tells whether a square that uses its symmetry takes fewer multipliers than a product does.
  bool is_smaller() const {
    const int products =
        ceil_div(precision_, multiplier_.a_bits) * ceil_div(precision_, multiplier_.b_bits);
    return spare_bits() >= 0 && parts() > 1 && multipliers() < products;
  }

  int multipliers() const { return parts() * (parts() + 1) / 2; }
  /// The number of products of two different parts. Each is added to those before it.
  int links() const { return parts() * (parts() - 1) / 2; }
  /// The last part has more bits than a multiplier's narrow side: logic adds the contribution of
  /// the excess bits.
  bool has_excess() const { return precision_ > parts() * multiplier_.b_bits; }

  /// Bits that the lower and the upper half of the last sum add.
  int lower_half_bits() const { return sum_bits() / 2; }
  int upper_half_bits() const { return sum_bits() - lower_half_bits(); }

private:
  static int ceil_div(int a, int b) { return (a + b - 1) / b; }

  int spare_bits() const { return std::min(2, multiplier_.a_bits - multiplier_.b_bits); }
  int parts() const {
    return precision_ > spare_bits() ? ceil_div(precision_ - spare_bits(), multiplier_.b_bits) : 1;
  }
  /// Bits of the last sum. No product of two parts has bits below these.
  int sum_bits() const { return 2 * precision_ - multiplier_.b_bits - 1; }

  int precision_;
  devices::MultiplierSize multiplier_;
};

}  // namespace mixcmp::datapath
