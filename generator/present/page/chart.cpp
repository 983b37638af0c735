#include "generator/present/page/chart.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mixcmp::page {
namespace {

/// The picture and, inside, the rectangle of the plot.
struct Frame {
  double width, height;
  double left, right, top, bottom;
};

Frame frame_of(const Chart& chart) {
  const double width = chart.wide ? 860 : 480, height = chart.wide ? 400 : 300;
  return {width, height, 54, width - 20, 30, height - 44};
}

std::vector<double> values_on(const Chart& chart, ChartBand::Across axis) {
  std::vector<double> values;
  const bool is_x = axis == ChartBand::Across::x;
  for (const Series& series : chart.series) {
    for (const ChartPoint& point : series.points) values.push_back(is_x ? point.x : point.y);
  }
  for (const ChartBand& band : chart.bands) {
    if (band.axis == axis) values.insert(values.end(), {band.low, band.high});
  }
  return values;
}

class ChartPicture {
public:
  explicit ChartPicture(const Chart& chart)
      : chart_(chart),
        frame_(frame_of(chart)),
        x_(chart.x, values_on(chart, ChartBand::Across::x), frame_.left, frame_.right),
        y_(chart.y, values_on(chart, ChartBand::Across::y), frame_.bottom, frame_.top) {}

  Element draw() const {
    Element picture("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                            {"class", chart_.wide ? "chart wide" : "chart"},
                            {"viewBox", fmt::format("0 0 {} {}", frame_.width, frame_.height)},
                            {"role", "group"},
                            {"tabindex", "0"},
                            {"aria-label", chart_.title}});
    add_grid(picture);
    for (const ChartBand& band : chart_.bands) add_band(picture, band);
    for (const Series& series : chart_.series) add_series(picture, series);
    for (const ChartBand& band : chart_.bands) add_band_name(picture, band);
    return picture;
  }

private:
  void add_grid(Element& picture) const {
    for (const Tick& tick : y_.ticks()) {
      const double y = y_.position(tick.value);
      picture.add(Path().move_to(frame_.left, y).line_to(frame_.right, y).element("grid"));
      picture.add(text_at(frame_.left - 7, y + 4, "tick end", tick.label));
    }
    for (const Tick& tick : x_.ticks()) {
      const double x = x_.position(tick.value);
      picture.add(Path().move_to(x, frame_.bottom).line_to(x, frame_.bottom + 4).element("grid"));
      picture.add(text_at(x, frame_.bottom + 18, "tick middle", tick.label));
    }
    picture.add(text_at((frame_.left + frame_.right) / 2, frame_.height - 6, "label middle",
                        chart_.x.label));
    picture.add(text_at(4, 15, "label", chart_.y.label));
  }

  void add_band(Element& picture, const ChartBand& band) const {
    const bool is_x = band.axis == ChartBand::Across::x;
    const Axis& axis = is_x ? x_ : y_;
    const double low = axis.position(band.low), high = axis.position(band.high);
    Path outline;
    if (is_x) {
      outline.move_to(low, frame_.bottom).line_to(low, frame_.top);
      outline.line_to(high, frame_.top).line_to(high, frame_.bottom).close();
    } else {
      outline.move_to(frame_.left, low).line_to(frame_.right, low);
      outline.line_to(frame_.right, high).line_to(frame_.left, high).close();
    }
    picture.add(outline.element("band").add(tip(band.title)));
  }

  /// Above all curves, so that none strikes it out.
  void add_band_name(Element& picture, const ChartBand& band) const {
    const bool is_x = band.axis == ChartBand::Across::x;
    const double x = is_x ? x_.position(band.low) + 5 : frame_.right - 4;
    const double y = is_x ? frame_.top + 12 : y_.position(band.high) - 5;
    picture.add(text_at(x, y, is_x ? "bandname" : "bandname end", band.title));
  }

  void add_series(Element& picture, const Series& series) const {
    const bool dashed = series.mark == Mark::dashed_line;
    Element group("g", {{"class", fmt::format("series {}{}", color_class(series.color),
                                              dashed ? " dashed" : "")}});
    if (series.mark != Mark::points && series.points.size() > 1) {
      group.add(line_of(series).element("line"));
    }
    if (!dashed) {
      for (const ChartPoint& point : series.points) {
        Element circle("circle", {{"class", "point"},
                                  {"cx", coordinate(x_.position(point.x))},
                                  {"cy", coordinate(y_.position(point.y))},
                                  {"r", chart_.wide ? "4" : "3"}});
        group.add(circle.add(tip(point.tip)));
      }
    }
    picture.add(group);
  }

  Path line_of(const Series& series) const {
    Path path;
    double last_y = 0;
    for (std::size_t k = 0; k < series.points.size(); ++k) {
      const double x = x_.position(series.points[k].x), y = y_.position(series.points[k].y);
      if (k == 0) {
        path.move_to(x, y);
      } else {
        if (series.mark == Mark::steps) path.line_to(x, last_y);
        path.line_to(x, y);
      }
      last_y = y;
    }
    return path;
  }

  const Chart& chart_;
  Frame frame_;
  Axis x_, y_;
};

Element legend(const Chart& chart) {
  Element list("ul", {{"class", "legend"}});
  for (const Series& series : chart.series) {
    if (series.title.empty()) continue;
    const bool dashed = series.mark == Mark::dashed_line;
    Element entry("li");
    entry.add(Element("span", {{"class", fmt::format("swatch {}{}", color_class(series.color),
                                                     dashed ? " dashed" : "")}}));
    list.add(entry.add_text(series.title));
  }
  return list;
}

}  // namespace

Element draw(const Chart& chart) {
  Element whole("div", {{"class", chart.wide ? "picture wide" : "picture"}});
  Element scrolling("div", {{"class", "scroll"}});
  whole.add(scrolling.add(ChartPicture(chart).draw()));
  whole.add(legend(chart));
  return whole;
}

std::string color_class(int color) {
  return fmt::format("c{}", color % color_count);
}

}  // namespace mixcmp::page
