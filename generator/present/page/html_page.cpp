#include "generator/present/page/html_page.hpp"

#include <algorithm>
#include <charconv>

#include "embedded/page_files.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::page {
namespace {

std::string_view page_file(std::string_view name) {
  for (const EmbeddedFile& file : page_files()) {
    if (file.name == name) return file.text;
  }
  MIXCMP_CHECK(false);
}

/// Takes a number from the text's beginning; false where there is none.
bool take_number(std::string_view& text) {
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, status] = std::from_chars(text.data(), last, value);
  text = {end, static_cast<std::size_t>(last - end)};
  return status == std::errc{};
}

/// Whether a cell is a number or a range of numbers, "3-4.5", perhaps with a blank and a unit
/// behind it, or says that there is none.
bool is_numeric(const std::string& cell) {
  constexpr std::size_t longest = 14;
  if (cell.empty() || cell == "-") return true;
  std::string_view rest = cell;
  if (cell.size() > longest || !take_number(rest)) return false;
  if (rest.starts_with('-')) {
    rest.remove_prefix(1);
    if (!take_number(rest)) return false;
  }
  return rest.empty() || rest.starts_with(' ');
}

using Cells = std::vector<std::string>;

std::vector<bool> numeric_columns(const std::vector<Cells>& rows, std::size_t columns) {
  std::vector<bool> numeric(columns, !rows.empty());
  for (const Cells& row : rows) {
    for (std::size_t k = 0; k < row.size() && k < numeric.size(); ++k) {
      numeric[k] = numeric[k] && is_numeric(row[k]);
    }
  }
  return numeric;
}

Element row_of(const Cells& cells, const char* name, const std::vector<bool>& numeric) {
  Element row("tr");
  for (std::size_t k = 0; k < cells.size(); ++k) {
    std::vector<Attribute> attributes;
    if (k < numeric.size() && numeric[k]) attributes.push_back({"class", "number"});
    row.add(text_element(name, attributes, cells[k]));
  }
  return row;
}

Element head_of(const Page& page) {
  Element head("head");
  head.add(Element("meta", {{"charset", "utf-8"}}));
  head.add(
      Element("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}}));
  head.add(Element("meta", {{"name", "color-scheme"}, {"content", "light dark"}}));
  head.add(text_element("title", {}, page.title));
  return head.add(Element("style").add_verbatim(page_file("page.css")));
}

Element definition_list(const char* style, const table::Lines& entries) {
  Element list("dl", {{"class", style}});
  for (const table::Line& line : entries) {
    Element entry("div");
    entry.add(text_element("dt", {}, line.name)).add(text_element("dd", {}, line.text));
    list.add(entry);
  }
  return list;
}

Element navigation(const Page& page) {
  Element list("ul");
  for (const Section& section : page.sections) {
    Element entry("li");
    list.add(entry.add(text_element("a", {{"href", "#" + section.id}}, section.title)));
  }
  Element nav("nav", {{"aria-label", "Sections"}});
  return nav.add(list);
}

Element body_of(const Page& page) {
  Element header("header");
  header.add(text_element("h1", {}, page.title));
  header.add(text_element("p", {{"class", "subtitle"}}, page.subtitle));
  Element main("main");
  for (const Section& section : page.sections) {
    Element element("section", {{"id", section.id}});
    element.add(text_element("h2", {}, section.title));
    for (const Element& part : section.content) element.add(part);
    main.add(element);
  }
  Element body("body");
  body.add(header).add(navigation(page)).add(main);
  body.add(text_element("footer", {}, page.footer));
  body.add(Element("div", {{"id", "tip"}, {"role", "status"}, {"hidden", "hidden"}}));
  return body.add(Element("script").add_verbatim(page_file("page.js")));
}

}  // namespace

Element paragraph(std::string_view text) {
  return text_element("p", {}, text);
}

Element note(std::string_view text) {
  return text_element("p", {{"class", "note"}}, text);
}

Element heading(std::string_view text) {
  return text_element("h3", {}, text);
}

Element definitions(const table::Lines& entries) {
  return definition_list("entries", entries);
}

Element short_definitions(const table::Lines& entries) {
  return definition_list("entries short", entries);
}

Element code(std::string_view text) {
  Element block("pre", {{"tabindex", "0"}});
  return block.add(text_element("code", {}, text));
}

Element missing(std::string_view why, std::string_view command) {
  Element box("div", {{"class", "missing"}});
  box.add(paragraph(why));
  return command.empty() ? box : box.add(code(command));
}

Element figure(const Element& picture, std::string_view caption) {
  Element element("figure");
  return element.add(picture).add(text_element("figcaption", {}, caption));
}

Element gallery(const std::vector<Element>& figures) {
  Element grid("div", {{"class", "gallery"}});
  for (const Element& each : figures) grid.add(each);
  return grid;
}

Element key_figures(const table::Lines& entries) {
  return definition_list("key", entries);
}

Element details(std::string_view summary, const Element& content) {
  Element element("details");
  return element.add(text_element("summary", {}, summary)).add(content);
}

Element draw(const table::Table& table) {
  std::vector<Cells> rows;
  for (const table::Row& row : table.rows) rows.push_back(shown_cells(table, row));
  const std::vector<bool> numeric = numeric_columns(rows, table.columns.size());
  Element head("thead"), body("tbody");
  head.add(row_of(shown_titles(table), "th", numeric));
  for (const Cells& row : rows) body.add(row_of(row, "td", numeric));
  Element element("table");
  element.add(head).add(body);
  Element scrolling("div", {{"class", "scroll"}, {"tabindex", "0"}});
  return scrolling.add(element);
}

std::string to_html(const Page& page) {
  Element root("html", {{"lang", "en"}});
  root.add(head_of(page)).add(body_of(page));
  return "<!DOCTYPE html>\n" + root.to_text() + "\n";
}

}  // namespace mixcmp::page
