#include "generator/present/page/pipeline.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "generator/present/page/pipeline_columns.hpp"
#include "generator/present/page/pipeline_rows.hpp"

namespace mixcmp::page {
namespace {

/// The space around the units, with the numbers of the cycles.
constexpr double margin_left = 46, margin_right = 12, margin_top = 17, margin_bottom = 16;

std::string_view style_of(UnitRole role) {
  switch (role) {
    case UnitRole::input: return "unit input point";
    case UnitRole::arithmetic: return "unit arithmetic point";
    case UnitRole::check: return "unit check point";
    case UnitRole::bound: return "unit bound point";
    case UnitRole::decision: return "unit decision point";
  }
  return "";
}

class PipelinePicture {
public:
  explicit PipelinePicture(const Pipeline& pipeline)
      : pipeline_(pipeline), rows_(pipeline), columns_(pipeline, rows_) {}

  Element draw() const {
    const double width = margin_left + columns_.width() + margin_right;
    const double height = margin_top + rows_.height() + margin_bottom;
    Element picture("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                            {"class", "chart pipeline"},
                            {"viewBox", fmt::format("0 0 {:.0f} {:.0f}", width, height)},
                            {"style", fmt::format("width:{:.0f}px", width)},
                            {"role", "group"},
                            {"tabindex", "0"},
                            {"aria-label", pipeline_.title}});
    add_cycles(picture, width);
    for (std::size_t k = 0; k < columns_.wires().size(); ++k) add_wire(picture, k);
    for (std::size_t k = 0; k < pipeline_.units.size(); ++k) add_unit(picture, k);
    return picture;
  }

private:
  /// A line and a number where each cycle begins; numbers keep some distance.
  void add_cycles(Element& picture, double width) const {
    constexpr double least_distance = 13;
    double last = -least_distance;
    for (int cycle = 0; cycle <= pipeline_.cycles; ++cycle) {
      const double y = margin_top + rows_.top(rows_.row_of_cycle(cycle)) - 2;
      picture.add(Path().move_to(margin_left - 8, y).line_to(width, y).element("rank"));
      if (y - last < least_distance && cycle < pipeline_.cycles) continue;
      picture.add(text_at(margin_left - 13, y + 4, "tick end", fmt::format("{}", cycle)));
      last = y;
    }
    picture.add(text_at(4, margin_top - 1, "tick", "cycle"));
  }

  void add_unit(Element& picture, std::size_t k) const {
    const PipelineUnit& unit = pipeline_.units[k];
    const int index = static_cast<int>(k);
    const double x = margin_left + columns_.x(index), width = columns_.box_width(index);
    const double upper = upper_edge(index), height = lower_edge(index) - upper;
    Element group("g", {{"class", std::string(style_of(unit.role))}});
    group.add(tip(unit.tip));
    group.add(Element("rect", {{"x", coordinate(x - width / 2)},
                               {"y", coordinate(upper)},
                               {"width", coordinate(width)},
                               {"height", coordinate(height)},
                               {"rx", unit.role == UnitRole::input ? "12" : "4"}}));
    const double middle = upper + height / 2;
    group.add(text_at(x, unit.detail.empty() ? middle + 4 : middle - 3, "name middle", unit.title));
    if (!unit.detail.empty()) group.add(text_at(x, middle + 12, "detail middle", unit.detail));
    picture.add(group);
  }

  void add_wire(Element& picture, std::size_t k) const {
    const PipelineWire& wire = columns_.wires()[k];
    const double from_x = margin_left + columns_.x(wire.from), to_x = margin_left + entry_x(k);
    const double from_y = lower_edge(wire.from), to_y = upper_edge(wire.to);
    Path path;
    path.move_to(from_x, from_y);
    if (wire.item < 0) {
      curve(path, from_x, from_y, to_x, to_y);
    } else {
      const double x = margin_left + columns_.x_of_item(wire.item);
      const double first = margin_top + rows_.top(rows_.last_row(wire.from) + 1);
      const double last = margin_top + rows_.bottom(rows_.first_row(wire.to) - 1);
      const double begin = std::max(first, std::min(from_y + 18, last));
      const double end = std::max(begin, std::min(last, to_y - 18));
      curve(path, from_x, from_y, x, begin);
      path.line_to(x, end);
      curve(path, x, end, to_x, to_y);
    }
    picture.add(path.element(is_delayed(wire) ? "wire delayed" : "wire"));
  }

  static void curve(Path& path, double from_x, double from_y, double to_x, double to_y) {
    const double middle = (from_y + to_y) / 2;
    path.curve_to(from_x, middle, to_x, middle, to_x, to_y);
  }

  /// Whether the value waits in registers.
  bool is_delayed(const PipelineWire& wire) const {
    return pipeline_.units[wire.from].ready_cycle < pipeline_.units[wire.to].start_cycle;
  }

  /// Where a wire enters its box: the wires of one box in the order in which they come.
  double entry_x(std::size_t k) const {
    const PipelineWire& wire = columns_.wires()[k];
    int before = 0, all = 0;
    for (std::size_t other = 0; other < columns_.wires().size(); ++other) {
      if (columns_.wires()[other].to != wire.to) continue;
      ++all;
      const double here = approach_x(wire), there = approach_x(columns_.wires()[other]);
      if (there < here || (there == here && other < k)) ++before;
    }
    const double room = columns_.box_width(wire.to) - 16;
    const double pitch = std::min(16.0, room / std::max(1, all));
    return columns_.x(wire.to) + pitch * (before - (all - 1) / 2.0);
  }

  double approach_x(const PipelineWire& wire) const {
    return wire.item >= 0 ? columns_.x_of_item(wire.item) : columns_.x(wire.from);
  }

  double upper_edge(int unit) const { return margin_top + rows_.top(rows_.first_row(unit)); }
  double lower_edge(int unit) const { return margin_top + rows_.bottom(rows_.last_row(unit)); }

  const Pipeline& pipeline_;
  PipelineRows rows_;
  PipelineColumns columns_;
};

}  // namespace

Element draw(const Pipeline& pipeline) {
  Element whole("div", {{"class", "picture wide"}});
  Element scrolling("div", {{"class", "scroll"}});
  return whole.add(scrolling.add(PipelinePicture(pipeline).draw()));
}

}  // namespace mixcmp::page
