#include "model/judge/emulator/kernels.hpp"

// On x86 only the baseline, AVX2 and AVX-512 are worth their compile time.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/judge/emulator/kernels.cpp"
#include "hwy/foreach_target.h"
// after foreach_target.h
#include "hwy/highway.h"
#include "model/judge/emulator/bounds-inl.hpp"
#include "model/judge/emulator/criterion-inl.hpp"
#include "model/judge/emulator/doubts-inl.hpp"
#include "model/judge/emulator/rounding-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mixcmp::emulator::HWY_NAMESPACE {

struct Addition {
  static constexpr bool unary = false, product = false;
  static HWY_INLINE Vec result(Vec a, Vec b) { return hn::Add(a, b); }
  static HWY_INLINE Vec error(Vec a, Vec b, Vec r) { return sum_error(a, b, r); }
};
struct Subtraction {
  static constexpr bool unary = false, product = false;
  static HWY_INLINE Vec result(Vec a, Vec b) { return hn::Sub(a, b); }
  static HWY_INLINE Vec error(Vec a, Vec b, Vec r) { return sum_error(a, hn::Neg(b), r); }
};
struct Multiplication {
  static constexpr bool unary = false, product = true;
  static HWY_INLINE Vec result(Vec a, Vec b) { return hn::Mul(a, b); }
  static HWY_INLINE Vec error(Vec a, Vec b, Vec r) { return product_error(a, b, r); }
};
struct Squaring : Multiplication {
  static constexpr bool unary = true;
};
struct Division {
  static constexpr bool unary = false, product = false;
  static HWY_INLINE Vec result(Vec a, Vec b) { return hn::Div(a, b); }
  static HWY_INLINE Vec error(Vec a, Vec b, Vec r) {  // has the sign of (a - r b) / b
    return hn::Xor(remainder(r, b, a), sign_bits(b));
  }
};
struct Root {
  static constexpr bool unary = true, product = false;
  static HWY_INLINE Vec result(Vec a, Vec) { return hn::Sqrt(a); }
  static HWY_INLINE Vec error(Vec a, Vec, Vec r) { return remainder(r, r, a); }
};
struct Conversion {
  static constexpr bool unary = true, product = false;
  static HWY_INLINE Vec result(Vec a, Vec) { return a; }
  static HWY_INLINE Vec error(Vec, Vec, Vec) { return hn::Zero(Tag()); }
};

/// One loop over the columns of an operation; `finish` maps operands and r to the result.
template <class Operation, class Finisher>
HWY_INLINE void loop(const Instruction& instruction, const Block& block, Finisher finish) {
  const double* HWY_RESTRICT a_column = block.columns[instruction.a];
  const double* HWY_RESTRICT b_column = block.columns[instruction.b];
  double* HWY_RESTRICT results = block.results[instruction.result];
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(Tag())) {
    const Vec a = hn::LoadU(Tag(), a_column + i);
    const Vec b = Operation::unary ? a : hn::LoadU(Tag(), b_column + i);
    hn::StoreU(finish(a, b, Operation::result(a, b)), Tag(), results + i);
  }
}

/// Watches a few vectors for results that may lie half way: then all dropped digits of the raised
/// number are 0.
class AnyDigit {
public:
  HWY_INLINE AnyDigit() : half_way_(hn::MaskFromVec(hn::Zero(Int()))) {}
  HWY_INLINE void see(IntVec raised, IntVec kept) {
    half_way_ = hn::Or(half_way_, hn::Eq(raised, kept));
  }
  HWY_INLINE bool may_be_half_way() const { return !hn::AllFalse(Int(), half_way_); }

private:
  hn::Mask<Int> half_way_;
};

#if HWY_TARGET == HWY_SCALAR
using LowWord = AnyDigit;
#else
/// A cheaper watch for formats that drop more than 32 digits: a result can lie half way only if the
/// lower 32 bits of its raised number are all 0. It reports more results than AnyDigit.
class LowWord {
public:
  HWY_INLINE LowWord() : smallest_(hn::Set(Word(), ~0u)) {}
  HWY_INLINE void see(IntVec raised, IntVec) {
    smallest_ = hn::Min(smallest_, hn::BitCast(Word(), raised));
  }
  HWY_INLINE bool may_be_half_way() const {
    const IntVec low = hn::ShiftLeft<32>(hn::BitCast(Int(), smallest_));
    return !hn::AllFalse(Int(), hn::Eq(low, hn::Zero(Int())));
  }

private:
  WordVec smallest_;
};
#endif

/// Rounds four vectors at a time without their errors, and once more with the errors if a result
/// may lie half way.
template <class Operation, class Watch>
void loop_watched(const Instruction& instruction, const Block& block) {
  const Rounder rounder(instruction.dropped_digits);
  const double* HWY_RESTRICT a_column = block.columns[instruction.a];
  const double* HWY_RESTRICT b_column = block.columns[instruction.b];
  double* HWY_RESTRICT results = block.results[instruction.result];
  const std::size_t lanes = hn::Lanes(Tag());
  for (std::size_t i = 0; i < block.size; i += 4 * lanes) {
    Watch watch;
    for (std::size_t k = i; k < i + 4 * lanes; k += lanes) {
      const Vec a = hn::LoadU(Tag(), a_column + k), b = hn::LoadU(Tag(), b_column + k);
      const IntVec raised = rounder.raised_half(Operation::result(a, b));
      const IntVec kept = rounder.kept(raised);
      watch.see(raised, kept);
      hn::StoreU(from_bits(kept), Tag(), results + k);
    }
    if (HWY_LIKELY(!watch.may_be_half_way())) continue;
    for (std::size_t k = i; k < i + 4 * lanes; k += lanes) {
      const Vec a = hn::LoadU(Tag(), a_column + k), b = hn::LoadU(Tag(), b_column + k);
      const Vec r = Operation::result(a, b);
      hn::StoreU(rounder.corrected(r, Operation::error(a, b, r)), Tag(), results + k);
    }
  }
}

template <class Operation>
void loop_corrected(const Instruction& instruction, const Block& block) {
  const Rounder rounder(instruction.dropped_digits);
  loop<Operation>(instruction, block, [&](Vec a, Vec b, Vec r) HWY_ATTR {
    return rounder.corrected(r, Operation::error(a, b, r));
  });
}

template <class Operation>
void loop_fused(const Instruction& instruction, const Block& block) {
#if HWY_NATIVE_FMA
  const Rounder rounder(instruction.dropped_digits);
  loop<Operation>(instruction, block, [&](Vec a, Vec b, Vec r) HWY_ATTR {
    const Vec rounded = rounder.fused(a, b, r);
    // M - M is +0 if a * b is -0; otherwise the signs are those of r.
    return Operation::unary ? rounded : hn::Or(rounded, sign_bits(r));
  });
#else
  loop_corrected<Operation>(instruction, block);
#endif
}

template <class Operation>
void apply(const Instruction& instruction, const Block& block) {
  const Rounder rounder(instruction.dropped_digits);
  switch (instruction.finish) {
    case Finish::hardware:
      return loop<Operation>(instruction, block, [&](Vec, Vec, Vec r) HWY_ATTR { return r; });
    case Finish::nearest:
      return loop<Operation>(instruction, block,
                             [&](Vec, Vec, Vec r) HWY_ATTR { return rounder.nearest(r); });
    case Finish::watched:
      return instruction.dropped_digits > 32
                 ? loop_watched<Operation, LowWord>(instruction, block)
                 : loop_watched<Operation, AnyDigit>(instruction, block);
    case Finish::corrected: return loop_corrected<Operation>(instruction, block);
    case Finish::fused:
      if constexpr (Operation::product) loop_fused<Operation>(instruction, block);
      return;
    case Finish::truncated:
      return loop<Operation>(instruction, block, [&](Vec a, Vec b, Vec r) HWY_ATTR {
        return rounder.truncated(r, Operation::error(a, b, r));
      });
  }
}

/// Operations that round nothing.
struct Selection {
  static constexpr bool unary = false;
  static HWY_INLINE Vec result(Vec a, Vec) { return a; }
};

void select(const Instruction& instruction, const Block& block) {
  const Vec sign = hn::SignBit(Tag());
  switch (instruction.kernel) {
    case Kernel::negate:
      return loop<Selection>(instruction, block,
                             [&](Vec a, Vec, Vec) HWY_ATTR { return hn::Xor(a, sign); });
    case Kernel::absolute:
      return loop<Selection>(instruction, block,
                             [&](Vec a, Vec, Vec) HWY_ATTR { return hn::AndNot(sign, a); });
    // Equal numbers can differ only if they are zeros, in their signs: -0 < +0.
    case Kernel::minimum:
      return loop<Selection>(instruction, block, [&](Vec a, Vec b, Vec) HWY_ATTR {
        return hn::IfThenElse(hn::Eq(a, b), hn::Or(a, b), hn::Min(a, b));
      });
    default:
      return loop<Selection>(instruction, block, [&](Vec a, Vec b, Vec) HWY_ATTR {
        return hn::IfThenElse(hn::Eq(a, b), hn::And(a, b), hn::Max(a, b));
      });
  }
}

void execute_one(const Instruction& instruction, const Block& block) {
  switch (instruction.kernel) {
    case Kernel::add: return apply<Addition>(instruction, block);
    case Kernel::subtract: return apply<Subtraction>(instruction, block);
    case Kernel::multiply: return apply<Multiplication>(instruction, block);
    case Kernel::square: return apply<Squaring>(instruction, block);
    case Kernel::divide: return apply<Division>(instruction, block);
    case Kernel::square_root: return apply<Root>(instruction, block);
    case Kernel::convert: return apply<Conversion>(instruction, block);
    case Kernel::negate:
    case Kernel::absolute:
    case Kernel::minimum:
    case Kernel::maximum: return select(instruction, block);
    case Kernel::bound_magnitude:
    case Kernel::bound_binade:
    case Kernel::bound_reciprocal:
    case Kernel::bound_add:
    case Kernel::bound_multiply:
    case Kernel::bound_maximum: return bound(instruction, block);
  }
}

void execute(const std::vector<Instruction>& instructions, const Block& block) {
  for (const Instruction& instruction : instructions) execute_one(instruction, block);
}

const char* instruction_set() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace mixcmp::emulator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mixcmp::emulator {

HWY_EXPORT(all_inside);
HWY_EXPORT(execute);
HWY_EXPORT(find_doubts);
HWY_EXPORT(decide);
HWY_EXPORT(instruction_set);

void execute(const std::vector<Instruction>& instructions, const Block& block) {
  HWY_DYNAMIC_DISPATCH(execute)(instructions, block);
}

bool find_doubts(const std::vector<TrustedRange>& ranges, const Block& block,
                 std::uint64_t* doubts) {
  return HWY_DYNAMIC_DISPATCH(find_doubts)(ranges, block, doubts);
}

bool all_inside(const OperandWindow& window, const Block& block) {
  return HWY_DYNAMIC_DISPATCH(all_inside)(window, block);
}

void decide(const FloatCriterion& criterion, const Block& block, std::uint8_t* codes) {
  HWY_DYNAMIC_DISPATCH(decide)(criterion, block, codes);
}

const char* instruction_set() {
  return HWY_DYNAMIC_DISPATCH(instruction_set)();
}

}  // namespace mixcmp::emulator
#endif
