#pragma once

#include "model/format/float_format.hpp"
#include "model/golden/big_float.hpp"

namespace mixcmp::model::golden {

/// Holds every finite encoding of every format: the widest significand, in whole limbs.
inline constexpr mpfr_prec_t encoding_precision = 128;

/// x = the exact value of a finite encoding, or the infinity or NaN. x has at least
/// encoding_precision digits.
void decode(BigFloat& x, FloatFormat format, Bits bits);

/// The encoding of a finite value that the format holds exactly, in a BigFloat of the format's
/// precision.
Bits encode(FloatFormat format, const BigFloat& x);

}  // namespace mixcmp::model::golden
