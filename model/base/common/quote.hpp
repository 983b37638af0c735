#pragma once

#include <string>
#include <string_view>

namespace mixcmp::inline common {

/// `text` in quotes, fit for one line of an error message. '?' replaces control characters and
/// bytes that are not valid UTF-8, and a text that is too long ends in "...".
std::string in_quotes(std::string_view text);

/// Whether `text` is valid UTF-8 without control characters.
bool is_one_line(std::string_view text);

/// `text` with '?' for every control character except line ends, and for every byte that is not
/// valid UTF-8, which the JSON writer refuses.
std::string printable(std::string_view text);

/// `text` with '?' for everything that printable() replaces, and for line ends.
std::string printable_line(std::string_view text);

/// The words of `text` with one blank between them instead of any blanks, tabs and line ends.
std::string on_one_line(std::string_view text);

/// One word of a POSIX shell's command line, quoted if necessary.
std::string quoted(const std::string& text);

}  // namespace mixcmp::inline common
