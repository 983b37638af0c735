#include "model/emulator/fixed_kernels.hpp"

// On x86 only the baseline, AVX2 and AVX-512 are worth their compile time.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/emulator/fixed_kernels.cpp"
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

HWY_INLINE Vec rounded_down(Vec x, Vec unit, Vec per_unit) {
  return hn::Mul(hn::Floor(hn::Mul(x, per_unit)), unit);
}

/// The magnitude is truncated; all bits of a negative operand's are inverted: -k - 1.
template <bool is_signed>
HWY_INLINE void convert_all(const FixedConversion& conversion, const double* operands,
                            std::size_t count, double* converted) {
  const Vec unit = hn::Set(Tag(), conversion.unit);
  const Vec per_unit = hn::Set(Tag(), 1 / conversion.unit);
  const Vec limit = hn::Set(Tag(), conversion.limit);
  const Vec no_number = hn::NaN(Tag());
  for (std::size_t i = 0; i < count; i += hn::Lanes(Tag())) {
    const Vec x = hn::LoadU(Tag(), operands + i);
    const Vec magnitude = hn::Abs(x);
    const Vec kept = rounded_down(magnitude, unit, per_unit);
    const auto negative =
        hn::MaskFromVec(hn::BitCast(Tag(), hn::BroadcastSignBit(hn::BitCast(Int(), x))));
    const Vec below_zero = is_signed ? hn::Neg(hn::Add(kept, unit)) : no_number;
    const Vec number = hn::IfThenElse(negative, below_zero, kept);
    hn::StoreU(hn::IfThenElse(hn::Lt(magnitude, limit), number, no_number), Tag(), converted + i);
  }
}

void convert_fixed(const FixedConversion& conversion, const double* operands, std::size_t count,
                   double* converted) {
  return conversion.is_signed ? convert_all<true>(conversion, operands, count, converted)
                              : convert_all<false>(conversion, operands, count, converted);
}

/// 2^exponent, for exponents of normal numbers.
HWY_INLINE Vec power_of(IntVec exponent) {
  const IntVec biased = hn::Add(exponent, hn::Set(Int(), 1023));
  return hn::BitCast(Tag(), hn::ShiftLeft<52>(biased));
}

/// The division takes two steps, since the reciprocal of the largest power is no normal number.
void divide_all(double* const* operands, std::size_t operand_count, std::size_t count,
                int least_exponent) {
  const IntVec least = hn::Set(Int(), least_exponent + 1022);
  const IntVec no_number = hn::Set(Int(), 2047);
  for (std::size_t i = 0; i < count; i += hn::Lanes(Tag())) {
    IntVec largest = hn::Zero(Int());
    for (std::size_t k = 0; k < operand_count; ++k) {
      const Vec magnitude = hn::Abs(hn::LoadU(Tag(), operands[k] + i));
      largest = hn::Max(largest, hn::BitCast(Int(), magnitude));
    }
    const IntVec biased = hn::ShiftRight<52>(largest);
    const IntVec exponent = hn::Sub(hn::Set(Int(), 1022), hn::Max(biased, least));
    const IntVec half = hn::ShiftRight<1>(exponent);
    const Vec first = hn::IfThenElse(hn::RebindMask(Tag(), hn::Eq(biased, no_number)),
                                     hn::NaN(Tag()), power_of(half));
    const Vec second = power_of(hn::Sub(exponent, half));
    for (std::size_t k = 0; k < operand_count; ++k) {
      const Vec operand = hn::LoadU(Tag(), operands[k] + i);
      hn::StoreU(hn::Mul(hn::Mul(operand, first), second), Tag(), operands[k] + i);
    }
  }
}

/// One loop over the columns of an instruction. A column that the function does not read may be any
/// of the block's: code takes the first operand's.
template <class Function>
HWY_INLINE void loop(const FixedInstruction& instruction, const Block& block, Function function) {
  const double* HWY_RESTRICT a_column = block.columns[instruction.a];
  const double* HWY_RESTRICT b_column = block.columns[instruction.b];
  const double* HWY_RESTRICT c_column = block.columns[instruction.c];
  double* HWY_RESTRICT results = block.results[instruction.result];
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(Tag())) {
    const Vec a = hn::LoadU(Tag(), a_column + i), b = hn::LoadU(Tag(), b_column + i);
    const Vec c = hn::LoadU(Tag(), c_column + i);
    hn::StoreU(function(a, b, c), Tag(), results + i);
  }
}

HWY_INLINE Vec square(Vec a) {
  return hn::Mul(a, a);
}

/// The exponent of the root's power is half of the square's, rounded down, and one.
HWY_INLINE Vec power_above_root(Vec square) {
  const hn::RebindToUnsigned<Int> words;
  const auto exponent = hn::ShiftRight<52>(hn::BitCast(words, square));
  const auto halved = hn::ShiftRight<1>(hn::Add(exponent, hn::Set(words, 1025)));
  const Vec power = hn::BitCast(Tag(), hn::ShiftLeft<52>(halved));
  return hn::Max(power, hn::Set(Tag(), 1));
}

/// Minimum and maximum keep a NaN wherever it stands; those of processors do not.
HWY_INLINE Vec or_no_number(Vec a, Vec b, Vec chosen) {
  const auto numbers = hn::And(hn::Eq(a, a), hn::Eq(b, b));
  return hn::IfThenElse(numbers, chosen, hn::NaN(Tag()));
}

void execute_one(const FixedInstruction& instruction, const Block& block) {
  const auto each = [&](auto function) HWY_ATTR { loop(instruction, block, function); };
  switch (instruction.kernel) {
    case FixedKernel::negate: return each([](Vec a, Vec, Vec) HWY_ATTR { return hn::Neg(a); });
    case FixedKernel::absolute: return each([](Vec a, Vec, Vec) HWY_ATTR { return hn::Abs(a); });
    case FixedKernel::add: return each([](Vec a, Vec b, Vec) HWY_ATTR { return hn::Add(a, b); });
    case FixedKernel::subtract:
      return each([](Vec a, Vec b, Vec) HWY_ATTR { return hn::Sub(a, b); });
    case FixedKernel::multiply:
      return each([](Vec a, Vec b, Vec) HWY_ATTR { return hn::Mul(a, b); });
    case FixedKernel::minimum:
      return each([](Vec a, Vec b, Vec) HWY_ATTR { return or_no_number(a, b, hn::Min(a, b)); });
    case FixedKernel::maximum:
      return each([](Vec a, Vec b, Vec) HWY_ATTR { return or_no_number(a, b, hn::Max(a, b)); });
    case FixedKernel::add_product:
      return each([](Vec a, Vec b, Vec c) HWY_ATTR { return hn::MulAdd(a, b, c); });
    case FixedKernel::subtract_product:
      return each([](Vec a, Vec b, Vec c) HWY_ATTR { return hn::NegMulAdd(a, b, c); });
    case FixedKernel::square_of_difference:
      return each([](Vec a, Vec b, Vec) HWY_ATTR { return square(hn::Sub(a, b)); });
    case FixedKernel::add_square_of_difference:
      return each([](Vec a, Vec b, Vec c) HWY_ATTR {
        const Vec difference = hn::Sub(a, b);
        return hn::MulAdd(difference, difference, c);
      });
    case FixedKernel::subtract_square_of_difference:
      return each([](Vec a, Vec b, Vec c) HWY_ATTR {
        const Vec difference = hn::Sub(a, b);
        return hn::NegMulAdd(difference, difference, c);
      });
    case FixedKernel::square_root:
      return each([](Vec a, Vec, Vec) HWY_ATTR { return hn::Sqrt(a); });
    case FixedKernel::truncate: {
      const Vec unit = hn::Set(Tag(), instruction.unit);
      const Vec per_unit = hn::Set(Tag(), 1 / instruction.unit);
      return each([&](Vec a, Vec, Vec) HWY_ATTR { return rounded_down(a, unit, per_unit); });
    }
    case FixedKernel::limit: {
      const Vec low = hn::Set(Tag(), instruction.low), high = hn::Set(Tag(), instruction.high);
      return each([&](Vec a, Vec, Vec) HWY_ATTR {
        return hn::IfThenElse(hn::And(hn::Ge(a, low), hn::Le(a, high)), a, hn::NaN(Tag()));
      });
    }
    case FixedKernel::power_above_root: {
      const Vec unit = hn::Set(Tag(), instruction.unit);
      const Vec per_unit = hn::Set(Tag(), 1 / instruction.square_unit);
      return each([&](Vec a, Vec, Vec)
                      HWY_ATTR { return hn::Mul(power_above_root(hn::Mul(a, per_unit)), unit); });
    }
  }
}

void execute_fixed(const std::vector<FixedInstruction>& instructions, const Block& block) {
  for (const FixedInstruction& instruction : instructions) execute_one(instruction, block);
}

HWY_INLINE IntVec code(int decision) {
  return hn::Set(Int(), decision);
}

void decide_fixed(const FixedCriterion& criterion, const Block& block, std::uint8_t* codes) {
  const Vec slope_above = hn::Set(Tag(), criterion.slope_above);
  const Vec offset_above = hn::Set(Tag(), criterion.offset_above);
  const Vec slope_below = hn::Set(Tag(), criterion.slope_below);
  const Vec offset_below = hn::Set(Tag(), criterion.offset_below);
  const IntVec greater = code(criterion.greater), less = code(criterion.less);
  const IntVec otherwise = code(criterion.otherwise), undecided = code(4);
  const hn::Rebind<std::uint64_t, Tag> words;
  const hn::Rebind<std::uint8_t, Tag> bytes;
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(Tag())) {
    const Vec difference = hn::LoadU(Tag(), block.columns[criterion.difference] + i);
    const Vec radius = hn::LoadU(Tag(), block.columns[criterion.radius] + i);
    const auto above = hn::Ge(difference, hn::MulAdd(slope_above, radius, offset_above));
    const auto below = hn::Gt(hn::Neg(difference), hn::MulAdd(slope_below, radius, offset_below));
    const auto is_number = hn::RebindMask(Int(), hn::Eq(difference, difference));
    IntVec result = hn::IfThenElse(is_number, otherwise, undecided);
    result = hn::IfThenElse(hn::RebindMask(Int(), below), less, result);
    result = hn::IfThenElse(hn::RebindMask(Int(), above), greater, result);
    hn::StoreU(hn::TruncateTo(bytes, hn::BitCast(words, result)), bytes, codes + i);
  }
}

}  // namespace mixcmp::emulator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mixcmp::emulator {

HWY_EXPORT(convert_fixed);
HWY_EXPORT(divide_all);
HWY_EXPORT(execute_fixed);
HWY_EXPORT(decide_fixed);

void convert(const FixedConversion& conversion, const double* operands, std::size_t count,
             double* converted) {
  HWY_DYNAMIC_DISPATCH(convert_fixed)(conversion, operands, count, converted);
}

void divide_by_common_power(std::span<double* const> operands, std::size_t count,
                            int least_exponent) {
  HWY_DYNAMIC_DISPATCH(divide_all)(operands.data(), operands.size(), count, least_exponent);
}

void execute(const std::vector<FixedInstruction>& instructions, const Block& block) {
  HWY_DYNAMIC_DISPATCH(execute_fixed)(instructions, block);
}

void decide(const FixedCriterion& criterion, const Block& block, std::uint8_t* codes) {
  HWY_DYNAMIC_DISPATCH(decide_fixed)(criterion, block, codes);
}

}  // namespace mixcmp::emulator
#endif
