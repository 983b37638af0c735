#include "model/base/common/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "model/base/common/quote.hpp"

namespace mixcmp::inline common {

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int substituted = last[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, substituted});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

std::string nearest(std::string_view text, std::span<const std::string> names) {
  constexpr std::size_t longest_name = 64;  // longer texts are no slip, and cost quadratic time
  if (text.size() > longest_name) return {};
  std::string best;
  int best_distance = static_cast<int>(std::max<std::size_t>(text.size(), 2)) / 2 + 1;
  for (const std::string& name : names) {
    const auto longer =
        static_cast<std::int64_t>(name.size()) - static_cast<std::int64_t>(text.size());
    if (std::abs(longer) >= best_distance) continue;  // a lower bound on the distance
    const int distance = edit_distance(text, name);
    if (distance >= best_distance) continue;
    best = name;
    best_distance = distance;
  }
  return best;
}

std::string list_with_nearest(std::string_view text, std::span<const std::string> names) {
  const std::string first = nearest(text, names);
  std::vector<std::string> listed;
  if (!first.empty()) listed.push_back(printable_line(first) + " (the nearest)");
  constexpr std::size_t most = 40;
  for (const std::string& name : names) {
    if (listed.size() == most) break;
    if (name != first) listed.push_back(printable_line(name));
  }
  const std::size_t others = names.size() - std::min(names.size(), listed.size());
  if (listed.size() == most && others > 0) listed.push_back(fmt::format("and {} more", others));
  return fmt::format("{}", fmt::join(listed, ", "));
}

}  // namespace mixcmp::inline common
