// Rounds doubles to fewer digits. Only kernels.cpp includes this file, once per instruction set.
#if defined(MIXCMP_EMULATOR_ROUNDING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MIXCMP_EMULATOR_ROUNDING_INL
#undef MIXCMP_EMULATOR_ROUNDING_INL
#else
#define MIXCMP_EMULATOR_ROUNDING_INL
#endif

#include <cstdint>

#include "hwy/highway.h"
#include "model/judge/emulator/kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace mixcmp::emulator::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<double>;
using Int = hn::RebindToSigned<Tag>;
using Vec = hn::Vec<Tag>;
using IntVec = hn::Vec<Int>;
using Long = hn::RebindToUnsigned<Int>;
#if HWY_TARGET != HWY_SCALAR
using Word = hn::Repartition<std::uint32_t, Tag>;
using WordVec = hn::Vec<Word>;
#endif

HWY_INLINE IntVec bits_of(Vec x) {
  return hn::BitCast(Int(), x);
}
HWY_INLINE Vec from_bits(IntVec x) {
  return hn::BitCast(Tag(), x);
}
HWY_INLINE Vec sign_bits(Vec x) {
  return hn::And(x, hn::SignBit(Tag()));
}
/// All ones if x and y differ in sign.
HWY_INLINE IntVec opposite_signs(Vec x, Vec y) {
  return hn::BroadcastSignBit(bits_of(hn::Xor(x, y)));
}

/// The error functions return the exact error of r = RN(a op b) for op = +, -, *. For a quotient or
/// root, `remainder` returns a number with the error's sign, which is 0 if the error is. Nothing
/// here may underflow: docs/emulator.md.
HWY_INLINE Vec sum_error(Vec a, Vec b, Vec r) {  // Knuth's TwoSum
  const Vec b_part = hn::Sub(r, a);
  return hn::Add(hn::Sub(a, hn::Sub(r, b_part)), hn::Sub(b, b_part));
}

#if HWY_NATIVE_FMA
HWY_INLINE Vec product_error(Vec a, Vec b, Vec r) {
  return hn::MulSub(a, b, r);
}
/// c - a * b, which for quotients and roots is exact in 53 digits.
HWY_INLINE Vec remainder(Vec a, Vec b, Vec c) {
  return hn::NegMulAdd(a, b, c);
}
#else
HWY_INLINE Vec high_half(Vec x) {  // Veltkamp: 26 digits, and as many are left
  const Vec scaled = hn::Mul(x, hn::Set(Tag(), 0x1p27 + 1));
  return hn::Sub(scaled, hn::Sub(scaled, x));
}
HWY_INLINE Vec product_error(Vec a, Vec b, Vec r) {  // Dekker
  const Vec a_high = high_half(a), a_low = hn::Sub(a, a_high);
  const Vec b_high = high_half(b), b_low = hn::Sub(b, b_high);
  Vec error = hn::Sub(hn::Mul(a_high, b_high), r);
  error = hn::Add(error, hn::Mul(a_high, b_low));
  error = hn::Add(error, hn::Mul(a_low, b_high));
  return hn::Add(error, hn::Mul(a_low, b_low));
}
HWY_INLINE Vec remainder(Vec a, Vec b, Vec c) {
  const Vec product = hn::Mul(a, b);
  return hn::Sub(hn::Sub(c, product), product_error(a, b, product));
}
#endif

/// Rounds r, a number of 53 digits, to P = 53 - dropped digits. It works on r's bits as an integer.
/// In these a step of P digits is 2^dropped, and a carry into the exponent gives the right number.
class Rounder {
public:
  HWY_INLINE explicit Rounder(int dropped_digits)
      : step_(hn::Set(Int(), std::int64_t{1} << dropped_digits)),
        half_(hn::Set(Int(), (std::int64_t{1} << dropped_digits) >> 1)),
        kept_(hn::Set(Int(), -(std::int64_t{1} << dropped_digits))),
        scale_(hn::Set(Tag(), static_cast<double>(std::int64_t{1} << dropped_digits))) {}

  /// r + half a step. The kept digits are those of r rounded to nearest, upward if r lies half way;
  /// then the dropped digits are all 0.
  HWY_INLINE IntVec raised_half(Vec r) const { return hn::Add(bits_of(r), half_); }
  HWY_INLINE IntVec kept(IntVec raised) const { return hn::And(raised, kept_); }

  HWY_INLINE Vec nearest(Vec r) const {
    const IntVec raised = raised_half(r), up = kept(raised);
    const IntVec last_digit = hn::IfThenElseZero(hn::Eq(raised, up), step_);
    return from_bits(hn::AndNot(last_digit, up));  // to even
  }

  /// Numbers half way between neighbours of P digits have P + 1 <= 53 digits. Rounding to 53 digits
  /// is monotone, so x lies on the same side of each of them as r does, unless r is one: then e
  /// decides.
  HWY_INLINE Vec corrected(Vec r, Vec e) const {
    const IntVec raised = raised_half(r), up = kept(raised);
    const IntVec step = hn::IfThenElseZero(hn::Eq(raised, up), step_);
    const hn::Mask<Int> exact = hn::RebindMask(Int(), hn::Eq(e, hn::Zero(Tag())));
    const IntVec down = hn::IfThenElse(exact, up, opposite_signs(e, r));
    return from_bits(hn::Sub(up, hn::And(step, down)));
  }

  /// Truncates x to P digits. Starts from r, or from the next double toward zero if e points there.
  HWY_INLINE Vec truncated(Vec r, Vec e) const {
    const hn::Mask<Int> inexact = hn::RebindMask(Int(), hn::Ne(e, hn::Zero(Tag())));
    const IntVec minus_one = hn::IfThenElseZero(inexact, opposite_signs(e, r));
    return from_bits(hn::And(hn::Add(bits_of(r), minus_one), kept_));
  }

  /// Rounds a bound, which is never negative, up to P digits, P <= 52. If e > 0 it starts from the
  /// next double above r. If e < 0, r is at most half a double's step too high, and no number of P
  /// digits lies between.
  HWY_INLINE Vec raised(Vec r, Vec e) const {
    const IntVec above = hn::BitCast(Int(), hn::VecFromMask(Tag(), hn::Gt(e, hn::Zero(Tag()))));
    return raised(from_bits(hn::Sub(bits_of(r), above)));
  }
  HWY_INLINE Vec raised(Vec r) const {
    const IntVec rest = hn::Not(kept_);
    return from_bits(hn::And(hn::Add(bits_of(r), rest), kept_));
  }

  /// a * b rounded once. Let M = 2^(dropped + floor(log2 |r|)), with r's sign. One step of a double
  /// in M's binade is one step of P digits in r's, and a * b + M stays within that binade (or is
  /// its upper end). If r was rounded up to a power of two, both binades' steps round a * b to that
  /// power.
  HWY_INLINE Vec fused(Vec a, Vec b, Vec r) const {
    const Vec power = hn::And(r, from_bits(hn::Set(Int(), ~((std::int64_t{1} << 52) - 1))));
    const Vec m = hn::Mul(power, scale_);
    return hn::Sub(hn::MulAdd(a, b, m), m);
  }

private:
  IntVec step_, half_, kept_;
  Vec scale_;
};

}  // namespace mixcmp::emulator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
