#include "generator/synthesis/characterise/static_timing.hpp"

#include <fmt/core.h>

#include <optional>
#include <regex>

#include "embedded/timing_files.hpp"

namespace mixcmp::characterise {
namespace {

std::optional<std::string> untimed_cell(const std::string& text) {
  // Yosys' two messages about a cell without known delays: it has no model, or a model without
  // delays.
  static const std::regex untimed(
      "(?:Cell type '([^']+)' not recognised|Module '([^']+)' has no timing arcs)");
  std::smatch found;
  if (!std::regex_search(text, found, untimed)) return std::nullopt;
  return found[1].matched ? found[1] : found[2];
}

}  // namespace

Result<int> longest_path_ps(std::string_view sta_text) {
  const std::string text(sta_text);
  if (const auto cell = untimed_cell(text)) {
    return Error{.message = fmt::format("Yosys knows no delays of the cell {}", *cell)};
  }
  static const std::regex latest("Latest arrival time in '[^']*' is (\\d{1,9}):");
  std::smatch found;
  int picoseconds = 0;
  if (std::regex_search(text, found, latest)) picoseconds = std::stoi(found[1]);
  if (picoseconds > 0) return picoseconds;
  return Error{.message = "there is no path between registers"};
}

const EmbeddedFile& shift_register_output() {
  return timing_files().front();
}

}  // namespace mixcmp::characterise
