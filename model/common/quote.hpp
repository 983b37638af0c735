#pragma once

#include <string>
#include <string_view>

namespace mixcmp::inline common {

/// `text` in quotes, fit for one line of an error message: '?' stands for control characters and
/// for bytes that are not valid UTF-8, and what is too long ends in "...".
std::string in_quotes(std::string_view text);

/// Whether `text` is valid UTF-8 without control characters.
bool is_one_line(std::string_view text);

/// `text` with '?' in place of every control character but line ends, and of every byte that is not
/// valid UTF-8, which the JSON writer refuses.
std::string printable(std::string_view text);

/// printable(), with '?' in place of line ends, too.
std::string printable_line(std::string_view text);

/// The words of `text` with one blank between them, whatever blanks, tabs and line ends there were.
std::string on_one_line(std::string_view text);

/// One word of a POSIX shell's command line, quoted where it must be.
std::string quoted(const std::string& text);

}  // namespace mixcmp::inline common
