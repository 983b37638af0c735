#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/comparison/data/comparisons.hpp"
#include "model/cost/devices/device.hpp"
#include "model/cost/measured/measurement.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::components {

/// The input of a plan: scene, device and measured table.
struct Planning {
  /// With the target_mhz that the table was measured for, and the lanes that a chain has.
  scene::Scene scene;
  devices::Device device;
  measured::Characterisation table;
  std::filesystem::path table_path;
  std::vector<std::string> notes;  ///< for the user: limitations of the table's rows
};

/// Texts for an error about the table: the name of its path, and the remedy if there is no table.
struct TableAdvice {
  std::string field;
  std::string accepted;
};

/// Reads the table of a scene's device. `data` may be null. It is an error if there is no table, or
/// if it is of another device or scene. `scene` has the lanes of its chain:
/// design::with_chain_lanes.
Result<Planning> load_planning(const scene::Scene& scene, const data::Comparisons* data,
                               const devices::Device& device, const std::filesystem::path& table,
                               const TableAdvice& advice);

}  // namespace mixcmp::components
