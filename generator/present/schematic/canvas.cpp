#include "generator/present/schematic/canvas.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mixcmp::schematic {

using page::coordinate;
using page::Element;
using page::Path;
using page::text_at;

std::string counted(int count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void Canvas::box(const Box& box, const std::string& style, const std::vector<std::string>& lines,
                 int count, const std::string& tip) {
  for (int behind = std::min(count, 3) - 1; behind > 0; --behind) {
    rectangle({box.x + 5 * behind, box.y - 5 * behind, box.width, box.height}, "block " + style,
              "");
  }
  rectangle(box, "block point " + style, tip);
  const double first = box.middle() + 4 - 8.0 * static_cast<double>(lines.size() - 1);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    text(box.center(), first + 16 * static_cast<double>(k),
         k == 0 ? "name middle" : "detail middle", lines[k]);
  }
}

void Canvas::frame(const Box& box) {
  rectangle(box, "frame", "");
}

void Canvas::text(double x, double y, const std::string& style, const std::string& words) {
  picture_.add(text_at(x, y, style, words));
}

void Canvas::arrow(const std::vector<Corner>& corners) {
  Path path;
  path.move_to(corners[0].x, corners[0].y);
  for (std::size_t k = 1; k < corners.size(); ++k) path.line_to(corners[k].x, corners[k].y);
  picture_.add(path.element("wire"));
  const Corner& end = corners.back();
  const Corner& before = corners[corners.size() - 2];
  const double dx = end.x == before.x ? 0 : (end.x > before.x ? 1 : -1);
  const double dy = end.y == before.y ? 0 : (end.y > before.y ? 1 : -1);
  Path head;
  head.move_to(end.x, end.y);
  head.line_to(end.x - 8 * dx - 4 * dy, end.y - 8 * dy - 4 * dx);
  head.line_to(end.x - 8 * dx + 4 * dy, end.y - 8 * dy + 4 * dx).close();
  picture_.add(head.element("arrowhead"));
}

void Canvas::rectangle(const Box& box, const std::string& style, const std::string& tip) {
  Element rect("rect", {{"class", style},
                        {"x", coordinate(box.x)},
                        {"y", coordinate(box.y)},
                        {"width", coordinate(box.width)},
                        {"height", coordinate(box.height)},
                        {"rx", "4"}});
  if (!tip.empty()) rect.add(page::tip(tip));
  picture_.add(rect);
}

Element block_diagram(double height, const std::string& title) {
  return Element("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                         {"class", "chart wide"},
                         {"viewBox", fmt::format("0 0 {} {}", picture_width, height)},
                         {"role", "group"},
                         {"tabindex", "0"},
                         {"aria-label", "Block diagram of " + title}});
}

Element framed(const Element& picture) {
  Element whole("div", {{"class", "picture wide"}}), scrolling("div", {{"class", "scroll"}});
  return whole.add(scrolling.add(picture));
}

}  // namespace mixcmp::schematic
