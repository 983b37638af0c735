#include "generator/synthesis/components/unit_library.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

#include "generator/hardware/emit/template_parts.hpp"
#include "generator/hardware/emit/template_ports.hpp"
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

Result<UnitLibrary> library_for(const devices::Device& device) {
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

}  // namespace

std::optional<fs::path> unit_library_folder() {
  const std::optional<fs::path> folder = cache_folder();
  return folder ? std::optional(*folder / "units") : std::nullopt;
}

std::vector<rtl::TemplateInstance> parts_of_unit(const rtl::TemplateInstance& instance) {
  const auto parameters = emit::template_parameters(instance);
  const bool is_staged = std::any_of(parameters.begin(), parameters.end(),
                                     [](const auto& each) { return each.name == "CUTS"; });
  return is_staged ? std::vector<rtl::TemplateInstance>() : emit::template_parts(instance);
}

Result<UnitLibrary> unit_library(const devices::Device& device) {
  MIXCMP_TRY(library, library_for(device));
  library.areas.take_apart([](const units::Unit& unit) {
    std::vector<units::Unit> parts;
    for (const auto& part : parts_of_unit(instance_of(unit))) parts.push_back(unit_of(part));
    return parts;
  });
  return library;
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
