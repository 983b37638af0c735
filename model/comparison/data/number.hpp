#pragma once

#include <gmpxx.h>

#include <optional>
#include <string_view>

#include "model/base/number/float_format.hpp"

namespace mixcmp::data {

/// Reads a data file's number from its decimal (or hex-float) text, rounded once; blanks around it
/// are ignored. Infinities and NaNs must be written as such: a number beyond the format's largest
/// is an error.
Result<Bits> read_number(FloatFormat format, std::string_view text);

/// The whole number that `text` writes in digits if `number`, which read_number made of it, is
/// another; otherwise none.
std::optional<mpz_class> rounded_whole(FloatFormat format, std::string_view text, Bits number);

/// `text` without blanks at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace mixcmp::data
