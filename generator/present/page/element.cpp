#include "generator/present/page/element.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "model/base/common/check.hpp"

namespace mixcmp::page {
namespace {

/// HTML takes no other element without an end tag.
constexpr std::array<std::string_view, 12> without_end_tag = {"br",      "circle",   "col",  "hr",
                                                              "line",    "link",     "meta", "path",
                                                              "polygon", "polyline", "rect", "use"};

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c;
    }
  }
  return result;
}

}  // namespace

Element::Element(std::string name, const std::vector<Attribute>& attributes)
    : name_(std::move(name)) {
  for (const Attribute& attribute : attributes) set(attribute.name, attribute.value);
}

Element& Element::set(std::string_view name, std::string_view value) {
  attributes_ += fmt::format(" {}=\"{}\"", name, escaped(value));
  return *this;
}

Element& Element::add(const Element& child) {
  content_ += child.to_text();
  return *this;
}

Element& Element::add_text(std::string_view text) {
  content_ += escaped(text);
  return *this;
}

Element& Element::add_verbatim(std::string_view code) {
  MIXCMP_CHECK(code.find("</") == std::string_view::npos);
  MIXCMP_CHECK(code.find("]]>") == std::string_view::npos);
  content_ += fmt::format("/*<![CDATA[*/\n{}/*]]>*/", code);
  return *this;
}

std::string Element::to_text() const {
  const bool no_end_tag =
      std::find(without_end_tag.begin(), without_end_tag.end(), name_) != without_end_tag.end();
  if (no_end_tag && content_.empty()) return fmt::format("<{}{}/>", name_, attributes_);
  return fmt::format("<{0}{1}>{2}</{0}>", name_, attributes_, content_);
}

Element text_element(std::string name, const std::vector<Attribute>& attributes,
                     std::string_view text) {
  Element element(std::move(name), attributes);
  element.add_text(text);
  return element;
}

std::string coordinate(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

Element text_at(double x, double y, std::string_view style, std::string_view text) {
  return text_element(
      "text", {{"class", std::string(style)}, {"x", coordinate(x)}, {"y", coordinate(y)}}, text);
}

Element tip(std::string_view text) {
  return text_element("title", {}, text);
}

Path& Path::close() {
  data_ += 'z';
  return *this;
}

Element Path::element(std::string_view style) const {
  return Element("path", {{"class", std::string(style)}, {"d", data_}});
}

Path& Path::add(char command, const std::vector<double>& numbers) {
  data_ += command;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    data_ += fmt::format("{}{}", k == 0 ? "" : ",", coordinate(numbers[k]));
  }
  return *this;
}

}  // namespace mixcmp::page
