#include "generator/synthesis/components/imported_rows.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>

#include "generator/hardware/emit/scheduled_system.hpp"
#include "generator/synthesis/characterise/job_hash.hpp"
#include "generator/synthesis/components/synthesis_jobs.hpp"
#include "model/base/common/cases.hpp"
#include "model/scene/lane_bound.hpp"

namespace mixcmp::components {
namespace {

using characterise::InstanceArea;
using devices::Area;
using measured::Measurement;

constexpr int Area::*all_resources[] = {&Area::luts,     &Area::registers, &Area::dsps,
                                        &Area::memories, &Area::carries,   &Area::shift_luts};

/// `area` times numerator / denominator, rounded up.
Area scaled(const Area& area, int numerator, int denominator) {
  Area part;
  for (const auto resource : all_resources) {
    const long long product = static_cast<long long>(area.*resource) * numerator;
    part.*resource = static_cast<int>((product + denominator - 1) / denominator);
  }
  return part;
}

bool is_same_rtl(const characterise::SynthesisJob& one, const characterise::SynthesisJob& other) {
  return std::equal(
      one.sources.begin(), one.sources.end(), other.sources.begin(), other.sources.end(),
      [](const auto& a, const auto& b) { return a.name == b.name && a.text == b.text; });
}

/// The bounds that a lane may be listed under: its own, or any where its parts have several.
std::vector<Bound> possible_bounds(const design::Lane& lane) {
  return std::visit(
      Cases{[](const error::Lane& made) {
              const auto own = scene::bound_of(made);
              if (own) return std::vector{*own};
              const auto all = counted_bounds();
              return std::vector<Bound>(all.begin(), all.end());
            },
            [](const fixed::FixedLane& made) { return std::vector{scene::bound_of(made)}; }},
      lane);
}

/// Instances are numbered through the groups of lanes and of references.
using PathOf = std::function<std::string(int number)>;

class Importer {
public:
  Importer(const scene::Scene& scene, const data::Comparisons* data, const design::Design& design,
           const ImportedReports& reports)
      : maker_(scene, data), design_(design), reports_(reports) {}

  Result<std::vector<ImportedRow>> run() {
    if (design_.system.engine.kind != scene::EngineKind::none) return no_rows_of_an_engine();
    MIXCMP_TRY(scheduled, emit::schedule_system(design_));
    shape_ = std::move(scheduled.shape);
    MIXCMP_TRY(lanes, add_lanes());
    MIXCMP_DO(add_fifos());
    if (shape_.recomputes()) {
      MIXCMP_TRY(references, add_references());
      MIXCMP_TRY(crossbar, add_crossbar());
    }
    return std::move(rows_);
  }

private:
  /// The lanes of an engine begin behind the conversion; those of rows do not.
  Error no_rows_of_an_engine() const {
    return {
        .field = "engine.kind",
        .message = "the lanes of an engine read words of its items, of which a table has no rows",
        .received = std::string(to_string(design_.system.engine.kind)),
        .accepted = "none: generate and compile the system with --set engine.kind=none"};
  }

  std::string path(const rtl::DatapathGroup& group, int number, const std::string& part) const {
    return fmt::format("g_{}[{}].channel/{}", group.label, number, part);
  }

  /// The path of lane `number`, which is in a loop of its group's channel if it has a group.
  std::string lane_path(const rtl::DatapathGroup& group, int number) const {
    const int lanes = shape_.lanes_per_group;
    if (lanes == 1) return path(group, number, "lane");
    return path(group, number / lanes, fmt::format("g_lanes[{}].lane", number % lanes));
  }

  Result<Area> area_of(const std::string& path) const {
    const auto& instances = reports_.areas.instances;
    const auto found = std::find_if(instances.begin(), instances.end(),
                                    [&](const InstanceArea& each) { return each.path == path; });
    if (found != instances.end()) return found->area;
    return Error{.file = reports_.areas.file.string(),
                 .line = instances.empty() ? 0 : instances.front().line,
                 .message = "the table of instances lacks one of the system's",
                 .received = fmt::format("{} instances without {}", instances.size(), path),
                 .accepted = "a report down to that depth, of a system whose hierarchy is kept"};
  }

  Result<Area> sum_of(int first, int count, const PathOf& path) const {
    Area sum;
    for (int number = first; number < first + count; ++number) {
      MIXCMP_TRY(area, area_of(path(number)));
      sum += area;
    }
    return sum;
  }

  void add(const Component& component, int latency_cycles, const Area& area, int instances) {
    const std::string tool = fmt::format("{}, {}", reports_.areas.tool, reports_.part);
    Measurement row{.key = component.key,
                    .latency_cycles = latency_cycles,
                    .area = area,
                    .clock = {},
                    .hash = characterise::imported_hash(component.job, tool),
                    .tools = tool,
                    .stage = reports_.areas.stage};
    if (reports_.timing) {
      const double mhz = reports_.timing->mhz.value();
      row.timing_seeds = 1;
      row.clock = measured::Clock{.mhz = mhz,
                                  .low_mhz = mhz,
                                  .high_mhz = mhz,
                                  .seeds = 1,
                                  .source = measured::ClockSource::routed};
    }
    // Groups without a product may differ only in their multipliers, which no key names then.
    const auto twin = std::find_if(rows_.begin(), rows_.end(), [&](const ImportedRow& known) {
      return known.row.key == row.key;
    });
    if (twin == rows_.end()) return rows_.push_back({std::move(row), instances});
    const Area sum = twin->instances * twin->row.area + instances * area;
    twin->instances += instances;
    twin->row.area = scaled(sum, 1, twin->instances);
  }

  /// The component whose RTL equals that of these lanes. A row of the table names them by its key.
  Result<Component> component_of(const design::LaneGroup& group) {
    MIXCMP_TRY(built, lane_rtl(design_.inputs, group.lane, group.multipliers, design_.system));
    const characterise::SynthesisJob wanted = module_job(built.module);
    MIXCMP_TRY(format, LaneFormat::parse(design::format_name(group.lane)));
    measured::Lane key{.format = format, .inputs = {}, .multipliers = group.multipliers};
    if (const auto* lane = std::get_if<error::Lane>(&group.lane)) {
      key.inputs = group.inputs.in_lane(lane->graph.arithmetic.format.precision(),
                                        maker_.scene().reference.format.precision());
    }
    for (const Bound& bound : possible_bounds(group.lane)) {
      key.bound = bound;
      Result<Component> component = maker_.make(key);
      if (component.ok() && is_same_rtl(component->job, wanted)) return component;
    }
    return Error{
        .field = "reduced",
        .message = "a table has no row for such lanes, which characterise does not make",
        .received = fmt::format("{}: {}", format.name(), design::describe_criterion(group.lane)),
        .accepted = "lanes of one of the kinds that mixcmp characterise measures"};
  }

  Result<Done> add_lanes() {
    for (std::size_t k = 0; k < design_.lanes.size(); ++k) {
      const rtl::DatapathGroup& group = shape_.lane_groups[k];
      MIXCMP_TRY(component, component_of(design_.lanes[k]));
      MIXCMP_TRY(sum, sum_of(group.first, group.count,
                             [&](int number) { return lane_path(group, number); }));
      add(component, component.latency_cycles, scaled(sum, 1, group.count), group.count);
    }
    return Done{};
  }

  Result<Done> add_fifos() {
    Area sum;
    for (const rtl::DatapathGroup& group : shape_.lane_groups) {
      const int lanes = shape_.lanes_per_group;
      MIXCMP_TRY(area, sum_of(group.first / lanes, group.count / lanes,
                              [&](int number) { return path(group, number, "tracker"); }));
      sum += area;
    }
    MIXCMP_TRY(component, maker_.make(measured::Fifo{1 << shape_.slot_bits}));
    add(component, component.latency_cycles, scaled(sum, 1, shape_.channels()), shape_.channels());
    return Done{};
  }

  Result<Done> add_references() {
    for (std::size_t k = 0; k < design_.references.size(); ++k) {
      const rtl::DatapathGroup& group = shape_.reference_groups[k];
      MIXCMP_TRY(component,
                 maker_.make(reference_key(maker_.scene(), design_.references[k].structure)));
      MIXCMP_TRY(sum, sum_of(group.first, group.count,
                             [&](int number) { return path(group, number, "reference"); }));
      add(component, component.latency_cycles, scaled(sum, 1, group.count), group.count);
    }
    return Done{};
  }

  Result<Done> add_crossbar() {
    const int lanes = (shape_.channels() + shape_.references - 1) / shape_.references;
    if (!measured_ports.allow(lanes)) return Done{};
    MIXCMP_TRY(area, area_of("recomputation"));
    MIXCMP_TRY(component, maker_.make(measured::Crossbar{lanes}));
    add(component, component.latency_cycles, scaled(area, lanes, shape_.channels()), 1);
    return Done{};
  }

  ComponentMaker maker_;
  const design::Design& design_;
  const ImportedReports& reports_;
  rtl::SystemShape shape_;
  std::vector<ImportedRow> rows_;
};

}  // namespace

Result<std::vector<ImportedRow>> imported_rows(const scene::Scene& scene,
                                               const data::Comparisons* data,
                                               const design::Design& design,
                                               const ImportedReports& reports) {
  return Importer(scene, data, design, reports).run();
}

}  // namespace mixcmp::components
