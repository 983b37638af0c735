#include "model/cost/devices/device.hpp"

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "embedded/device_files.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/quote.hpp"
#include "model/cost/devices/device_file.hpp"
#include "model/cost/devices/parts.hpp"

namespace mixcmp::devices {
namespace {

constexpr std::string_view ending = ".toml";

std::string_view stem(const EmbeddedFile& file) {
  return file.name.substr(0, file.name.size() - ending.size());
}

/// The device file with this name; null where there is none.
const EmbeddedFile* file_named(std::string_view name) {
  for (const EmbeddedFile& file : device_files()) {
    if (stem(file) == name) return &file;
  }
  return nullptr;
}

/// A device that comes with the program.
Result<Device> read_known(std::string_view name) {
  const std::optional<Part> part = find_part(name);
  const EmbeddedFile* file = file_named(part ? part->device : lower_case(name));
  if (file != nullptr) return read_device(std::string(file->text), file->name);
  if (part) return read_device(device_file_of(*part), "parts.csv");
  return Error{
      .field = "system.device",
      .message = "unknown device",
      .received = in_quotes(name),
      .accepted = candidates_for(name) + " (mixcmp devices lists all), or a device file (.toml)"};
}

}  // namespace

Result<Device> find_device(std::string_view name) {
  if (name.ends_with(ending)) {
    const std::filesystem::path path(name);
    MIXCMP_TRY(text, read_file(path));
    return read_device(std::move(text), path);
  }
  // Read once: a plan's search schedules thousands of designs, and each asks for its device.
  static std::mutex mutex;
  static std::map<std::string, Device, std::less<>> known;
  const std::lock_guard lock(mutex);
  const auto place = known.find(name);
  if (place != known.end()) return place->second;
  MIXCMP_TRY(device, read_known(name));
  return known.emplace(name, std::move(device)).first->second;
}

std::vector<std::string> device_names() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : device_files()) names.emplace_back(stem(file));
  return names;
}

std::vector<KnownDevice> known_devices() {
  std::vector<KnownDevice> known;
  const auto add = [&known](std::string_view name, std::vector<std::string> other_names) {
    known.push_back({find_device(name).value(), std::move(other_names)});
  };
  std::vector<std::string> without_part = device_names();
  for (const Part& part : parts()) {
    std::erase(without_part, part.device);
    std::vector<std::string> other_names;
    if (!part.device.empty()) other_names.emplace_back(part.name);
    for (const Board& board : boards()) {
      if (board.part == part.name) other_names.emplace_back(board.name);
    }
    add(part.name, std::move(other_names));
  }
  for (const std::string& name : without_part) add(name, {});
  return known;
}

}  // namespace mixcmp::devices
