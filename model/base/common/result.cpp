#include "model/base/common/result.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "model/base/common/quote.hpp"

namespace mixcmp::inline common {
namespace {

// The longest printed parts of a message, in bytes; longer text ends in "...".
constexpr std::size_t most_of_field = 200, most_of_message = 4000, most_of_received = 500,
                      most_of_accepted = 2000;

/// `text`, cut between characters if it is too long.
std::string bounded(std::string_view text, std::size_t most) {
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  std::size_t end = std::min(text.size(), most);
  while (end < text.size() && end > 0 && continues(text[end])) --end;
  const std::string shown = printable(text.substr(0, end));
  return end < text.size() ? shown + "..." : shown;
}

}  // namespace

std::string Error::to_string() const {
  std::string text = file;
  if (line > 0) text += fmt::format(":{}", line);
  if (line > 0 && column > 0) text += fmt::format(":{}", column);
  if (!field.empty()) text += (text.empty() ? "" : ": ") + bounded(field, most_of_field);
  if (!message.empty()) text += (text.empty() ? "" : ": ") + bounded(message, most_of_message);
  if (!received.empty()) text += fmt::format(": received {}", bounded(received, most_of_received));
  if (!accepted.empty()) text += fmt::format("; accepted {}", bounded(accepted, most_of_accepted));
  return text;
}

}  // namespace mixcmp::inline common
