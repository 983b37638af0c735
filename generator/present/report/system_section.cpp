#include <fmt/format.h>

#include "generator/present/report/report_sections.hpp"
#include "generator/present/schematic/canvas.hpp"
#include "generator/present/schematic/datapath_pipeline.hpp"
#include "generator/present/schematic/system_picture.hpp"

namespace mixcmp::report {
namespace {

std::string size_of(const page::Pipeline& pipeline, std::string_view from) {
  return fmt::format("{} from {} to the verdict, one comparison in each.",
                     schematic::counted(pipeline.cycles, "cycle"), from);
}

/// A lane that reads words, its inputs named as its ports.
design::Lane with_named_inputs(const rtl::WordLane& reading) {
  design::Lane lane = reading.lane;
  auto* const fixed = std::get_if<fixed::FixedLane>(&lane);
  if (fixed == nullptr) return lane;
  for (std::size_t input = 0; input < fixed->loaded_inputs.size(); ++input) {
    fixed->input_names.push_back(reading.ports[input].name);
  }
  return lane;
}

/// The lanes of group k as they are built.
design::Lane built_lane(const BuiltSystem& system, std::size_t k) {
  const rtl::ItemWords* const words = system.scheduled.words();
  return words != nullptr ? with_named_inputs(words->lanes[k]) : system.design.lanes[k].lane;
}

/// Adds the conversion of one kind of item, which lanes in fixed point leave to the engine around
/// them.
void add_conversion(page::Section& section, const rtl::ItemWords& words, data::Item item,
                    const std::string& what) {
  const rtl::Word& word = words.of(item);
  if (!word.converts()) return;
  const page::Pipeline pipeline = schematic::item_pipeline(words.loader_of(item), word.schedule);
  section.content.push_back(page::heading("The conversion of " + what));
  section.content.push_back(page::figure(
      draw(pipeline),
      fmt::format("What lanes know of {}, a word of {} bits, computed once, when it is loaded: {}.",
                  what, word.bits(), schematic::counted(pipeline.cycles, "cycle"))));
}

void add_conversions(page::Section& section, const BuiltSystem& system) {
  const rtl::ItemWords* const words = system.scheduled.words();
  if (words == nullptr) return;
  const bool pairwise = system.scheduled.pairwise.has_value();
  add_conversion(section, *words, data::Item::first, pairwise ? "an item" : "a candidate");
  add_conversion(section, *words, data::Item::row, "a row");
}

const char* operands_of_lane(const BuiltSystem& system) {
  if (system.scheduled.pairwise) return "the words of two items";
  return system.scheduled.arg_min ? "the words of a row and two candidates" : "the operands";
}

void add_lanes(page::Section& section, const BuiltSystem& system) {
  const std::vector<std::string> names = lane_group_names(system.design);
  const char* const from = operands_of_lane(system);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const page::Pipeline pipeline = schematic::lane_pipeline(
        built_lane(system, k), system.scheduled.shape.lane_groups[k].schedule);
    section.content.push_back(page::heading("A lane in " + names[k]));
    section.content.push_back(page::figure(draw(pipeline), size_of(pipeline, from)));
  }
}

/// The second tier's lane as built: in an engine it reads words.
design::Lane built_second_tier(const BuiltSystem& system) {
  if (!system.scheduled.pairwise) return system.design.second_tier->lane;
  return with_named_inputs(*system.scheduled.pairwise->words.second_tier);
}

void add_second_tier(page::Section& section, const BuiltSystem& system) {
  if (!system.design.second_tier) return;
  const page::Pipeline pipeline = schematic::lane_pipeline(
      built_second_tier(system), system.scheduled.shape.second_tier->schedule);
  const int lanes = system.design.system.engine.lanes_per_group;
  const std::string whose =
      system.scheduled.pairwise ? fmt::format("a group of {} lanes leaves", lanes) : "lanes leave";
  section.content.push_back(page::heading("The second tier, a lane in " +
                                          design::format_name(system.design.second_tier->lane)));
  section.content.push_back(
      page::figure(draw(pipeline), fmt::format("It decides again what {} undecided. {}", whose,
                                               size_of(pipeline, operands_of_lane(system)))));
}

void add_references(page::Section& section, const BuiltSystem& system) {
  const std::vector<std::string> names = reference_group_names(system.design);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (system.design.references[k].count == 0) continue;
    const page::Pipeline pipeline = schematic::reference_pipeline(
        system.design.reference_datapath(), system.scheduled.shape.reference_groups[k].schedule);
    section.content.push_back(page::heading("A reference in " + names[k]));
    section.content.push_back(page::figure(draw(pipeline), size_of(pipeline, "the operands")));
  }
}

std::string caption_of(const emit::Signature& signature) {
  const std::string groups =
      signature.lanes_per_group == 1
          ? ""
          : fmt::format(" in groups of {} in lock step", signature.lanes_per_group);
  const std::string numbers =
      fmt::format("p_L = {}{}, p_H = {}.", signature.lanes, groups, signature.references);
  if (!signature.engine) return fmt::format("The top module {}: {}", signature.top, numbers);
  const std::string& top = signature.engine->top;
  if (signature.engine->kind == scene::EngineKind::pairwise) {
    return fmt::format("The top module {}, which makes all pairs of its items: {}", top, numbers);
  }
  return fmt::format(
      "The system {} inside the top module {}, an engine that finds the least of {} "
      "candidates: {}",
      signature.top, top, signature.engine->capacity, numbers);
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
      page::figure(schematic::system_picture(system.signature), caption_of(system.signature)));
  for (const std::string& note : system.notes)
    section.content.push_back(page::note("Note: " + note));
  section.content.push_back(page::paragraph(
      "In the pictures of datapaths time runs downwards, a row of registers a line. A box is a "
      "unit with the format of its result; a dashed line is a value that waits in registers."));
  add_conversions(section, system);
  add_lanes(section, system);
  add_second_tier(section, system);
  add_references(section, system);
  return section;
}

}  // namespace mixcmp::report
