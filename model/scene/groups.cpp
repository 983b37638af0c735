#include <fmt/core.h>

#include <algorithm>

#include "model/scene/scene.hpp"

namespace mixcmp::scene {
namespace {

template <class Groups>
std::optional<int> total(const Groups& groups) {
  int count = 0;
  for (const auto& group : groups) {
    if (!group.count) return std::nullopt;
    count += *group.count;
  }
  return count;
}

std::string joined(const std::vector<PartText>& parts, std::string PartText::*side) {
  std::string text;
  for (const PartText& part : parts) text += (text.empty() ? "" : "; ") + part.*side;
  return text;
}

}  // namespace

std::string Scene::f_text() const {
  return joined(parts, &PartText::f);
}

std::string Scene::g_text() const {
  return joined(parts, &PartText::g);
}

LaneFormat Scene::format_of_reference() const {
  if (reference_fixed_point) return {.fixed_point = reference_fixed_point};
  return {.floating = reference.format};
}

std::optional<std::string> Scene::why_no_float_lane() const {
  if (const std::optional<Function> function = graph.first_function()) {
    return "a lane in floating point has no " + applied_text(*function, "x");
  }
  if (!has_fixed_operands()) return std::nullopt;
  return "a lane in floating point takes no operands in fixed point";
}

bool Scene::has_fixed_operands() const {
  return std::any_of(operand_formats.begin(), operand_formats.end(),
                     [](const OperandFormat& format) { return format.fixed() != nullptr; });
}

bool Scene::has_only_fixed_operands() const {
  return has_fixed_operands() &&
         std::all_of(operand_formats.begin(), operand_formats.end(),
                     [](const OperandFormat& format) { return format.fixed() != nullptr; });
}

bool Scene::has_promised_grids() const {
  for (std::size_t k = 0; k < grids.size(); ++k) {
    if (grids[k] && operand_formats[k].fixed() == nullptr) return true;
  }
  return false;
}

std::vector<bool> Scene::nonnegative_inputs() const {
  std::vector<bool> nonnegative;
  for (const std::optional<Range>& range : ranges) {
    nonnegative.push_back(range && range->low >= 0);
  }
  return nonnegative;
}

std::vector<LaneGroupSpec> Scene::lane_groups() const {
  if (!lanes.empty()) return lanes;
  return {{.count = system.lanes, .reduced = reduced, .place = {path.string()}}};
}

std::vector<ReferenceGroupSpec> Scene::reference_groups() const {
  if (!references.empty()) return references;
  return {{.count = system.references, .structure = reference_structure}};
}

std::optional<int> Scene::lane_count() const {
  return total(lane_groups());
}

std::optional<int> Scene::reference_count() const {
  return total(reference_groups());
}

Scene Scene::with_one_kind() const {
  Scene scene = *this;
  scene.lanes.clear();
  scene.references.clear();
  return scene;
}

}  // namespace mixcmp::scene
