#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/synthesis/characterise/synthesis.hpp"
#include "generator/synthesis/components/component_parts.hpp"
#include "model/cost/devices/device.hpp"
#include "model/cost/units/unit_areas.hpp"

namespace mixcmp::components {

/// The folder in which libraries are looked for, before those that come with the program; none
/// without a cache (cache_folder).
std::optional<std::filesystem::path> unit_library_folder();

/// A library of unit areas for a device.
struct UnitLibrary {
  units::UnitAreas areas;
  bool stands_in = false;  ///< it is of another synthesis command: areas are rough
};

/// The library for the device's synthesis command or, where there is none, that of Xilinx' 7
/// series.
Result<UnitLibrary> unit_library(const devices::Device& device);

/// The templates that an instance of a template is taken apart into, where the library does not
/// have it. Those with stages (CUTS) are whole: their parts share logic.
std::vector<rtl::TemplateInstance> parts_of_unit(const rtl::TemplateInstance& instance);

/// A hash of a template and of all that it instantiates, without comments, for all families.
std::string template_hash(const std::string& module);

/// The batch that maps these instances, which are of one template.
characterise::UnitBatch unit_batch(const std::vector<rtl::TemplateInstance>& instances);

}  // namespace mixcmp::components
