#include "model/cost/devices/vendor_part.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "model/base/common/nearest.hpp"

namespace mixcmp::devices {
namespace {

/// Only the letters and digits, in lower case: part numbers are written with and without dashes.
std::string plain(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0) letters += static_cast<char>(std::tolower(byte));
  }
  return letters;
}

std::size_t common_letters(std::string_view a, std::string_view b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first -
                                  a.begin());
}

/// The number of letters of a part number that name the chip. Package and speed follow.
constexpr std::size_t chip_letters = 8;
/// The number of letters that name the family.
constexpr std::size_t family_letters = 4;

bool is_chip(std::string_view text, std::string_view part) {
  if (part.empty()) return false;
  if (common_letters(text, part) >= std::min(chip_letters, part.size())) return true;
  return text.size() >= family_letters && part.find(text) != std::string_view::npos;
}

bool is_family(std::string_view text, std::string_view part) {
  return common_letters(text, part) >= family_letters;
}

/// The list with one device in front, and the reason for that.
std::string with_first(const NamedPart& first, const std::string& reason,
                       std::span<const NamedPart> parts) {
  std::vector<std::string> listed = {fmt::format("{} ({})", first.name, reason)};
  for (const NamedPart& part : parts) {
    if (part.name != first.name) listed.push_back(part.name);
  }
  return fmt::format("{}", fmt::join(listed, ", "));
}

}  // namespace

std::string list_for(std::string_view received, std::span<const NamedPart> parts) {
  const std::string text = plain(received);
  for (const NamedPart& part : parts) {
    if (!is_chip(text, plain(part.vendor_name))) continue;
    return with_first(part, "which is " + part.vendor_name, parts);
  }
  for (const NamedPart& part : parts) {
    if (!is_family(text, plain(part.vendor_name))) continue;
    return with_first(part, part.vendor_name + ", of the same family", parts);
  }
  std::vector<std::string> names;
  for (const NamedPart& part : parts) names.push_back(part.name);
  return list_with_nearest(received, names);
}

}  // namespace mixcmp::devices
