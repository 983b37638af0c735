#pragma once

#include "generator/components/component_maker.hpp"
#include "generator/emit/scheduled_system.hpp"
#include "model/design/design.hpp"

/// The parts of a pairwise engine, each ready to be synthesised alone.
namespace mixcmp::components {

/// The numbers of segments with which an engine is measured: what it takes grows by the same amount
/// with each further segment, so that two are enough.
std::vector<int> measured_segments(const scene::EngineSpec& engine);

/// A pairwise engine with lanes of one kind, scheduled for its device and clock.
class EngineParts {
public:
  /// `lanes` of this kind, in segments of `engine.lanes_per_group`. An error means that the device
  /// is unknown.
  static Result<EngineParts> make(const scene::Scene& scene, const design::LaneGroup& lanes);

  /// Cycles of a lane behind the conversion.
  int lane_latency_cycles() const;
  /// A lane alone, behind the conversion.
  rtl::Module lane() const;
  /// The first segment with its lanes.
  characterise::SynthesisJob segment() const;

  /// Whether items are converted when they are loaded.
  bool converts() const { return scheduled_.pairwise->words.items.converts(); }
  int conversion_latency_cycles() const;
  characterise::SynthesisJob conversion() const;

  /// Everything else: loading, the chain's beginning, the merge of exceptions, recomputation,
  /// reports.
  characterise::SynthesisJob engine() const;

private:
  explicit EngineParts(emit::ScheduledSystem scheduled) : scheduled_(std::move(scheduled)) {}

  emit::ScheduledSystem scheduled_;
};

}  // namespace mixcmp::components
