// Finds values for which double cannot be trusted. Only kernels.cpp includes this file, once per
// instruction set.
#if defined(MIXCMP_EMULATOR_DOUBTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MIXCMP_EMULATOR_DOUBTS_INL
#undef MIXCMP_EMULATOR_DOUBTS_INL
#else
#define MIXCMP_EMULATOR_DOUBTS_INL
#endif

#include <algorithm>
#include <cmath>
#include <cstring>

#include "model/judge/emulator/rounding-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mixcmp::emulator::HWY_NAMESPACE {

bool all_inside(const OperandWindow& window, const Block& block) {
  const auto least = hn::Set(Long(), window.least);
  const std::size_t lanes = hn::Lanes(Tag());
  auto even = hn::Zero(Long()), odd = hn::Zero(Long());
  for (const int column : window.columns) {
    const double* HWY_RESTRICT values = block.columns[column];
    const auto above = [&](std::size_t i) HWY_ATTR {
      return hn::Sub(hn::BitCast(Long(), hn::LoadU(Tag(), values + i)), least);
    };
    for (std::size_t i = 0; i < block.size; i += 4 * lanes) {
      even = hn::Or(even, hn::Or(above(i), above(i + 2 * lanes)));
      odd = hn::Or(odd, hn::Or(above(i + lanes), above(i + 3 * lanes)));
    }
  }
  const auto outside = hn::And(hn::Or(even, odd), hn::Set(Long(), window.outside));
  return hn::AllTrue(Long(), hn::Eq(outside, hn::Zero(Long())));
}

#if HWY_TARGET == HWY_SCALAR

inline bool is_trusted(const TrustedRange& range, double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  const double magnitude = std::fabs(value);
  return (bits & range.zero_bits) == 0 && magnitude < range.limit &&
         (magnitude == 0 || magnitude >= range.least);
}

bool find_doubts(const std::vector<TrustedRange>& ranges, const Block& block,
                 std::uint64_t* doubts) {
  bool any = false;
  for (std::size_t i = 0; i < block.size; ++i) {
    bool trusted = true;
    for (const TrustedRange& range : ranges) {
      for (const int column : range.columns) {
        trusted = trusted && is_trusted(range, block.columns[column][i]);
      }
    }
    doubts[i] = trusted ? 0 : ~std::uint64_t{0};
    any = any || !trusted;
  }
  return any;
}

#else

/// Packs halves of two vectors of doubles into one vector, the second vector's in odd places.
/// `upper_halves` takes the upper halves of twice their bits: no sign, the whole exponent, 21
/// digits.

HWY_INLINE WordVec interleave(hn::Vec<Long> even, hn::Vec<Long> odd) {
  return hn::OddEven(hn::BitCast(Word(), odd), hn::BitCast(Word(), even));
}

HWY_INLINE WordVec upper_halves(hn::Vec<Long> first, hn::Vec<Long> second) {
  return interleave(hn::ShiftRight<31>(first), hn::Add(second, second));
}

/// 1 if the lower half is not 0, so that a number below 2^-1043 does not count as 0.
HWY_INLINE WordVec any_lower_digit(hn::Vec<Long> first, hn::Vec<Long> second) {
  return hn::Min(interleave(first, hn::ShiftLeft<32>(second)), hn::Set(Word(), 1));
}

inline std::uint32_t upper_half(double power_of_two) {
  std::uint64_t bits;
  std::memcpy(&bits, &power_of_two, sizeof bits);
  return static_cast<std::uint32_t>(bits >> 31);
}

/// All ones if a number of the two vectors at i has a digit that should be 0 and is not.
HWY_INLINE WordVec surplus_digits(const TrustedRange& range, const Block& block, std::size_t i) {
  auto first = hn::Zero(Long()), second = hn::Zero(Long());
  for (const int column : range.columns) {
    const double* values = block.columns[column] + i;
    first = hn::Or(first, hn::BitCast(Long(), hn::LoadU(Tag(), values)));
    second = hn::Or(second, hn::BitCast(Long(), hn::LoadU(Tag(), values + hn::Lanes(Tag()))));
  }
  const auto zero_bits = hn::Set(Long(), range.zero_bits);
  const auto has = [&](hn::Vec<Long> digits) HWY_ATTR {
    return hn::VecFromMask(Long(), hn::Ne(hn::And(digits, zero_bits), hn::Zero(Long())));
  };
  return interleave(has(first), has(second));
}

/// All ones if a number of the two vectors at i is outside the range. `smallest` holds magnitudes
/// less one: 0 wraps around to the largest word, so zeros never count as too small.
template <bool any_double>
HWY_INLINE WordVec outside(const TrustedRange& range, const Block& block, std::size_t i) {
  const WordVec one = hn::Set(Word(), 1);
  WordVec smallest = hn::Set(Word(), ~0u), greatest = hn::Zero(Word());
  for (const int column : range.columns) {
    const double* values = block.columns[column] + i;
    const auto first = hn::BitCast(Long(), hn::LoadU(Tag(), values));
    const auto second = hn::BitCast(Long(), hn::LoadU(Tag(), values + hn::Lanes(Tag())));
    WordVec magnitudes = upper_halves(first, second);
    if (any_double) magnitudes = hn::Or(magnitudes, any_lower_digit(first, second));
    greatest = hn::Max(greatest, magnitudes);
    smallest = hn::Min(smallest, hn::Sub(magnitudes, one));
  }
  const WordVec least = hn::Set(Word(), std::max(upper_half(range.least), 1u) - 1);
  const WordVec most = hn::Set(Word(), upper_half(range.limit) - 1);
  return hn::Or(hn::VecFromMask(Word(), hn::Lt(smallest, least)),
                hn::VecFromMask(Word(), hn::Gt(greatest, most)));
}

bool find_doubts(const std::vector<TrustedRange>& ranges, const Block& block,
                 std::uint64_t* doubts) {
  const std::size_t lanes = hn::Lanes(Tag());
  WordVec any = hn::Zero(Word());
  for (std::size_t i = 0; i < block.size; i += 2 * lanes) {
    WordVec found = hn::Zero(Word());
    for (const TrustedRange& range : ranges) {
      found = hn::Or(found, range.any_double ? outside<true>(range, block, i)
                                             : outside<false>(range, block, i));
      if (range.zero_bits != 0) found = hn::Or(found, surplus_digits(range, block, i));
    }
    const auto pair = hn::BitCast(Long(), found);
    hn::StoreU(hn::ShiftLeft<32>(pair), Long(), doubts + i);
    hn::StoreU(pair, Long(), doubts + i + lanes);
    any = hn::Or(any, found);
  }
  return !hn::AllTrue(Word(), hn::Eq(any, hn::Zero(Word())));
}

#endif

}  // namespace mixcmp::emulator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
