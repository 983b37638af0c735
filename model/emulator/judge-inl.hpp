// Decisions; included once per instruction set, by kernels.cpp alone.
#if defined(MIXCMP_EMULATOR_JUDGE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MIXCMP_EMULATOR_JUDGE_INL
#undef MIXCMP_EMULATOR_JUDGE_INL
#else
#define MIXCMP_EMULATOR_JUDGE_INL
#endif

#include "model/emulator/rounding-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mixcmp::model::emulator::HWY_NAMESPACE {

/// Codes of model::Decision, one a comparison.
HWY_INLINE IntVec code(int decision) {
  return hn::Set(Int(), decision);
}
HWY_INLINE IntVec as_int(hn::Mask<Tag> mask) {
  return hn::BitCast(Int(), hn::VecFromMask(Tag(), mask));
}
HWY_INLINE IntVec greater_or_less(hn::Mask<Int> greater, hn::Mask<Int> less) {
  const IntVec rest = hn::IfThenElse(less, code(0), code(4));
  return hn::IfThenElse(greater, code(2), rest);
}

/// 1, one more where f > g, one less where f < g.
struct Order {
  const Judgement& judgement;
  HWY_INLINE IntVec operator()(const Block& block, std::size_t i) const {
    const Vec f = hn::LoadU(Tag(), block.columns[judgement.first] + i);
    const Vec g = hn::LoadU(Tag(), block.columns[judgement.second] + i);
    return hn::Add(hn::Sub(code(1), as_int(hn::Gt(f, g))), as_int(hn::Lt(f, g)));
  }
};

/// A key is half of what its magnitude bits in the lane are, times 2^(53 - P): the last of a
/// double's bits is always 0 here, and so a difference of two keys fits. Zeros lie below the
/// rebias.
class UlpDistance {
public:
  HWY_INLINE explicit UlpDistance(const Judgement& judgement)
      : first_(judgement.first),
        second_(judgement.second),
        nonnegative_(judgement.nonnegative),
        rebias_(hn::Set(Int(), judgement.rebias)),
        below_guard_(hn::Set(Int(), judgement.guard - 1)) {}

  HWY_INLINE IntVec operator()(const Block& block, std::size_t i) const {
    const Vec f = hn::LoadU(Tag(), block.columns[first_] + i);
    const Vec g = hn::LoadU(Tag(), block.columns[second_] + i);
    const IntVec f_above = hn::Sub(key(f), key(g));
    const IntVec g_above = hn::Sub(hn::Zero(Int()), f_above);
    return greater_or_less(hn::Gt(f_above, below_guard_), hn::Gt(g_above, below_guard_));
  }

private:
  HWY_INLINE IntVec key(Vec x) const {
    const IntVec magnitude = hn::Sub(bits_of(hn::Abs(x)), rebias_);
    const IntVec halved = hn::ShiftRight<1>(hn::Max(magnitude, hn::Zero(Int())));
    if (nonnegative_) return halved;
    const IntVec sign = hn::BroadcastSignBit(bits_of(x));
    return hn::Sub(hn::Xor(halved, sign), sign);
  }

  int first_, second_;
  bool nonnegative_;
  IntVec rebias_, below_guard_;
};

/// The sign of the difference, where it exceeds the bound and every condition holds.
struct AbsoluteBound {
  const Judgement& judgement;
  HWY_INLINE IntVec operator()(const Block& block, std::size_t i) const {
    const Vec difference = hn::LoadU(Tag(), block.columns[judgement.first] + i);
    const Vec bound = hn::LoadU(Tag(), block.columns[judgement.second] + i);
    IntVec holds = as_int(hn::Lt(bound, hn::Abs(difference)));
    for (const Judgement::Condition& condition : judgement.conditions) {
      const Vec limit = hn::LoadU(Tag(), block.columns[condition.bound] + i);
      const Vec value = hn::LoadU(Tag(), block.columns[condition.value] + i);
      holds = hn::And(holds, as_int(hn::Le(limit, hn::Abs(value))));
    }
    const IntVec negative = hn::BroadcastSignBit(bits_of(difference));
    return greater_or_less(hn::MaskFromVec(hn::AndNot(negative, holds)),
                           hn::MaskFromVec(hn::And(negative, holds)));
  }
};

struct Interval {
  const Judgement& judgement;
  HWY_INLINE IntVec operator()(const Block& block, std::size_t i) const {
    const Vec minimum = hn::LoadU(Tag(), block.columns[judgement.first] + i);
    const Vec maximum = hn::LoadU(Tag(), block.columns[judgement.second] + i);
    return greater_or_less(hn::RebindMask(Int(), hn::Gt(minimum, hn::Zero(Tag()))),
                           hn::RebindMask(Int(), hn::Lt(maximum, hn::Zero(Tag()))));
  }
};

HWY_INLINE IntVec failing(const OperandCheck& check, const Block& block, std::size_t i) {
  const Vec x = hn::LoadU(Tag(), block.columns[check.column] + i);
  const Vec magnitude = hn::Abs(x);
  const IntVec low = as_int(hn::Lt(magnitude, hn::Set(Tag(), check.least)));
  const IntVec high = as_int(hn::Gt(magnitude, hn::Set(Tag(), check.greatest)));
  const IntVec negative = hn::BroadcastSignBit(bits_of(x));
  const IntVec wrong_sign = check.sign == Sign::any           ? hn::Zero(Int())
                            : check.sign == Sign::nonnegative ? negative
                                                              : hn::Not(negative);
  return hn::Or(wrong_sign, hn::Or(low, high));
}

template <class RuleOf>
void judge_by(const RuleOf& rule, const Judgement& judgement, const Block& block,
              std::uint8_t* codes) {
  const hn::Rebind<std::uint64_t, Tag> words;
  const hn::Rebind<std::uint8_t, Tag> bytes;
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(Tag())) {
    IntVec decision = rule(block, i);
    for (const OperandCheck& check : judgement.checks) {
      decision = hn::IfThenElse(hn::MaskFromVec(failing(check, block, i)), code(4), decision);
    }
    hn::StoreU(hn::TruncateTo(bytes, hn::BitCast(words, decision)), bytes, codes + i);
  }
}

void judge(const Judgement& judgement, const Block& block, std::uint8_t* codes) {
  switch (judgement.rule) {
    case Rule::order: return judge_by(Order{judgement}, judgement, block, codes);
    case Rule::ulp_distance: return judge_by(UlpDistance(judgement), judgement, block, codes);
    case Rule::absolute_bound: return judge_by(AbsoluteBound{judgement}, judgement, block, codes);
    case Rule::interval: return judge_by(Interval{judgement}, judgement, block, codes);
  }
}

}  // namespace mixcmp::model::emulator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
