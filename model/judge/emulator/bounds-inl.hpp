// Arithmetic of bounds, rounded up. Only kernels.cpp includes this file, once per instruction set.
#if defined(MIXCMP_EMULATOR_BOUNDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MIXCMP_EMULATOR_BOUNDS_INL
#undef MIXCMP_EMULATOR_BOUNDS_INL
#else
#define MIXCMP_EMULATOR_BOUNDS_INL
#endif

#include "model/judge/emulator/rounding-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mixcmp::emulator::HWY_NAMESPACE {

/// Applies the rules of model/lane/error/bound_graph.hpp in double; an infinite bound is an
/// infinity.
class Bounds {
public:
  HWY_INLINE explicit Bounds(const Instruction& instruction)
      : rounder_(instruction.dropped_digits),
        smallest_(hn::Set(Tag(), instruction.smallest)),
        largest_(hn::Set(Tag(), instruction.largest)),
        infinity_(hn::Inf(Tag())),
        exponent_(from_bits(hn::Set(Int(), std::int64_t{0x7ff} << 52))) {}

  HWY_INLINE Vec magnitude(Vec x) const { return in_range(rounder_.raised(hn::Abs(x))); }
  HWY_INLINE Vec binade(Vec x) const { return in_range(hn::And(x, exponent_)); }
  /// Biased exponents e and 2046 - e are those of reciprocal powers of two.
  HWY_INLINE Vec reciprocal(Vec x) const {
    const IntVec one_twice = hn::Set(Int(), std::int64_t{2046} << 52);
    const Vec power = from_bits(hn::Sub(one_twice, bits_of(hn::And(x, exponent_))));
    return hn::IfThenElse(hn::Eq(x, hn::Zero(Tag())), infinity_, in_range(power));
  }
  /// The error of an infinite sum is NaN, which counts as none.
  HWY_INLINE Vec add(Vec a, Vec b) const {
    const Vec r = hn::Add(a, b);
    return in_range(rounder_.raised(r, sum_error(a, b, r)));
  }
  HWY_INLINE Vec multiply_short(Vec a, Vec b) const {
    return product(a, b, rounder_.raised(hn::Mul(a, b)));
  }
  HWY_INLINE Vec multiply(Vec a, Vec b) const {
    const Vec r = hn::Mul(a, b);
    return product(a, b, rounder_.raised(r, product_error(a, b, r)));
  }

private:
  HWY_INLINE Vec in_range(Vec x) const {
    const Vec not_below = hn::IfThenZeroElse(hn::Eq(x, hn::Zero(Tag())), hn::Max(x, smallest_));
    return hn::IfThenElse(hn::Gt(not_below, largest_), infinity_, not_below);
  }
  /// Corrects two products: one that underflows to 0 in double although no factor is 0, and 0 times
  /// infinity, which is NaN in double and infinite as a bound.
  HWY_INLINE Vec product(Vec a, Vec b, Vec raised) const {
    const Vec not_zero = in_range(hn::Max(raised, smallest_));
    const Vec finite = hn::IfThenZeroElse(hn::Eq(hn::Min(a, b), hn::Zero(Tag())), not_zero);
    return hn::IfThenElse(hn::Eq(hn::Max(a, b), infinity_), infinity_, finite);
  }

  Rounder rounder_;
  Vec smallest_, largest_, infinity_, exponent_;
};

template <class Function>
HWY_INLINE void bound_loop(const Instruction& instruction, const Block& block, Function function) {
  const double* HWY_RESTRICT a_column = block.columns[instruction.a];
  const double* HWY_RESTRICT b_column = block.columns[instruction.b];
  double* HWY_RESTRICT results = block.results[instruction.result];
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(Tag())) {
    const Vec a = hn::LoadU(Tag(), a_column + i), b = hn::LoadU(Tag(), b_column + i);
    hn::StoreU(function(a, b), Tag(), results + i);
  }
}

void bound(const Instruction& instruction, const Block& block) {
  const Bounds bounds(instruction);
  switch (instruction.kernel) {
    case Kernel::bound_magnitude:
      return bound_loop(instruction, block,
                        [&](Vec a, Vec) HWY_ATTR { return bounds.magnitude(a); });
    case Kernel::bound_binade:
      return bound_loop(instruction, block, [&](Vec a, Vec) HWY_ATTR { return bounds.binade(a); });
    case Kernel::bound_reciprocal:
      return bound_loop(instruction, block,
                        [&](Vec a, Vec) HWY_ATTR { return bounds.reciprocal(a); });
    case Kernel::bound_add:
      return bound_loop(instruction, block,
                        [&](Vec a, Vec b) HWY_ATTR { return bounds.add(a, b); });
    case Kernel::bound_multiply:
      // Two factors of at most 26 digits have an exact product in double.
      if (instruction.dropped_digits >= 27) {
        return bound_loop(instruction, block,
                          [&](Vec a, Vec b) HWY_ATTR { return bounds.multiply_short(a, b); });
      }
      return bound_loop(instruction, block,
                        [&](Vec a, Vec b) HWY_ATTR { return bounds.multiply(a, b); });
    default:
      return bound_loop(instruction, block, [&](Vec a, Vec b) HWY_ATTR { return hn::Max(a, b); });
  }
}

}  // namespace mixcmp::emulator::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
