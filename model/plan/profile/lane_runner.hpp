#pragma once

#include <optional>
#include <span>

#include "model/design/lane.hpp"
#include "model/judge/emulator/emulator.hpp"
#include "model/plan/profile/profile.hpp"

namespace mixcmp::profile {

/// A lane of one scheme, ready to run on batches.
class LaneRunner {
public:
  LaneRunner(SchemeKind kind, const std::optional<design::Lane>& lane);

  bool exists() const { return emulator_.has_value(); }
  /// Decides as the scheme's lane does. `operands` as for emulator::Emulator.
  void decide(emulator::OperandColumns operands, std::size_t count,
              std::span<Decision> decisions) const;

private:
  std::optional<emulator::Emulator> emulator_;
  bool compares_ = false;  ///< by the order of f and g, whatever the bound
};

}  // namespace mixcmp::profile
