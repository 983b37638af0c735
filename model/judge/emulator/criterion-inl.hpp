// Decides comparisons. Only kernels.cpp includes this file, once per instruction set.
#if defined(MIXCMP_EMULATOR_CRITERION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MIXCMP_EMULATOR_CRITERION_INL
#undef MIXCMP_EMULATOR_CRITERION_INL
#else
#define MIXCMP_EMULATOR_CRITERION_INL
#endif

#include "model/judge/emulator/rounding-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mixcmp::emulator::HWY_NAMESPACE {

/// A vector of one code of Decision.
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

/// Decides by the order of f and g. The code is 1 (equal), one more if f > g, one less if f < g.
struct Order {
  const FloatCriterion& criterion;
  HWY_INLINE IntVec operator()(const Block& block, std::size_t i) const {
    const Vec f = hn::LoadU(Tag(), block.columns[criterion.first] + i);
    const Vec g = hn::LoadU(Tag(), block.columns[criterion.second] + i);
    return hn::Add(hn::Sub(code(1), as_int(hn::Gt(f, g))), as_int(hn::Lt(f, g)));
  }
};

/// Decides if two encodings are at least `guard` apart.
class Guard {
public:
  HWY_INLINE explicit Guard(std::int64_t guard)
      : below_(hn::Set(Int(), guard - 1)), above_minus_(hn::Set(Int(), 1 - guard)) {}

  HWY_INLINE IntVec decide(IntVec f, IntVec g) const {
    const IntVec distance = hn::Sub(f, g);
    return greater_or_less(hn::Gt(distance, below_), hn::Gt(above_minus_, distance));
  }

private:
  IntVec below_, above_minus_;
};

/// Decides by the distance of the encodings of f and g, which are not negative. Their bits as
/// doubles are, up to a constant that cancels, 2^(53 - P) times those in the lane. `zero`, one
/// binade below the smallest normal number, stands for 0.
class Magnitudes {
public:
  HWY_INLINE explicit Magnitudes(const FloatCriterion& criterion)
      : first_(criterion.first),
        second_(criterion.second),
        zero_(hn::Set(Tag(), criterion.zero)),
        guard_(criterion.guard) {}

  HWY_INLINE IntVec operator()(const Block& block, std::size_t i) const {
    const IntVec f = bits_of(hn::Max(hn::LoadU(Tag(), block.columns[first_] + i), zero_));
    const IntVec g = bits_of(hn::Max(hn::LoadU(Tag(), block.columns[second_] + i), zero_));
    return guard_.decide(f, g);
  }

private:
  int first_, second_;
  Vec zero_;
  Guard guard_;
};

/// Decides by the distance of integer keys that have the order of signed numbers. Keys are half of
/// the encodings, so their difference fits. No information is lost, because the last bit of a
/// double with at most 52 digits is 0.
class SignedKeys {
public:
  HWY_INLINE explicit SignedKeys(const FloatCriterion& criterion)
      : first_(criterion.first),
        second_(criterion.second),
        zero_(hn::Set(Tag(), criterion.zero)),
        guard_(criterion.guard) {}

  HWY_INLINE IntVec operator()(const Block& block, std::size_t i) const {
    const IntVec f = key(hn::LoadU(Tag(), block.columns[first_] + i));
    const IntVec g = key(hn::LoadU(Tag(), block.columns[second_] + i));
    return guard_.decide(f, g);
  }

private:
  HWY_INLINE IntVec key(Vec x) const {
    const IntVec magnitude = hn::Sub(bits_of(hn::Max(hn::Abs(x), zero_)), bits_of(zero_));
    const IntVec halved = hn::ShiftRight<1>(magnitude);
    const IntVec sign = hn::BroadcastSignBit(bits_of(x));
    return hn::Sub(hn::Xor(halved, sign), sign);
  }

  int first_, second_;
  Vec zero_;
  Guard guard_;
};

/// Decides by the sign of the difference, if its encoding exceeds the bound's by more than the
/// guard and every condition holds. An infinite bound exceeds every difference.
class AbsoluteBound {
public:
  HWY_INLINE explicit AbsoluteBound(const FloatCriterion& criterion)
      : criterion_(criterion),
        zero_(hn::Set(Tag(), criterion.zero)),
        guard_(hn::Set(Int(), criterion.guard)) {}

  HWY_INLINE IntVec operator()(const Block& block, std::size_t i) const {
    const Vec difference = hn::LoadU(Tag(), block.columns[criterion_.first] + i);
    const Vec bound = hn::LoadU(Tag(), block.columns[criterion_.second] + i);
    const IntVec excess =
        hn::Sub(bits_of(hn::Max(hn::Abs(difference), zero_)), bits_of(hn::Max(bound, zero_)));
    IntVec holds = hn::VecFromMask(Int(), hn::Gt(excess, guard_));
    for (const FloatCriterion::Condition& condition : criterion_.conditions) {
      const Vec limit = hn::LoadU(Tag(), block.columns[condition.bound] + i);
      const Vec value = hn::LoadU(Tag(), block.columns[condition.value] + i);
      holds = hn::And(holds, as_int(hn::Le(limit, hn::Abs(value))));
    }
    const IntVec negative = hn::BroadcastSignBit(bits_of(difference));
    return greater_or_less(hn::MaskFromVec(hn::AndNot(negative, holds)),
                           hn::MaskFromVec(hn::And(negative, holds)));
  }

private:
  const FloatCriterion& criterion_;
  Vec zero_;
  IntVec guard_;
};

struct Interval {
  const FloatCriterion& criterion;
  HWY_INLINE IntVec operator()(const Block& block, std::size_t i) const {
    const Vec minimum = hn::LoadU(Tag(), block.columns[criterion.first] + i);
    const Vec maximum = hn::LoadU(Tag(), block.columns[criterion.second] + i);
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

template <class Decides>
void decide_by(const Decides& decides, const FloatCriterion& criterion, const Block& block,
               std::uint8_t* codes) {
  const hn::Rebind<std::uint64_t, Tag> words;
  const hn::Rebind<std::uint8_t, Tag> bytes;
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(Tag())) {
    IntVec decision = decides(block, i);
    for (const OperandCheck& check : criterion.checks) {
      decision = hn::IfThenElse(hn::MaskFromVec(failing(check, block, i)), code(4), decision);
    }
    hn::StoreU(hn::TruncateTo(bytes, hn::BitCast(words, decision)), bytes, codes + i);
  }
}

void decide(const FloatCriterion& criterion, const Block& block, std::uint8_t* codes) {
  switch (criterion.kind) {
    case CriterionKind::order: return decide_by(Order{criterion}, criterion, block, codes);
    case CriterionKind::magnitudes:
      return decide_by(Magnitudes(criterion), criterion, block, codes);
    case CriterionKind::signed_keys:
      return decide_by(SignedKeys(criterion), criterion, block, codes);
    case CriterionKind::absolute_bound:
      return decide_by(AbsoluteBound(criterion), criterion, block, codes);
    case CriterionKind::interval: return decide_by(Interval{criterion}, criterion, block, codes);
  }
}

}  // namespace mixcmp::emulator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
