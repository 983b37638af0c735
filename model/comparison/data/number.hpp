#pragma once

#include <optional>
#include <string_view>

#include "model/base/number/float_format.hpp"

namespace mixcmp::data {

/// Reads a data file's number from its decimal (or hex-float) text, rounded once; blanks around it
/// are ignored. Infinities and NaNs must be written as such: a number beyond the format's largest
/// is an error.
Result<Bits> read_number(FloatFormat format, std::string_view text);
/// Reads a number, rounds it to `rounded_to` if there is such a format, and encodes it in `format`.
Result<Bits> read_number(FloatFormat format, std::optional<FloatFormat> rounded_to,
                         std::string_view text);

/// `text` without blanks at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace mixcmp::data
