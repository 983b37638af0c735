#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "generator/present/report/report_sections.hpp"
#include "generator/present/report/summary_report.hpp"

namespace mixcmp::report {
namespace {

/// The first lines of a summary, which a reader of the page wants to see at once.
constexpr std::array<std::string_view, 5> shown_titles = {"inputs", "formats", "system", "data",
                                                          "notes"};

bool is_shown(const SummaryLines& lines) {
  if (lines.title.starts_with("scene ") || lines.title.starts_with("plan ")) return true;
  for (const std::string_view title : shown_titles) {
    if (lines.title == title) return true;
  }
  return false;
}

/// A title of a summary with a capital letter.
std::string as_heading(std::string title) {
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

void add_shown(page::Section& section, const SummaryLines& lines) {
  if (lines.title.starts_with("scene ")) {
    return section.content.push_back(page::definitions(lines.lines));
  }
  section.content.push_back(page::heading(as_heading(lines.title)));
  std::size_t longest = 0;
  for (const table::Line& line : lines.lines) longest = std::max(longest, line.text.size());
  constexpr std::size_t most_letters_side_by_side = 40;
  section.content.push_back(longest <= most_letters_side_by_side
                                ? page::short_definitions(lines.lines)
                                : page::definitions(lines.lines));
}

std::string sentence(const scene::Scene& scene) {
  if (scene.parts.size() == 1) {
    return "For each pair of operand sets the hardware answers whether f is less than, equal to or "
           "greater than g.";
  }
  return fmt::format(
      "Each comparison has {} parts. For each the hardware answers whether f is less than, equal "
      "to or greater than g; the verdict combines them by \"{}\".",
      scene.parts.size(), to_string(scene.graph.combination()));
}

}  // namespace

page::Section request_section(const scene::Summary& summary, const table::Lines& made_by) {
  page::Section section{"request", "What was asked", {page::paragraph(sentence(*summary.scene))}};
  page::Element more("div");
  bool has_more = false;
  for (const SummaryLines& lines : lines_of(summary)) {
    if (lines.lines.empty()) continue;  // a plan that changes nothing that is counted
    if (is_shown(lines)) {
      add_shown(section, lines);
      continue;
    }
    more.add(page::heading(as_heading(lines.title))).add(page::definitions(lines.lines));
    has_more = true;
  }
  if (has_more) {
    section.content.push_back(
        page::details("Operators, and what the declared ranges rule out", more));
  }
  section.content.push_back(page::heading("This page"));
  section.content.push_back(page::definitions(made_by));
  return section;
}

}  // namespace mixcmp::report
