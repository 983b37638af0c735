#pragma once

#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "generator/hardware/rtl/engine_shape.hpp"
#include "generator/hardware/rtl/system_shape.hpp"
#include "generator/synthesis/characterise/synthesis.hpp"
#include "generator/synthesis/components/component_parts.hpp"
#include "model/comparison/data/comparisons.hpp"
#include "model/design/design.hpp"
#include "model/design/lane.hpp"
#include "model/design/reference_structure.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::components {

class EngineParts;

/// The numbers of lanes per reference with which a crossbar is measured by itself. Yosys maps 128
/// in a minute but not 512 in five. Generated systems may have more.
inline constexpr settings::Limits measured_ports{1, 128};

/// One component of a scene's systems, ready for synthesis by itself.
struct Component {
  measured::ComponentKey key;
  int latency_cycles = 0;
  /// A template by itself, or modules of which the last instantiates the others.
  std::variant<rtl::TemplateInstance, std::vector<rtl::Module>> hardware;

  characterise::SynthesisJob job() const;
  ComponentParts parts() const;
};

/// The reference of a table; its component is made without multipliers where it has no product.
measured::Reference reference_key(const scene::Scene& scene,
                                  const design::ReferenceStructure& structure);

/// The datapath of one lane, without streams around it.
struct LaneRtl {
  int latency_cycles = 0;
  rtl::Module module;
};
/// Generates the datapath of `lane` for the device and clock of `system`. An error means that the
/// device is unknown.
Result<LaneRtl> lane_rtl(const std::vector<std::string>& inputs, const design::Lane& lane,
                         scene::Multipliers multipliers, const scene::SystemSpec& system);

/// Generates the RTL of a scene's components, one at a time, by the keys of a table's rows.
class ComponentMaker {
public:
  /// `data` may be null; only a profiled lane whose constants the scene does not give needs it.
  ComponentMaker(scene::Scene scene, const data::Comparisons* data);

  /// The component of a key, or why there is none. A component without a product has no kind of
  /// multipliers in its key, even if the given key has one.
  Result<Component> make(const measured::ComponentKey& key);

  /// Whether an engine of such lanes converts items before it stores them.
  Result<bool> converts(const measured::Lane& key);
  /// A lane that is not yet hardware. It is designed once.
  Result<design::Lane> lane(const measured::Lane& key);

  /// Takes the system and the references' structure of another scene of the same comparison. Lanes
  /// need not be designed again.
  void use_system_of(const scene::Scene& other);

  const scene::Scene& scene() const { return scene_; }
  const scene::EngineSpec& engine() const { return scene_.system.engine; }
  /// Whether the scene's lanes read words of the items of an engine.
  bool has_engine() const { return engine().kind != scene::EngineKind::none; }
  /// Whether requests for recomputation pass a crossbar.
  bool has_crossbar() const { return engine().kind != scene::EngineKind::pairwise; }
  /// The numbers of segments with which the engine is measured.
  Result<std::vector<int>> engine_sizes() const;

private:
  using Constants = std::pair<std::optional<mpq_class>, std::optional<mpq_class>>;  ///< RE_f, RE_g

  Result<design::Lane> designed(const measured::Lane& key);
  static Result<Component> made(const measured::Unit& key);
  Result<Component> made(const measured::Lane& key);
  Result<Component> made_word_lane(const measured::Lane& key);
  Result<Component> made(const measured::Reference& key);
  Result<Component> made(const measured::Fifo& key);
  Result<Component> made(const measured::Crossbar& key);
  Result<Component> made(const measured::ReferencePort& key);
  Result<Component> made(const measured::SecondLane& key);
  Result<Component> made(const measured::Segment& key);
  Result<Component> made(const measured::Conversion& key);
  Result<Component> made(const measured::Engine& key);
  Result<Component> made(const measured::OperandMemory& key) const;
  /// Such lanes, as a group of a design.
  Result<design::LaneGroup> lane_group(const measured::Lane& key, int count);
  /// The parts of an engine with such lanes, in so many segments. If absent, it has as many lanes
  /// as determine the widths inside.
  Result<EngineParts> engine_parts(const measured::Lane& key, std::optional<int> segments = {});
  /// The properties of an arg-min engine that follow from its candidates and rows.
  struct Chain {
    rtl::EngineShape engine;
    int place_bits;  ///< of lanes with as many slots as a crossbar is measured with
  };
  Result<Chain> chain() const;
  Result<Done> check_reference(const measured::Reference& key) const;
  Result<datapath::Schedule> reference_schedule(const measured::Reference& key,
                                                const design::ReferenceDatapath& datapath) const;
  Result<Done> give_constants(scene::ReducedSpec& lane);
  Result<Done> measure_constants(LaneInputs inputs);
  /// The streams of one lane and one reference. They do not depend on the computation between them.
  rtl::SystemShape stream_shape() const;
  /// The shape that sets the width of a request for recomputation: the largest system, or the
  /// scene's engine.
  Result<rtl::SystemShape> request_shape() const;

  scene::Scene scene_;
  const data::Comparisons* data_;
  std::map<measured::Lane, Result<design::Lane>> lanes_;
  std::map<LaneInputs, std::map<int, Constants>> constants_;  ///< by precision; as measured
};

}  // namespace mixcmp::components
