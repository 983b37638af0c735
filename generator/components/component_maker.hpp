#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "generator/rtl/system_modules.hpp"
#include "model/characterise/synthesis.hpp"
#include "model/data/comparisons.hpp"
#include "model/error/combined_lane.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::gen {

/// How many lanes per reference a crossbar may have that is measured alone. Yosys maps 128 in a
/// minute but not 512 in five. Generated systems may have more.
inline constexpr model::Limits measured_ports{1, 128};

/// One component of a scene's systems, ready to be synthesised alone.
struct Component {
  model::ComponentKey key;
  int latency_cycles = 0;
  model::SynthesisJob job;
  std::vector<model::ComponentKey> units;  ///< the units of a lane or reference; else empty
};

/// The datapath of one lane alone.
struct LaneRtl {
  int latency_cycles = 0;
  rtl::Module module;
};
/// Generates the datapath of `lane` for the device and clock of `system`. An error means that the
/// device is unknown.
model::Result<LaneRtl> lane_rtl(const std::vector<std::string>& inputs,
                                const model::CombinedLane& lane, model::Multipliers multipliers,
                                const model::SystemSpec& system);

/// Generates the RTL of a scene's components, one at a time, by the keys of a table's rows.
class ComponentMaker {
public:
  /// `data` may be null; only a profiled lane whose constants the scene does not give needs it.
  ComponentMaker(model::Scene scene, const model::Comparisons* data);

  /// The component of a key, or why there is none. A component without a product has no kind of
  /// multipliers in its key, even if the given key has one.
  model::Result<Component> make(const model::ComponentKey& key);

  const model::Scene& scene() const { return scene_; }

private:
  using Constants = std::pair<std::optional<mpq_class>, std::optional<mpq_class>>;  ///< RE_f, RE_g

  model::Result<Component> make_lane(const model::ComponentKey& key);
  model::Result<Component> make_reference(const model::ComponentKey& key);
  model::Result<Component> make_fifo(const model::ComponentKey& key);
  model::Result<Component> make_crossbar(const model::ComponentKey& key);
  model::Result<model::Done> give_constants(model::ReducedSpec& lane);
  model::Result<model::Done> measure_constants();
  /// The streams of one lane and one reference, which do not depend on what is computed between
  /// them.
  SystemShape stream_shape() const;

  model::Scene scene_;
  const model::Comparisons* data_;
  std::map<std::pair<int, model::LaneInputs>, Constants> constants_;
};

}  // namespace mixcmp::gen
