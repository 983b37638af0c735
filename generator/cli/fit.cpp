#include "generator/cli/fit.hpp"

#include "generator/cli/planning.hpp"
#include "model/common/file.hpp"
#include "model/optimise/footprint.hpp"

namespace mixcmp::cli {
namespace {

/// The table beside the scene; nullopt where it is absent, unreadable or of another scene or
/// device. None of these is an error here; `optimise` reports what is wrong.
std::optional<characterise::Characterisation> table_beside(const std::filesystem::path& path,
                                                           const scene::Scene& scene,
                                                           const devices::Device& device) {
  if (!path_exists(path)) return std::nullopt;
  auto table = characterise::read_characterisation(path);
  if (!table.ok() || table->device != device.name || table->scene != scene.name) {
    return std::nullopt;
  }
  return std::move(table).value();
}

}  // namespace

std::optional<std::string> fit_note(const LoadedScene& loaded, const design::Design& design) {
  const auto device = devices::find_device(loaded.scene.system.device);
  if (!device.ok()) return std::nullopt;
  const scene::Scene& scene = loaded.scene;
  const std::filesystem::path path = default_table(scene.path, scene.variant, device->name);
  const auto table = table_beside(path, scene, *device);
  const auto footprint = optimise::footprint_of(design, table ? &*table : nullptr, *device);
  return excess_of(footprint, design, *device, path.string());
}

}  // namespace mixcmp::cli
