#pragma once

#include <compare>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/devices/device.hpp"
#include "model/scene/bound_choice.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::model {

enum class ClockSource {
  estimate_before_routing,  ///< Yosys' sta, no wires
  routed,                   ///< after place and route
};
std::string_view to_string(ClockSource source);

/// The highest clock of a component. Over several seeds of the router: the median and the extremes.
struct Clock {
  double mhz = 0;
  double low_mhz = 0, high_mhz = 0;
  int seeds = 1;
  ClockSource source = ClockSource::estimate_before_routing;
};

enum class ComponentKind {
  unit,       ///< one floating-point or bound unit; for the eye
  lane,       ///< one reduced datapath alone
  reference,  ///< one reference datapath alone
  fifo,       ///< the scoreboard or reorder buffer around one lane
  crossbar,   ///< the share of the crossbar that one reference has when it serves `ports` lanes
};
std::string_view to_string(ComponentKind kind);

/// What was synthesised, as a row of a table names it. What does not apply is left empty or 0.
struct ComponentKey {
  ComponentKind kind = ComponentKind::lane;
  std::string name;                  ///< of a unit its template and formats; else empty
  std::string format;                ///< "s17e8"
  std::string inputs;                ///< of a lane: "rounded" or "exact"
  std::optional<BoundChoice> bound;  ///< of a lane
  std::string multipliers;           ///< of lanes, references and units with a product
  int ports = 0;                     ///< of a crossbar: lanes; of a fifo: slots

  friend auto operator<=>(const ComponentKey&, const ComponentKey&) = default;
};

/// One row of a table.
struct Measurement {
  ComponentKey key;
  int latency_cycles = 0;
  Area area;  ///< before placement, unless the clock is routed
  std::optional<Clock> clock;
  int timing_seeds = 0;  ///< of the router, that the clock was asked for with; 0: it was not
  std::string hash;      ///< of RTL, tools and options: the key in the store
  std::string tools;     ///< "Yosys 0.23 (git sha1 ...)"
};

/// All that is known of one scene's components on one device.
struct Characterisation {
  std::string device;
  std::string scene;
  std::string command;  ///< that makes the table again
  /// What the RTL depends on, for the eye: "f" with its text, "target_mhz", ...
  std::vector<std::pair<std::string, std::string>> spec;
  std::vector<Measurement> rows;  ///< sorted by key

  const Measurement* find(const ComponentKey& key) const;
};

/// CSV (RFC 4180), one row a component, with comment lines ("# device: ...") before the header.
std::string to_csv(const Characterisation& table);
/// Errors name the file, line and column.
Result<Characterisation> read_characterisation(const std::filesystem::path& path);

}  // namespace mixcmp::model
