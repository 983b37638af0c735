#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "model/cost/devices/device.hpp"
#include "model/cost/measured/component_key.hpp"
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
  predicted,    ///< not counted: by the areas of units and a schedule (predicted_table.hpp)
  mapped,       ///< by our run of Yosys and the device's packer, of the component by itself
  synthesised,  ///< by a vendor's tool, of instances in a whole system, before placement
  placed,       ///< by a vendor's tool, as above, before routing
  routed,       ///< by a vendor's tool, as above, placed and routed
};
std::string_view to_string(AreaStage stage);

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
  bool is_imported() const { return stage > AreaStage::mapped; }
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
  /// The row of this key, or of the same component without a product.
  const Measurement* find_datapath(const ComponentKey& key) const;
};

/// The rows of all sizes of a component, by their counts. `like` may have multipliers that the rows
/// lack since there is no product.
template <Counted Component>
std::map<int, const Measurement*> sizes_of(const Characterisation& table, Component like) {
  std::map<int, const Measurement*> sizes;
  for (const Measurement& row : table.rows) {
    const auto* component = std::get_if<Component>(&row.key);
    if (component == nullptr) continue;
    like.*Component::count = component->*Component::count;
    if (*component == like || without_multipliers(like) == row.key) {
      sizes.emplace(like.*Component::count, &row);
    }
  }
  return sizes;
}

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
