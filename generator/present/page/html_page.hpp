#pragma once

#include <string>
#include <utility>
#include <vector>

#include "generator/present/page/element.hpp"
#include "generator/present/table/table.hpp"

namespace mixcmp::page {

Element paragraph(std::string_view text);
Element note(std::string_view text);
Element heading(std::string_view text);
/// Names and their meanings, in two columns.
Element definitions(const table::Lines& entries);
/// Names and short meanings: several entries side by side where there is room.
Element short_definitions(const table::Lines& entries);
/// Lines of a command or a program, as they are.
Element code(std::string_view text);
/// States the missing part of a section, and the command that makes it (empty: none).
Element missing(std::string_view why, std::string_view command);
/// A picture with a sentence below it.
Element figure(const Element& picture, std::string_view caption);
/// Several pictures side by side where there is room.
Element gallery(const std::vector<Element>& figures);
/// Large numbers with their names.
Element key_figures(const table::Lines& entries);
/// A part of a page that a reader may open for more details.
Element details(std::string_view summary, const Element& content);

/// A table as people read it. Columns whose cells are all numbers are aligned to the right.
Element draw(const table::Table& table);

struct Section {
  std::string id;  ///< letters and hyphens
  std::string title;
  std::vector<Element> content;
};

struct Page {
  std::string title;
  std::string subtitle;
  std::vector<Section> sections;
  std::string footer;
};

/// One file of HTML that needs no other: style sheet and script are inside, and nothing is loaded.
std::string to_html(const Page& page);

}  // namespace mixcmp::page
