#include "generator/synthesis/components/component_maker.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>

#include "generator/hardware/datapath/delays.hpp"
#include "generator/hardware/datapath/schedule.hpp"
#include "generator/hardware/rtl/arg_min_module.hpp"
#include "generator/hardware/rtl/channel_modules.hpp"
#include "generator/hardware/rtl/datapath_builder.hpp"
#include "generator/hardware/rtl/lane_module.hpp"
#include "generator/hardware/rtl/reference_module.hpp"
#include "generator/hardware/rtl/system_modules.hpp"
#include "generator/synthesis/components/engine_components.hpp"
#include "generator/synthesis/components/synthesis_jobs.hpp"
#include "model/base/common/cases.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/number/lane_format.hpp"
#include "model/design/design.hpp"
#include "model/design/request_beats.hpp"
#include "model/design/slots.hpp"
#include "model/plan/profile/profile.hpp"
#include "model/scene/lane_bound.hpp"

namespace mixcmp::components {
namespace {

using measured::ComponentKey;
using scene::Multipliers;

/// The number of comparisons on which the constants of profiled lanes are measured, as for
/// `generate`.
constexpr std::uint64_t constant_samples = 100'000;
/// The slots of lanes with 11 to 42 cycles. For other lanes a request is a bit narrower or wider.
constexpr int crossbar_slot_bits = 6;
constexpr int crossbar_radix = 4;
constexpr int answer_cycles = 2;

/// A key without a kind of multipliers is of a datapath without products.
Multipliers multipliers_of(const std::optional<Multipliers>& multipliers) {
  return multipliers.value_or(Multipliers::embedded);
}

template <class Nodes>
bool any_product(const Nodes& nodes) {
  return std::any_of(nodes.begin(), nodes.end(), [](const auto& node) {
    return node.operation == Operation::multiply || node.operation == Operation::square;
  });
}

bool has_product(const TypedGraph& reference) {
  return any_product(reference.nodes) ||
         std::any_of(reference.nodes.begin(), reference.nodes.end(), [](const TypedNode& node) {
           return std::any_of(node.terms.begin(), node.terms.end(),
                              [](const FusedTerm& term) { return term.is_product(); });
         });
}

bool has_product(const design::ReferenceDatapath& reference) {
  return std::visit(Cases{[](const TypedGraph& graph) { return has_product(graph); },
                          [](const fixed::FixedLane& made) { return any_product(made.nodes); }},
                    reference);
}

bool has_product(const design::Lane& lane) {
  return std::visit(Cases{[](const error::Lane& made) { return any_product(made.graph.nodes); },
                          [](const fixed::FixedLane& made) { return any_product(made.nodes); }},
                    lane);
}

/// The key as tables have it: without a kind of multipliers if there is no product.
ComponentKey listed(const ComponentKey& key, bool has_product) {
  return has_product ? key : without_multipliers(key);
}

/// The slowest lane that these slots serve at full rate: the one with the longest delays.
std::optional<int> slowest_lane(int slots, const rtl::SystemShape& shape) {
  std::optional<int> slowest;
  for (int cycles = 1;; ++cycles) {
    const int needed = design::slots_for(cycles + shape.input_registers, shape.recomputes());
    if (needed > slots) return slowest;
    if (needed == slots) slowest = cycles;
  }
}

int tree_levels(int inputs) {
  int levels = 1;
  for (int reach = crossbar_radix; reach < inputs; reach *= crossbar_radix) ++levels;
  return levels;
}

Error out_of_range(const std::string& field, int received, const std::string& accepted) {
  return {.field = field,
          .message = "out of range",
          .received = fmt::format("{}", received),
          .accepted = accepted};
}

}  // namespace

characterise::SynthesisJob Component::job() const {
  return std::visit(
      Cases{[](const rtl::TemplateInstance& instance) { return template_job(instance); },
            [](const std::vector<rtl::Module>& modules) { return modules_job(modules); }},
      hardware);
}

ComponentParts Component::parts() const {
  return std::visit(
      Cases{[](const rtl::TemplateInstance& instance) {
              return ComponentParts{.instances = {{instance}}, .statements = {}};
            },
            [](const std::vector<rtl::Module>& modules) { return parts_of(modules); }},
      hardware);
}

Result<LaneRtl> lane_rtl(const std::vector<std::string>& inputs, const design::Lane& lane,
                         Multipliers multipliers, const scene::SystemSpec& system) {
  MIXCMP_TRY(delays, datapath::delays_of(system.device));
  const datapath::Schedule schedule =
      datapath::schedule_lane(lane, multipliers, delays, system.target_mhz);
  return LaneRtl{schedule.latency_cycles, rtl::lane_module("lane", inputs, lane, schedule)};
}

measured::Reference reference_key(const scene::Scene& scene,
                                  const design::ReferenceStructure& structure) {
  return {.format = design::datapath_format(scene),
          .multipliers = structure.multipliers,
          .sums = scene.reference.sums,
          .initiation_interval = structure.initiation_interval,
          .target_mhz = structure.own_target_mhz(scene.system.target_mhz)};
}

ComponentMaker::ComponentMaker(scene::Scene scene, const data::Comparisons* data)
    : scene_(std::move(scene)), data_(data) {}

void ComponentMaker::use_system_of(const scene::Scene& other) {
  scene_.system = other.system;
  scene_.reference_structure = other.reference_structure;
}

Result<Component> ComponentMaker::make(const ComponentKey& key) {
  return std::visit([this](const auto& component) { return made(component); }, key);
}

Result<Component> ComponentMaker::made(const measured::Unit& key) {
  MIXCMP_TRY(instance, instance_of_name(key.name));
  return Component{key, 0, instance};
}

Result<design::Lane> ComponentMaker::lane(const measured::Lane& key) {
  const auto known = lanes_.find(key);
  return known == lanes_.end() ? lanes_.emplace(key, designed(key)).first->second : known->second;
}

Result<design::Lane> ComponentMaker::designed(const measured::Lane& key) {
  const Multipliers multipliers = multipliers_of(key.multipliers);
  scene::ReducedSpec reduced = scene::with_bound(scene_.reduced, key.bound);
  reduced.format = key.format.floating;
  reduced.fixed_point = key.format.fixed_point;
  if (reduced.format) {
    MIXCMP_CHECK(key.inputs.has_value());
    reduced.inputs = *key.inputs;
  }
  reduced.multipliers = multipliers;
  if (key.bound.is_profiled()) {
    MIXCMP_DO(give_constants(reduced));
  }
  MIXCMP_TRY(made, design::design_lane(scene_, reduced, nullptr));
  MIXCMP_DO(design::check_multipliers(made, multipliers));
  return made;
}

Result<Component> ComponentMaker::made(const measured::Lane& key) {
  if (has_engine()) return made_word_lane(key);
  MIXCMP_TRY(lane, this->lane(key));
  MIXCMP_TRY(built,
             lane_rtl(scene_.graph.inputs(), lane, multipliers_of(key.multipliers), scene_.system));
  return Component{listed(key, has_product(lane)), built.latency_cycles, std::vector{built.module}};
}

Result<Component> ComponentMaker::made_word_lane(const measured::Lane& key) {
  MIXCMP_TRY(lane, this->lane(key));
  MIXCMP_TRY(parts, engine_parts(key));
  return Component{listed(key, has_product(lane)), parts.lane_latency_cycles(),
                   std::vector{parts.lane()}};
}

Result<Done> ComponentMaker::check_reference(const measured::Reference& key) const {
  const auto other = [](const char* field, std::string_view received, std::string_view accepted) {
    return Error{.field = field,
                 .message = "not the scene's",
                 .received = in_quotes(received),
                 .accepted = std::string(accepted)};
  };
  const LaneFormat format = design::datapath_format(scene_);
  if (key.format != format) return other("reference.format", key.format.name(), format.name());
  const Sums sums = scene_.reference.sums;
  if (key.sums != sums) return other("reference.sums", to_string(key.sums), to_string(sums));
  if (key.multipliers != Multipliers::memory) return Done{};
  return Error{.message = "not a choice",
               .received = in_quotes(to_string(key.multipliers)),
               .accepted = "embedded, logic"};
}

Result<datapath::Schedule> ComponentMaker::reference_schedule(
    const measured::Reference& key, const design::ReferenceDatapath& datapath) const {
  MIXCMP_DO(check_reference(key));
  MIXCMP_TRY(delays, datapath::delays_of(scene_.system.device));
  return datapath::schedule_reference(datapath,
                                      {multipliers_of(key.multipliers), key.initiation_interval},
                                      delays, key.target_mhz.value_or(scene_.system.target_mhz));
}

Result<Component> ComponentMaker::made(const measured::Reference& key) {
  MIXCMP_TRY(datapath, design::reference_datapath(scene_));
  MIXCMP_TRY(schedule, reference_schedule(key, datapath));
  return Component{
      listed(key, has_product(datapath)), schedule.latency_cycles,
      std::vector{rtl::reference_module("reference", scene_.graph.inputs(), datapath, schedule)}};
}

Result<Component> ComponentMaker::made(const measured::ReferencePort& key) {
  MIXCMP_TRY(datapath, design::reference_datapath(scene_));
  MIXCMP_TRY(schedule, reference_schedule(key.reference, datapath));
  MIXCMP_TRY(shape, request_shape());
  return Component{listed(key, has_product(datapath)), 0,
                   rtl::reference_port_template(shape, schedule)};
}

Result<Component> ComponentMaker::made(const measured::SecondLane& key) {
  constexpr settings::Limits slots = {8, 4096};
  if (!slots.allow(key.slots) || !std::has_single_bit(static_cast<unsigned>(key.slots))) {
    return out_of_range("ports", key.slots, "a power of two, " + to_string(slots));
  }
  MIXCMP_TRY(lane, this->lane(key.lane));
  MIXCMP_TRY(delays, datapath::delays_of(scene_.system.device));
  MIXCMP_TRY(shape, request_shape());
  datapath::Schedule schedule = datapath::schedule_lane(lane, multipliers_of(key.lane.multipliers),
                                                        delays, scene_.system.target_mhz);
  const int latency_cycles = schedule.latency_cycles;
  shape.second_tier_slot_bits = std::countr_zero(static_cast<unsigned>(key.slots));
  shape.second_tier = rtl::DatapathGroup{.datapath = "lane",
                                         .operands = shape.operand_ports(),
                                         .channel = "second_lane",
                                         .label = {},
                                         .schedule = std::move(schedule),
                                         .count = settings::limits::lanes.most};  // widest numbers
  const rtl::Module datapath =
      rtl::lane_module("lane", scene_.graph.inputs(), lane, shape.second_tier->schedule);
  return Component{listed(key, has_product(lane)), latency_cycles,
                   std::vector{datapath, rtl::second_tier_channel_module(shape)}};
}

rtl::SystemShape ComponentMaker::stream_shape() const {
  scene::SystemSpec system = scene_.system;
  const std::vector<OperandFormat>& formats = scene_.operand_formats;
  const std::optional<int> interval = scene_.reference_structure.initiation_interval;
  system.request_beats = design::request_beats(system, total_width(formats), interval.value_or(1));
  rtl::SystemShape shape = emit::stream_shape(scene_.graph.inputs(), formats, system);
  shape.lanes = shape.lanes_per_group;
  shape.references = scene_.system.references.value_or(1) > 0 ? 1 : 0;
  return shape;
}

Result<rtl::SystemShape> ComponentMaker::request_shape() const {
  rtl::SystemShape shape = stream_shape();
  shape.references = 1;
  if (!has_crossbar()) return rtl::reference_shape(shape);
  // Numbered as in the largest system: a few bits more than most.
  const int most = settings::limits::lanes_in_groups(shape.lanes_per_group).most;
  shape.lanes = most / shape.lanes_per_group * shape.lanes_per_group;
  shape.slot_bits = crossbar_slot_bits;
  if (has_engine()) {
    MIXCMP_TRY(chain, this->chain());
    shape.lanes = chain.engine.capacity - 1;
    shape.asking_bits = rtl::asking_bits(chain.engine, chain.place_bits);
  }
  return shape;
}

Result<ComponentMaker::Chain> ComponentMaker::chain() const {
  MIXCMP_TRY(scene, design::with_chain_lanes(scene_, data_));
  rtl::SystemShape shape = stream_shape();
  shape.lanes = *scene.lane_count();
  return Chain{.engine = *rtl::engine_shape(shape, scene.graph.inputs(), scene.system.engine),
               .place_bits = rtl::place_bits(shape.lanes, crossbar_slot_bits, 0)};
}

Result<std::vector<int>> ComponentMaker::engine_sizes() const {
  MIXCMP_TRY(scene, design::with_chain_lanes(scene_, data_));
  return measured_segments(scene);
}

Result<EngineParts> ComponentMaker::engine_parts(const measured::Lane& key,
                                                 std::optional<int> segments) {
  MIXCMP_TRY(scene, design::with_chain_lanes(scene_, data_));
  const bool is_chain = engine().kind == scene::EngineKind::arg_min;
  const int own = is_chain ? *scene.lane_count() : engine().lanes_per_segment();
  MIXCMP_TRY(lanes, lane_group(key, segments ? *segments * engine().lanes_per_segment() : own));
  return EngineParts::make(scene_, lanes);
}

Result<Component> ComponentMaker::made(const measured::Fifo& key) {
  rtl::SystemShape shape = stream_shape();
  const std::optional<int> slowest = slowest_lane(key.slots, shape);
  if (!slowest) return out_of_range("slots", key.slots, "a power of two that some lane needs");
  shape.slot_bits = std::countr_zero(static_cast<unsigned>(key.slots));
  return Component{key, shape.channel_latency_cycles(), rtl::tracker_template(shape, *slowest)};
}

Result<Component> ComponentMaker::made(const measured::Crossbar& key) {
  if (!measured_ports.allow(key.lanes)) {
    return out_of_range("ports", key.lanes, to_string(measured_ports));
  }
  MIXCMP_TRY(shape, request_shape());
  rtl::TemplateInstance crossbar = rtl::crossbar_template(shape, shape.references);
  for (rtl::Parameter& parameter : crossbar.parameters) {
    if (parameter.name == "LANES") parameter.value = key.lanes;
  }
  const int beat_latency = shape.beat_bits == 0 ? 1 : 2;  // of the first beat, at each level
  return Component{key, beat_latency * tree_levels(key.lanes) + answer_cycles, crossbar};
}

Result<design::LaneGroup> ComponentMaker::lane_group(const measured::Lane& key, int count) {
  MIXCMP_TRY(lane, this->lane(key));
  return design::LaneGroup{.lane = std::move(lane),
                           .inputs = key.inputs.value_or(LaneInputs::exact),
                           .multipliers = multipliers_of(key.multipliers),
                           .count = count};
}

Result<Component> ComponentMaker::made(const measured::Segment& key) {
  if (key.lanes != engine().lanes_per_segment()) {
    const char* const reason = engine().kind == scene::EngineKind::pairwise
                                   ? ", as engine.lanes_per_group says"
                                   : ": each lane of the chain by itself";
    return out_of_range("ports", key.lanes,
                        fmt::format("{}{}", engine().lanes_per_segment(), reason));
  }
  MIXCMP_TRY(lane, this->lane(key.lane));
  MIXCMP_TRY(parts, engine_parts(key.lane));
  return Component{listed(key, has_product(lane)), parts.lane_latency_cycles(), parts.segment()};
}

Result<bool> ComponentMaker::converts(const measured::Lane& key) {
  if (!key.format.fixed_point || key.format.fixed_point->is_block) return false;
  MIXCMP_TRY(parts, engine_parts(key));
  return parts.converts();
}

Result<Component> ComponentMaker::made(const measured::Conversion& key) {
  MIXCMP_TRY(lane, this->lane(key.lane));
  MIXCMP_TRY(parts, engine_parts(key.lane));
  if (!parts.converts()) {
    return Error{.field = "format",
                 .message = "lanes of this format take items as they arrive",
                 .received = in_quotes(key.lane.format.name()),
                 .accepted = "lanes in fixed point, such as q13"};
  }
  return Component{listed(key, has_product(lane)), parts.conversion_latency_cycles(),
                   parts.conversion()};
}

Result<Component> ComponentMaker::made(const measured::Engine& key) {
  MIXCMP_TRY(lane, this->lane(key.lane));
  MIXCMP_TRY(parts, engine_parts(key.lane, key.segments));
  return Component{listed(key, has_product(lane)), 0, parts.engine()};
}

Result<Component> ComponentMaker::made(const measured::OperandMemory& key) const {
  if (!settings::limits::references.allow(key.references) || key.references < 1) {
    return out_of_range("ports", key.references, fmt::format("1..{}", scene::max_references));
  }
  MIXCMP_TRY(chain, this->chain());
  return Component{key, 0,
                   rtl::operand_memory_template(chain.engine, chain.place_bits, key.references)};
}

Result<Done> ComponentMaker::give_constants(scene::ReducedSpec& lane) {
  if (lane.relative_error_f && lane.relative_error_g) return Done{};
  if (!constants_.contains(lane.inputs)) {
    MIXCMP_TRY(measured, measure_constants(lane.inputs));
  }
  const auto& of_inputs = constants_.at(lane.inputs);
  const auto found = of_inputs.find(lane.format->precision());
  if (found == of_inputs.end()) {
    return out_of_range("precision", lane.format->precision(), "what a profile measures");
  }
  if (!lane.relative_error_f) lane.relative_error_f = found->second.first;
  if (!lane.relative_error_g) lane.relative_error_g = found->second.second;
  if (lane.relative_error_f && lane.relative_error_g) return Done{};
  return Error{
      .field = lane.relative_error_f ? "reduced.relative_error_g" : "reduced.relative_error_f",
      .message = "cannot be measured: no comparison of the data has a relative error",
      .received = fmt::format("lanes of {} digits", lane.format->precision()),
      .accepted = "other data, or the constant itself"};
}

Result<Done> ComponentMaker::measure_constants(LaneInputs inputs) {
  if (data_ == nullptr) {
    return Error{.field = "reduced.relative_error_f, reduced.relative_error_g",
                 .message = "a profiled bound needs its constants, or data to measure them on",
                 .received = "neither",
                 .accepted = "both constants, or a [data] section"};
  }
  scene::Scene scene = scene_;
  // A profiled lane checks no range: its exponents reach as far as the reference's.
  if (scene.reduced.exponent_bits_from_ranges) scene.reduced.format.reset();
  const profile::ProfileOptions options{
      .last_precision = settings::lane_precisions(scene.reference.format).most,
      .error_samples = constant_samples};
  MIXCMP_DO(check_profile(scene, options));
  const auto measured = profile_errors(scene, *data_, {inputs}, options);
  for (const profile::ErrorAtPrecision& error : measured.front().precisions) {
    constants_[inputs][error.precision] = {error.f, error.g};
  }
  return Done{};
}

}  // namespace mixcmp::components
