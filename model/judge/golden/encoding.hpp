#pragma once

#include "model/base/number/float_format.hpp"
#include "model/judge/golden/big_float.hpp"

namespace mixcmp::golden {

/// A precision, in bits, that holds every finite number of every format: the widest significand, in
/// whole limbs.
inline constexpr mpfr_prec_t encoding_precision = 128;

/// Sets x to the number, infinity or NaN that `bits` encodes, exactly. The caller must have given x
/// a precision of encoding_precision or more.
void decode(BigFloat& x, FloatFormat format, Bits bits);

/// The encoding of a finite value that the format holds exactly, in a BigFloat of the format's
/// precision.
Bits encode(FloatFormat format, const BigFloat& x);

}  // namespace mixcmp::golden
