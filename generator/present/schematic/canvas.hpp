#pragma once

#include <string>
#include <vector>

#include "generator/present/page/element.hpp"

/// Boxes and arrows of block diagrams.
namespace mixcmp::schematic {

inline constexpr double picture_width = 860;

struct Box {
  double x, y, width, height;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  double center() const { return x + width / 2; }
  double middle() const { return y + height / 2; }
};

struct Corner {
  double x, y;
};

/// "1 lane", "2 lanes".
std::string counted(int count, const char* what);

/// Draws boxes and arrows.
class Canvas {
public:
  explicit Canvas(page::Element& picture) : picture_(picture) {}

  /// A box with up to three lines. If it stands for several, the edges of further ones show behind
  /// it.
  void box(const Box& box, const std::string& style, const std::vector<std::string>& lines,
           int count, const std::string& tip);
  void frame(const Box& box);
  void text(double x, double y, const std::string& style, const std::string& words);
  /// A line through the corners, with an arrowhead at the last.
  void arrow(const std::vector<Corner>& corners);

private:
  void rectangle(const Box& box, const std::string& style, const std::string& tip);

  page::Element& picture_;
};

/// An empty picture of this height. `title` describes it to readers who cannot see it.
page::Element block_diagram(double height, const std::string& title);
/// The picture in a frame that scrolls where it is wider than the page.
page::Element framed(const page::Element& picture);

}  // namespace mixcmp::schematic
