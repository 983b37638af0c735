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

/// Lanes at a reference whose crossbar is measured alone. Yosys maps 128 in a minute and not 512 in
/// five; what is generated may have more.
inline constexpr model::Limits measured_ports{1, 128};

/// One component of a scene's systems, ready to be synthesised alone.
struct Component {
  model::ComponentKey key;
  int latency_cycles = 0;
  model::SynthesisJob job;
  std::vector<model::ComponentKey> units;  ///< of a lane or reference: what it is made of
};

/// A reduced datapath alone, whatever scene it is of.
struct LaneRtl {
  int latency_cycles = 0;
  rtl::Module module;
};
/// An error where the device is unknown.
model::Result<LaneRtl> lane_rtl(const std::vector<std::string>& inputs,
                                const model::CombinedLane& lane, model::Multipliers multipliers,
                                const model::SystemSpec& system);

/// Writes the RTL of a scene's components, one at a time, by the keys of a table's rows.
class ComponentMaker {
public:
  /// `data` may be null; only a profiled lane whose constants the scene does not give needs it.
  ComponentMaker(const model::Scene& scene, const model::Comparisons* data);

  /// The component of a key, or why there is none. The key that comes back may say less: without a
  /// product there is nothing to make multipliers of.
  model::Result<Component> make(const model::ComponentKey& key);

  const model::Scene& scene() const { return scene_; }

private:
  using Constants = std::pair<mpq_class, mpq_class>;  ///< RE_f, RE_g

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
