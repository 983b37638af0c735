#include "model/cost/devices/parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "embedded/part_files.hpp"
#include "model/base/common/check.hpp"
#include "model/base/common/nearest.hpp"
#include "model/cost/devices/device.hpp"

namespace mixcmp::devices {
namespace {

std::string_view text_of(std::string_view name) {
  for (const EmbeddedFile& file : part_files()) {
    if (file.name == name) return file.text;
  }
  MIXCMP_CHECK(!"a table of that name");
}

/// The text in front of `separator`, which is removed from `text` together with it.
std::string_view cut(std::string_view& text, char separator) {
  const std::string_view front = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(front.size() + 1, text.size()));
  return front;
}

/// The rows of a table whose cells have no quotes. Comments and the headings are left out.
template <class Row, std::size_t columns>
std::vector<Row> rows_of(std::string_view text,
                         const std::array<std::string_view Row::*, columns>& members) {
  std::vector<Row> rows;
  bool is_heading = true;
  while (!text.empty()) {
    std::string_view line = cut(text, '\n');
    if (line.starts_with('#')) continue;
    if (std::exchange(is_heading, false)) continue;
    Row row;
    for (const auto member : members) row.*member = cut(line, ',');
    MIXCMP_CHECK(line.empty());
    rows.push_back(row);
  }
  return rows;
}

/// Tells whether a number for orders is one of this part: behind the part there is a dash, or a
/// package. Fewer than four letters make another part, as in GW1N-1S.
bool is_order_of(std::string_view number, std::string_view part) {
  if (!number.starts_with(part)) return false;
  const std::string_view rest = number.substr(part.size());
  if (rest.empty() || rest.front() == '-') return true;
  return rest.size() >= 4 && std::isalpha(static_cast<unsigned char>(rest.front())) != 0;
}

/// Only the letters and digits, in lower case: part numbers are written with and without dashes.
std::string plain(std::string_view name) {
  std::string letters = lower_case(name);
  std::erase_if(letters, [](unsigned char c) { return std::isalnum(c) == 0; });
  return letters;
}

/// The names of all devices that come with the program: device files, parts and boards.
std::vector<std::string> all_names() {
  std::vector<std::string> names = device_names();
  for (const Part& part : parts()) names.emplace_back(part.name);
  for (const Board& board : boards()) names.emplace_back(board.name);
  return names;
}

/// The names whose letters and digits hold those of `text`, in front or anywhere.
std::vector<std::string> names_with(const std::string& text) {
  std::vector<std::string> first, others;
  for (const std::string& name : all_names()) {
    const std::size_t at = plain(name).find(text);
    if (at == std::string::npos) continue;
    (at == 0 ? first : others).push_back(name);
  }
  return first.empty() ? others : first;
}

std::vector<std::string> parts_of_family(std::string_view family) {
  std::vector<std::string> names;
  for (const Part& part : parts()) {
    if (part.family == family) names.emplace_back(part.name);
  }
  return names;
}

std::vector<std::string> names_nearest_to(const std::string& text) {
  constexpr std::size_t most = 5;
  std::vector<std::string> names = all_names();
  std::vector<std::string> found;
  while (found.size() < most) {
    const std::string next = nearest(text, names);
    if (next.empty()) break;
    found.push_back(next);
    std::erase(names, next);
  }
  return found;
}

}  // namespace

std::vector<Part> parts() {
  return rows_of<Part, 10>(
      text_of("parts.csv"),
      {&Part::name, &Part::family, &Part::luts, &Part::registers, &Part::dsps, &Part::memories,
       &Part::arguments, &Part::vivado_part, &Part::quartus_part, &Part::device});
}

std::vector<Board> boards() {
  return rows_of<Board, 4>(text_of("boards.csv"),
                           {&Board::name, &Board::part, &Board::maker, &Board::page});
}

std::optional<Part> find_part(std::string_view name) {
  const std::string lower = lower_case(name);
  std::string_view number = lower;
  for (const Board& board : boards()) {
    if (board.name == lower) number = board.part;
  }
  std::optional<Part> found;
  for (const Part& part : parts()) {
    const bool is_longer = !found || part.name.size() > found->name.size();
    if (is_longer && is_order_of(number, part.name)) found = part;
  }
  return found;
}

std::string device_file_of(const Part& part) {
  std::string vendor_name(part.name);
  std::transform(vendor_name.begin(), vendor_name.end(), vendor_name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string text = fmt::format(
      "[device]\nname = \"{}\"\nvendor_name = \"{}\"\nfamily = \"{}\"\nluts = {}\nregisters = {}\n"
      "dsps = {}\nmemories = {}\nvivado_part = \"{}\"\nquartus_part = \"{}\"\n",
      part.name, vendor_name, part.family, part.luts, part.registers, part.dsps, part.memories,
      part.vivado_part, part.quartus_part);
  if (part.arguments.empty()) return text;
  std::vector<std::string> arguments;
  for (std::string_view rest = part.arguments; !rest.empty();) {
    arguments.push_back(fmt::format("\"{}\"", cut(rest, ' ')));
  }
  return text + fmt::format("[timing]\narguments = [{}]\n", fmt::join(arguments, ", "));
}

std::vector<KnownDevice> devices_with(std::string_view letters) {
  std::vector<KnownDevice> known = known_devices();
  std::erase_if(known, [text = lower_case(letters)](const KnownDevice& each) {
    const std::string words =
        fmt::format("{} {} {} {}", each.device.name, each.device.family,
                    to_string(each.device.timing), fmt::join(each.other_names, " "));
    return words.find(text) == std::string::npos;
  });
  return known;
}

std::string lower_case(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

std::string candidates_for(std::string_view received) {
  const std::string text = plain(received);
  std::vector<std::string> names = parts_of_family(lower_case(received));
  if (names.empty() && !text.empty()) names = names_with(text);
  if (names.empty()) names = names_nearest_to(lower_case(received));
  if (names.empty()) names = device_names();
  constexpr std::size_t most = 10;
  const std::size_t others = names.size() - std::min(names.size(), most);
  names.resize(names.size() - others);
  if (others > 0) names.push_back(fmt::format("{} more", others));
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace mixcmp::devices
