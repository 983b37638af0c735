#pragma once

#include <string_view>

#include "model/base/number/float_format.hpp"

namespace mixcmp::data {

/// Reads a data file's number from its decimal (or hex-float) text, rounded once; blanks around it
/// are ignored. Infinities and NaNs must be written as such: a number beyond the format's largest
/// is an error, or the NaN of a format without infinities.
Result<Bits> read_number(FloatFormat format, std::string_view text);

/// Whether reading changed the number: `text` is a whole number in digits ("17", "17.0") and
/// `number`, which read_number made of it, another one; or `number` is 0 and `text` is not;
/// or `number` is a NaN and `text` is not.
bool is_lost(FloatFormat format, std::string_view text, Bits number);

/// `text` without blanks at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace mixcmp::data
