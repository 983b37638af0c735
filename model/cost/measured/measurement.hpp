#pragma once

#include <array>
#include <compare>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/base/number/bound.hpp"
#include "model/cost/devices/device.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::measured {

enum class ClockSource {
  estimate_before_routing,  ///< Yosys' sta, without wire delays
  routed,                   ///< after place and route
};
std::string_view to_string(ClockSource source);

/// The highest clock of a component. Over several seeds of the router, `mhz` is the median, and the
/// others are the extremes.
struct Clock {
  double mhz = 0;
  double low_mhz = 0, high_mhz = 0;
  int seeds = 1;
  ClockSource source = ClockSource::estimate_before_routing;
};

/// The step and the flow after which an area was counted.
enum class AreaStage {
  mapped,       ///< by our run of Yosys and the device's packer, of the component by itself
  synthesised,  ///< by a vendor's tool, of instances in a whole system, before placement
  placed,       ///< by a vendor's tool, as above, before routing
  routed,       ///< by a vendor's tool, as above, placed and routed
};
std::string_view to_string(AreaStage stage);

enum class ComponentKind {
  unit,       ///< one floating-point or bound unit; for information only
  lane,       ///< one reduced datapath by itself; in an engine without the conversion
  reference,  ///< one reference datapath by itself
  fifo,       ///< the scoreboard or reorder buffer around one lane or group of lanes
  /// One reference's share of the crossbar when it serves `ports` lanes or groups.
  crossbar,
  reference_port,  ///< the streams around one reference
  second_lane,     ///< of a system of streams: a lane of its second tier with its `ports` slots
  /// In an engine: `ports` lanes with all logic that only they use. Lanes of a pairwise engine work
  /// in lock step and share that logic; a lane of an arg-min engine has its own.
  segment,
  conversion,  ///< in an engine: computes the words of items and rows when they come in
  /// In an engine with `ports` segments: all other logic, except crossbar and references.
  engine,
  operand_memory,  ///< in an arg-min engine: full rows and candidates for `ports` references
};
std::string_view to_string(ComponentKind kind);

inline constexpr std::array component_kinds = {
    ComponentKind::unit,        ComponentKind::lane,          ComponentKind::reference,
    ComponentKind::fifo,        ComponentKind::crossbar,      ComponentKind::reference_port,
    ComponentKind::second_lane, ComponentKind::segment,       ComponentKind::conversion,
    ComponentKind::engine,      ComponentKind::operand_memory};

/// Whether components of this kind depend on the lane's properties: format, inputs, bound and
/// multipliers.
bool depends_on_lane(ComponentKind kind);
/// Whether components of this kind depend on the reference's properties.
bool depends_on_reference(ComponentKind kind);

/// Identifies a synthesised component in a table. A field that does not apply is empty or 0.
struct ComponentKey {
  ComponentKind kind = ComponentKind::lane;
  std::string name;                  ///< of a unit its template and formats; else empty
  std::string format;                ///< "s17e8"; of a lane in fixed point "q13"
  std::optional<LaneInputs> inputs;  ///< of a lane in floating point
  std::optional<Bound> bound;        ///< of a lane
  std::string multipliers;           ///< of lanes, references and units with a product
  Sums sums = Sums::composed;        ///< of a reference; composed for everything else
  int initiation_interval = 0;       ///< of a reference, in cycles
  int target_mhz = 0;                ///< of a reference; 0: the table's
  /// A crossbar's and a segment's lanes; a fifo's and a second lane's slots; an engine's segments;
  /// an operand memory's references.
  int ports = 0;

  friend auto operator<=>(const ComponentKey&, const ComponentKey&) = default;
};

/// One row of a table.
struct Measurement {
  ComponentKey key;
  int latency_cycles = 0;
  devices::Area area;  ///< of a mapped component before placement, unless the clock is routed
  std::optional<Clock> clock;
  int timing_seeds = 0;  ///< router seeds requested; 0: no clock was requested
  std::string hash;      ///< of RTL, tools and options: the key in the store
  std::string tools;     ///< "Yosys 0.23 (git sha1 ...)"
  AreaStage stage = AreaStage::mapped;

  /// Whether the row comes from a vendor's report, which we cannot make again.
  bool is_imported() const { return stage != AreaStage::mapped; }
};

/// The measurements of one scene's components on one device.
struct Characterisation {
  std::string device;
  std::string scene;
  std::string command;  ///< the command that makes the table again
  /// The settings on which the RTL depends, for information: "f" with its text, "target_mhz", ...
  std::vector<std::pair<std::string, std::string>> spec;
  std::vector<Measurement> rows;  ///< sorted by key

  const Measurement* find(const ComponentKey& key) const;
};

/// The properties on which the parts of a scene's engine depend, in words: the spec "engine" of a
/// table. Empty if there is no engine.
std::string engine_text(const scene::Scene& scene);

/// Refuses a table whose scoreboards surround groups of other sizes than the scene's. `path` is for
/// the error.
Result<Done> check_groups(const Characterisation& table, const std::filesystem::path& path,
                          const scene::Scene& scene);

/// CSV (RFC 4180) with one row per component and comment lines ("# device: ...") before the header.
std::string to_csv(const Characterisation& table);
/// Reads such a CSV file. Errors name the file, line and column.
Result<Characterisation> read_characterisation(const std::filesystem::path& path);

}  // namespace mixcmp::measured
