#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "tests/support/float_samples.hpp"

namespace mixcmp::test {

/// Operands of sums of products: unrelated ones, ones of like magnitude, and ones whose products
/// nearly cancel or are short enough for ties.
class FusedOperandMaker {
public:
  using Operands = std::array<Bits, 5>;

  FusedOperandMaker(FloatFormat format, std::uint64_t seed)
      : format_(format), specials_(special_encodings(format)), random_(seed) {}

  Operands next() {
    Operands x = {};
    for (Bits& each : x) each = random_encoding(format_, random_);
    switch (random_() % 6) {
      case 0: return x;
      case 1: return near(x);
      case 2: return cancelling(near(x));
      case 3: return cancelling(x);
      case 4: return short_ones(near(x));
      default: x[random_() % x.size()] = specials_[random_() % specials_.size()]; return x;
    }
  }

private:
  Operands near(Operands x) {
    for (std::size_t k = 1; k < x.size(); ++k) x[k] = random_encoding_near(format_, x[0], random_);
    return x;
  }

  /// x0 x1 and x2 x3 with equal factors, or with factors a few units in the last place apart.
  Operands cancelling(Operands x) {
    const auto beside = [&](Bits bits) {
      const Bits magnitude = format_.magnitude(bits) + random_() % 3;
      return magnitude <= format_.magnitude(format_.infinity(false)) ? magnitude : bits;
    };
    x[2] = beside(x[0]);
    x[3] = beside(x[1]);
    return x;
  }

  /// Keeps only a few digits of each significand.
  Operands short_ones(Operands x) {
    const int dropped = format_.fraction_bits() - static_cast<int>(random_() % 3) - 1;
    for (Bits& each : x) each = (each >> std::max(dropped, 0)) << std::max(dropped, 0);
    return x;
  }

  FloatFormat format_;
  std::vector<Bits> specials_;
  std::mt19937_64 random_;
};

}  // namespace mixcmp::test
