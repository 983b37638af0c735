#include "model/profile/lane_runner.hpp"

#include "model/common/cases.hpp"

namespace mixcmp::profile {

LaneRunner::LaneRunner(SchemeKind kind, const std::optional<design::Lane>& lane) : kind_(kind) {
  if (!lane) return;
  std::visit(
      Cases{[&](const error::Lane& floating) { emulator_.emplace<emulator::Emulator>(floating); },
            [&](const fixed::FixedLane& fixed_point) {
              emulator_.emplace<emulator::FixedEmulator>(fixed_point);
            }},
      *lane);
}

void LaneRunner::decide(emulator::OperandColumns operands, std::size_t count,
                        std::span<Decision> decisions) const {
  if (const auto* fixed_point = std::get_if<emulator::FixedEmulator>(&emulator_)) {
    return fixed_point->decide(operands, count, decisions);
  }
  const auto& floating = std::get<emulator::Emulator>(emulator_);
  if (kind_ == SchemeKind::lanes_alone) {
    floating.compare(operands, count, decisions);
  } else {
    floating.decide(operands, count, decisions);
  }
}

}  // namespace mixcmp::profile
