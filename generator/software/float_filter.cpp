#include "generator/software/float_filter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>

#include "model/base/number/exact.hpp"
#include "model/lane/error/error_analysis.hpp"
#include "model/lane/error/sign.hpp"

namespace mixcmp::software {
namespace {

using error::BoundOperation;

constexpr int float_digits = std::numeric_limits<float>::digits;

FloatFormat float_format() {
  return FloatFormat::parse("binary32").value();
}

/// A factor c such that exact <= c * computed after `count` roundings to nearest, none of them
/// exceptional.
mpq_class inverse_of_roundings(int count) {
  const mpq_class one_step = 1 - mpq_class(1, mpz_class(1) << float_digits);
  mpq_class product = 1;
  for (int k = 0; k < count; ++k) product *= one_step;
  return 1 / product;
}

/// The most roundings on a path to each bound node. A product adds those of both operands.
std::vector<int> bound_roundings(const error::BoundGraph& bound) {
  std::vector<int> roundings;
  for (const error::BoundNode& node : bound.nodes) {
    const auto of = [&](int k) { return roundings[static_cast<std::size_t>(node.operands[k])]; };
    switch (node.operation) {
      case BoundOperation::constant:  // rounded up, by rounded_up
      case BoundOperation::magnitude:
      case BoundOperation::binade: roundings.push_back(0); break;
      case BoundOperation::reciprocal: roundings.push_back(1); break;
      case BoundOperation::add: roundings.push_back(std::max(of(0), of(1)) + 1); break;
      case BoundOperation::multiply: roundings.push_back(of(0) + of(1) + 1); break;
      case BoundOperation::maximum: roundings.push_back(std::max(of(0), of(1))); break;
    }
  }
  return roundings;
}

/// gamma(steps) of docs/error_bounds.md, theorem 2: the least factor between two numbers whose
/// encodings are `steps` apart. It is at least the ratio that the steps were chosen for.
mpq_class ratio_of_steps(Bits steps) {
  const auto doublings = static_cast<unsigned long>(steps >> (float_digits - 1));
  const auto rest = static_cast<unsigned long>(steps & low_mask(float_digits - 1));
  const mpq_class share(mpz_class(rest), mpz_class(1) << float_digits);
  return mpq_class(mpz_class(1) << doublings) / (1 - share);
}

bool all_finite(const ThresholdCriterion& criterion) {
  return std::isfinite(criterion.factor) &&
         std::all_of(
             criterion.conditions.begin(), criterion.conditions.end(),
             [](const FloatCondition& condition) { return std::isfinite(condition.factor); }) &&
         std::all_of(criterion.bound.nodes.begin(), criterion.bound.nodes.end(),
                     [](const error::BoundNode& node) {
                       return node.operation != BoundOperation::constant ||
                              std::isfinite(float_at_least(node.constant));
                     });
}

/// The criterion in binary32; nullopt if the guard has so many steps that binary32 cannot hold
/// their factor.
std::optional<ThresholdCriterion> threshold_of(const error::AbsoluteBoundCriterion& criterion) {
  constexpr Bits most_steps = Bits{1} << (float_digits + 6);
  if (criterion.guard_ulp > most_steps) return std::nullopt;
  const std::vector<int> roundings = bound_roundings(criterion.bound);
  ThresholdCriterion threshold{.difference = criterion.difference,
                               .bound = criterion.bound,
                               // The product with the factor also rounds.
                               .factor = float_at_least(ratio_of_steps(criterion.guard_ulp) *
                                                        inverse_of_roundings(roundings.back() + 1)),
                               .conditions = {}};
  for (const error::BoundCondition& condition : criterion.conditions) {
    const int count = roundings[static_cast<std::size_t>(condition.bound)] + 1;
    threshold.conditions.push_back(
        {condition.bound, condition.value, float_at_least(inverse_of_roundings(count))});
  }
  if (!all_finite(threshold)) return std::nullopt;
  return threshold;
}

/// Multiplies a constant bound by its factor here, so that the whole threshold is one literal.
void fold_constant(ThresholdCriterion& criterion) {
  error::BoundNode& last = criterion.bound.nodes.back();
  if (last.operation != BoundOperation::constant) return;
  last.constant *= mpq_class(criterion.factor);
  criterion.factor = 1;
}

Result<PartFilter> threshold_filter(BoundKind kind, const TypedGraph& graph,
                                    const scene::Scene& scene) {
  // A CPU gains nothing from hazards that ranges rule out: its flags tell when one occurs.
  MIXCMP_TRY(lane, error::certified_lane(graph, {.kind = kind,
                                                 .ranges = scene.ranges,
                                                 .hazards = error::HazardRemoval::keep}));
  auto criterion = threshold_of(std::get<error::AbsoluteBoundCriterion>(lane.criterion()));
  if (criterion) fold_constant(*criterion);
  if (!criterion || !all_finite(*criterion)) {
    return Error{.message = "the bound is out of binary32's range"};
  }
  return PartFilter{std::move(lane.graph), std::move(*criterion), std::move(lane.checks)};
}

Result<PartFilter> ratio_filter(const TypedGraph& graph, const scene::Scene& scene) {
  const error::ErrorAnalysis analysis = error::analyse_errors(graph, scene.nonnegative_inputs());
  const auto bound_of = [&](NodeId id) { return analysis.nodes[static_cast<std::size_t>(id)]; };
  const error::NodeBound f = bound_of(graph.f()), g = bound_of(graph.g());
  for (const error::NodeBound* side : {&f, &g}) {
    if (!side->relative) return Error{.message = side->reason};
  }
  const std::vector<error::Sign> signs = error::analyse_signs(graph, scene.nonnegative_inputs());
  const error::SignProof proof =
      error::both(signs[static_cast<std::size_t>(graph.f())].nonnegative,
                  signs[static_cast<std::size_t>(graph.g())].nonnegative);
  if (!proof) return Error{.message = "f and g are not proven to be non-negative"};
  const float ratio = float_at_least(
      std::max(f.relative->high / g.relative->low, g.relative->high / f.relative->low));
  if (!std::isfinite(ratio)) return Error{.message = "the errors are out of bounds"};
  PartFilter filter{graph, RatioCriterion{ratio}, {}};
  std::set<int> inputs = *proof;
  inputs.insert(analysis.nonnegative_inputs.begin(), analysis.nonnegative_inputs.end());
  for (const int input : inputs) {
    filter.checks.push_back(sign_check(input, error::RequiredSign::nonnegative));
  }
  return filter;
}

Result<FloatFilter> filter_of(BoundKind kind, const TypedGraph& graph, const scene::Scene& scene) {
  FloatFilter filter{.kind = kind, .parts = {}};
  for (std::size_t k = 0; k < graph.parts.size(); ++k) {
    const TypedGraph part = part_of(graph, k).graph;
    Result<PartFilter> made = kind == BoundKind::relative ? ratio_filter(part, scene)
                                                          : threshold_filter(kind, part, scene);
    if (!made.ok()) return error::of_part(made.error(), k, graph.parts.size());
    filter.parts.push_back(std::move(made).value());
  }
  return filter;
}

}  // namespace

float float_at_least(const mpq_class& value) {
  const auto bits = static_cast<std::uint32_t>(from_rational_up(float_format(), value));
  const auto rounded = std::bit_cast<float>(bits);
  return value == 0 ? 0 : std::max(rounded, std::numeric_limits<float>::min());
}

FloatFormat software_format() {
  return FloatFormat::parse("binary64").value();
}

FloatFilters float_filters(const scene::Scene& scene) {
  const TypedGraph graph = lane_graph(scene.graph.with_any_operands(), software_format(),
                                      {float_format()}, LaneInputs::rounded);
  FloatFilters found;
  for (const BoundKind kind : {BoundKind::constant, BoundKind::relative, BoundKind::running}) {
    Result<FloatFilter> filter = filter_of(kind, graph, scene);
    if (filter.ok()) {
      found.filters.push_back(std::move(filter).value());
    } else {
      found.missing.push_back({kind, filter.error().message});
    }
  }
  return found;
}

}  // namespace mixcmp::software
