#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/emulator/emulator.hpp"
#include "model/profile/envelope.hpp"
#include "model/profile/systems.hpp"
#include "model/profile/threshold.hpp"

namespace mixcmp::model {

/// Where the last precision at which a comparison may be open is kept: one byte a comparison.
using LastOpen = std::uint8_t;

/// What all systems do at precisions anchor .. next - 1, for comparisons not yet settled there.
class Stage {
public:
  /// A lane of one system at one precision, ready to run; none where it does not exist.
  struct Runner {
    SystemKind kind;
    std::optional<Emulator> emulator;
  };

  /// `systems` have lanes from precision `first` on.
  Stage(const Envelope::Options& options, int next, int first, const TypedGraph& graph,
        const std::vector<SystemLanes>& systems);

  int anchor() const { return envelope_.anchor(); }
  int next() const { return next_; }
  std::size_t system_count() const { return thresholds_.size(); }
  const Runner& runner(std::size_t system, int precision) const {
    return runners_[system][precision - anchor()];
  }

  const Envelope& envelope() const { return envelope_; }

  /// Into last[system * stride + k], for k < envelope_width: the last precision at which the system
  /// may be undecided or wrong on comparison k of the block; anchor() - 1 if at none, next() if at
  /// next() or later.
  void last_open(const EnvelopeBlock& block, std::size_t stride, LastOpen* last) const;

private:
  Envelope envelope_;
  int next_;
  std::vector<Threshold> thresholds_;
  std::vector<std::vector<Runner>> runners_;
};

/// 1 where the sign of values f - g of the block might not be that of the true f - g, or the
/// reference's verdict might differ from it.
void find_doubtful(const Envelope& envelope, int reference_precision, const EnvelopeBlock& block,
                   std::uint8_t* doubtful);

}  // namespace mixcmp::model
