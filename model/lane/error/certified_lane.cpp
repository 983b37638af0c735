#include "model/lane/error/certified_lane.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "model/base/number/exact.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/lane/error/constant_bound.hpp"
#include "model/lane/error/error_analysis.hpp"
#include "model/lane/error/hazards.hpp"

namespace mixcmp::error {
namespace {

using Ranges = std::vector<std::optional<Range>>;

std::vector<bool> nonnegative(const Ranges& ranges, int input_count) {
  std::vector<bool> result(static_cast<std::size_t>(input_count), false);
  for (std::size_t input = 0; input < ranges.size(); ++input) {
    result[input] = ranges[input] && ranges[input]->low >= 0;
  }
  return result;
}

/// Digits of a constant bound. With this number of digits, rounding it up costs nothing measurable.
constexpr int constant_bound_digits = 16;

/// The first node that has no bound although its operands have.
template <typename Missing>
NodeId first_failure(const ErrorAnalysis& analysis, Missing missing) {
  const auto first = std::find_if(analysis.nodes.begin(), analysis.nodes.end(), missing);
  MIXCMP_CHECK(first != analysis.nodes.end());
  return static_cast<NodeId>(first - analysis.nodes.begin());
}

/// Whether this node would hold an unrounded value with inputs = "exact".
bool would_be_exact(const TypedGraph& graph, NodeId id) {
  const TypedNode& node = graph.nodes[id];
  switch (node.operation) {
    case Operation::input: return true;
    case Operation::constant:
      return to_rational(graph.input_format, from_rational(graph.input_format, node.value)) ==
             node.value;
    case Operation::convert:
    case Operation::negate:
    case Operation::absolute: return would_be_exact(graph, node.operands[0]);
    case Operation::minimum:
    case Operation::maximum:
      return would_be_exact(graph, node.operands[0]) && would_be_exact(graph, node.operands[1]);
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::divide:
    case Operation::square_root:
    case Operation::fused_sum: return false;
    case Operation::function:
    case Operation::look_up: break;
  }
  MIXCMP_CHECK(false);
}

/// The advice for a constant that its format does not hold. That format is the lane's or, with
/// exact inputs, the reference's.
std::string what_helps_a_constant(const TypedGraph& graph, const TypedNode& constant) {
  const bool is_references =
      constant.format == graph.input_format && !(constant.format == graph.arithmetic.format);
  std::string help = is_references ? "reduced.inputs = \"rounded\", a reference.format with more "
                                     "exponent bits"
                                   : "a reduced.format with more exponent bits";
  const bool is_flushed = constant.format.is_subnormal(constant.constant);
  if (is_flushed) help += ", reduced.subnormals = \"gradual\"";
  return help;
}

std::string what_helps(const TypedGraph& graph, NodeId failure) {
  const TypedNode& node = graph.nodes[failure];
  if (node.operation == Operation::constant) return what_helps_a_constant(graph, node);
  std::string help = "reduced.error_bound = \"running\", ";
  if (would_be_exact(graph, node.operands[0]) && would_be_exact(graph, node.operands[1])) {
    help += "reduced.inputs = \"exact\", ";
  }
  const std::vector<bool> all_nonnegative(graph.input_count, true);
  if (analyse_errors(graph, all_nonnegative).nodes[failure].relative) {
    help += "ranges that exclude negative inputs, ";
  }
  return help + "reduced.bound = \"profiled\", or another formulation of f and g";
}

Error no_bound(BoundKind kind, const std::string& reason, std::string accepted) {
  return {.field = "reduced.bound",
          .message = fmt::format("no {} bound can be proven: {}", to_string(kind), reason),
          .received = "\"certified\"",
          .accepted = std::move(accepted)};
}

/// A distance greater than that of any two finite encodings. It is as wide as an encoding, so the
/// lane's hardware can hold it.
Bits never(FloatFormat format) {
  return low_mask(format.width());
}

Bits smallest_guard(const NodeBound& f, const NodeBound& g, int precision) {
  return std::min(guard_ulp(*f.relative, *g.relative, precision),
                  guard_ulp_before_rounding(*f.before_rounding, *g.before_rounding, precision));
}

std::vector<RangeCheck> sign_checks(const ErrorAnalysis& analysis) {
  std::vector<RangeCheck> checks;
  for (const int input : analysis.nonnegative_inputs) {
    checks.push_back(sign_check(input, RequiredSign::nonnegative));
  }
  return checks;
}

Result<Lane> relative_lane(TypedGraph graph, const CertifiedOptions& options) {
  const ErrorAnalysis analysis =
      analyse_errors(graph, nonnegative(options.ranges, graph.input_count));
  const NodeBound &f = analysis.nodes[graph.f()], &g = analysis.nodes[graph.g()];
  if (!f.relative || !g.relative) {
    const NodeId failure = first_failure(analysis, [](const NodeBound& b) { return !b.relative; });
    return no_bound(BoundKind::relative, analysis.nodes[failure].reason,
                    what_helps(graph, failure));
  }
  const FloatFormat format = graph.arithmetic.format;
  UlpDistanceCriterion criterion{
      .guard_ulp = std::min(smallest_guard(f, g, format.precision()), never(format)),
      .nonnegative = f.nonnegative && g.nonnegative};
  return one_part_lane(std::move(graph), criterion, sign_checks(analysis));
}

/// Appends f - g, rounded, and returns its node.
NodeId append_difference(TypedGraph& graph) {
  graph.nodes.push_back({.operation = Operation::subtract,
                         .operands = {graph.f(), graph.g()},
                         .operand_format = graph.arithmetic.format,
                         .format = graph.arithmetic.format,
                         .value = {}});
  return static_cast<NodeId>(graph.nodes.size()) - 1;
}

/// Collects the nodes that the bound and the conditions need, and puts the bound last.
class Pruner {
public:
  explicit Pruner(const std::vector<BoundNode>& nodes) : nodes_(nodes), ids_(nodes.size(), -1) {}

  int keep(int id) {
    if (ids_[id] >= 0) return ids_[id];
    BoundNode node = nodes_[id];
    for (int k = 0; k < arity(node.operation); ++k) node.operands[k] = keep(node.operands[k]);
    kept_.push_back(std::move(node));
    return ids_[id] = static_cast<int>(kept_.size()) - 1;
  }

  std::vector<BoundNode> take(int bound) {
    const int last = bound == no_bound_node ? -1 : keep(bound);
    const bool in_place = last >= 0 && last + 1 == static_cast<int>(kept_.size());
    if (!in_place) kept_.push_back(last < 0 ? BoundNode{BoundOperation::constant} : kept_[last]);
    return std::move(kept_);
  }

private:
  const std::vector<BoundNode>& nodes_;
  std::vector<int> ids_;
  std::vector<BoundNode> kept_;
};

/// The bound that the computed |f - g| must exceed (docs/error_bounds.md, theorem 8).
struct DifferenceBound {
  NodeId difference;
  ErrorAnalysis analysis;
  AbsoluteError bound;
};

Result<DifferenceBound> bound_difference(TypedGraph& graph, BoundKind kind,
                                         const CertifiedOptions& options) {
  const NodeId difference = append_difference(graph);
  DifferenceBound result{
      .difference = difference,
      .analysis = analyse_errors(graph, nonnegative(options.ranges, graph.input_count)),
      .bound = {}};
  const NodeBound& bound = result.analysis.nodes[difference];
  if (!bound.mixed) {
    const NodeId failure =
        first_failure(result.analysis, [](const NodeBound& node) { return !node.mixed; });
    const bool constant = graph.nodes[failure].operation == Operation::constant;
    return no_bound(kind, result.analysis.nodes[failure].reason,
                    constant ? what_helps_a_constant(graph, graph.nodes[failure])
                             : "a reduced.format with more precision, or another formulation");
  }
  // Theorem 8 uses the factor and the absolute error of f - g before its own rounding, so the
  // division by `own` removes that rounding. The bound must then exceed the absolute error over
  // `low`.
  result.bound = bound.mixed->absolute;
  const RelativeBound own =
      rounding_bound(graph.arithmetic.format.precision(), graph.arithmetic.rounding);
  const mpq_class low = bound.mixed->factor.low / own.low;
  if (low < 1) result.bound.inflation = widened_up(result.bound.inflation / low);
  return result;
}

Result<Lane> running_lane(TypedGraph graph, const CertifiedOptions& options) {
  MIXCMP_TRY(found, bound_difference(graph, BoundKind::running, options));
  const FloatFormat format = graph.arithmetic.format;
  Pruner pruner(found.analysis.bounds);
  AbsoluteBoundCriterion criterion{.difference = found.difference,
                                   .bound = {.format = {.precision = 1, .exponent_bits = 1}}};
  for (const BoundCondition& condition : found.analysis.conditions) {
    criterion.conditions.push_back({pruner.keep(condition.bound), condition.value});
  }
  criterion.bound = {.format = {.precision = std::min(options.bound_digits, format.precision()),
                                .exponent_bits = format.exponent_bits()},
                     .nodes = pruner.take(found.bound.bound)};
  if (found.bound.inflation > 1) {
    criterion.guard_ulp =
        std::min(steps_beyond(found.bound.inflation, format.precision()), never(format));
  }
  return one_part_lane(std::move(graph), std::move(criterion), sign_checks(found.analysis));
}

Result<Lane> constant_lane(TypedGraph graph, const CertifiedOptions& options) {
  MIXCMP_TRY(found, bound_difference(graph, BoundKind::constant, options));
  const std::vector<RangeCheck> checks = full_range_checks(graph, options.ranges);
  MIXCMP_DO(check_divisors(graph, checks));
  MIXCMP_TRY(bound, constant_bound(graph, found.analysis, found.bound, checks));
  const FloatFormat format = graph.arithmetic.format;
  AbsoluteBoundCriterion criterion{
      .difference = found.difference,
      .bound = {.format = {.precision = std::min(constant_bound_digits, format.precision()),
                           .exponent_bits = format.exponent_bits()},
                .nodes = {{.operation = BoundOperation::constant, .constant = bound}}},
      .conditions = {}};
  return one_part_lane(std::move(graph), std::move(criterion), checks);
}

Result<Lane> lane_of(BoundKind kind, TypedGraph graph, const CertifiedOptions& options) {
  switch (kind) {
    case BoundKind::relative: return relative_lane(std::move(graph), options);
    case BoundKind::running: return running_lane(std::move(graph), options);
    case BoundKind::constant: return constant_lane(std::move(graph), options);
    case BoundKind::norm:
    case BoundKind::grid: break;
    case BoundKind::profiled: MIXCMP_CHECK(!"a bound that is proven");
  }
  return Error{.field = "reduced.error_bound",
               .message = "a bound of lanes in fixed point",
               .received = std::string(to_string(kind)),
               .accepted = "auto, relative, running, constant, or reduced.format = \"q13\""};
}

/// The lane with the kind of bound that the scene asks for. An error names the key that asks for
/// it, reduced.error_bound.
Result<Lane> asked_lane(BoundKind kind, TypedGraph graph, const CertifiedOptions& options) {
  Result<Lane> lane = lane_of(kind, std::move(graph), options);
  if (lane.ok() || lane.error().field != "reduced.bound") return lane;
  Error error = lane.error();
  error.field = "reduced.error_bound";
  error.received = fmt::format("\"{}\"", to_string(kind));
  return error;
}

Result<Lane> first_lane(const TypedGraph& graph, const CertifiedOptions& options) {
  Result<Lane> relative = relative_lane(graph, options);
  if (relative.ok()) return relative;
  return running_lane(graph, options);
}

Result<Lane> certified_part(const TypedGraph& graph, const CertifiedOptions& options) {
  MIXCMP_TRY(lane,
             options.kind ? asked_lane(*options.kind, graph, options) : first_lane(graph, options));
  if (options.hazards == HazardRemoval::remove) remove_hazards(lane, options.ranges);
  return lane;
}

}  // namespace

Result<Lane> certified_lane(const TypedGraph& graph, const CertifiedOptions& options) {
  return lane_of_parts(graph,
                       [&](const TypedGraph& part) { return certified_part(part, options); });
}

std::vector<CandidateLane> candidate_lanes(const TypedGraph& graph,
                                           const std::vector<std::optional<Range>>& ranges) {
  std::vector<CandidateLane> candidates;
  for (const Bound& bound : counted_bounds()) {
    if (bound.is_fixed_point() || bound.is_profiled()) continue;
    const CertifiedOptions options{
        .kind = bound.kind, .bound_digits = std::max(bound.digits, 1), .ranges = ranges};
    candidates.push_back({bound, certified_lane(graph, options)});
  }
  return candidates;
}

}  // namespace mixcmp::error
