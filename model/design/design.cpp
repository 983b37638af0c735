#include "model/design/design.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "model/base/common/cases.hpp"
#include "model/base/common/command_line.hpp"
#include "model/base/number/double.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/design/engine_data.hpp"
#include "model/design/request_beats.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/lane/error/exactness.hpp"
#include "model/lane/error/hazards.hpp"
#include "model/lane/error/range_analysis.hpp"
#include "model/lane/fixed/exact_lane.hpp"
#include "model/lane/fixed/square_tables.hpp"
#include "model/scene/reference_model.hpp"

namespace mixcmp::design {
namespace {

/// The number of comparisons that are measured for the paper's constants, RE_f and RE_g.
constexpr std::uint64_t profile_samples = 100'000;

/// The error for an unresolved "auto". It suggests `mixcmp optimise`, except for the lanes of an
/// arg-min engine: that verb also takes their number from the candidates.
Error unresolved(const scene::Scene& scene, const std::string& field, const std::string& option,
                 const std::string& accepted) {
  std::string ways = fmt::format("{}, in the scene or by {}", accepted, option);
  const bool is_chain = scene.system.engine.kind == scene::EngineKind::arg_min;
  if (!is_chain || field != "system.lanes") {
    ways += "; or a plan, made by: " +
            CommandLine("optimise", scene.path, scene.settings).add("-o", "plan.toml").text();
  }
  return {.field = field, .message = "is not chosen yet", .received = "\"auto\"", .accepted = ways};
}

/// The number of lanes in a group. If it is "auto", an arg-min engine gets a lane for each of the
/// data's candidates except the first.
Result<int> lane_count(const scene::Scene& scene, const scene::LaneGroupSpec& group,
                       const data::Comparisons* data) {
  if (group.count) return *group.count;
  if (scene.system.engine.kind != scene::EngineKind::arg_min || data == nullptr) {
    return unresolved(scene, "system.lanes", "--lanes 8", fmt::format("1..{}", scene::max_lanes));
  }
  const std::uint64_t candidates = data->tables()[1].rows();
  if (candidates <= scene::max_lanes + 1) return static_cast<int>(candidates - 1);
  return Error{.field = "system.lanes",
               .message = "the arg-min engine has a lane for each candidate but the first",
               .received = fmt::format("{} candidates", candidates),
               .accepted = fmt::format("data with at most {}", scene::max_lanes + 1)};
}

/// Measures the errors of each part.
std::vector<error::ProfiledError> profile_parts(const scene::Scene& scene, const TypedGraph& graph,
                                                const data::Comparisons& data,
                                                MeasureErrors measure) {
  const std::uint64_t seed = scene.data ? scene.data->seed : 1;
  std::vector<error::ProfiledError> parts;
  for (std::size_t k = 0; k < graph.parts.size(); ++k) {
    parts.push_back(
        measure(scene.graph.part(k), part_of(graph, k).graph, data, profile_samples, seed));
  }
  return parts;
}

/// The key of a constant that the scene does not give and that the data do not determine, because
/// in some part no comparison has that relative error.
std::optional<std::string> unmeasured_constant(const scene::ReducedSpec& reduced,
                                               const std::vector<error::ProfiledError>& parts) {
  for (const error::ProfiledError& part : parts) {
    const std::uint64_t all = part.comparisons;
    if (!reduced.relative_error_f && part.f_unbounded == all) return "reduced.relative_error_f";
    if (!reduced.relative_error_g && part.g_unbounded == all) return "reduced.relative_error_g";
  }
  return std::nullopt;
}

Result<error::Lane> design_profiled_lane(const scene::Scene& scene,
                                         const scene::ReducedSpec& reduced, const TypedGraph& graph,
                                         const data::Comparisons* data, MeasureErrors measure) {
  if (reduced.relative_error_f && reduced.relative_error_g) {
    return error::profiled_lane(graph, *reduced.relative_error_f, *reduced.relative_error_g);
  }
  if (data == nullptr || measure == nullptr) {
    return Error{.field = "reduced.relative_error_f, reduced.relative_error_g",
                 .message = "a profiled bound needs its constants, or data to measure them on",
                 .received = "neither",
                 .accepted = "both constants, or a [data] section"};
  }
  const std::vector<error::ProfiledError> parts = profile_parts(scene, graph, *data, measure);
  const bool any = std::any_of(parts.begin(), parts.end(), [](const error::ProfiledError& part) {
    return part.comparisons > 0;
  });
  if (!any) {
    return Error{.field = "reduced.bound",
                 .message = "no comparison of the data could be measured for the profile",
                 .received = fmt::format("{} comparisons, none with finite f and g", data->size()),
                 .accepted = "other data, or reduced.relative_error_f and relative_error_g"};
  }
  if (const auto unknown = unmeasured_constant(reduced, parts)) {
    return Error{
        .field = *unknown,
        .message = "cannot be measured: no comparison of the data has a relative error",
        .received = "computed values that are infinite, or miss a true zero",
        .accepted = "a format with more exponent bits, other data, or the constant itself"};
  }
  // The parts share one RE_f and one RE_g.
  mpq_class f = 0, g = 0;
  for (const error::ProfiledError& part : parts) {
    f = std::max(f, part.f);
    g = std::max(g, part.g);
  }
  return error::profiled_lane(graph, reduced.relative_error_f.value_or(f),
                              reduced.relative_error_g.value_or(g));
}

bool can_decide(const error::UlpDistanceCriterion& criterion, const error::Lane& lane) {
  const Bits largest = lane.graph.arithmetic.format.largest_finite(false);
  return criterion.guard_ulp <= (criterion.nonnegative ? largest : 2 * largest);
}

/// A constant bound can exceed every difference of checked operands.
bool can_decide(const error::AbsoluteBoundCriterion& criterion, const error::Lane& lane) {
  const error::BoundNode& bound = criterion.bound.nodes.back();
  if (bound.operation != error::BoundOperation::constant) return true;
  const auto ranges =
      error::analyse_ranges(lane.graph, error::checked_ranges(lane.graph, lane.checks));
  const Range& difference = ranges[static_cast<std::size_t>(criterion.difference)].value;
  return bound.constant < std::max<mpq_class>(abs(difference.low), abs(difference.high));
}

bool can_decide(const error::IntervalCriterion&, const error::Lane&) {
  return true;
}

/// Whether any two results can lie far enough apart for the lane to decide.
bool part_can_decide(const error::Lane& lane) {
  return std::visit([&](const auto& criterion) { return can_decide(criterion, lane); },
                    lane.criterion());
}

Error undecidable(const std::string& format) {
  return {
      .field = "reduced.format",
      .message = "the error bound exceeds every difference of f and g: nothing would be decided",
      .received = format,
      .accepted = "more precision, or f and g that differ by more"};
}

Result<error::Lane> design_certified_lane(const scene::Scene& scene,
                                          const scene::ReducedSpec& reduced,
                                          const TypedGraph& graph) {
  const error::CertifiedOptions options{
      .kind = reduced.error_bound, .bound_digits = reduced.bound_digits, .ranges = scene.ranges};
  MIXCMP_TRY(lane, certified_lane(graph, options));
  // One part that decides may suffice for the verdict.
  for (std::size_t k = 0; k < lane.parts.size(); ++k) {
    if (part_can_decide(part_of(lane, k))) return lane;
  }
  return undecidable(lane.graph.arithmetic.format.name());
}

/// Refuses a bound that fixed-point lanes do not have.
Result<Done> check_fixed_bound(const scene::ReducedSpec& reduced) {
  if (reduced.is_profiled) {
    return Error{.field = "reduced.bound",
                 .message = "a lane in fixed point is certified",
                 .received = "profiled",
                 .accepted = "certified, or a format in floating point"};
  }
  if (reduced.error_bound != BoundKind::relative) return Done{};
  return Error{.field = "reduced.error_bound",
               .message = "not a bound of lanes in fixed point",
               .received = "relative",
               .accepted = "auto, constant, norm, running, grid"};
}

bool can_decide(const fixed::FixedLane&, const fixed::ConstantThresholds& thresholds,
                const fixed::FixedNode& difference) {
  const mpq_class unit = difference.format.unit();
  return thresholds.decides_ties || thresholds.greater_from * unit <= difference.value.high ||
         thresholds.less_to * unit >= difference.value.low;
}

bool can_decide(const fixed::FixedLane&, const fixed::RunningThresholds& thresholds,
                const fixed::FixedNode& difference) {
  const mpq_class unit = difference.format.unit();
  return std::any_of(thresholds.of_steps.begin(), thresholds.of_steps.end(),
                     [&](const mpz_class& threshold) {
                       return threshold * unit <= difference.value.high ||
                              -threshold * unit > difference.value.low;
                     });
}

/// `greater` is decided most easily if the radius is zero, `less` if it is the largest: -D grows
/// with its square, the threshold with the radius itself. A power of two above a root is less than
/// twice the root.
bool can_decide(const fixed::FixedLane& lane, const fixed::NormThresholds& thresholds,
                const fixed::FixedNode& difference) {
  const mpq_class unit = difference.format.unit();
  const fixed::FixedNode& radius = lane.nodes[static_cast<std::size_t>(thresholds.radius)];
  const mpq_class largest =
      thresholds.radius_is_squared ? root_of(radius.value.high, double_digits) : radius.value.high;
  const mpq_class per_radius = unit / power_of_two(thresholds.unit_exponent(lane.nodes));
  const mpq_class slope = power_of_two(thresholds.shift_below) * per_radius;
  return thresholds.offset_above * unit <= difference.value.high ||
         slope * largest < -difference.value.low;
}

/// Whether any two results can lie far enough apart for some part to be decided.
bool can_decide(const fixed::FixedLane& lane) {
  // A lane with reaches decides every number beyond one of them.
  if (std::any_of(lane.nodes.begin(), lane.nodes.end(), fixed::is_reach)) return true;
  return std::any_of(lane.parts.begin(), lane.parts.end(), [&](const fixed::FixedPart& part) {
    const fixed::FixedNode& difference = lane.nodes[static_cast<std::size_t>(part.difference)];
    return std::visit(
        [&](const auto& criterion) { return can_decide(lane, criterion, difference); },
        part.criterion);
  });
}

Result<fixed::FixedLane> design_fixed_lane(const scene::Scene& scene,
                                           const scene::ReducedSpec& reduced) {
  MIXCMP_DO(check_fixed_bound(reduced));
  const bool is_embedded = reduced.multipliers == scene::Multipliers::embedded;
  const fixed::FixedOptions options{
      .format = *reduced.fixed_point,
      .bound = reduced.error_bound,
      .ranges = scene.ranges,
      .grids = scene.grids,
      .operand_formats = scene.operand_formats,
      .products = is_embedded ? function::ProductKind::embedded : function::ProductKind::logic};
  MIXCMP_TRY(lane, fixed::fixed_lane(scene.graph, scene.reference.format, options));
  if (can_decide(lane)) return lane;
  return undecidable(reduced.format_name());
}

/// Gives an error without a file the place of the faulty lane group. For a group of [[lanes]] the
/// error names that table's key instead of the one in [reduced].
Error with_location(Error error, const scene::LaneGroupSpec& group) {
  constexpr std::string_view section = "reduced.";
  if (error.file.empty()) {
    error.file = group.place.file;
    error.line = group.place.line;
  }
  const bool in_list = group.place.line > 0;
  if (in_list && error.field.starts_with(section)) {
    error.field = "lanes." + error.field.substr(section.size());
  }
  return error;
}

Result<LaneGroup> design_group(const scene::Scene& scene, const scene::LaneGroupSpec& group,
                               const data::Comparisons* data, MeasureErrors measure) {
  const Result<Lane> lane = design_lane(scene, group.reduced, data, measure);
  if (!lane.ok()) return with_location(lane.error(), group);
  const auto possible = check_multipliers(*lane, group.reduced.multipliers);
  if (!possible.ok()) return with_location(possible.error(), group);
  MIXCMP_TRY(count, lane_count(scene, group, data));
  return LaneGroup{.lane = *lane,
                   .inputs = group.reduced.inputs_beside(scene.reference.format),
                   .multipliers = group.reduced.multipliers,
                   .count = count};
}

/// Refuses lanes that do not fill their groups.
Result<Done> check_whole_groups(const scene::Scene& scene) {
  const int group = scene.system.lanes_per_group;
  for (const scene::LaneGroupSpec& lanes : scene.lane_groups()) {
    if (!lanes.count || *lanes.count % group == 0) continue;
    return Error{.file = lanes.place.file,
                 .line = lanes.place.line,
                 .field = lanes.place.line > 0 ? "lanes.count" : "system.lanes",
                 .message = "lanes in lock step come in whole groups",
                 .received = fmt::format("{}", *lanes.count),
                 .accepted = fmt::format("a multiple of system.lanes_per_group, {}", group)};
  }
  return Done{};
}

/// Refuses more streams of reports than a pairwise engine has groups of lanes.
Result<Done> check_report_streams(const scene::Scene& scene) {
  const scene::EngineSpec& engine = scene.system.engine;
  int groups = 0;
  for (const scene::LaneGroupSpec& lanes : scene.lane_groups()) {
    if (!lanes.count) return Done{};
    groups += (*lanes.count + engine.lanes_per_group - 1) / engine.lanes_per_group;
  }
  if (engine.report_streams <= groups) return Done{};
  return Error{.field = "engine.report_streams",
               .message = "each group of lanes has one at most",
               .received = fmt::format("{}", engine.report_streams),
               .accepted = fmt::format("1..{}, or more groups, by more lanes or a smaller "
                                       "engine.lanes_per_group than {}",
                                       groups, engine.lanes_per_group)};
}

/// Checked here and not when the scene is read, since `optimise` chooses another number of lanes.
Result<Done> check_groups(const scene::Scene& scene) {
  switch (scene.system.engine.kind) {
    case scene::EngineKind::none: return check_whole_groups(scene);
    case scene::EngineKind::pairwise: return check_report_streams(scene);
    case scene::EngineKind::arg_min: return Done{};
  }
  MIXCMP_CHECK(false);
}

/// In a system of streams a second tier must have a known number of lanes, and references behind
/// it.
Result<Done> check_second_tier(const scene::Scene& scene) {
  if (!scene.second_tier || scene.system.engine.kind != scene::EngineKind::none) return Done{};
  if (!scene.second_tier_count) {
    return unresolved(scene, "second_tier.count", "--set second_tier.count=2",
                      to_string(settings::limits::lanes));
  }
  if (scene.reference_count() != 0) return Done{};
  return Error{
      .field = "second_tier.format",
      .message =
          "a second tier also needs a reference, for the comparisons that it leaves undecided",
      .received = "system.references = 0",
      .accepted = "system.references of at least 1, or second_tier.format = \"none\""};
}

/// The clock that the scene's plan expects, for display; empty if there is none. The plan's values
/// are as in TOML, so the words of its basis are in quotes.
std::string planned_clock(const scene::Scene& scene) {
  if (!scene.plan) return "";
  std::string clock, basis;
  for (const auto& [key, value] : scene.plan->values) {
    if (key == "clock_mhz") clock = value + " MHz";
    if (key == "clock_basis") basis = fmt::format(" ({})", value.substr(1, value.size() - 2));
  }
  return clock.empty() ? "" : clock + basis;
}

/// The lane of the scene's bits, or the exact lane of the fewest bits. Beside the latter the judges
/// compute in the reference format, which must not round either.
Result<fixed::FixedLane> design_fixed_reference(const scene::Scene& scene) {
  if (scene.reference_fixed_point) {
    MIXCMP_TRY(model, scene::reference_model(scene));
    return std::get<fixed::FixedLane>(std::move(model));
  }
  const bool is_chain = scene.system.engine.kind == scene::EngineKind::arg_min;
  const auto bits = fixed::exact_bits(scene.graph, scene.reference.format,
                                      {.ranges = {}, .operand_formats = scene.operand_formats},
                                      settings::limits::fixed_bits.most);
  if (!bits.ok()) {
    Error error = bits.error();
    error.field = "system.references";
    error.message = "a reference for operands in fixed point is an exact lane: " + error.message;
    if (!is_chain) error.accepted += ", or 0 references";
    return error;
  }
  const std::vector<bool> is_exact =
      error::exact_nodes(reference_graph(scene.graph, scene.reference), scene.ranges, scene.grids);
  if (std::find(is_exact.begin(), is_exact.end(), false) != is_exact.end()) {
    return Error{.field = "reference.format",
                 .message =
                     "references for operands in fixed point round nothing, but in this "
                     "format f or g is rounded",
                 .received = scene.reference.format.name(),
                 .accepted = "\"exact\" or a format of more digits, without a division" +
                             std::string(is_chain ? "" : "; or system.references = 0")};
  }
  return fixed::fixed_lane(scene.graph, scene.reference.format,
                           {.format = {.bits = *bits},
                            .bound = std::nullopt,
                            .ranges = {},
                            .operand_formats = scene.operand_formats});
}

Result<Design> choose(const scene::Scene& scene, const data::Comparisons* data,
                      MeasureErrors measure) {
  Design design{.name = scene.name,
                .inputs = scene.graph.inputs(),
                .lanes = {},
                .second_tier = {},
                .parts = scene.parts,
                .lets = scene.lets,
                .planned_clock = planned_clock(scene),
                .reference = reference_graph(scene.graph, scene.reference),
                .references = {},
                .system = scene.system,
                .operand_formats = scene.operand_formats};
  MIXCMP_DO(check_groups(scene));
  for (const scene::LaneGroupSpec& spec : scene.lane_groups()) {
    MIXCMP_TRY(group, design_group(scene, spec, data, measure));
    design.lanes.push_back(std::move(group));
  }
  MIXCMP_DO(check_second_tier(scene));
  MIXCMP_TRY(second_tier, design_second_tier(scene));
  design.second_tier = std::move(second_tier);
  std::optional<int> shortest;
  for (const scene::ReferenceGroupSpec& spec : scene.reference_groups()) {
    if (!spec.count) {
      // Lanes that could do without one have known formats, and then the number is known as well.
      const int fewest = scene.system.engine.kind == scene::EngineKind::arg_min ? 1 : 0;
      return unresolved(scene, "system.references", "--references 1",
                        fmt::format("{}..{}", fewest, scene::max_references));
    }
    if (*spec.count == 0) continue;
    const auto& [multipliers, interval, target_mhz] = spec.structure;
    if (!interval) {
      return unresolved(scene, "reference.initiation_interval",
                        "--set reference.initiation_interval=16",
                        to_string(settings::limits::initiation_interval));
    }
    design.references.push_back(
        {.structure = {multipliers, *interval, target_mhz}, .count = *spec.count});
    shortest = std::min(shortest.value_or(*interval), *interval);
    MIXCMP_DO(check_request_beats(scene.system, *interval));
  }
  if (scene.reference_fixed_point || (scene.has_fixed_references() && !design.references.empty())) {
    MIXCMP_TRY(fixed, design_fixed_reference(scene));
    design.fixed_reference = std::move(fixed);
  }
  design.system.request_beats =
      request_beats(scene.system, total_width(design.formats_of_inputs()), shortest.value_or(1));
  if (data != nullptr) {
    MIXCMP_DO(check_engine_data(scene.system.engine, design.lane_count(), *data));
  }
  return design;
}

template <class Groups>
int total(const Groups& groups) {
  int count = 0;
  for (const auto& group : groups) count += group.count;
  return count;
}

}  // namespace

Result<ReferenceDatapath> reference_datapath(const scene::Scene& scene) {
  if (!scene.has_fixed_references()) {
    return ReferenceDatapath(reference_graph(scene.graph, scene.reference));
  }
  MIXCMP_TRY(lane, design_fixed_reference(scene));
  return ReferenceDatapath(std::move(lane));
}

LaneFormat datapath_format(const ReferenceDatapath& reference) {
  return std::visit(Cases{[](const TypedGraph& graph) {
                            return LaneFormat{.floating = graph.arithmetic.format,
                                              .fixed_point = {}};
                          },
                          [](const fixed::FixedLane& lane) {
                            return LaneFormat{.floating = {}, .fixed_point = lane.format};
                          }},
                    reference);
}

ReferenceDatapath datapath_or_model(const scene::Scene& scene) {
  Result<ReferenceDatapath> datapath = reference_datapath(scene);
  if (datapath.ok()) return std::move(datapath).value();
  return reference_graph(scene.graph, scene.reference);
}

LaneFormat datapath_format(const scene::Scene& scene) {
  return datapath_format(datapath_or_model(scene));
}

bool Design::has_fixed_operands() const {
  return std::any_of(operand_formats.begin(), operand_formats.end(),
                     [](const OperandFormat& format) { return format.fixed() != nullptr; });
}

ReferenceDatapath Design::reference_datapath() const {
  if (fixed_reference) return *fixed_reference;
  return reference;
}

const fixed::FixedLane* Design::requested_reference() const {
  return fixed_reference && fixed_reference->is_reference ? &*fixed_reference : nullptr;
}

std::vector<OperandFormat> Design::formats_of_inputs() const {
  if (!operand_formats.empty()) return operand_formats;
  return std::vector<OperandFormat>(inputs.size(), OperandFormat(reference.input_format));
}

int Design::lane_count() const {
  return total(lanes);
}

int Design::reference_count() const {
  return total(references);
}

std::size_t Design::group_of_lane(int lane) const {
  std::size_t group = 0;
  while (lane >= lanes[group].count) lane -= lanes[group++].count;
  return group;
}

bool Design::has_second_lanes() const {
  return second_tier && system.engine.kind == scene::EngineKind::none;
}

bool Design::certified() const {
  if (second_tier && !is_certified(second_tier->lane)) return false;
  return std::all_of(lanes.begin(), lanes.end(),
                     [](const LaneGroup& group) { return is_certified(group.lane); });
}

Result<Lane> design_lane(const scene::Scene& scene, const scene::ReducedSpec& reduced,
                         const data::Comparisons* data, MeasureErrors measure) {
  if (reduced.fixed_point) return as_lane(design_fixed_lane(scene, reduced));
  const std::optional<std::string> no_float_lane = scene.why_no_float_lane();
  if (!reduced.format) {
    if (no_float_lane) {
      return unresolved(scene, "reduced.format",
                        scene.has_fixed_operands() ? "--format exact" : "--format q13",
                        "\"exact\", or qW such as q13");
    }
    return unresolved(scene, "reduced.format", "--format s17e8",
                      "sPeE, such as s17e8, qW, such as q13, or blockW");
  }
  if (no_float_lane) {
    return Error{.field = "reduced.format",
                 .message = *no_float_lane,
                 .received = reduced.format_name(),
                 .accepted = "\"exact\", or qW such as q13"};
  }
  const Arithmetic arithmetic{*reduced.format, reduced.rounding, reduced.subnormals};
  const FloatFormat reference = scene.reference.format;
  const TypedGraph graph =
      lane_graph(scene.graph, reference, arithmetic, reduced.inputs_beside(reference));
  if (reduced.is_profiled)
    return as_lane(design_profiled_lane(scene, reduced, graph, data, measure));
  return as_lane(design_certified_lane(scene, reduced, graph));
}

Result<std::optional<LaneGroup>> design_second_tier(const scene::Scene& scene) {
  if (!scene.second_tier) return std::optional<LaneGroup>();
  Result<LaneGroup> tier = design_group(
      scene,
      {.count = scene.second_tier_count.value_or(1), .reduced = *scene.second_tier, .place = {}},
      nullptr, nullptr);
  if (tier.ok()) return std::optional<LaneGroup>(std::move(tier).value());
  constexpr std::string_view section = "reduced.";
  Error error = tier.error();
  if (error.field.starts_with(section)) {
    error.field = "second_tier." + error.field.substr(section.size());
  }
  return error;
}

Result<Done> check_multipliers(const Lane& lane, scene::Multipliers multipliers) {
  if (multipliers != scene::Multipliers::memory) return Done{};
  const auto* fixed = std::get_if<fixed::FixedLane>(&lane);
  if (fixed == nullptr) {
    return Error{.field = "reduced.multipliers",
                 .message = "only lanes in fixed point read squares from memories",
                 .received = fmt::format("\"memory\" in {}", format_name(lane)),
                 .accepted = "embedded or logic, or a format such as q11 or block11"};
  }
  const int widest = fixed::widest_squared_magnitude(*fixed);
  if (widest <= fixed::most_table_bits) return Done{};
  return Error{.field = "reduced.multipliers",
               .message = "the memory of a square would be too large",
               .received = fmt::format("\"memory\", where {} squares magnitudes of {} bits",
                                       format_name(lane), widest),
               .accepted = fmt::format("embedded or logic, or a format with fewer bits: magnitudes "
                                       "of at most {}",
                                       fixed::most_table_bits)};
}

Result<scene::Scene> with_chain_lanes(scene::Scene scene, const data::Comparisons* data) {
  if (scene.system.engine.kind != scene::EngineKind::arg_min) return scene;
  int lanes = 0;
  for (const scene::LaneGroupSpec& group : scene.lane_groups()) {
    MIXCMP_TRY(count, lane_count(scene, group, data));
    lanes += count;
  }
  if (data != nullptr) {
    MIXCMP_DO(check_engine_data(scene.system.engine, lanes, *data));
  }
  if (scene.lanes.empty()) scene.system.lanes = lanes;
  return scene;
}

Result<Design> make_design(const scene::Scene& scene, const data::Comparisons* data,
                           MeasureErrors measure) {
  Result<Design> design = choose(scene, data, measure);
  if (design.ok()) return design;
  Error error = design.error();
  if (error.file.empty()) error.file = scene.path.string();
  return error;
}

}  // namespace mixcmp::design
