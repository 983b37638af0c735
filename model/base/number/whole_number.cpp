#include "model/base/number/whole_number.hpp"

#include <charconv>

namespace mixcmp::inline number {

std::optional<int> whole_number(std::string_view word) {
  unsigned short number = 0;  // unsigned: takes no sign
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, number);
  const bool whole = read.ec == std::errc() && read.ptr == end;
  return whole ? std::optional<int>(number) : std::nullopt;
}

}  // namespace mixcmp::inline number
