#include "generator/tasks/units.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <set>

#include "generator/hardware/emit/template_ports.hpp"
#include "generator/synthesis/components/component_list.hpp"
#include "generator/synthesis/components/synthesis_jobs.hpp"
#include "generator/synthesis/components/unit_library.hpp"
#include "model/base/common/content_hash.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"
#include "model/base/settings/bound_name.hpp"

namespace mixcmp::tasks {
namespace {

namespace fs = std::filesystem;
using components::ComponentQuery;

/// Units of one template in one run of Yosys: enough to hide its start, few enough to lose little.
constexpr std::size_t batch_units = 20;
constexpr int seconds_of_a_batch = 3600;

std::vector<Bound> usual_bounds() {
  std::vector<Bound> bounds;
  for (const char* name :
       {"relative", "running_4", "running_1", "constant", "fixed_norm", "fixed_constant",
        "fixed_running", "block_norm", "block_constant", "block_running", "fixed_norm_g2"}) {
    bounds.push_back(settings::parse_bound(name).value());
  }
  return bounds;
}

ComponentQuery everything_of(const scene::Scene& scene) {
  ComponentQuery query;
  query.kinds = {measured::component_kinds.begin(), measured::component_kinds.end()};
  query.kinds.erase(measured::ComponentKind::unit);
  for (int precision = 4; precision <= 24; ++precision) query.precisions.push_back(precision);
  query.bounds = usual_bounds();
  // Its constants are measured on the data, which takes long: only where the scene asks for it.
  if (scene.reduced.is_profiled) query.bounds.push_back({.kind = BoundKind::profiled});
  query.multipliers = {scene::Multipliers::embedded, scene::Multipliers::logic,
                       scene::Multipliers::memory};
  query.initiation_intervals = {1, 4, 16};
  query.crossbars = {1, 2, 3, 4, 6, 8, 16, 32, 64};
  // A chain has as many lanes as candidates, which a crossbar's numbers of lanes cannot exceed.
  if (scene.system.engine.kind == scene::EngineKind::arg_min) query.crossbars = {1};
  return query;
}

using Choices = std::vector<std::string>;  ///< "section.key=value"

/// Clocks between which the registers of datapaths move.
std::vector<Choices> datapath_settings() {
  std::vector<Choices> all;
  for (const char* mhz : {"150", "200", "300", "400"}) {
    all.push_back({fmt::format("system.target_mhz={}", mhz)});
    all.push_back({fmt::format("system.target_mhz={}", mhz), "reference.sums=fused"});
  }
  return all;
}

/// Streams around lanes. Those that a scene refuses are left out.
std::vector<Choices> stream_settings() {
  std::vector<Choices> all = {{}};
  const std::vector<Choices> keys = {
      {"system.operands=carried", "system.operands=refetched"},
      {"system.lanes_per_group=1", "system.lanes_per_group=2", "system.lanes_per_group=4",
       "system.lanes_per_group=8", "system.lanes_per_group=16"},
      {"system.operand_memory=logic", "system.operand_memory=block"},
      {"system.request_beats=1", "system.request_beats=4", "system.request_beats=8"},
      {"system.order=tagged", "system.order=in_order"},
      {"system.counter_bits=0", "system.counter_bits=32"}};
  for (const Choices& key : keys) {
    std::vector<Choices> longer;
    for (const Choices& settings : all) {
      for (const std::string& value : key) {
        longer.push_back(settings);
        longer.back().push_back(value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

/// Streams depend on no lane but its latency.
ComponentQuery streams_of(const scene::Scene& scene) {
  ComponentQuery query = everything_of(scene);
  query.kinds = {measured::ComponentKind::fifo, measured::ComponentKind::crossbar,
                 measured::ComponentKind::reference_port};
  query.precisions = {8, 16};
  query.bounds.resize(2);
  query.bounds.push_back(settings::parse_bound("fixed_norm").value());
  query.multipliers = {scene::Multipliers::embedded};
  return query;
}

/// Whether Yosys maps a unit otherwise in the template around it: arbiters of four words at full
/// rate take two to five LUTs a bit by themselves, and one to two in a crossbar.
bool depends_on_surroundings(const rtl::TemplateInstance& instance) {
  const rtl::Instance arbiter{instance.module, "unit", instance.parameters, {}};
  const auto number = [&](const char* name) {
    return emit::template_parameter(arbiter, name).value_or(0);
  };
  return instance.module == "stream_arbiter" && number("INPUTS") >= 4 && number("HALF_RATE") == 0 &&
         number("BEAT_BITS") == 0;
}

using Candidates = std::map<std::string, std::vector<rtl::TemplateInstance>>;  ///< by template

/// Collects units, each once.
class Collector {
public:
  /// A scene that refuses the choices has no units with them.
  void add(const SceneRequest& request, const data::Comparisons* data, const Choices& choices,
           ComponentQuery (*query)(const scene::Scene&)) {
    std::vector<std::string> settings = request.settings;
    settings.insert(settings.end(), choices.begin(), choices.end());
    const Result<scene::Scene> scene = scene::load_scene(request.source, settings);
    if (!scene.ok()) return;
    components::ComponentMaker maker(*scene, data);
    (void)components::for_each_component(
        maker, query(*scene), [this](const components::Component& component) {
          for (const components::ComponentParts parts = component.parts();
               const components::Part& part : parts.instances)
            add(part.instance);
        });
  }

  /// At most `most` of each template, those whose hash is the least: a choice at random that only
  /// names decide. Delay lines are measured by the bit, and memories by depth and up to the width
  /// from which they repeat (UnitAreas::of): tools choose between kinds of memory, which no formula
  /// tells.
  Candidates chosen(std::size_t most) {
    Candidates chosen;
    for (auto& [name, instance] : units_) {
      if (!depends_on_surroundings(instance)) chosen[instance.module].push_back(instance);
    }
    for (auto& [module, units] : chosen) {
      std::sort(units.begin(), units.end(),
                [](const auto& a, const auto& b) { return hash_of(a) < hash_of(b); });
      units.resize(std::min(units.size(), most));
    }
    chosen["delay_line"] = delay_lines();
    chosen["dual_port_memory"] = memories();
    return chosen;
  }

  int count() const { return static_cast<int>(units_.size()); }

private:
  static std::vector<rtl::TemplateInstance> delay_lines() {
    constexpr int longest = 128;
    std::vector<rtl::TemplateInstance> lines;
    for (int length = 0; length <= longest; ++length) {
      lines.push_back({"delay_line", {{"WIDTH", 1LL}, {"LENGTH", length}}});
    }
    return lines;
  }

  static std::vector<rtl::TemplateInstance> memories() {
    constexpr int most_address_bits = 12;
    std::vector<rtl::TemplateInstance> memories;
    for (int bits = 1; bits <= most_address_bits; ++bits) {
      for (const int width :
           {1,  2,  3,  4,  5,  6,  7,  8,   10,  12,  14,  16,  18,  20,  24,  28,  32, 36,
            40, 48, 56, 64, 72, 80, 96, 128, 144, 192, 256, 288, 320, 384, 448, 512, 576}) {
        memories.push_back({"dual_port_memory", {{"WIDTH", width}, {"ADDRESS_BITS", bits}}});
      }
    }
    return memories;
  }

  static std::string hash_of(const rtl::TemplateInstance& instance) {
    return ContentHash().add(components::instance_name(instance)).hex();
  }
  void add(const rtl::TemplateInstance& instance) {
    if (!units_.emplace(components::instance_name(instance), instance).second) return;
    for (const rtl::TemplateInstance& part : components::parts_of_unit(instance)) add(part);
  }

  std::map<std::string, rtl::TemplateInstance> units_;
};

/// A library on its way into a file.
class LibraryFile {
public:
  LibraryFile(units::UnitAreas areas, fs::path path)
      : areas_(std::move(areas)), path_(std::move(path)) {}

  /// Whether the library has the unit, measured on today's template.
  bool has(const units::Unit& unit, const std::string& rtl) const {
    const units::TemplateAreas* const known = areas_.find(unit.module);
    return known != nullptr && known->rtl == rtl &&
           std::find(known->units.begin(), known->units.end(), unit) != known->units.end();
  }

  Result<Done> add(const std::vector<units::Unit>& units, const std::vector<devices::Area>& areas,
                   const std::string& rtl) {
    const std::lock_guard lock(mutex_);
    const std::string& module = units.front().module;
    const units::TemplateAreas* const known = areas_.find(module);
    units::TemplateAreas all;
    if (known != nullptr && known->rtl == rtl) all = *known;
    all.module = module;
    all.rtl = rtl;
    all.units.insert(all.units.end(), units.begin(), units.end());
    all.areas.insert(all.areas.end(), areas.begin(), areas.end());
    areas_.set(sorted(all));
    return write_file(path_, areas_.text());
  }

private:
  static units::TemplateAreas sorted(const units::TemplateAreas& areas) {
    std::map<units::Unit, devices::Area> rows;
    for (std::size_t k = 0; k < areas.units.size(); ++k) rows[areas.units[k]] = areas.areas[k];
    units::TemplateAreas result{.module = areas.module, .rtl = areas.rtl, .units = {}, .areas = {}};
    for (const auto& [unit, area] : rows) {
      result.units.push_back(unit);
      result.areas.push_back(area);
    }
    return result;
  }

  units::UnitAreas areas_;
  fs::path path_;
  std::mutex mutex_;
};

Result<units::UnitAreas> new_library(const std::string& synthesis) {
  MIXCMP_TRY(shipped, units::shipped_libraries());
  for (units::UnitAreas& library : shipped) {
    if (library.holds_for(synthesis)) return std::move(library);
  }
  return units::UnitAreas(synthesis);
}

Result<units::UnitAreas> started_library(const UnitsRequest& request) {
  if (!path_exists(request.library)) return new_library(request.device.synthesis);
  MIXCMP_TRY(text, read_file(request.library));
  MIXCMP_TRY(areas, units::UnitAreas::read(text, request.library));
  if (areas.holds_for(request.device.synthesis)) return areas;
  return Error{.file = request.library.string(),
               .field = "synthesis",
               .message = "a library of another synthesis command",
               .received = areas.synthesis(),
               .accepted = request.device.synthesis};
}

Result<Done> check_templates(const std::set<std::string>& templates, const Candidates& candidates) {
  std::vector<std::string> known;
  for (const auto& [name, instances] : candidates) known.push_back(name);
  for (const std::string& name : templates) {
    if (candidates.contains(name)) continue;
    return Error{.field = "template",
                 .message = "these scenes have no units of it",
                 .received = name,
                 .accepted = fmt::format("{}", fmt::join(known, ", "))};
  }
  return Done{};
}

/// Units of one template that one run of Yosys maps.
struct Batch {
  std::vector<rtl::TemplateInstance> instances;
  std::string rtl;
};

std::vector<Batch> batches_of(const Candidates& candidates, const std::set<std::string>& templates,
                              const LibraryFile& library, UnitsReport& report) {
  std::vector<Batch> batches;
  for (const auto& [module, instances] : candidates) {
    if (!templates.empty() && !templates.contains(module)) continue;
    const std::string rtl = components::template_hash(module);
    std::vector<rtl::TemplateInstance> missing;
    for (const rtl::TemplateInstance& instance : instances) {
      if (library.has(components::unit_of(instance), rtl))
        ++report.kept;
      else
        missing.push_back(instance);
    }
    for (std::size_t first = 0; first < missing.size(); first += batch_units) {
      const std::size_t last = std::min(first + batch_units, missing.size());
      batches.push_back({{missing.begin() + static_cast<std::ptrdiff_t>(first),
                          missing.begin() + static_cast<std::ptrdiff_t>(last)},
                         rtl});
    }
  }
  return batches;
}

Result<Done> measure(const Batch& batch, const UnitsRequest& request, LibraryFile& library,
                     const fs::path& folder, const std::atomic<bool>& cancelled) {
  const ToolLimits limits = {.seconds = seconds_of_a_batch, .cancelled = &cancelled};
  MIXCMP_TRY(areas, characterise::map_units(components::unit_batch(batch.instances), request.device,
                                            limits, folder));
  if (cancelled) return Error{.message = "interrupted"};
  std::vector<units::Unit> units;
  for (const auto& instance : batch.instances) units.push_back(components::unit_of(instance));
  return library.add(units, areas, batch.rtl);
}

}  // namespace

Result<UnitsReport> make_unit_library(const UnitsRequest& request) {
  MIXCMP_TRY(started, started_library(request));
  MIXCMP_TRY(tools,
             characterise::tool_versions(request.device, characterise::TimingEffort::area_only));
  Collector collector;
  for (SceneRequest scene : request.scenes) {
    scene.settings.push_back("system.device=" + request.device.name);
    MIXCMP_TRY(loaded, load(scene));
    for (const Choices& choices : datapath_settings()) {
      collector.add(scene, loaded.data_if_any(), choices, everything_of);
    }
    for (const Choices& choices : stream_settings()) {
      collector.add(scene, loaded.data_if_any(), choices, streams_of);
    }
  }
  UnitsReport report{.candidates = collector.count()};
  LibraryFile library(std::move(started), request.library);
  const Candidates candidates =
      collector.chosen(static_cast<std::size_t>(request.units_of_a_template));
  MIXCMP_DO(check_templates(request.templates, candidates));
  const std::vector<Batch> batches = batches_of(candidates, request.templates, library, report);
  std::vector<characterise::Work> all;
  for (const Batch& batch : batches) {
    const std::string& module = batch.instances.front().module;
    all.push_back({fmt::format("{}.{}", module, all.size()),
                   fmt::format("{} units of {}", batch.instances.size(), module),
                   [&](const fs::path& folder, const std::atomic<bool>& cancelled) {
                     return measure(batch, request, library, folder, cancelled);
                   }});
    report.measured += static_cast<int>(batch.instances.size());
  }
  const int count = static_cast<int>(all.size());
  MIXCMP_TRY(run, characterise::run_work(all, request.library.string() + ".work", request.workers,
                                         [&](int finished, double seconds) {
                                           if (request.progress) {
                                             request.progress(finished, count, seconds);
                                           }
                                         }));
  report.failed = std::move(run.failed);
  report.interrupted_by = run.interrupted_by;
  return report;
}

}  // namespace mixcmp::tasks
