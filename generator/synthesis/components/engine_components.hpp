#pragma once

#include <array>
#include <vector>

#include "generator/hardware/emit/scheduled_system.hpp"
#include "generator/synthesis/components/component_maker.hpp"
#include "model/design/design.hpp"

/// The parts of an engine, each ready for synthesis by itself.
namespace mixcmp::components {

/// The numbers of segments with which the scene's engine is measured. Each further segment adds the
/// same area, so two numbers are enough. In an arg-min engine the area for a lane also grows with
/// the number of candidates. The larger number is therefore the scene's, which a plan has, unless
/// that is a single lane. The scene's lanes are known.
std::vector<int> measured_segments(const scene::Scene& scene);

/// The numbers of references with which the memory of an arg-min engine is measured.
inline constexpr std::array measured_memory_references = {1, 4};

/// An engine with lanes of one kind, scheduled for its device and clock.
class EngineParts {
public:
  /// `lanes` of this kind, in segments of `engine.lanes_per_segment()`. An error means that the
  /// device is unknown.
  static Result<EngineParts> make(const scene::Scene& scene, const design::LaneGroup& lanes);

  /// Cycles of a lane behind the conversion.
  int lane_latency_cycles() const;
  /// One lane, behind the conversion.
  rtl::Module lane() const;
  /// The first segment with its lanes; in an arg-min engine a lane with the buffer around it.
  PreparedJob segment() const;

  /// Whether items and rows are converted when they come in.
  bool converts() const { return words().items.converts(); }
  int conversion_latency_cycles() const;
  PreparedJob conversion() const;

  /// The rest of the engine, without crossbar and references. A pairwise engine: loading, the
  /// chain's beginning, the merge of exceptions, recomputation, reports. An arg-min engine with one
  /// reference: loading, the memories of full rows and candidates, the stages of the chain.
  PreparedJob engine() const;

private:
  explicit EngineParts(emit::ScheduledSystem scheduled) : scheduled_(std::move(scheduled)) {}

  const rtl::ItemWords& words() const { return *scheduled_.words(); }

  emit::ScheduledSystem scheduled_;
};

}  // namespace mixcmp::components
