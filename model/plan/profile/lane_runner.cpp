#include "model/plan/profile/lane_runner.hpp"

namespace mixcmp::profile {

LaneRunner::LaneRunner(SchemeKind kind, const std::optional<design::Lane>& lane) {
  if (!lane) return;
  std::visit([&](const auto& made) { emulator_.emplace(made); }, *lane);
  compares_ = kind == SchemeKind::lanes_alone && std::holds_alternative<error::Lane>(*lane);
}

void LaneRunner::decide(emulator::OperandColumns operands, std::size_t count,
                        std::span<Decision> decisions) const {
  if (compares_) {
    emulator_->compare(operands, count, decisions);
  } else {
    emulator_->decide(operands, count, decisions);
  }
}

}  // namespace mixcmp::profile
