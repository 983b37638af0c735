#include "generator/faces/cli/fit.hpp"

#include <charconv>
#include <system_error>

#include "generator/faces/cli/planning.hpp"
#include "generator/synthesis/components/characterise.hpp"
#include "model/base/common/file.hpp"
#include "model/plan/optimise/footprint.hpp"

namespace mixcmp::cli {
namespace {

/// The table beside the scene; nullopt where it is absent, unreadable or of another scene or
/// device. None of these is an error here; `optimise` reports them.
std::optional<measured::Characterisation> table_beside(const std::filesystem::path& path,
                                                       const scene::Scene& scene,
                                                       const devices::Device& device) {
  if (!path_exists(path)) return std::nullopt;
  auto table = measured::read_characterisation(path);
  if (!table.ok() || table->device != device.name || table->scene != scene.name) {
    return std::nullopt;
  }
  return std::move(table).value();
}

/// Whether the scene is a plan that states its LUTs, and the device has so many. They are more
/// exact than a rough estimate.
bool states_that_it_fits(const scene::Scene& scene, const devices::Device& device) {
  if (!scene.plan) return false;
  for (const auto& [key, text] : scene.plan->values) {
    int luts = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), luts);
    if (key == "lut" && read.ec == std::errc()) return luts <= device.available.luts;
  }
  return false;
}

}  // namespace

std::optional<std::string> fit_note(const LoadedScene& loaded, const design::Design& design) {
  const auto device = devices::find_device(loaded.scene.system.device);
  if (!device.ok()) return std::nullopt;
  const scene::Scene& scene = loaded.scene;
  const std::filesystem::path path = optimise::default_table(scene.path, scene, device->name);
  const auto table = table_beside(path, scene, *device);
  const auto note = [&](const measured::Characterisation* areas) -> std::optional<std::string> {
    if (areas == nullptr && states_that_it_fits(scene, *device)) return std::nullopt;
    const auto footprint = optimise::footprint_of(design, areas, *device);
    return excess_of(footprint, design, *device, path.string());
  };
  if (!table) return note(nullptr);
  const auto measured = note(&*table);
  // It takes time to find whether the areas are of this RTL, so this is done only for a note.
  if (!measured) return std::nullopt;
  const data::Comparisons* data = loaded.data ? &*loaded.data : nullptr;
  const bool outdated = components::count_rows(*table, scene, data, *device).outdated > 0;
  return outdated ? note(nullptr) : measured;
}

}  // namespace mixcmp::cli
