#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Pages and pictures as text: HTML 5 and SVG that are also well-formed XML.
namespace mixcmp::page {

struct Attribute {
  std::string name;
  std::string value;
};

/// An element with its attributes, texts and children. Attributes and texts are escaped here, and
/// nowhere else.
class Element {
public:
  explicit Element(std::string name, const std::vector<Attribute>& attributes = {});

  Element& set(std::string_view name, std::string_view value);
  Element& add(const Element& child);
  Element& add_text(std::string_view text);
  /// Adds a style sheet or a script, in which nothing is escaped. It must not contain "</" or
  /// "]]>".
  Element& add_verbatim(std::string_view code);

  std::string to_text() const;

private:
  std::string name_;
  std::string attributes_;
  std::string content_;  ///< printed
};

/// An element that contains only a text.
Element text_element(std::string name, const std::vector<Attribute>& attributes,
                     std::string_view text);

/// A coordinate in a picture, with at most two decimals.
std::string coordinate(double value);

/// An SVG text at a place. `style`: its class.
Element text_at(double x, double y, std::string_view style, std::string_view text);

/// The <title> of an element, one line or several. A reader sees it by pointing at the element, or
/// by reaching it with keys.
Element tip(std::string_view text);

/// Concatenates commands and coordinates of an SVG path: "M1,2", "L3.5,4".
class Path {
public:
  Path& move_to(double x, double y) { return add('M', {x, y}); }
  Path& line_to(double x, double y) { return add('L', {x, y}); }
  Path& curve_to(double x1, double y1, double x2, double y2, double x, double y) {
    return add('C', {x1, y1, x2, y2, x, y});
  }
  Path& close();
  Element element(std::string_view style) const;

private:
  Path& add(char command, const std::vector<double>& numbers);

  std::string data_;
};

}  // namespace mixcmp::page
