#include "model/plan/optimise/architecture.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <numeric>

#include "model/base/common/check.hpp"

namespace mixcmp::optimise {
namespace {

using scene::CounterAccess;
using scene::EngineKind;
using scene::OperandMemory;
using scene::OperandStore;

constexpr std::array usual_groups = {1, 2, 4, 8, 16, 32};
constexpr std::array usual_engine_groups = {4, 8, 16, 24, 32};
constexpr std::array usual_report_streams = {1, 2, 4, 8, 16, 32};
constexpr std::array usual_beats = {1, 2, 4, 8};

/// The table of a section; null if the file has none.
const settings::Setting::Table* section_of(const settings::Settings& settings, const char* name) {
  const settings::Setting* section = settings.root.find(name);
  return section == nullptr ? nullptr : std::get_if<settings::Setting::Table>(&section->value);
}

bool is_open(const settings::Settings& settings, const char* section, const char* key) {
  const settings::Setting::Table* table = section_of(settings, section);
  const settings::Setting* entry = table == nullptr ? nullptr : table->find(key);
  if (entry == nullptr) return true;
  const auto* word = std::get_if<std::string>(&entry->value);
  return word != nullptr && *word == "auto";
}

template <class Value, class Values>
std::vector<Value> choices(bool open, const Value& given, const Values& usual) {
  return open ? std::vector<Value>(usual.begin(), usual.end()) : std::vector<Value>{given};
}

/// The sizes of groups to be tried. Systems of exact lanes have few other choices, so that every
/// size can be tried: one group may then have as many lanes as fit.
std::vector<int> group_sizes(const scene::Scene& scene) {
  std::vector<int> groups(usual_groups.begin(), usual_groups.end());
  if (scene.reference_count() != 0 || !scene.has_only_fixed_operands()) return groups;
  groups.resize(usual_groups.back());
  std::iota(groups.begin(), groups.end(), 1);
  return groups;
}

/// The architectures with these counters, groups and kind of operands.
void add_streams(std::vector<Architecture>& all, const Architecture& like,
                 const scene::SystemSpec& given, const OpenKeys& open) {
  if (like.operands == OperandStore::refetched) {
    const int name_bits = std::bit_width(static_cast<unsigned>(like.lanes_per_group - 1));
    const bool beats_given = !open.request_beats && given.request_beats.value_or(1) > 1;
    if (given.tag_bits < name_bits || beats_given) return;
    all.push_back(like);
    return;
  }
  const std::array memories = {OperandMemory::logic, OperandMemory::block};
  for (const auto memory : choices(open.operand_memory, given.operand_memory, memories)) {
    for (const auto beats :
         choices<std::optional<int>>(open.request_beats, given.request_beats, usual_beats)) {
      Architecture each = like;
      each.operand_memory = memory;
      each.request_beats = beats;
      all.push_back(each);
    }
  }
}

/// Whether an engine's streams carry more than pairs to be recomputed.
bool sends_reports(const scene::EngineSpec& engine) {
  return engine.report_as != scene::ReportForm::count;
}

std::string streams_of(const scene::EngineSpec& engine) {
  if (engine.report_streams == 1) return {};
  return fmt::format("{} streams of reports, ", engine.report_streams);
}

/// The open keys that change the scene's systems. Without references nothing keeps operands.
OpenKeys keys_with_effect(OpenKeys open, const scene::Scene& scene) {
  if (scene.reference_count() != 0) return open;
  open.operands = open.operand_memory = open.request_beats = open.initiation_interval = false;
  return open;
}

std::string setting(const char* key, std::string_view value) {
  return fmt::format("{}={}", key, value);
}

}  // namespace

OpenKeys open_keys(const settings::Settings& settings) {
  return {.operands = is_open(settings, "system", "operands"),
          .operand_memory = is_open(settings, "system", "operand_memory"),
          .request_beats = is_open(settings, "system", "request_beats"),
          .lanes_per_group = is_open(settings, "system", "lanes_per_group"),
          .counters = is_open(settings, "system", "counters") &&
                      is_open(settings, "system", "counter_bits"),
          .initiation_interval = is_open(settings, "reference", "initiation_interval"),
          .references = is_open(settings, "system", "references") &&
                        settings.root.find("references") == nullptr,
          .engine = section_of(settings, "engine") == nullptr,
          .engine_lanes_per_group = is_open(settings, "engine", "lanes_per_group"),
          .report_streams = is_open(settings, "engine", "report_streams")};
}

std::vector<Architecture> architectures_of(const scene::Scene& scene, const OpenKeys& all_open) {
  const scene::SystemSpec& given = scene.system;
  const OpenKeys open = keys_with_effect(all_open, scene);
  const std::array counters = {CounterAccess::ports, CounterAccess::none};
  const std::array stores = {OperandStore::carried, OperandStore::refetched};
  std::vector<Architecture> all;
  for (const CounterAccess access : choices(open.counters, given.counters, counters)) {
    Architecture like{.operands = given.operands,
                      .operand_memory = given.operand_memory,
                      .request_beats = given.request_beats,
                      .lanes_per_group = given.lanes_per_group,
                      .counters = access};
    switch (given.engine.kind) {
      case EngineKind::none:
        for (const auto store : choices(open.operands, given.operands, stores)) {
          like.operands = store;
          for (const int group :
               choices(open.lanes_per_group, given.lanes_per_group, group_sizes(scene))) {
            like.lanes_per_group = group;
            add_streams(all, like, given, open);
          }
        }
        break;
      case EngineKind::pairwise:
        for (const int group : choices(open.engine_lanes_per_group, given.engine.lanes_per_group,
                                       usual_engine_groups)) {
          like.lanes_per_group = group;
          for (const int streams : choices(open.report_streams && sends_reports(given.engine),
                                           given.engine.report_streams, usual_report_streams)) {
            like.report_streams = streams;
            all.push_back(like);
          }
        }
        break;
      case EngineKind::arg_min: all.push_back(like); break;
    }
  }
  return all;
}

scene::Scene with_architecture(scene::Scene scene, const Architecture& architecture,
                               const OpenKeys& open) {
  scene::SystemSpec& system = scene.system;
  if (open.counters) {
    system.counters = architecture.counters;
    if (architecture.counters == CounterAccess::none) system.counter_bits = 0;
  }
  if (open.initiation_interval) scene.reference_structure.initiation_interval.reset();
  switch (system.engine.kind) {
    case EngineKind::none:
      system.operands = architecture.operands;
      system.operand_memory = architecture.operand_memory;
      system.request_beats = architecture.request_beats;
      system.lanes_per_group = architecture.lanes_per_group;
      break;
    case EngineKind::pairwise:
      system.engine.lanes_per_group = architecture.lanes_per_group;
      system.engine.report_streams = architecture.report_streams;
      break;
    case EngineKind::arg_min: break;
  }
  return scene;
}

std::vector<std::string> settings_of(const Architecture& architecture, const scene::Scene& scene,
                                     const OpenKeys& all_open) {
  const OpenKeys open = keys_with_effect(all_open, scene);
  std::vector<std::string> settings;
  const bool streams = scene.system.engine.kind == EngineKind::none;
  if (open.operands && streams) {
    settings.push_back(setting("system.operands", to_string(architecture.operands)));
  }
  if (streams && architecture.operands == OperandStore::carried) {
    if (open.operand_memory) {
      settings.push_back(setting("system.operand_memory", to_string(architecture.operand_memory)));
    }
    if (open.request_beats) {
      settings.push_back(
          setting("system.request_beats", std::to_string(*architecture.request_beats)));
    }
  }
  const std::string group = std::to_string(architecture.lanes_per_group);
  if (streams && open.lanes_per_group) settings.push_back(setting("system.lanes_per_group", group));
  if (scene.system.engine.kind == EngineKind::pairwise && open.engine_lanes_per_group) {
    settings.push_back(setting("engine.lanes_per_group", group));
  }
  if (scene.system.engine.kind == EngineKind::pairwise && open.report_streams) {
    settings.push_back(
        setting("engine.report_streams", std::to_string(architecture.report_streams)));
  }
  if (open.counters) {
    settings.push_back(setting("system.counters", to_string(architecture.counters)));
  }
  return settings;
}

std::string interface_of(const scene::Scene& scene) {
  const scene::SystemSpec& system = scene.system;
  const std::string counters = system.counters == CounterAccess::none ? "no counters"
                               : system.counters == CounterAccess::axi_lite
                                   ? "counters on AXI4-Lite"
                                   : "counters";
  const std::string none = scene.reference_count() == 0 ? "no references, " : "";
  switch (system.engine.kind) {
    case EngineKind::none:
      if (!none.empty()) return none + counters;
      return fmt::format("operands {}, {}", to_string(system.operands), counters);
    case EngineKind::pairwise:
      return fmt::format("pairwise engine, {}{}{}", none, streams_of(system.engine), counters);
    case EngineKind::arg_min: return fmt::format("arg-min engine, {}{}", none, counters);
  }
  MIXCMP_CHECK(false);
}

bool asks_no_more(const scene::SystemSpec& a, const scene::SystemSpec& b) {
  const bool same_ports = a.engine.kind != EngineKind::none || a.operands == b.operands;
  // A system without references is no rival of one with them: both are listed.
  const bool same_recomputation = (a.references == 0) == (b.references == 0);
  return a.engine.kind == b.engine.kind && same_ports && same_recomputation &&
         a.counters == b.counters && a.engine.report_streams <= b.engine.report_streams;
}

}  // namespace mixcmp::optimise
