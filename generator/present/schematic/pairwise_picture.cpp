#include "generator/present/schematic/pairwise_picture.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>

#include "generator/present/schematic/canvas.hpp"

namespace mixcmp::schematic {
namespace {

using emit::Signature;
using emit::SignatureEngine;
using emit::SignatureLanes;
using emit::SignatureReferences;
using page::Element;

constexpr double boxes_top = 34, box_height = 70;
constexpr double group_pitch = 100;   // of groups of lanes, and of the boxes below them
constexpr double request_pitch = 74;  // of the boxes below the lanes
constexpr double group_x = 398, group_width = 204;

std::string form_of_reports(const SignatureEngine& engine) {
  switch (engine.report_as) {
    case scene::ReportForm::pairs: return "as (i, j)";
    case scene::ReportForm::bitmap: return fmt::format("{} flags a beat", engine.report_lanes);
    case scene::ReportForm::count: return "only their number";
  }
  return "";
}

class PairwisePicture {
public:
  PairwisePicture(Element& picture, const Signature& signature)
      : canvas_(picture), signature_(signature), engine_(*signature.engine) {}

  void draw() {
    draw_items();
    for (std::size_t k = 0; k < signature_.lane_groups.size(); ++k) draw_lanes(k);
    if (signature_.second_tier) draw_second_tier();
    draw_reports();
    if (signature_.references > 0) draw_recomputation();
  }

  static double height(const Signature& signature) {
    const auto lanes = static_cast<double>(rows_of_lanes(signature));
    const auto references = static_cast<double>(signature.reference_groups.size());
    const double upper = boxes_top + group_pitch * lanes;
    return signature.references == 0 ? upper : upper + request_pitch * (1 + references);
  }

private:
  static std::size_t rows_of_lanes(const Signature& signature) {
    return signature.lane_groups.size() + (signature.second_tier ? 1 : 0);
  }

  Box lanes_box(std::size_t k) const {
    return {group_x, boxes_top + group_pitch * static_cast<double>(k), group_width, box_height};
  }

  void draw_items() {
    canvas_.box(items_, "network",
                {"items", fmt::format("up to {}", engine_.capacity), "kept for references"}, 1,
                "Numbers the items, keeps them, and what the lanes need to know of them.");
    canvas_.box(walker_, "network", {"all pairs", "an item a cycle", "past all lanes"}, 1,
                "Each lane holds an item i; each item j behind it is compared with all of them.");
    const double middle = items_.middle();
    canvas_.arrow({{14, middle}, {items_.x, middle}});
    canvas_.text(14, middle - 8, "detail", "s_axis: items");
    canvas_.text(14, middle + 17, "detail", fmt::format("{} bytes", engine_.item_bytes));
    canvas_.arrow({{items_.right(), middle}, {walker_.x, middle}});
    canvas_.arrow({{walker_.right(), middle}, {group_x, middle}});
  }

  /// Words pass one group of lanes after the other.
  void draw_lanes(std::size_t k) {
    const SignatureLanes& lanes = signature_.lane_groups[k];
    const Box box = lanes_box(k);
    canvas_.box(box, "lane",
                {fmt::format("{}, {}", counted(lanes.count, "lane"), lanes.format),
                 fmt::format("{}, {} in lock step", counted(lanes.latency_cycles, "cycle"),
                             std::min(lanes.count, engine_.report_lanes)),
                 "multipliers: " + std::string(to_string(lanes.multipliers))},
                lanes.count, lanes.module + "\n" + lanes.decision);
    if (k > 0) draw_arrow_down_to(k);
    draw_arrow_to_reports(box);
  }

  /// Draws the lanes of the second tier. One stands behind each group and decides its undecided
  /// pairs again.
  void draw_second_tier() {
    const SignatureLanes& tier = *signature_.second_tier;
    const std::size_t row = rows_of_lanes(signature_) - 1;
    const Box box = lanes_box(row);
    canvas_.box(box, "lane",
                {fmt::format("second tier: {}, {}", counted(tier.count, "lane"), tier.format),
                 counted(tier.latency_cycles, "cycle"),
                 "multipliers: " + std::string(to_string(tier.multipliers))},
                tier.count, tier.module + "\n" + tier.decision);
    draw_arrow_down_to(row);
    canvas_.text(box.center() + 8, box.y - 10, "detail", "undecided");
    draw_arrow_to_reports(box);
  }

  void draw_arrow_down_to(std::size_t row) {
    const Box before = lanes_box(row - 1), box = lanes_box(row);
    canvas_.arrow({{before.center(), before.bottom()}, {box.center(), box.y}});
  }

  void draw_arrow_to_reports(const Box& box) {
    canvas_.arrow({{box.right(), box.middle()},
                   {reports_.x - 20, box.middle()},
                   {reports_.x - 20, reports_.middle()},
                   {reports_.x, reports_.middle()}});
  }

  void draw_reports() {
    canvas_.box(
        reports_, "network",
        {"reports", fmt::format("{}", fmt::join(engine_.report, ", ")), form_of_reports(engine_)},
        engine_.report_streams,
        fmt::format("{} m_axis, each with a closing beat after every set.",
                    counted(engine_.report_streams, "stream")));
    canvas_.arrow({{reports_.right(), reports_.middle()}, {850, reports_.middle()}});
    canvas_.text(reports_.right() + 16, reports_.middle() - 8, "detail", "m_axis");
    if (engine_.report_streams > 1) {
      canvas_.text(reports_.right() + 16, reports_.middle() + 17, "detail",
                   fmt::format("{} streams", engine_.report_streams));
    }
  }

  void draw_recomputation() {
    const Box last = lanes_box(rows_of_lanes(signature_) - 1);
    const Box again{group_x, last.y + group_pitch, group_width, 50};
    canvas_.box(again, "network", {"recomputation", "reads both items of a pair"}, 1,
                "Hands undecided pairs to the references in turn.");
    canvas_.arrow({{last.center(), last.bottom()}, {again.center(), again.y}});
    canvas_.text(again.center() + 8, again.y - 10, "detail", "undecided");
    canvas_.arrow({{items_.center(), items_.bottom()},
                   {items_.center(), again.middle()},
                   {again.x, again.middle()}});
    canvas_.text(items_.center() + 8, again.middle() - 8, "detail", "items i and j");
    canvas_.arrow({{again.right(), again.middle()},
                   {reports_.center(), again.middle()},
                   {reports_.center(), reports_.bottom()}});
    canvas_.text(again.right() + 8, again.middle() - 8, "detail", "verdicts");
    for (std::size_t k = 0; k < signature_.reference_groups.size(); ++k) draw_references(k, again);
  }

  /// Requests and verdicts go both ways between them and the box above.
  void draw_references(std::size_t k, const Box& again) {
    const SignatureReferences& group = signature_.reference_groups[k];
    const Box box{group_x, again.y + request_pitch * static_cast<double>(k + 1), group_width, 50};
    canvas_.box(box, "reference",
                {fmt::format("{} in {}", counted(group.count, "reference"), group.format),
                 fmt::format("{}, multipliers: {}", counted(group.latency_cycles, "cycle"),
                             to_string(group.multipliers))},
                group.count, group.module);
    const double left = again.x - 14 - 10 * static_cast<double>(k), right = again.right() + 14;
    canvas_.arrow({{again.x, again.y + 40},
                   {left, again.y + 40},
                   {left, box.middle()},
                   {box.x, box.middle()}});
    canvas_.arrow({{box.right(), box.middle()},
                   {right, box.middle()},
                   {right, again.y + 40},
                   {again.right(), again.y + 40}});
  }

  Canvas canvas_;
  const Signature& signature_;
  const SignatureEngine& engine_;
  const Box items_{112, boxes_top, 120, box_height}, walker_{256, boxes_top, 116, box_height},
      reports_{650, boxes_top, 130, box_height};
};

}  // namespace

Element pairwise_picture(const Signature& signature) {
  Element picture = block_diagram(PairwisePicture::height(signature), signature.engine->top);
  PairwisePicture(picture, signature).draw();
  return framed(picture);
}

}  // namespace mixcmp::schematic
