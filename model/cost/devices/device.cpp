#include "model/cost/devices/device.hpp"

#include <filesystem>

#include "embedded/device_files.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/quote.hpp"
#include "model/cost/devices/device_file.hpp"
#include "model/cost/devices/vendor_part.hpp"

namespace mixcmp::devices {
namespace {

constexpr std::string_view ending = ".toml";

std::string_view stem(const EmbeddedFile& file) {
  return file.name.substr(0, file.name.size() - ending.size());
}

std::vector<NamedPart> named_parts() {
  std::vector<NamedPart> parts;
  for (const EmbeddedFile& file : device_files()) {
    const Result<Device> device = read_device(std::string(file.text), file.name);
    parts.push_back({std::string(stem(file)), device.ok() ? device->vendor_name : ""});
  }
  return parts;
}

}  // namespace

Result<Device> find_device(std::string_view name) {
  for (const EmbeddedFile& file : device_files()) {
    if (stem(file) == name) return read_device(std::string(file.text), file.name);
  }
  if (name.ends_with(ending)) {
    const std::filesystem::path path(name);
    MIXCMP_TRY(text, read_file(path));
    return read_device(std::move(text), path);
  }
  return Error{.field = "system.device",
               .message = "unknown device",
               .received = in_quotes(name),
               .accepted = list_for(name, named_parts()) + ", or a device file (.toml)"};
}

std::vector<std::string> device_names() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : device_files()) names.emplace_back(stem(file));
  return names;
}

}  // namespace mixcmp::devices
