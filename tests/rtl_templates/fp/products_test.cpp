#include <fmt/core.h>
#include <gmp.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "Vproducts.h"
#include "Vproducts___024root.h"
#include "model/base/common/bits.hpp"

/// Tests products of logic and of multipliers against GMP. All precisions that are built get their
/// factors in the same cycle, and each product is expected at the latency that its mask of cuts
/// names.
namespace mixcmp::test::products_test {
namespace {

constexpr int widest = 113, cuts = 8;

struct Factors {
  Bits a;
  Bits b;
};

/// Four words, the lowest first.
using Wide = std::array<uint64_t, 4>;

/// The kind of multiplier that a product uses.
enum class Kind { logic, logic_behind_digits, embedded };

struct Slot {
  int precision;
  Kind kind;
  bool square;
  bool complemented;

  unsigned cuts() const {
    const auto mask =
        static_cast<unsigned>(37 * precision + 53 * square + 139 * static_cast<int>(kind));
    return (complemented ? ~mask : mask) & 255;
  }
  bool is_built() const {
    const bool both = precision <= 12 && kind != Kind::embedded;
    return both || complemented == ((precision + static_cast<int>(kind) + square) % 2 == 1);
  }
  int latency_cycles() const { return std::popcount(cuts()); }
  int index() const {
    return 12 * precision + 4 * static_cast<int>(kind) + 2 * square + complemented;
  }
};

bool is_built(int precision) {
  return precision <= 12 || (precision >= 16 && precision <= 18) || precision == 24 ||
         precision == 33 || precision == 34 || precision == 53 || precision == 64 ||
         precision == 65 || precision == widest;
}

bool has_multipliers(int precision) {
  return precision <= 12 || precision == 17 || precision == 24 || precision == 34 ||
         precision == 53 || precision == 64 || precision == widest;
}

Bits significand(int precision, Bits low_places) {
  return (Bits{1} << (precision - 1)) | (low_places & ((Bits{1} << (precision - 1)) - 1));
}

Wide wide(Bits bits) {
  return {static_cast<uint64_t>(bits), static_cast<uint64_t>(bits >> 64)};
}

Wide multiplied(Bits a, Bits b) {
  const std::array<mp_limb_t, 2> x = {static_cast<uint64_t>(a), static_cast<uint64_t>(a >> 64)};
  const std::array<mp_limb_t, 2> y = {static_cast<uint64_t>(b), static_cast<uint64_t>(b >> 64)};
  std::array<mp_limb_t, 4> product;
  mpn_mul_n(product.data(), x.data(), y.data(), 2);
  return {product[0], product[1], product[2], product[3]};
}

std::string hex(const Wide& value) {
  return fmt::format("{:016x}{:016x}{:016x}{:016x}", value[3], value[2], value[1], value[0]);
}

class Product : public testing::Test {
protected:
  /// Feeds these factors in one cycle and judges every answer that is due.
  void feed(const Factors& factors) {
    history_.push_front(factors);
    if (history_.size() > cuts + 1) history_.pop_back();
    for (int i = 0; i < 4; ++i) {
      model_.a[i] = static_cast<uint32_t>(factors.a >> (32 * i));
      model_.b[i] = static_cast<uint32_t>(factors.b >> (32 * i));
    }
    model_.aclk = 0;
    model_.eval();
    for (int precision = 2; precision <= widest; ++precision) {
      if (is_built(precision)) judge(precision);
    }
    model_.aclk = 1;
    model_.eval();
  }

  void drain() {
    for (int i = 0; i < cuts; ++i) feed({0, 0});
  }

private:
  void judge(int precision) {
    for (int variant = 0; variant < (has_multipliers(precision) ? 12 : 8); ++variant) {
      const Slot slot = {precision, static_cast<Kind>(variant / 4), (variant & 2) != 0,
                         (variant & 1) != 0};
      const auto latency = static_cast<std::size_t>(slot.latency_cycles());
      if (slot.is_built() && history_.size() > latency) judge(slot);
    }
  }

  void judge(const Slot& slot) {
    const Factors& then = history_[static_cast<std::size_t>(slot.latency_cycles())];
    const Bits a = significand(slot.precision, then.a);
    const Bits b = significand(slot.precision, slot.square ? then.a : then.b);
    const Wide expected = multiplied(a, b);
    ASSERT_EQ(hex(read(slot.index())), hex(expected))
        << "PRECISION=" << slot.precision << " EMBEDDED=" << (slot.kind == Kind::embedded)
        << " DIGIT_STAGE=" << (slot.kind == Kind::logic_behind_digits) << " SQUARE=" << slot.square
        << " CUTS=" << slot.cuts() << " a=" << hex(wide(a)) << " b=" << hex(wide(b));
  }

  Wide read(int index) const {
    Wide value;
    const auto& words = model_.rootp->products__DOT__y[index];
    for (std::size_t i = 0; i < 4; ++i) {
      value[i] = static_cast<uint64_t>(words[2 * i + 1]) << 32 | words[2 * i];
    }
    return value;
  }

  VerilatedContext context_;
  Vproducts model_{&context_};
  std::deque<Factors> history_;  ///< the latest first
};

/// Multiplies every pair of up to 8 bits, and squares every number of up to 15.
TEST_F(Product, EveryPairOfFewBitsIsMultipliedExactly) {
  for (unsigned i = 0; i < 1u << 14 && !HasFatalFailure(); ++i) feed({i, i >> 7});
  drain();
}

/// Splitmix64: number `index` of a stream.
uint64_t drawn(uint64_t index) {
  uint64_t z = (index + 1) * 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

/// A pattern that favours one kind of digits: every digit the same, runs of ones, single ones, or
/// noise.
Bits patterned(uint64_t index) {
  const Bits noise = Bits{drawn(2 * index)} << 64 | drawn(2 * index + 1);
  const int place = static_cast<int>(drawn(~index) % widest);
  switch (drawn(~index) >> 60) {
    case 0: return ~Bits{0};
    case 1: return 0;
    case 2: return ~Bits{0} / 3;
    case 3: return ~Bits{0} / 3 * 2;
    case 4: return ~Bits{0} / 15 * 6;
    case 5: return ~Bits{0} / 15 * 9;
    case 6: return ~Bits{0} / 7 * 3;
    case 7: return Bits{1} << place;
    case 8: return ~(Bits{1} << place);
    case 9: return ~Bits{0} << place;
    case 10: return ~(~Bits{0} << place);
    case 11: return noise & noise >> 1 & noise << 1;
    case 12: return noise | noise >> 1 | noise << 1;
    default: return noise;
  }
}

TEST_F(Product, WideFactorsAreMultipliedExactly) {
  for (uint64_t i = 0; i < 12000 && !HasFatalFailure(); ++i) {
    feed({patterned(2 * i), patterned(2 * i + 1)});
  }
  drain();
}

}  // namespace
}  // namespace mixcmp::test::products_test
