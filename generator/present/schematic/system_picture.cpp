#include "generator/present/schematic/system_picture.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "generator/present/schematic/canvas.hpp"
#include "generator/present/schematic/pairwise_picture.hpp"

namespace mixcmp::schematic {
namespace {

using emit::Signature;
using emit::SignatureLanes;
using emit::SignatureReferences;
using page::Element;

constexpr double lane_pitch = 142, reference_pitch = 74, tier_pitch = 88;
constexpr double asked_x = 560,
                 asked_width = 226;               // of the boxes that decide undecided comparisons
constexpr double lanes_top = 26;                  // of the first group of lanes
constexpr double lane_x = 292, lane_width = 200;  // of lanes, and of the crossbar below them

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
    if (signature.references == 0) return lanes;
    const double second_tier = signature.second_tier ? tier_pitch : 0;
    return lanes + 16 + second_tier + reference_pitch * std::max(1.0, groups);
  }

private:
  void draw_lanes(const SignatureLanes& lanes, double y) {
    const Box slots{136, y + 34, 116, 70}, lane{lane_x, y + 34, lane_width, 70},
        results{532, y + 34, 112, 70};
    canvas_.frame({118, y, 546, 122});
    canvas_.text(128, y + 17, "detail", title_of(lanes));
    canvas_.box(
        slots, "network",
        {"scoreboard", counted(signature_.slots, "slot"), carries() ? "tags, operands" : "tags"}, 1,
        is_grouped() ? "Keeps what is inside a group of lanes, until its verdicts have left."
                     : "Keeps what is inside a lane, until its verdict has left.");
    canvas_.box(
        lane, "lane",
        {"lane, " + lanes.format, counted(lanes.latency_cycles, "cycle") + ", 1 result a cycle",
         "multipliers: " + std::string(to_string(lanes.multipliers))},
        is_grouped() ? signature_.lanes_per_group : lanes.count,
        lanes.module + "\n" + lanes.decision);
    canvas_.box(results, "network", {"results", order()}, 1,
                "Verdicts of the lane and of the references.");
    const double middle = lane.middle();
    canvas_.arrow({{14, middle}, {slots.x, middle}});
    canvas_.text(14, middle - 8, "detail", "operands, tag");
    canvas_.text(14, middle + 17, "detail", operand_bytes());
    canvas_.arrow({{slots.right(), middle}, {lane.x, middle}});
    canvas_.arrow({{lane.right(), middle}, {results.x, middle}});
    canvas_.arrow({{results.right(), middle}, {780, middle}});
    canvas_.text(690, middle - 8, "detail", is_grouped() ? "verdicts, tag" : "verdict, tag");
    slots_bottoms_.push_back({slots.center(), slots.bottom()});
    results_bottoms_.push_back({results.center(), results.bottom()});
  }

  void draw_recomputation() {
    const double y =
        lanes_top + lane_pitch * static_cast<double>(signature_.lane_groups.size()) + 8;
    const int senders = emit::group_count(signature_);
    const SignatureLanes* const tier = signature_.second_tier ? &*signature_.second_tier : nullptr;
    const Box crossbar = draw_crossbar(y, senders, tier ? tier->count : signature_.references);
    for (std::size_t k = 0; k < slots_bottoms_.size(); ++k) {
      const double x = slots_bottoms_[k].x - 14 * static_cast<double>(k);
      const double end = crossbar.middle() + 8 * static_cast<double>(k);
      canvas_.arrow({{x, slots_bottoms_[k].y}, {x, end}, {crossbar.x, end}});
    }
    if (tier == nullptr) {
      draw_references(crossbar);
    } else {
      draw_second_tier(crossbar, *tier);
    }
    draw_verdicts(crossbar.middle());
  }

  Box draw_crossbar(double y, int senders, int asked) {
    const Box crossbar{lane_x, y + 4, lane_width, 50};
    canvas_.box(crossbar, "network", {"crossbar", fmt::format("{} to {}", senders, asked)}, 1,
                "Takes undecided comparisons to those that decide them, round-robin.");
    canvas_.text(crossbar.x - 82, crossbar.middle() - 8, "detail", "undecided");
    return crossbar;
  }

  void draw_second_tier(const Box& crossbar, const SignatureLanes& tier) {
    const Box box{asked_x, crossbar.y, asked_width, 50};
    canvas_.box(box, "lane",
                {fmt::format("{}, {}", counted(tier.count, "second lane"), tier.format),
                 fmt::format("{}, multipliers: {}", counted(tier.latency_cycles, "cycle"),
                             to_string(tier.multipliers))},
                tier.count, tier.module + "\n" + tier.decision);
    canvas_.arrow({{crossbar.right(), crossbar.middle()}, {box.x, box.middle()}});
    const Box next = draw_crossbar(crossbar.y - 4 + tier_pitch, tier.count, signature_.references);
    const double level = box.bottom() + 14, left = next.x - 98;
    canvas_.arrow({{box.center(), box.bottom()},
                   {box.center(), level},
                   {left, level},
                   {left, next.middle()},
                   {next.x, next.middle()}});
    draw_references(next);
    const double x = box.right() + 14;
    canvas_.arrow({{box.right(), next.middle()},
                   {x, next.middle()},
                   {x, box.middle() + 12},
                   {box.right(), box.middle() + 12}});
  }

  void draw_references(const Box& crossbar) {
    for (std::size_t k = 0; k < signature_.reference_groups.size(); ++k) {
      const SignatureReferences& group = signature_.reference_groups[k];
      const Box box{asked_x, crossbar.y + reference_pitch * static_cast<double>(k), asked_width,
                    50};
      canvas_.box(box, "reference",
                  {fmt::format("{} in {}", counted(group.count, "reference"), group.format),
                   fmt::format("{}, multipliers: {}", counted(group.latency_cycles, "cycle"),
                               to_string(group.multipliers))},
                  group.count, group.module);
      const double turn = 526;
      canvas_.arrow({{crossbar.right(), crossbar.middle()},
                     {turn, crossbar.middle()},
                     {turn, box.middle()},
                     {box.x, box.middle()}});
    }
  }

  /// Arrows from the boxes that the lanes ask, at height `y`, back to the results.
  void draw_verdicts(double y) {
    const double right = asked_x + asked_width, x = right + 14;
    for (const Corner& results : results_bottoms_) {
      const double level = results.y + 26;
      canvas_.arrow({{right, y}, {x, y}, {x, level}, {results.x, level}, {results.x, results.y}});
    }
    canvas_.text(806, y - 12, "detail", "verdict");
  }

  bool is_grouped() const { return signature_.lanes_per_group > 1; }

  /// The title of the frame around lanes of one kind: "8 lanes, each with:".
  std::string title_of(const SignatureLanes& lanes) const {
    const std::string all = counted(lanes.count, "lane");
    if (!is_grouped()) return all + ", each with:";
    return fmt::format("{} in {} of {} in lock step, each group with:", all,
                       counted(lanes.count / signature_.lanes_per_group, "group"),
                       signature_.lanes_per_group);
  }

  std::string operand_bytes() const {
    const std::string bytes = fmt::format("{} bytes", signature_.tdata_bytes);
    return is_grouped() ? fmt::format("{} x {}", signature_.lanes_per_group, bytes) : bytes;
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
  const bool is_pairwise =
      signature.engine && signature.engine->kind == scene::EngineKind::pairwise;
  if (is_pairwise) return pairwise_picture(signature);
  Element picture = block_diagram(SystemPicture::height(signature), signature.top);
  SystemPicture(picture, signature).draw();
  return framed(picture);
}

}  // namespace mixcmp::schematic
