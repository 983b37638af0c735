#include "generator/schematic/system_picture.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

namespace mixcmp::schematic {
namespace {

using emit::Signature;
using emit::SignatureLanes;
using emit::SignatureReferences;
using page::coordinate;
using page::Element;
using page::Path;
using page::text_at;

constexpr double width = 860, lane_pitch = 142, reference_pitch = 74;
constexpr double lanes_top = 26;                  // of the first group of lanes
constexpr double lane_x = 292, lane_width = 200;  // of lanes, and of the crossbar below them

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

std::string counted(int count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// Draws boxes and arrows.
class Canvas {
public:
  explicit Canvas(Element& picture) : picture_(picture) {}

  /// A box with up to three lines; behind it the edges of further ones where it stands for several.
  void box(const Box& box, const std::string& style, const std::vector<std::string>& lines,
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

  void frame(const Box& box) { rectangle(box, "frame", ""); }

  void text(double x, double y, const std::string& style, const std::string& words) {
    picture_.add(text_at(x, y, style, words));
  }

  /// A line through the corners, with an arrowhead at the last.
  void arrow(const std::vector<Corner>& corners) {
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

private:
  void rectangle(const Box& box, const std::string& style, const std::string& tip) {
    Element rect("rect", {{"class", style},
                          {"x", coordinate(box.x)},
                          {"y", coordinate(box.y)},
                          {"width", coordinate(box.width)},
                          {"height", coordinate(box.height)},
                          {"rx", "4"}});
    if (!tip.empty()) rect.add(page::tip(tip));
    picture_.add(rect);
  }

  Element& picture_;
};

class SystemPicture {
public:
  SystemPicture(Element& picture, const Signature& signature)
      : canvas_(picture), signature_(signature) {}

  void draw() {
    for (std::size_t k = 0; k < signature_.lane_groups.size(); ++k) {
      draw_lanes(signature_.lane_groups[k], lanes_top + lane_pitch * static_cast<double>(k));
    }
    if (signature_.references > 0) draw_recomputation();
  }

  static double height(const Signature& signature) {
    const double lanes = 20 + lane_pitch * static_cast<double>(signature.lane_groups.size());
    const auto groups = static_cast<double>(signature.reference_groups.size());
    return signature.references == 0 ? lanes : lanes + 16 + reference_pitch * std::max(1.0, groups);
  }

private:
  void draw_lanes(const SignatureLanes& lanes, double y) {
    const Box slots{136, y + 34, 116, 70}, lane{lane_x, y + 34, lane_width, 70},
        results{532, y + 34, 112, 70};
    canvas_.frame({118, y, 546, 122});
    canvas_.text(128, y + 17, "detail", counted(lanes.count, "lane") + ", each with:");
    canvas_.box(
        slots, "network",
        {"scoreboard", counted(signature_.slots, "slot"), carries() ? "tags, operands" : "tags"}, 1,
        "Keeps what is inside a lane, until its verdict has left.");
    canvas_.box(
        lane, "lane",
        {"lane, " + lanes.format, fmt::format("{} cycles, 1 result a cycle", lanes.latency_cycles),
         "multipliers: " + std::string(to_string(lanes.multipliers))},
        lanes.count, lanes.module + "\n" + lanes.decision);
    canvas_.box(results, "network", {"results", order()}, 1,
                "Verdicts of the lane and of the references.");
    const double middle = lane.middle();
    canvas_.arrow({{14, middle}, {slots.x, middle}});
    canvas_.text(14, middle - 8, "detail", "operands, tag");
    canvas_.text(14, middle + 17, "detail", fmt::format("{} bytes", signature_.tdata_bytes));
    canvas_.arrow({{slots.right(), middle}, {lane.x, middle}});
    canvas_.arrow({{lane.right(), middle}, {results.x, middle}});
    canvas_.arrow({{results.right(), middle}, {780, middle}});
    canvas_.text(690, middle - 8, "detail", "verdict, tag");
    slots_bottoms_.push_back({slots.center(), slots.bottom()});
    results_bottoms_.push_back({results.center(), results.bottom()});
  }

  void draw_recomputation() {
    const double y =
        lanes_top + lane_pitch * static_cast<double>(signature_.lane_groups.size()) + 8;
    const Box crossbar{lane_x, y + 4, lane_width, 50};
    canvas_.box(crossbar, "network",
                {"crossbar", fmt::format("{} to {}", signature_.lanes, signature_.references)}, 1,
                "Takes undecided comparisons to the references, round-robin.");
    for (std::size_t k = 0; k < slots_bottoms_.size(); ++k) {
      const double x = slots_bottoms_[k].x - 14 * static_cast<double>(k);
      const double end = crossbar.middle() + 8 * static_cast<double>(k);
      canvas_.arrow({{x, slots_bottoms_[k].y}, {x, end}, {crossbar.x, end}});
    }
    canvas_.text(crossbar.x - 82, crossbar.middle() - 8, "detail", "undecided");
    draw_references(crossbar);
  }

  void draw_references(const Box& crossbar) {
    for (std::size_t k = 0; k < signature_.reference_groups.size(); ++k) {
      const SignatureReferences& group = signature_.reference_groups[k];
      const Box box{560, crossbar.y + reference_pitch * static_cast<double>(k), 226, 50};
      canvas_.box(box, "reference",
                  {fmt::format("{} in {}", counted(group.count, "reference"),
                               signature_.reference_format.name()),
                   fmt::format("{} cycles, multipliers: {}", group.latency_cycles,
                               to_string(group.multipliers))},
                  group.count, group.module);
      const double turn = 526;
      canvas_.arrow({{crossbar.right(), crossbar.middle()},
                     {turn, crossbar.middle()},
                     {turn, box.middle()},
                     {box.x, box.middle()}});
    }
    const double x = 800, y = crossbar.middle();
    for (const Corner& results : results_bottoms_) {
      const double level = results.y + 26;
      canvas_.arrow({{786, y}, {x, y}, {x, level}, {results.x, level}, {results.x, results.y}});
    }
    canvas_.text(806, y - 12, "detail", "verdict");
  }

  bool carries() const {
    return signature_.references > 0 && signature_.operands == scene::OperandStore::carried;
  }
  std::string order() const {
    return signature_.order == scene::ResultOrder::tagged ? "first come" : "in order";
  }

  Canvas canvas_;
  const Signature& signature_;
  std::vector<Corner> slots_bottoms_, results_bottoms_;
};

}  // namespace

Element system_picture(const Signature& signature) {
  Element picture("svg",
                  {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"class", "chart wide"},
                   {"viewBox", fmt::format("0 0 {} {}", width, SystemPicture::height(signature))},
                   {"role", "group"},
                   {"tabindex", "0"},
                   {"aria-label", "Block diagram of " + signature.top}});
  SystemPicture(picture, signature).draw();
  Element whole("div", {{"class", "picture wide"}}), scrolling("div", {{"class", "scroll"}});
  return whole.add(scrolling.add(picture));
}

}  // namespace mixcmp::schematic
