#include <algorithm>
#include <random>

#include "tests/rtl_templates/bound/bound_units_fixture.hpp"
#include "tests/support/float_samples.hpp"

namespace mixcmp::test::bound_units_test {
namespace {

constexpr int random_stimuli = 30'000;

/// A bound that is random by field. Its exponent is uniform, at either end, or close to `near`; its
/// fraction is uniform, zeros or ones.
Bits random_bound(int near, std::mt19937_64& random) {
  const int top = (1 << bound.exponent_bits) - 2;
  int exponent = 1 + static_cast<int>(random() % static_cast<unsigned>(top));
  const int reach = bound.precision + 2;
  const int offset = static_cast<int>(random() % static_cast<unsigned>(2 * reach + 1)) - reach;
  switch (random() % 8) {
    case 0: return random() % 2 == 0 ? 0 : bound.infinity();
    case 1: exponent = 1 + std::max(0, offset); break;
    case 2: exponent = top - std::max(0, offset); break;
    case 3:
    case 4:
    case 5: exponent = near + offset; break;
    default: break;
  }
  Bits fraction = random();
  if (random() % 4 == 0) fraction = 0;
  if (random() % 4 == 0) fraction = ~Bits{0};
  exponent = std::clamp(exponent, 1, top);
  return (Bits(exponent) << (bound.precision - 1)) | (fraction & low_mask(bound.precision - 1));
}

int exponent_of(Bits value) {
  return static_cast<int>(value >> (bound.precision - 1));
}

/// Exponents that are close, and exponents whose sum is close to an end of the range.
TEST_F(BoundUnits, RandomPairsOfBounds) {
  std::mt19937_64 random(1);
  const int ends[] = {bound.bias(), 3 * bound.bias()};
  for (int i = 0; i < random_stimuli; ++i) {
    const Bits a = random_bound(bound.bias(), random);
    const bool product = random() % 2 == 0;
    const int near = product ? ends[random() % 2] - exponent_of(a) : exponent_of(a);
    feed({.a = a, .b = random_bound(near, random)});
  }
}

/// Numbers at and beside the bound they are compared with.
TEST_F(BoundUnits, RandomNumbersAgainstBoundsNearThem) {
  std::mt19937_64 random(2);
  for (int i = 0; i < random_stimuli; ++i) {
    const Bits a = random_bound(bound.bias(), random);
    Bits x = random_encoding(lane, random);
    if (random() % 2 == 0) {
      const Bits beside = (a << (lane.precision() - bound.precision)) + random() % 5 - 2;
      x = lane.magnitude(beside) | lane.zero(random() % 2 == 0);
    }
    feed({.x = x, .a = a, .exceptional = random() % 8 == 0});
  }
}

TEST_F(BoundUnits, SpecialNumbers) {
  for (const Bits x : special_encodings(lane)) {
    for (const Bits a : {Bits{0}, bound.smallest(), bound.infinity() - 1, bound.infinity()}) {
      feed({.x = x, .a = a});
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::bound_units_test
