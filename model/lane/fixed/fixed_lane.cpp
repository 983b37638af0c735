#include "model/lane/fixed/fixed_lane.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/formulas.hpp"
#include "model/lane/fixed/graph_builder.hpp"
#include "model/lane/fixed/logarithms.hpp"
#include "model/lane/fixed/norm_part.hpp"
#include "model/lane/fixed/running_bound.hpp"
#include "model/lane/fixed/scale_degree.hpp"

namespace mixcmp::fixed {
namespace {

bool any_promised(const std::vector<FixedNode>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(),
                     [](const FixedNode& node) { return node.is_promised; });
}

bool has_no_error(const FixedNode& node) {
  return node.error.low == 0 && node.error.high == 0;
}

/// The thresholds beyond which the difference, less its error, has a certain sign. Proof:
/// docs/fixed_point.md, theorem 3.
ConstantThresholds constant_thresholds(const FixedNode& difference) {
  const mpq_class unit = difference.format.unit();
  const Range& error = difference.error;
  return {.greater_from = floor_of(error.high / unit) + 1,
          .less_to = ceiling_of(error.low / unit) - 1,
          .decides_ties = has_no_error(difference)};
}

Result<FixedPart> make_part(FixedGraphBuilder& builder, const Sides& sides,
                            const FixedOptions& options) {
  MIXCMP_TRY(f, builder.side(sides, sides.f));
  MIXCMP_TRY(g, builder.side(sides, sides.g));
  const bool is_exact = has_no_error(builder.nodes()[f]) && has_no_error(builder.nodes()[g]);
  if (!is_exact && (!options.bound || options.bound == BoundKind::norm)) {
    if (auto part = norm_part(builder, f, g)) return *part;
  }
  const NodeId difference = builder.difference(f, g);
  if (options.is_reference) {
    return FixedPart{
        .difference = difference,
        .criterion = ConstantThresholds{.greater_from = 1, .less_to = -1, .decides_ties = true}};
  }
  if (!is_exact && options.bound == BoundKind::running) {
    auto running = running_thresholds(builder.nodes(), options.format.bits, difference,
                                      builder.nodes_in_products(sides));
    if (running) return FixedPart{.difference = difference, .criterion = std::move(*running)};
  }
  return FixedPart{.difference = difference,
                   .criterion = constant_thresholds(builder.nodes()[difference])};
}

/// The nodes on which any criterion depends.
std::set<NodeId> nodes_read(const FixedLane& lane) {
  std::set<NodeId> read;
  for (const FixedPart& part : lane.parts) {
    read.merge(fan_in(lane, part.difference));
    for (const NodeId id : read_by(part.criterion)) read.merge(fan_in(lane, id));
  }
  return read;
}

/// Removes the nodes that attempts at a norm left behind.
void remove_unread(FixedLane& lane) {
  const std::set<NodeId> read = nodes_read(lane);
  std::vector<NodeId> new_id(lane.nodes.size(), -1);
  std::vector<FixedNode> kept;
  for (std::size_t id = 0; id < lane.nodes.size(); ++id) {
    if (!read.contains(static_cast<NodeId>(id))) continue;
    FixedNode& node = kept.emplace_back(std::move(lane.nodes[id]));
    for (int k = 0; k < arity(node.operation); ++k) node.operands[k] = new_id[node.operands[k]];
    new_id[id] = static_cast<NodeId>(kept.size()) - 1;
  }
  lane.nodes = std::move(kept);
  for (FixedPart& part : lane.parts) {
    part.difference = new_id[part.difference];
    if (auto* norm = std::get_if<NormThresholds>(&part.criterion)) {
      norm->radius = new_id[norm->radius];
    }
    if (auto* running = std::get_if<RunningThresholds>(&part.criterion)) {
      for (NodeId& id : running->watched) id = new_id[id];
    }
  }
}

Error no_error_to_bound(BoundKind kind) {
  return {.field = "reduced.error_bound",
          .message = "the lane rounds nothing: there is no error to bound",
          .received = std::string(to_string(kind)),
          .accepted = "auto, constant"};
}

Error no_grid(const FixedPoint& format, bool relies_on_grids) {
  return {.field = "reduced.error_bound",
          .message = relies_on_grids
                         ? fmt::format("{} rounds a constant or a result of f or g", format.name())
                         : fmt::format("{} holds the multiples of no grid of an input in floating "
                                       "point",
                                       format.name()),
          .received = "grid",
          .accepted = "auto, constant, norm, running, or reduced.format = \"exact\""};
}

Error no_norm() {
  return {.field = "reduced.error_bound",
          .message =
              "no norm bound: it needs sums of squares on both sides, none of them too wide to be "
              "exact",
          .received = "norm",
          .accepted = "constant"};
}

Error no_running() {
  return {.field = "reduced.error_bound",
          .message = "no running bound: no error grows with what f and g multiply",
          .received = "running",
          .accepted = "constant, or norm for sums of squares"};
}

Error no_grid_in(const FixedPoint& format) {
  return {.field = "reduced.format",
          .message = "lanes that rely on grids have neither guard digits nor blocks",
          .received = format.name(),
          .accepted = "qW, such as q10"};
}

Error no_block(const FixedPoint& format) {
  return {.field = "reduced.format",
          .message =
              "block floating point finds its unit in the exponents of floating-point "
              "operands: some inputs are in fixed point",
          .received = format.name(),
          .accepted = "qW or \"exact\""};
}

Error received(Error error, const FixedPoint& format) {
  error.received = format.name();
  return error;
}

std::string shown(const mpq_class& value) {
  return fmt::format("{:.3g}", value.get_d());
}

std::string describe(const ConstantThresholds& thresholds, const FixedPart& part,
                     const std::vector<FixedNode>& nodes) {
  if (thresholds.decides_ties) {
    return any_promised(nodes) ? "certified: everywhere on the promised grids, nothing is rounded"
                               : "certified: everywhere, nothing is rounded";
  }
  const mpq_class unit = nodes[part.difference].format.unit();
  return fmt::format("certified: where f - g is {} or more, or {} or less",
                     shown(thresholds.greater_from * unit), shown(thresholds.less_to * unit));
}

std::string describe(const NormThresholds& thresholds, const FixedPart& part,
                     const std::vector<FixedNode>& nodes) {
  const mpq_class unit = nodes[part.difference].format.unit();
  const mpq_class per_radius = unit / power_of_two(thresholds.unit_exponent(nodes));
  return fmt::format("certified: where {} is {} s + {} or more, or below {} s, with {}",
                     part.swapped ? "g - f" : "f - g",
                     shown(power_of_two(thresholds.shift_above) * per_radius),
                     shown(thresholds.offset_above * unit),
                     shown(-power_of_two(thresholds.shift_below) * per_radius),
                     thresholds.radius_is_squared ? "s the power of two above the root of g"
                     : part.swapped               ? "f = s^2"
                                                  : "g = s^2");
}

std::string describe(const RunningThresholds& thresholds, const FixedPart& part,
                     const std::vector<FixedNode>& nodes) {
  const mpq_class unit = nodes[part.difference].format.unit();
  return fmt::format(
      "certified: where f - g is {0} or more, or below -{0}, up to {1} as what is "
      "multiplied is larger",
      shown(thresholds.of_steps.front() * unit), shown(thresholds.of_steps.back() * unit));
}

std::string describe(const FixedLane& lane, const FixedPart& part) {
  return std::visit([&](const auto& thresholds) { return describe(thresholds, part, lane.nodes); },
                    part.criterion);
}

template <class Thresholds>
bool has_criterion(const FixedLane& lane) {
  return std::any_of(lane.parts.begin(), lane.parts.end(), [](const FixedPart& part) {
    return std::holds_alternative<Thresholds>(part.criterion);
  });
}

/// One per part; 0 if operands are neither divided by their unit nor cut in common.
Result<std::vector<mpq_class>> degrees_of(const Graph& graph, const FixedPoint& format) {
  std::vector<mpq_class> degrees(graph.parts().size());
  if (format.guard_digits > 0) {
    auto found = cut_degrees(graph);
    if (!found.ok()) return received(found.error(), format);
    degrees = std::move(found).value();
  }
  if (format.is_block) {
    auto found = scale_degrees(graph);
    if (!found.ok()) return received(found.error(), format);
    degrees = std::move(found).value();
  }
  return degrees;
}

}  // namespace

int piece_bits(const std::vector<FixedNode>& nodes, const FixedNode& look_up) {
  return nodes[look_up.operands[0]].format.width - look_up.words.address_bits();
}

bool follows_operands(const FixedNode& node) {
  return !node.function;
}

bool is_floating_code(const FixedNode& node) {
  return node.conversion == Conversion::floating;
}

bool is_limited_encoding(const std::vector<FixedNode>& nodes, const FixedNode& node) {
  return is_limit(node) && nodes[node.operands[0]].is_encoding;
}

bool is_code_of_encoding(const std::vector<FixedNode>& nodes, const FixedNode& node) {
  const bool is_difference = node.operation == Operation::subtract && node.function &&
                             nodes[node.operands[1]].operation == Operation::constant;
  return (is_difference || node.conversion == Conversion::place) &&
         is_limited_encoding(nodes, nodes[node.operands[0]]);
}

bool is_wires(const FixedNode& node) {
  return node.operation == Operation::convert && !is_common_cut(node) && !is_floating_code(node);
}

bool is_limit(const FixedNode& node) {
  return node.conversion == Conversion::limit;
}

bool is_common_cut(const FixedNode& node) {
  return node.conversion == Conversion::common_cut;
}

bool is_reach(const FixedNode& node) {
  return node.conversion == Conversion::reach;
}

bool is_checked(const FixedNode& node) {
  return is_limit(node) || is_reach(node);
}

namespace {

Result<FixedLane> lane_of_graph(const Graph& graph, FloatFormat input_format,
                                const FixedOptions& options) {
  const bool any_fixed =
      std::any_of(options.operand_formats.begin(), options.operand_formats.end(),
                  [](const OperandFormat& format) { return format.fixed() != nullptr; });
  if (options.format.is_block && any_fixed) return no_block(options.format);
  if (options.bound == BoundKind::grid && !options.format.is_plain()) {
    return no_grid_in(options.format);
  }
  MIXCMP_TRY(degrees, degrees_of(graph, options.format));
  FixedGraphBuilder builder(graph, input_format, options);
  MIXCMP_DO(builder.cut_in_common());
  FixedLane lane{.format = options.format,
                 .nodes = {},
                 .input_names = graph.inputs(),
                 .input_format = input_format,
                 .parts = {},
                 .combination = graph.combination(),
                 .operand_formats = options.operand_formats,
                 .outputs = {},
                 .is_reference = options.is_reference};
  for (std::size_t k = 0; k < graph.parts().size(); ++k) {
    MIXCMP_TRY(part, make_part(builder, graph.parts()[k], options));
    lane.parts.push_back(std::move(part));
    lane.parts.back().degree = degrees[k];
  }
  lane.nodes = std::move(builder.nodes());
  remove_unread(lane);
  if (options.bound == BoundKind::grid) {
    const bool relies = relies_on_grids(lane);
    return relies && rounds_nothing(lane) ? Result<FixedLane>(lane)
                                          : no_grid(options.format, relies);
  }
  if (is_exact(lane))
    return options.bound.value_or(BoundKind::constant) == BoundKind::constant
               ? Result<FixedLane>(lane)
               : no_error_to_bound(*options.bound);
  if (options.bound == BoundKind::norm && !has_norm(lane)) return no_norm();
  if (options.bound == BoundKind::running && !has_running(lane)) return no_running();
  return lane;
}

/// The declared range of each input, or that of its fixed-point format.
std::vector<std::optional<Range>> known_ranges(const FixedOptions& options) {
  std::vector<std::optional<Range>> ranges = options.ranges;
  ranges.resize(std::max(ranges.size(), options.operand_formats.size()));
  for (std::size_t k = 0; k < options.operand_formats.size(); ++k) {
    const FixedFormat* fixed = options.operand_formats[k].fixed();
    if (ranges[k] || fixed == nullptr) continue;
    ranges[k] = Range{fixed->smallest() * fixed->unit(), fixed->largest() * fixed->unit()};
  }
  return ranges;
}

Result<FixedLane> lane_with_formulas(const Graph& graph, FloatFormat input_format,
                                     const FixedOptions& options) {
  const auto lane_of = [&](const Graph& of) { return lane_of_graph(of, input_format, options); };
  const std::vector<std::optional<Range>> ranges = known_ranges(options);
  auto formulas = with_formulas(graph, ranges);
  if (!formulas) return lane_of(graph);
  Result<FixedLane> lane = lane_of(*formulas);
  if (lane.ok()) return lane;
  // Some formula has no table that is small enough.
  formulas = with_formulas(graph, ranges, [&](const Graph& one) { return lane_of(one).ok(); });
  Result<FixedLane> fewer = lane_of(formulas ? *formulas : graph);
  if (!fewer.ok() && formulas) fewer = lane_of(graph);
  return fewer.ok() ? std::move(fewer) : std::move(lane);
}

/// Whether some part's difference errs less than half as much as in another lane, and none errs
/// more.
bool errs_less(const FixedLane& lane, const FixedLane& other) {
  const auto error = [](const FixedLane& of, std::size_t part) {
    return absolute(of.nodes[of.parts[part].difference].error).high;
  };
  bool any = false;
  for (std::size_t part = 0; part < lane.parts.size(); ++part) {
    const mpq_class own = error(lane, part), others = error(other, part);
    if (own > others) return false;
    any = any || 2 * own < others;
  }
  return any;
}

}  // namespace

Result<FixedLane> fixed_lane(const Graph& graph, FloatFormat input_format,
                             const FixedOptions& options) {
  if (!options.format.is_plain()) return lane_of_graph(graph, input_format, options);
  Result<FixedLane> lane = lane_with_formulas(graph, input_format, options);
  const auto logarithms = with_logarithms(graph, known_ranges(options));
  if (!logarithms) return lane;
  Result<FixedLane> other = lane_with_formulas(*logarithms, input_format, options);
  const bool is_better = !lane.ok() || (other.ok() && errs_less(*other, *lane));
  return is_better ? other : lane;
}

OperandFormat operand_format(const FixedLane& lane, int input) {
  return lane.operand_formats.empty() ? OperandFormat(lane.input_format)
                                      : lane.operand_formats[static_cast<std::size_t>(input)];
}

const mpq_class* FixedOptions::relied_grid(std::size_t input) const {
  if (bound != BoundKind::grid || grids.empty() || !grids[input]) return nullptr;
  return &*grids[input];
}

std::vector<OperandFormat> arriving_formats(const FixedLane& lane) {
  std::vector<OperandFormat> formats;
  if (!lane.loaded_inputs.empty()) return formats;
  const OperandFormat read(lane.input_format);
  bool any = false;
  for (const OperandFormat& format : lane.operand_formats) {
    formats.push_back(format.floating() == nullptr ? read : format);
    any = any || !(formats.back() == read);
  }
  return any ? formats : std::vector<OperandFormat>();
}

const FixedFormat* arriving_fixed(const FixedLane& lane, const FixedNode& node) {
  if (lane.operand_formats.empty()) return nullptr;
  return lane.operand_formats[static_cast<std::size_t>(node.input)].fixed();
}

bool is_read_as_it_arrives(const FixedLane& lane, const FixedNode& node) {
  return node.operation == Operation::input &&
         (!lane.loaded_inputs.empty() || arriving_fixed(lane, node) != nullptr || node.is_encoding);
}

namespace {

/// Whether each operand of an input fits: it is read as it arrives, in a lane that was split also
/// before it became part of a word.
bool is_always_taken(const FixedLane& lane, const FixedNode& input) {
  if (lane.loaded_inputs.empty()) return is_read_as_it_arrives(lane, input);
  return lane.loaded_inputs[static_cast<std::size_t>(input.input)].flags.empty();
}

}  // namespace

bool rounds_nothing(const FixedLane& lane) {
  return std::all_of(lane.parts.begin(), lane.parts.end(), [&](const FixedPart& part) {
    const auto* constants = std::get_if<ConstantThresholds>(&part.criterion);
    return constants != nullptr && constants->decides_ties &&
           has_no_error(lane.nodes[part.difference]);
  });
}

bool is_exact(const FixedLane& lane) {
  return rounds_nothing(lane) &&
         std::all_of(lane.nodes.begin(), lane.nodes.end(), [&](const FixedNode& node) {
           return !is_checked(node) &&
                  (node.operation != Operation::input || is_always_taken(lane, node));
         });
}

std::vector<int> inputs_read(const FixedLane& lane) {
  std::vector<int> inputs;
  for (const FixedNode& node : lane.nodes) {
    if (node.operation == Operation::input) inputs.push_back(node.input);
  }
  return inputs;
}

std::vector<NodeId> cut_in_common(const FixedLane& lane) {
  std::vector<NodeId> operands;
  for (const FixedNode& node : lane.nodes) {
    if (is_common_cut(node)) operands.push_back(node.operands[0]);
  }
  return operands;
}

int most_dropped_in_common(const FixedLane& lane) {
  int most = 0;
  for (const FixedNode& node : lane.nodes) most = std::max(most, node.most_dropped);
  return most;
}

bool divides_by_constant(const Graph& graph, NodeId quotient) {
  const Node& divisor = graph.nodes()[graph.nodes()[quotient].operands[1]];
  return divisor.operation == Operation::constant && divisor.value != 0;
}

std::set<NodeId> fan_in(const FixedLane& lane, NodeId node) {
  const std::vector<NodeId> cut = cut_in_common(lane);
  std::set<NodeId> found, open = {node};
  while (!open.empty()) {
    const NodeId id = open.extract(std::prev(open.end())).value();
    const FixedNode& next = lane.nodes[id];
    found.insert(id);
    open.insert(next.operands.begin(), next.operands.begin() + arity(next.operation));
    if (is_common_cut(next)) open.insert(cut.begin(), cut.end());
  }
  return found;
}

int least_block_exponent(FloatFormat input_format) {
  return input_format.min_exponent() + 1;
}

std::vector<NodeId> read_by(const Criterion& criterion) {
  if (const auto* norm = std::get_if<NormThresholds>(&criterion)) return {norm->radius};
  const auto* running = std::get_if<RunningThresholds>(&criterion);
  return running == nullptr ? std::vector<NodeId>() : running->watched;
}

bool relies_on_grids(const FixedLane& lane) {
  return any_promised(lane.nodes);
}

bool has_norm(const FixedLane& lane) {
  return has_criterion<NormThresholds>(lane);
}

bool has_running(const FixedLane& lane) {
  return has_criterion<RunningThresholds>(lane);
}

std::string describe_criterion(const FixedLane& lane) {
  std::vector<std::string> texts;
  for (const FixedPart& part : lane.parts) texts.push_back(describe(lane, part));
  if (texts.size() == 1) return texts.front();
  std::string text = fmt::format("{} of {} parts", to_string(lane.combination), texts.size());
  for (std::size_t k = 0; k < texts.size(); ++k) text += fmt::format("; part {} {}", k, texts[k]);
  return text;
}

}  // namespace mixcmp::fixed
