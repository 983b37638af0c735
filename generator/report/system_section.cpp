#include <fmt/format.h>

#include "generator/report/report_sections.hpp"
#include "generator/schematic/datapath_pipeline.hpp"
#include "generator/schematic/system_picture.hpp"

namespace mixcmp::report {
namespace {

std::string size_of(const page::Pipeline& pipeline) {
  return fmt::format("{} cycles from the operands to the verdict, one comparison in each.",
                     pipeline.cycles);
}

void add_lanes(page::Section& section, const BuiltSystem& system) {
  const std::vector<std::string> names = lane_group_names(system.design);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const page::Pipeline pipeline = schematic::lane_pipeline(
        system.design.lanes[k].lane, system.scheduled.shape.lane_groups[k].schedule);
    section.content.push_back(page::heading("A lane in " + names[k]));
    section.content.push_back(page::figure(draw(pipeline), size_of(pipeline)));
  }
}

void add_references(page::Section& section, const BuiltSystem& system) {
  const std::vector<std::string> names = reference_group_names(system.design);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (system.design.references[k].count == 0) continue;
    const page::Pipeline pipeline = schematic::reference_pipeline(
        system.design.reference, system.scheduled.shape.reference_groups[k].schedule);
    section.content.push_back(page::heading("A reference in " + names[k]));
    section.content.push_back(page::figure(draw(pipeline), size_of(pipeline)));
  }
}

}  // namespace

page::Section system_section(const IfThere<BuiltSystem>& there) {
  page::Section section{"system", "The system", {}};
  if (const auto* missing = std::get_if<Missing>(&there)) {
    section.content.push_back(page::missing(missing->why, missing->command));
    return section;
  }
  const auto& system = std::get<BuiltSystem>(there);
  section.content.push_back(
      page::figure(schematic::system_picture(system.signature),
                   fmt::format("The top module {}: p_L = {}, p_H = {}.", system.signature.top,
                               system.signature.lanes, system.signature.references)));
  for (const std::string& note : system.notes)
    section.content.push_back(page::note("Note: " + note));
  section.content.push_back(page::paragraph(
      "In the pictures of datapaths time runs downwards, a row of registers a line. A box is a "
      "unit with the format of its result; a dashed line is a value that waits in registers."));
  add_lanes(section, system);
  add_references(section, system);
  return section;
}

}  // namespace mixcmp::report
