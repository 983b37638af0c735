#include "model/judge/emulator/fixed_kernels.hpp"

#include <cmath>
#include <utility>

// On x86 only the baseline, AVX2 and AVX-512 are worth their compile time. Arrays of vectors, as
// below, need vectors of a size that the compiler knows.
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/judge/emulator/fixed_kernels.cpp"
#include "hwy/foreach_target.h"
// after foreach_target.h
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace mixcmp::emulator::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<double>;
using Int = hn::RebindToSigned<Tag>;
using Vec = hn::Vec<Tag>;
using IntVec = hn::Vec<Int>;
using Words = hn::RebindToUnsigned<Int>;

/// 2^exponent, for exponents of normal numbers.
HWY_INLINE Vec power_of(IntVec exponent) {
  const IntVec biased = hn::Add(exponent, hn::Set(Int(), 1023));
  return hn::BitCast(Tag(), hn::ShiftLeft<52>(biased));
}

/// The division takes two steps, since the reciprocal of the largest power is no normal number.
void execute_common_power(const FixedInstruction& instruction, const Block& block) {
  const IntVec least = hn::Set(Int(), instruction.least_exponent + 1022);
  const IntVec no_number = hn::Set(Int(), 2047);
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(Tag())) {
    IntVec largest = hn::Zero(Int());
    for (const FixedCut& input : instruction.cuts) {
      const Vec magnitude = hn::Abs(hn::LoadU(Tag(), block.columns[input.operand] + i));
      largest = hn::Max(largest, hn::BitCast(Int(), magnitude));
    }
    const IntVec biased = hn::ShiftRight<52>(largest);
    const IntVec exponent = hn::Sub(hn::Set(Int(), 1022), hn::Max(biased, least));
    const IntVec half = hn::ShiftRight<1>(exponent);
    const Vec first = hn::IfThenElse(hn::RebindMask(Tag(), hn::Eq(biased, no_number)),
                                     hn::NaN(Tag()), power_of(half));
    const Vec second = power_of(hn::Sub(exponent, half));
    for (const FixedCut& input : instruction.cuts) {
      const Vec operand = hn::LoadU(Tag(), block.columns[input.operand] + i);
      hn::StoreU(hn::Mul(hn::Mul(operand, first), second), Tag(), block.results[input.result] + i);
    }
  }
}

/// The vectors that hold a sum of block_granularity comparisons stay in registers while its terms
/// are added, so a jump to each term's code costs little.
constexpr std::size_t group = block_granularity / hn::MaxLanes(Tag());

/// Adds the term's values for the comparisons from number `first` on.
HWY_INLINE void add(const FixedTerm& term, const Block& block, std::size_t first,
                    Vec (&sum)[group]) {
  const double* const a_column = block.columns[term.a] + first;
  const double* const b_column = block.columns[term.b] + first;
  const auto each = [&](auto added) HWY_ATTR {
    for (std::size_t k = 0; k < group; ++k) {
      const std::size_t i = k * hn::Lanes(Tag());
      sum[k] = added(hn::LoadU(Tag(), a_column + i), hn::LoadU(Tag(), b_column + i), sum[k]);
    }
  };
  const auto add_product = [&](auto factors) HWY_ATTR {
    if (term.is_negative) {
      each([&](Vec a, Vec b, Vec onto) HWY_ATTR {
        const auto [x, y] = factors(a, b);
        return hn::NegMulAdd(x, y, onto);
      });
    } else {
      each([&](Vec a, Vec b, Vec onto) HWY_ATTR {
        const auto [x, y] = factors(a, b);
        return hn::MulAdd(x, y, onto);
      });
    }
  };
  const auto twice = [](Vec x) HWY_ATTR { return std::pair(x, x); };
  switch (term.kind) {
    case FixedTerm::Kind::value:
      return add_product([&](Vec a, Vec) HWY_ATTR { return std::pair(hn::Set(Tag(), 1), a); });
    case FixedTerm::Kind::product:
      return add_product([&](Vec a, Vec b) HWY_ATTR { return std::pair(a, b); });
    case FixedTerm::Kind::square_of_sum:
      return add_product([&](Vec a, Vec b) HWY_ATTR { return twice(hn::Add(a, b)); });
    case FixedTerm::Kind::square_of_difference:
      return add_product([&](Vec a, Vec b) HWY_ATTR { return twice(hn::Sub(a, b)); });
  }
}

/// The sum of the terms of the comparisons from number `first` on.
HWY_INLINE void add_up(const FixedSum& terms, const Block& block, std::size_t first,
                       Vec (&sum)[group]) {
  for (Vec& each : sum) each = hn::Zero(Tag());
  for (const FixedTerm& term : terms) add(term, block, first, sum);
}

void execute_sum(const FixedInstruction& instruction, const Block& block) {
  double* const results = block.results[instruction.result];
  for (std::size_t first = 0; first < block.size; first += block_granularity) {
    Vec sum[group];
    add_up(instruction.terms, block, first, sum);
    for (std::size_t k = 0; k < group; ++k) {
      hn::StoreU(sum[k], Tag(), results + first + k * hn::Lanes(Tag()));
    }
  }
}

/// The power of two by which a common cut multiplies: 1, or the largest that makes all integers
/// less than `beyond` in magnitude, or -beyond. A NaN if one of them is a NaN.
HWY_INLINE Vec common_factor(const FixedInstruction& instruction, const Block& block,
                             std::size_t i) {
  const Vec one = hn::Set(Tag(), 1);
  Vec largest = hn::Zero(Tag()), no_number = hn::Zero(Tag());
  for (const FixedCut& cut : instruction.cuts) {
    const Vec number = hn::LoadU(Tag(), block.columns[cut.operand] + i);
    const Vec units = hn::Mul(number, hn::Set(Tag(), 1 / cut.unit));
    const Vec inverted = hn::Neg(hn::Add(units, one));
    largest = hn::Max(largest, hn::Max(units, inverted));
    no_number = hn::MulAdd(units, hn::Zero(Tag()), no_number);
  }
  const Vec ratio = hn::Mul(largest, hn::Set(Tag(), 2 / instruction.beyond));
  const auto exponent = hn::ShiftLeft<52>(hn::ShiftRight<52>(hn::BitCast(Words(), ratio)));
  return hn::Add(hn::Div(one, hn::Max(hn::BitCast(Tag(), exponent), one)), no_number);
}

void execute_common_cut(const FixedInstruction& instruction, const Block& block) {
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(Tag())) {
    const Vec factor = common_factor(instruction, block, i);
    for (const FixedCut& cut : instruction.cuts) {
      const Vec number = hn::LoadU(Tag(), block.columns[cut.operand] + i);
      const Vec units = hn::Mul(hn::Mul(number, hn::Set(Tag(), 1 / cut.unit)), factor);
      hn::StoreU(hn::Mul(hn::Floor(units), hn::Set(Tag(), cut.unit)), Tag(),
                 block.results[cut.result] + i);
    }
  }
}

/// The threshold of each comparison's step. The step rises by one for each power of two that the
/// largest magnitude reaches. A negative number counts as one unit less than its magnitude.
void execute_running_threshold(const FixedInstruction& instruction, const Block& block) {
  double* const results = block.results[instruction.result];
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(Tag())) {
    Vec largest = hn::Zero(Tag());
    for (const FixedWatched& watched : instruction.watched) {
      const Vec number = hn::LoadU(Tag(), block.columns[watched.column] + i);
      const Vec inverted = hn::Neg(hn::Add(number, hn::Set(Tag(), watched.unit)));
      const Vec magnitude = hn::Max(number, inverted);
      largest = hn::Max(largest, hn::Mul(magnitude, hn::Set(Tag(), watched.per_step_0)));
    }
    Vec threshold = hn::Set(Tag(), instruction.of_steps.front());
    double beyond = 1;
    for (std::size_t step = 1; step < instruction.of_steps.size(); ++step, beyond *= 2) {
      threshold = hn::IfThenElse(hn::Ge(largest, hn::Set(Tag(), beyond)),
                                 hn::Set(Tag(), instruction.of_steps[step]), threshold);
    }
    hn::StoreU(threshold, Tag(), results + i);
  }
}

/// One loop over the columns of an instruction. An instruction with a single operand has it twice.
template <class Function>
HWY_INLINE void loop(const FixedInstruction& instruction, const Block& block, Function function) {
  const double* HWY_RESTRICT a_column = block.columns[instruction.a];
  const double* HWY_RESTRICT b_column = block.columns[instruction.b];
  double* HWY_RESTRICT results = block.results[instruction.result];
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(Tag())) {
    const Vec a = hn::LoadU(Tag(), a_column + i), b = hn::LoadU(Tag(), b_column + i);
    hn::StoreU(function(a, b), Tag(), results + i);
  }
}

/// The exponent of the power above the root: half of the square's exponent, rounded down, plus one.
HWY_INLINE Vec power_above_root(Vec square) {
  const Words words;
  const auto exponent = hn::ShiftRight<52>(hn::BitCast(words, square));
  const auto halved = hn::ShiftRight<1>(hn::Add(exponent, hn::Set(words, 1025)));
  const Vec power = hn::BitCast(Tag(), hn::ShiftLeft<52>(halved));
  return hn::Max(power, hn::Set(Tag(), 1));
}

/// The word at an integer's low bits; a NaN for a NaN. Adding 3 2^51 to an integer leaves it in the
/// low bits of the double.
HWY_INLINE Vec look_up(const std::vector<double>& words, Vec integer) {
  const IntVec bits = hn::BitCast(Int(), hn::Add(integer, hn::Set(Tag(), 0x1.8p52)));
  const auto last = static_cast<std::int64_t>(words.size()) - 1;
  const Vec word = hn::GatherIndex(Tag(), words.data(), hn::And(bits, hn::Set(Int(), last)));
  return hn::MulAdd(integer, hn::Zero(Tag()), word);
}

/// e + m + offset for a = 2^e m with 1 <= m < 2, of_zero for 0; a NaN for a NaN. m has the
/// fraction's bits of `kept`. An integer below 2^52 joined to the bits of 2^52 is their sum.
HWY_INLINE Vec floating_code(Vec a, std::uint64_t kept, Vec offset, Vec of_zero) {
  const Vec one = hn::Set(Tag(), 1), large = hn::Set(Tag(), 0x1p52);
  const Words words;
  const auto bits = hn::BitCast(words, a);
  const auto fraction = hn::And(bits, hn::Set(words, kept));
  const Vec significand = hn::BitCast(Tag(), hn::Or(fraction, hn::BitCast(words, one)));
  const auto biased = hn::Or(hn::ShiftRight<52>(bits), hn::BitCast(words, large));
  const Vec exponent = hn::Sub(hn::BitCast(Tag(), biased), hn::Set(Tag(), 0x1p52 + 1023));
  const Vec code = hn::MulAdd(a, hn::Zero(Tag()), hn::Add(hn::Add(exponent, offset), significand));
  return hn::IfThenElse(hn::Eq(a, hn::Zero(Tag())), of_zero, code);
}

/// Minimum and maximum keep a NaN in either operand; those of processors do not.
HWY_INLINE Vec or_no_number(Vec a, Vec b, Vec chosen) {
  const auto numbers = hn::And(hn::Eq(a, a), hn::Eq(b, b));
  return hn::IfThenElse(numbers, chosen, hn::NaN(Tag()));
}

/// One of the kernels convert_... . An exact one gives the operand itself, if it is a multiple of
/// the unit. The others cut its magnitude in units to an integer k. If the operand is negative, its
/// bits are inverted, so the result is -k - 1. Rounding down gives the same if the magnitude is
/// first raised to the next double: an integer k is then above k, and any other magnitude is at
/// most k + 1. The result may have the operand's column.
template <FixedKernel kernel>
HWY_INLINE void execute_conversion(const FixedInstruction& instruction, const Block& block) {
  constexpr bool is_signed =
      kernel == FixedKernel::convert_signed || kernel == FixedKernel::convert_exactly_signed;
  constexpr bool is_exact = kernel == FixedKernel::convert_exactly_signed ||
                            kernel == FixedKernel::convert_exactly_unsigned;
  const Vec unit = hn::Set(Tag(), instruction.unit);
  const Vec per_unit = hn::Set(Tag(), 1 / instruction.unit);
  const Vec limit = hn::Set(Tag(), instruction.beyond);
  const double* const operands = block.columns[instruction.a];
  double* const results = block.results[instruction.result];
  const Words words;
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(Tag())) {
    const Vec x = hn::LoadU(Tag(), operands + i);
    // The bits of nonnegative doubles have the order of the doubles; the bits of negative ones are
    // larger.
    auto taken = hn::RebindMask(Tag(), hn::Lt(hn::BitCast(words, x), hn::BitCast(words, limit)));
    Vec units = hn::Mul(x, per_unit);
    if constexpr (is_signed) taken = hn::Lt(hn::Abs(x), limit);
    if constexpr (is_exact) {
      taken = hn::And(taken, hn::Eq(hn::Floor(units), units));
    } else if constexpr (is_signed) {
      const IntVec bits = hn::BitCast(Int(), units);
      units = hn::BitCast(Tag(), hn::Sub(bits, hn::BroadcastSignBit(bits)));
    }
    const Vec number = hn::Mul(hn::Floor(units), unit);
    hn::StoreU(hn::IfThenElse(taken, number, hn::NaN(Tag())), Tag(), results + i);
  }
}

void execute_one(const FixedInstruction& instruction, const Block& block) {
  const auto each = [&](auto function) HWY_ATTR { loop(instruction, block, function); };
  switch (instruction.kernel) {
    case FixedKernel::common_power: return execute_common_power(instruction, block);
    case FixedKernel::convert_signed:
      return execute_conversion<FixedKernel::convert_signed>(instruction, block);
    case FixedKernel::convert_unsigned:
      return execute_conversion<FixedKernel::convert_unsigned>(instruction, block);
    case FixedKernel::convert_exactly_signed:
      return execute_conversion<FixedKernel::convert_exactly_signed>(instruction, block);
    case FixedKernel::convert_exactly_unsigned:
      return execute_conversion<FixedKernel::convert_exactly_unsigned>(instruction, block);
    case FixedKernel::sum: return execute_sum(instruction, block);
    case FixedKernel::common_cut: return execute_common_cut(instruction, block);
    case FixedKernel::running_threshold: return execute_running_threshold(instruction, block);
    case FixedKernel::absolute: return each([](Vec a, Vec) HWY_ATTR { return hn::Abs(a); });
    case FixedKernel::minimum:
      return each([](Vec a, Vec b) HWY_ATTR { return or_no_number(a, b, hn::Min(a, b)); });
    case FixedKernel::maximum:
      return each([](Vec a, Vec b) HWY_ATTR { return or_no_number(a, b, hn::Max(a, b)); });
    case FixedKernel::square_root: return each([](Vec a, Vec) HWY_ATTR { return hn::Sqrt(a); });
    case FixedKernel::truncate: {
      const Vec unit = hn::Set(Tag(), instruction.unit);
      const Vec per_unit = hn::Set(Tag(), 1 / instruction.unit);
      return each([&](Vec a, Vec)
                      HWY_ATTR { return hn::Mul(hn::Floor(hn::Mul(a, per_unit)), unit); });
    }
    case FixedKernel::place: {
      const Vec unit = hn::Set(Tag(), instruction.unit);
      const Vec per_unit = hn::Set(Tag(), 1 / instruction.unit);
      return each([&](Vec a, Vec)
                      HWY_ATTR { return hn::NegMulAdd(hn::Floor(hn::Mul(a, per_unit)), unit, a); });
    }
    case FixedKernel::floating: {
      const auto dropped = static_cast<std::uint64_t>(std::ldexp(instruction.unit, 52));
      const std::uint64_t kept = (std::uint64_t{1} << 52) - dropped;
      const Vec offset = hn::Set(Tag(), instruction.low);
      const Vec of_zero = hn::Set(Tag(), instruction.high);
      return each([&](Vec a, Vec) HWY_ATTR { return floating_code(a, kept, offset, of_zero); });
    }
    case FixedKernel::look_up: {
      const Vec per_unit = hn::Set(Tag(), 1 / instruction.unit);
      return each([&](Vec a, Vec) HWY_ATTR {
        return look_up(instruction.words, hn::Floor(hn::Mul(a, per_unit)));
      });
    }
    case FixedKernel::limit: {
      const Vec low = hn::Set(Tag(), instruction.low), high = hn::Set(Tag(), instruction.high);
      return each([&](Vec a, Vec) HWY_ATTR {
        return hn::IfThenElse(hn::And(hn::Ge(a, low), hn::Le(a, high)), a, hn::NaN(Tag()));
      });
    }
    case FixedKernel::power_above_root: {
      const Vec unit = hn::Set(Tag(), instruction.unit);
      const Vec per_unit = hn::Set(Tag(), 1 / instruction.square_unit);
      return each([&](Vec a, Vec)
                      HWY_ATTR { return hn::Mul(power_above_root(hn::Mul(a, per_unit)), unit); });
    }
  }
}

void execute_fixed(const std::vector<FixedInstruction>& instructions, const Block& block) {
  for (const FixedInstruction& instruction : instructions) execute_one(instruction, block);
}

/// Writes one byte per comparison, in order: the entry of `table` at the last two bits of its
/// state.
HWY_INLINE void store_codes(const IntVec (&states)[group], const std::uint8_t (&table)[16],
                            std::uint8_t* to) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t k = 0; k < group; ++k) to[k] = table[hn::GetLane(states[k]) & 3];
#else
  const hn::Repartition<std::uint32_t, Int> halves;
  const hn::Repartition<std::uint16_t, Int> quarters;
  const hn::Rebind<std::uint8_t, decltype(quarters)> bytes;
  const auto joined = [](auto tag, auto low, auto high) HWY_ATTR {
    return hn::ConcatEven(tag, hn::BitCast(tag, high), hn::BitCast(tag, low));
  };
  const auto codes_of_states = hn::LoadDup128(bytes, table);
  for (std::size_t k = 0; k < group; k += 4) {
    const auto all = joined(quarters, joined(halves, states[k], states[k + 1]),
                            joined(halves, states[k + 2], states[k + 3]));
    const auto entries = hn::And(hn::TruncateTo(bytes, all), hn::Set(bytes, 3));
    const auto codes = hn::TableLookupBytes(codes_of_states, entries);
    hn::StoreU(codes, bytes, to + k * hn::Lanes(Tag()));
  }
#endif
}

/// The state of a difference D is the sum of -1 if D < above and -2 if D >= below. Since below is
/// at most above, that is -1 for less, -2 for greater, -3 for a D between them, and 0 for a NaN.
HWY_INLINE IntVec state(Vec difference, Vec above, Vec below) {
  const auto less = hn::VecFromMask(Int(), hn::RebindMask(Int(), hn::Lt(difference, above)));
  const auto more = hn::VecFromMask(Int(), hn::RebindMask(Int(), hn::Ge(difference, below)));
  return hn::Add(less, hn::Add(more, more));
}

void decide_fixed(const FixedCriterion& criterion, const Block& block, std::uint8_t* codes) {
  const Vec slope_above = hn::Set(Tag(), criterion.slope_above);
  const Vec offset_above = hn::Set(Tag(), criterion.offset_above);
  const Vec slope_below = hn::Set(Tag(), criterion.slope_below);
  const Vec offset_below = hn::Set(Tag(), criterion.offset_below);
  alignas(16)
      const std::uint8_t table[16] = {4, criterion.otherwise, criterion.greater, criterion.less};
  for (std::size_t first = 0; first < block.size; first += block_granularity) {
    Vec difference[group], radius[group];
    add_up(criterion.difference, block, first, difference);
    add_up(criterion.radius, block, first, radius);
    IntVec states[group];
    for (std::size_t k = 0; k < group; ++k) {
      states[k] = state(difference[k], hn::MulAdd(slope_above, radius[k], offset_above),
                        hn::NegMulSub(slope_below, radius[k], offset_below));
    }
    store_codes(states, table, codes + first);
  }
}

}  // namespace mixcmp::emulator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mixcmp::emulator {

HWY_EXPORT(execute_fixed);
HWY_EXPORT(decide_fixed);

void execute(const std::vector<FixedInstruction>& instructions, const Block& block) {
  HWY_DYNAMIC_DISPATCH(execute_fixed)(instructions, block);
}

void decide(const FixedCriterion& criterion, const Block& block, std::uint8_t* codes) {
  HWY_DYNAMIC_DISPATCH(decide_fixed)(criterion, block, codes);
}

}  // namespace mixcmp::emulator
#endif
