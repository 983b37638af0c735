#include "generator/present/page/share_bars.hpp"

#include <fmt/core.h>

#include "generator/present/page/chart.hpp"

namespace mixcmp::page {
namespace {

/// Places in the picture of bars.
constexpr double bars_left = 66, bars_right = 770, bar_height = 26, bar_pitch = 46, bars_top = 24;
constexpr double bars_width = 860;

Element segment(const ShareBar& bar, const ShareSegment& part, double amount, double x,
                double length) {
  Element box("rect", {{"class", "segment point " + color_class(part.color)},
                       {"x", coordinate(x)},
                       {"y", "0"},
                       {"width", coordinate(length)},
                       {"height", coordinate(bar_height)}});
  return box.add(tip(fmt::format("{}\n{:.0f} {}, {:.1f} % of {:.0f}", part.name, amount, bar.name,
                                 100 * amount / bar.available, bar.available)));
}

Element draw_bar(const ShareBars& bars, const ShareBar& bar, double y) {
  Element group("g", {{"transform", fmt::format("translate(0,{})", coordinate(y))}});
  group.add(text_at(bars_left - 10, bar_height / 2 + 5, "label end", bar.name));
  group.add(Element("rect", {{"class", "whole"},
                             {"x", coordinate(bars_left)},
                             {"y", "0"},
                             {"width", coordinate(bars_right - bars_left)},
                             {"height", coordinate(bar_height)}}));
  double x = bars_left, used = 0;
  for (std::size_t k = 0; k < bar.amounts.size(); ++k) {
    const double length = (bars_right - bars_left) * bar.amounts[k] / bar.available;
    used += bar.amounts[k];
    if (length > 0) group.add(segment(bar, bars.segments[k], bar.amounts[k], x, length));
    x += length;
  }
  const double mark = bars_left + (bars_right - bars_left) * bar.usable / bar.available;
  if (bar.usable < bar.available) {
    group.add(Path().move_to(mark, -5).line_to(mark, bar_height + 5).element("mark"));
  }
  group.add(text_at(bars_right + 10, bar_height / 2 + 5, "tick",
                    fmt::format("{:.1f} %", 100 * used / bar.available)));
  return group;
}

}  // namespace

Element draw(const ShareBars& bars) {
  const double height = bars_top + bar_pitch * static_cast<double>(bars.bars.size());
  Element picture("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                          {"class", "chart wide"},
                          {"viewBox", fmt::format("0 0 {} {}", bars_width, height)},
                          {"role", "group"},
                          {"tabindex", "0"},
                          {"aria-label", bars.title}});
  double y = bars_top;
  if (!bars.bars.empty() && !bars.usable_name.empty()) {
    const ShareBar& first = bars.bars.front();
    const double mark = bars_left + (bars_right - bars_left) * first.usable / first.available;
    picture.add(text_at(mark, 13, "bandname middle", bars.usable_name));
  }
  for (const ShareBar& bar : bars.bars) {
    picture.add(draw_bar(bars, bar, y));
    y += bar_pitch;
  }
  Element legend("ul", {{"class", "legend"}});
  for (const ShareSegment& part : bars.segments) {
    Element entry("li");
    entry.add(Element("span", {{"class", "swatch " + color_class(part.color)}}));
    legend.add(entry.add_text(part.name));
  }
  Element whole("div", {{"class", "picture wide"}});
  Element scrolling("div", {{"class", "scroll"}});
  return whole.add(scrolling.add(picture)).add(legend);
}

}  // namespace mixcmp::page
