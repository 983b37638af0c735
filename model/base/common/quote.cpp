#include "model/base/common/quote.hpp"

#include <algorithm>

namespace mixcmp::inline common {
namespace {

/// The length in bytes of the character at the front of `text`, which is not empty; 0 if that is
/// not valid UTF-8.
std::size_t character_bytes(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return 0;
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte(k) & 0xC0U) != 0x80U) return 0;
  }
  // Overlong forms, surrogates and code points beyond U+10FFFF are not valid.
  const unsigned second = byte(1);
  const bool wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                     (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return wrong ? 0 : bytes;
}

bool needs_quotes(const std::string& text) {
  return text.empty() || text.find_first_of(" \t\n\"'$&|;<>()[]{}*?!#~`\\") != std::string::npos;
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t most = 80;
  if (text.size() <= most) return '"' + printable_line(text) + '"';
  std::size_t end = most;  // between two characters
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return '"' + printable_line(text.substr(0, end)) + "...\"";
}

bool is_one_line(std::string_view text) {
  while (!text.empty()) {
    const std::size_t bytes = character_bytes(text);
    const bool control =
        bytes == 1 && (static_cast<unsigned char>(text[0]) < ' ' || text[0] == 0x7F);
    if (bytes == 0 || control) return false;
    text.remove_prefix(bytes);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t bytes = character_bytes(text);
    const char c = text[0];
    const bool control = bytes == 1 && ((' ' > c && c != '\n') || c == 0x7F);
    shown += bytes == 0 || control ? "?" : text.substr(0, bytes);
    text.remove_prefix(bytes == 0 ? 1 : bytes);
  }
  return shown;
}

std::string printable_line(std::string_view text) {
  std::string line = printable(text);
  std::replace(line.begin(), line.end(), '\n', '?');
  return line;
}

std::string on_one_line(std::string_view text) {
  constexpr std::string_view space = " \t\r\n";
  std::string line;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
    if (text.empty()) return line;
    const std::string_view word = text.substr(0, text.find_first_of(space));
    line += (line.empty() ? "" : " ") + std::string(word);
    text.remove_prefix(word.size());
  }
}

std::string quoted(const std::string& text) {
  if (!needs_quotes(text)) return text;
  std::string quoted_text = "'";
  for (const char c : text) quoted_text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted_text + "'";
}

}  // namespace mixcmp::inline common
