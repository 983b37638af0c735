#pragma once

#include <optional>
#include <string_view>

namespace mixcmp::inline number {

/// The value of a word of decimal digits that fits 16 bits; none for any other word.
std::optional<int> whole_number(std::string_view word);

}  // namespace mixcmp::inline number
