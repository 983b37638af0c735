#include "model/profile/stage.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "model/profile/envelope_kernels.hpp"

namespace mixcmp::model {
namespace {

using envelope_kernels::for_each_lane;
using envelope_kernels::outward;

/// Below |f - g|, from its double evaluation.
struct Gap {
  const NodeEnvelope &f, &g, &difference;
  double error_of_double;  ///< in units of the errors at A

  double error(std::size_t k) const { return f.error[k] + g.error[k]; }
  double least(std::size_t k) const {
    return std::fabs(difference.value[k]) / outward - error(k) * error_of_double;
  }
};

Gap gap_of(const Envelope& envelope, const EnvelopeBlock& block) {
  const TypedGraph& graph = envelope.graph();
  return {block.nodes[graph.f], block.nodes[graph.g], block.nodes.back(),
          std::ldexp(outward, envelope.anchor() - 53)};
}

std::vector<const Lane*> lanes_from(const SystemLanes& system, std::size_t index) {
  std::vector<const Lane*> lanes;
  for (; index < system.lanes.size(); ++index) {
    lanes.push_back(system.lanes[index] ? &*system.lanes[index] : nullptr);
  }
  return lanes;
}

Threshold threshold_of(const SystemLanes& system, int index, const Envelope& envelope) {
  if (system.kind == SystemKind::lanes_alone) return Threshold::of_order();
  const std::vector<const Lane*> lanes = lanes_from(system, index);
  return Threshold::of_lanes(lanes, envelope);
}

}  // namespace

Stage::Stage(const Envelope::Options& options, int next, int first, const TypedGraph& graph,
             const std::vector<SystemLanes>& systems)
    : envelope_(graph, options), next_(next) {
  for (const SystemLanes& system : systems) {
    thresholds_.push_back(threshold_of(system, anchor() - first, envelope_));
    std::vector<Runner>& runners = runners_.emplace_back();
    for (int precision = anchor(); precision < next; ++precision) {
      const std::optional<Lane>& lane = system.lanes[precision - first];
      Runner& runner = runners.emplace_back(Runner{system.kind, std::nullopt});
      if (lane) runner.emulator.emplace(*lane);
    }
  }
}

void Stage::last_open(const EnvelopeBlock& block, std::size_t stride, LastOpen* last) const {
  alignas(64) EnvelopeRow scaled, fixed, wild;
  const Gap gap = gap_of(envelope_, block);
  // Steps from anchor - 1: none below a ratio of 1, all of them from `enough` on.
  const double enough = std::ldexp(1.0, next_ - anchor());
  const auto bias = static_cast<std::uint64_t>(1022 - (anchor() - 1));
  for (std::size_t system = 0; system < thresholds_.size(); ++system) {
    wild = block.wild;
    thresholds_[system].evaluate(block, scaled, fixed, wild);
    LastOpen* const open = last + system * stride;
    for_each_lane([&](std::size_t k) {
      // Open at L only if (|f - g| - fixed) 2^(L-A) <= errors + scaled.
      const double apart = gap.least(k) - fixed[k];
      const double ratio = (gap.error(k) + scaled[k]) / apart * outward;
      const bool known = (wild[k] == 0) & (apart > 0) & (ratio < enough);
      const double within = known ? ratio : enough;
      const double clamped = within < 0.5 ? 0.5 : within;
      open[k] = static_cast<LastOpen>((std::bit_cast<std::uint64_t>(clamped) >> 52) - bias);
    });
  }
}

void find_doubtful(const Envelope& envelope, int reference_precision, const EnvelopeBlock& block,
                   std::uint8_t* doubtful) {
  const Gap gap = gap_of(envelope, block);
  const double in_reference = std::ldexp(outward, envelope.anchor() - reference_precision);
  for_each_lane([&](std::size_t k) {
    const bool clear = (block.wild[k] == 0) & (gap.least(k) > gap.error(k) * in_reference);
    doubtful[k] = clear ? 0 : 1;
  });
}

}  // namespace mixcmp::model
