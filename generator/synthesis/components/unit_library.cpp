#include "generator/synthesis/components/unit_library.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

#include "generator/hardware/emit/verilog.hpp"
#include "generator/synthesis/components/synthesis_jobs.hpp"
#include "model/base/common/cache_folder.hpp"
#include "model/base/common/content_hash.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/quote.hpp"

namespace mixcmp::components {

namespace {

namespace fs = std::filesystem;

/// The libraries that the user has made, by name.
Result<std::vector<units::UnitAreas>> own_libraries() {
  std::set<fs::path> files;
  std::error_code none;
  if (const std::optional<fs::path> folder = unit_library_folder()) {
    for (const auto& file : fs::directory_iterator(*folder, none)) {
      if (file.path().extension() == ".csv") files.insert(file.path());
    }
  }
  std::vector<units::UnitAreas> libraries;
  for (const fs::path& path : files) {
    MIXCMP_TRY(text, read_file(path));
    MIXCMP_TRY(areas, units::UnitAreas::read(text, path));
    libraries.push_back(std::move(areas));
  }
  return libraries;
}

std::optional<units::UnitAreas> library_among(std::vector<units::UnitAreas> libraries,
                                              const std::string& synthesis) {
  for (units::UnitAreas& library : libraries) {
    if (library.holds_for(synthesis)) return std::move(library);
  }
  return std::nullopt;
}

}  // namespace

std::optional<fs::path> unit_library_folder() {
  const std::optional<fs::path> folder = cache_folder();
  return folder ? std::optional(*folder / "units") : std::nullopt;
}

Result<UnitLibrary> unit_library(const devices::Device& device) {
  MIXCMP_TRY(own, own_libraries());
  if (auto library = library_among(std::move(own), device.synthesis)) {
    return UnitLibrary{std::move(*library)};
  }
  MIXCMP_TRY(shipped, units::shipped_libraries());
  if (auto library = library_among(std::move(shipped), device.synthesis)) {
    return UnitLibrary{std::move(*library)};
  }
  MIXCMP_TRY(others, units::shipped_libraries());
  return UnitLibrary{std::move(others.front()), true};
}

std::optional<devices::Area> area_of_unit(const units::UnitAreas& library,
                                          const units::Unit& unit) {
  if (unit.module != "delay_line") return library.of(unit);
  units::Unit narrow = unit;
  int width = 1;
  for (units::Parameter& parameter : narrow.parameters) {
    if (parameter.name != "WIDTH") continue;
    width = static_cast<int>(parameter.size());
    parameter = units::integer("WIDTH", 1);
  }
  const std::optional<devices::Area> line = library.of(narrow);
  return line ? std::optional(width * *line) : std::nullopt;
}

std::string template_hash(const std::string& module) {
  ContentHash hash;
  for (const characterise::SourceText& source : template_sources(module)) {
    hash.add(source.name).add(source.text);
  }
  return hash.hex().substr(0, 16);
}

characterise::UnitBatch unit_batch(const std::vector<rtl::TemplateInstance>& instances) {
  const std::string& module = instances.front().module;
  characterise::UnitBatch batch{
      .sources = template_sources(module), .module = module, .parameters = {}};
  for (const rtl::TemplateInstance& instance : instances) {
    std::string text;
    for (const rtl::Parameter& parameter : instance.parameters) {
      text += fmt::format("{}.{}({})", text.empty() ? "" : ", ", parameter.name,
                          emit::to_verilog(parameter));
    }
    batch.parameters.push_back(std::move(text));
  }
  return batch;
}

}  // namespace mixcmp::components
