#include "generator/tasks/remedies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "model/cost/devices/parts.hpp"

namespace mixcmp::tasks {
namespace {

using devices::Device;

bool has_plan(const Result<OptimiseResult>& found) {
  return found.ok() && found->best().found.best() != nullptr;
}

/// A device of the table of parts.
Device device_of(const std::string& name) {
  return devices::find_device(name).value();
}

/// The devices of the family with no less of any resource and more of one, the smallest first.
std::vector<std::string> larger_than(const Device& device) {
  std::vector<std::string> names;
  for (const devices::Part& part : devices::parts()) {
    if (part.family != device.family) continue;
    const Device larger = device_of(std::string(part.name));
    const bool has_all =
        std::all_of(std::begin(devices::bounded_resources), std::end(devices::bounded_resources),
                    [&](const devices::Resource& resource) {
                      return larger.available.*resource.amount >= device.available.*resource.amount;
                    });
    if (has_all && larger.available != device.available) names.push_back(larger.name);
  }
  return names;  // parts are listed by their size
}

/// The first of these devices on which a system fits; empty if none does. Those that are smaller
/// than no other are tried first: where none of them helps, no other one does.
std::string smallest_of(const std::vector<std::string>& names, ArchitectureSearch& search) {
  const auto fits = [&](const std::string& name) {
    return search.move_to(name).ok() && has_plan(search.fastest());
  };
  const auto is_largest = [&](const std::string& name) {
    return larger_than(device_of(name)).empty();
  };
  if (std::none_of(names.begin(), names.end(),
                   [&](const std::string& name) { return is_largest(name) && fits(name); })) {
    return "";
  }
  const auto found = std::find_if(names.begin(), names.end(), fits);
  return found == names.end() ? "" : *found;
}

}  // namespace

std::string note_on_room(ArchitectureSearch& search, double slack) {
  const Device device = search.device();
  std::vector<std::string> remedies;
  if (slack > 0 && has_plan(search.fastest_without_slack())) {
    remedies.emplace_back("--set system.slack=0");
  }
  const std::string larger = smallest_of(larger_than(device), search);
  if (!larger.empty()) remedies.push_back("--device " + larger);
  if (!remedies.empty()) {
    return fmt::format("a system fits, by predicted areas, with: {}",
                       fmt::join(remedies, ", or with: "));
  }
  return fmt::format("no system fits with system.slack = 0 either, nor on a larger device of {}",
                     device.family.empty() ? "its family" : device.family);
}

}  // namespace mixcmp::tasks
