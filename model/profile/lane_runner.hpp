#pragma once

#include <optional>
#include <span>
#include <variant>

#include "model/design/lane.hpp"
#include "model/emulator/fixed_emulator.hpp"
#include "model/profile/profile.hpp"

namespace mixcmp::profile {

/// A lane of one scheme, ready to run on batches.
class LaneRunner {
public:
  LaneRunner(SchemeKind kind, const std::optional<design::Lane>& lane);

  bool exists() const { return !std::holds_alternative<std::monostate>(emulator_); }
  /// Decides as the scheme's lane does. `operands` as for emulator::Emulator.
  void decide(emulator::OperandColumns operands, std::size_t count,
              std::span<Decision> decisions) const;

private:
  SchemeKind kind_;
  std::variant<std::monostate, emulator::Emulator, emulator::FixedEmulator> emulator_;
};

}  // namespace mixcmp::profile
