#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/characterise/measurement.hpp"
#include "model/data/comparisons.hpp"
#include "model/devices/device.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::components {

/// What plans are made from.
struct Planning {
  scene::Scene scene;  ///< with the target_mhz that the table was measured for
  devices::Device device;
  characterise::Characterisation table;
  std::filesystem::path table_path;
  std::vector<std::string> notes;  ///< for the user: what the table's rows are not
};

/// Refuses a scene with an arg-min engine, whose chain of lanes leaves nothing to choose. The error
/// names the scene's key, without its place.
Result<Done> check_can_be_planned(const scene::Scene& scene);

/// How an error calls the table's path, and what the user can do where no table is.
struct TableAdvice {
  std::string field;
  std::string accepted;
};

/// Reads the table of a scene's device. `data` may be null. It is an error if there is no table, or
/// if it is of another device or scene.
Result<Planning> load_planning(const scene::Scene& scene, const data::Comparisons* data,
                               const devices::Device& device, const std::filesystem::path& table,
                               const TableAdvice& advice);

}  // namespace mixcmp::components
