#include "tests/rtl_templates/fp/vectors.hpp"

#include <algorithm>

namespace mixcmp::test {
namespace {

/// The random numbers of one vector: SplitMix64 of (seed, index, draw). They are counter-based, so
/// each vector can be drawn by itself.
class Draw {
public:
  Draw(uint64_t seed, uint64_t index) : state_(mix(mix(seed) + index)) {}

  uint64_t word() { return mix(state_ += 0x9e3779b97f4a7c15); }
  Bits bits(int width) {
    const Bits upper = word();
    return (upper << 64 | word()) & low_mask(width);
  }
  /// A random number from 0 to limit - 1.
  int below(int limit) { return static_cast<int>(word() % static_cast<uint64_t>(limit)); }
  /// A random number from -distance to distance.
  int near(int distance) { return below(2 * distance + 1) - distance; }
  bool coin() { return (word() & 1) != 0; }

private:
  static uint64_t mix(uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  uint64_t state_;
};

Bits one(FloatFormat format) {
  return format.pack(false, format.bias(), 0);
}

int clamp_exponent(FloatFormat format, int biased) {
  return std::clamp(biased, 0, format.max_biased_exponent());
}

/// The result format's smallest and largest normal exponents, biased as the operands are.
int lowest_result(FloatFormat operands, FloatFormat result) {
  return result.min_exponent() + operands.bias();
}
int highest_result(FloatFormat operands, FloatFormat result) {
  return result.max_exponent() + operands.bias();
}

/// A fraction for exact products, quotients and roots: at its top is the product of two short
/// significands without its leading one.
Bits fraction_of_product(FloatFormat format, Bits first, Bits second) {
  Bits product = first * second;
  if (product == 0) return 0;
  while ((product >> format.fraction_bits()) != 0) product >>= 1;
  while ((product >> format.fraction_bits()) == 0) product <<= 1;
  return format.fraction(product);
}

Bits draw_short_significand(FloatFormat format, Draw& draw) {
  const int width = 1 + draw.below(std::max(1, format.precision() / 2));
  return draw.bits(width) | Bits{1} << (width - 1);
}

/// The fraction with a tail of random length in place of its last bits: that of a tie, one a step
/// beside it, or all ones.
Bits with_tie_tail(FloatFormat format, Bits fraction, Draw& draw) {
  const int tail = 1 + draw.below(format.fraction_bits());
  const Bits half = Bits{1} << (tail - 1);
  const std::array<Bits, 4> tails = {half, half - 1, half + 1, 2 * half - 1};
  const Bits mask = low_mask(tail);
  return (fraction & ~mask) | (tails[draw.below(4)] & mask);
}

Bits draw_fraction(FloatFormat format, Draw& draw) {
  const int width = format.fraction_bits();
  const Bits uniform = draw.bits(width);
  switch (draw.below(8)) {
    case 0: return 0;
    case 1: return low_mask(width);
    case 2: return uniform & ~low_mask(draw.below(width + 1));
    case 3: return Bits{1} << draw.below(width);
    case 4: return with_tie_tail(format, uniform, draw);
    case 5: {
      const Bits root = draw_short_significand(format, draw);
      return (fraction_of_product(format, root, root) + draw.near(1)) & low_mask(width);
    }
    default: return uniform;
  }
}

int draw_exponent(FloatFormat operands, FloatFormat result, Draw& draw) {
  const int reach = std::max(operands.precision(), result.precision()) + 3;
  switch (draw.below(8)) {
    case 0: return clamp_exponent(operands, draw.below(3));
    case 1: return clamp_exponent(operands, operands.max_biased_exponent() - draw.below(3));
    case 2: return clamp_exponent(operands, operands.bias() + draw.near(reach));
    case 3: return clamp_exponent(operands, lowest_result(operands, result) + draw.near(reach));
    case 4: return clamp_exponent(operands, highest_result(operands, result) + draw.near(2));
    default: return draw.below(operands.max_biased_exponent() + 1);
  }
}

/// An exponent whose relation to the first operand's matters to one of the units.
int draw_second_exponent(FloatFormat operands, FloatFormat result, int first, Draw& draw) {
  const int reach = std::max(operands.precision(), result.precision()) + 3;
  const int target = draw.coin() ? lowest_result(operands, result) - draw.below(reach)
                                 : highest_result(operands, result) + draw.near(2);
  switch (draw.below(8)) {
    case 0: return draw_exponent(operands, result, draw);
    case 1: return first;
    case 2: return clamp_exponent(operands, first + draw.near(1));
    case 3:
    case 4: return clamp_exponent(operands, first + draw.near(reach));
    case 5: return clamp_exponent(operands, target + operands.bias() - first + draw.near(1));
    case 6: return clamp_exponent(operands, first + operands.bias() - target + draw.near(1));
    default: return draw.below(operands.max_biased_exponent() + 1);
  }
}

}  // namespace

std::vector<Bits> special_values(FloatFormat operands, FloatFormat result) {
  const FloatFormat f = operands;
  const Bits infinity = f.infinity(false);
  std::vector<Bits> values = {
      0,
      1,
      2,
      f.smallest_normal(false) - 1,
      f.smallest_normal(false),
      f.smallest_normal(false) + 1,
      f.smallest_normal(false) + f.smallest_normal(false),
      one(f) - 1,
      one(f),
      one(f) + 1,
      one(f) + f.smallest_normal(false) - 1,
      one(f) + f.smallest_normal(false),
      one(f) | Bits{1} << (f.fraction_bits() - 1),
      f.largest_finite(false),
      f.largest_finite(false) - 1,
      infinity,
      infinity + 1,
      f.quiet_nan(),
      infinity | low_mask(f.fraction_bits()),
  };
  for (const int edge : {lowest_result(operands, result), highest_result(operands, result)}) {
    for (const int exponent : {edge - result.precision(), edge - 1, edge, edge + 1}) {
      const Bits packed = f.pack(false, clamp_exponent(f, exponent), 0);
      values.insert(values.end(), {packed, packed | 1, packed | low_mask(f.fraction_bits())});
    }
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  const size_t count = values.size();
  for (size_t i = 0; i < count; ++i) values.push_back(values[i] | f.zero(true));
  return values;
}

Stimulus random_stimulus(FloatFormat operands, FloatFormat result, uint64_t seed, uint64_t index) {
  Draw draw(seed, index);
  const int a_exponent = draw_exponent(operands, result, draw);
  const int b_exponent = draw_second_exponent(operands, result, a_exponent, draw);
  Bits a_fraction = draw_fraction(operands, draw);
  Bits b_fraction = draw_fraction(operands, draw);
  const int relation = draw.below(6);
  if (relation == 0) b_fraction = (a_fraction + draw.near(2)) & low_mask(operands.fraction_bits());
  if (relation == 1) {
    const Bits divisor = draw_short_significand(operands, draw);
    const Bits quotient = draw_short_significand(operands, draw);
    a_fraction = fraction_of_product(operands, divisor, quotient);
    b_fraction = fraction_of_product(operands, divisor, 1);
  }
  return {operands.pack(draw.coin(), a_exponent, a_fraction),
          operands.pack(draw.coin(), b_exponent, b_fraction), draw.below(16) == 0};
}

Stimulus neighbour_stimulus(FloatFormat operands, FloatFormat result, uint64_t seed,
                            uint64_t index) {
  Draw draw(~seed, index);
  const Stimulus start = random_stimulus(operands, result, seed, index);
  const Bits b = operands.magnitude(start.a + draw.near(2));
  return {start.a, b | operands.zero(draw.coin()), false};
}

}  // namespace mixcmp::test
