#pragma once

#include <string>
#include <string_view>

#include "model/base/common/result.hpp"
#include "model/base/number/float_format.hpp"

namespace mixcmp::inline number {

/// Reads a decimal literal ("12.345", "-1e-7") or C hex-float, rounded once to nearest, or "inf",
/// "infinity" or "nan" in letters of either case.
Result<Bits> from_text(FloatFormat format, std::string_view text);
/// The shortest decimal that reads back as the same number, or "inf", "-inf", "nan".
std::string to_text(FloatFormat format, Bits bits);

}  // namespace mixcmp::inline number
