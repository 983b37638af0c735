#include "model/plan/profile/bound_envelope.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "model/base/common/check.hpp"
#include "model/base/number/bound_format.hpp"
#include "model/plan/profile/envelope_kernels.hpp"

namespace mixcmp::profile {
namespace {

using envelope_kernels::for_each_lane;
using envelope_kernels::infinity;
using envelope_kernels::outward;

const error::AbsoluteBoundCriterion& decision_of(const error::Lane& lane) {
  return std::get<error::AbsoluteBoundCriterion>(lane.criterion());
}

bool is_constant(const error::AbsoluteBoundCriterion& criterion) {
  return criterion.bound.nodes.size() == 1 &&
         criterion.bound.nodes.front().operation == error::BoundOperation::constant;
}

/// The constant as the hardware encodes it; infinite if it exceeds the format.
double encoded(BoundFormat format, const mpq_class& value) {
  const Bits bound = encode_bound(format, value);
  if (bound == format.infinity()) return infinity;
  return bound_value(format, bound).get_d();
}

/// 2^floor(log2 value) of a positive normal double.
double binade(double value) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) >> 52 << 52);
}

/// An upper bound of a + b, too large by less than two units in the last place.
double sum_up(double a, double b) {
  const double larger = a < b ? b : a, smaller = a < b ? a : b;
  const double sum = larger + smaller;
  return smaller - (sum - larger) > 0 ? sum * (1 + 0x1p-52) : sum;
}

/// An upper bound of |computed value| at every precision.
double largest(const NodeEnvelope& node, std::size_t k) {
  return (std::fabs(node.value[k]) + 1.5 * node.error[k]) * outward;
}
double smallest(const NodeEnvelope& node, std::size_t k) {
  return (std::fabs(node.value[k]) - 1.5 * node.error[k]) / outward;
}

}  // namespace

bool BoundEnvelope::same_structure(const error::AbsoluteBoundCriterion& a,
                                   const error::AbsoluteBoundCriterion& b) {
  const auto same_node = [](const error::BoundNode& x, const error::BoundNode& y) {
    return x.operation == y.operation && x.operands == y.operands && x.value == y.value;
  };
  const auto same_condition = [](const error::BoundCondition& x, const error::BoundCondition& y) {
    return x.bound == y.bound && x.value == y.value;
  };
  // Formats may differ only if nothing is rounded: between bounds that are a single constant.
  const bool alike = a.bound.format == b.bound.format || (is_constant(a) && is_constant(b));
  return alike &&
         std::equal(a.bound.nodes.begin(), a.bound.nodes.end(), b.bound.nodes.begin(),
                    b.bound.nodes.end(), same_node) &&
         std::equal(a.conditions.begin(), a.conditions.end(), b.conditions.begin(),
                    b.conditions.end(), same_condition);
}

BoundEnvelope::BoundEnvelope(std::span<const error::Lane* const> lanes, int first, int last,
                             const Envelope& envelope)
    : anchor_(envelope.anchor()),
      digits_(decision_of(*lanes.back()).bound.format.precision),
      conditions_(decision_of(*lanes.front()).conditions) {
  const error::BoundGraph& bound = decision_of(*lanes.front()).bound;
  const double tiny = std::ldexp(1.0, 1 - bound.format.bias());
  smallest_[0] = tiny;
  smallest_[1] = std::ldexp(tiny, last - anchor_);
  largest_ = std::ldexp(1.0, bound.format.bias());
  for (const error::BoundNode& node : bound.nodes) {
    Step step{.operation = node.operation, .operands = node.operands, .value = node.value};
    const auto degree = [&](int k) { return steps_[node.operands[k]].degree; };
    switch (node.operation) {
      case error::BoundOperation::constant:
        add_constant(step, lanes, first, static_cast<int>(steps_.size()));
        break;
      case error::BoundOperation::magnitude:
      case error::BoundOperation::binade:
      case error::BoundOperation::reciprocal: break;
      case error::BoundOperation::add:
      case error::BoundOperation::maximum: step.degree = std::min(degree(0), degree(1)); break;
      case error::BoundOperation::multiply: step.degree = std::max(degree(0), degree(1)); break;
    }
    steps_.push_back(step);
  }
}

/// Chooses degree 1 if the constants shrink about as fast as 2^-L. Either degree is sound.
void BoundEnvelope::add_constant(Step& step, std::span<const error::Lane* const> lanes, int first,
                                 int id) {
  double plain = 0, scaled = 0;
  int precision = first;
  for (const error::Lane* lane : lanes) {
    const error::BoundGraph& bound = decision_of(*lane).bound;
    const double value = encoded(bound.format, bound.nodes[id].constant);
    plain = std::max(plain, value);
    scaled = std::max(scaled, std::ldexp(value, precision - anchor_));
    ++precision;
  }
  const double at_first = std::ldexp(plain, first - anchor_);
  step.degree = scaled <= 4 * at_first ? 1 : 0;
  step.constant = step.degree == 1 ? scaled : plain;
}

/// Rounds a row up to the digits of the bound's format. Scaling by a power of two commutes with
/// that, so one rounding is valid for every precision.
void BoundEnvelope::round_up(EnvelopeRow& row, double least, EnvelopeRow& wild) const {
  const std::uint64_t below = (std::uint64_t{1} << (53 - digits_)) - 1;
  for_each_lane([&](std::size_t k) {
    const double value = row[k] > least ? row[k] : least;
    const auto rounded =
        std::bit_cast<double>((std::bit_cast<std::uint64_t>(value) + below) & ~below);
    wild[k] = rounded < largest_ ? wild[k] : 1;
    row[k] = rounded;
  });
}

void BoundEnvelope::evaluate(const Step& step, const EnvelopeBlock& block,
                             std::vector<EnvelopeRow>& rows, EnvelopeRow& wild) const {
  EnvelopeRow& y = rows[&step - steps_.data()];
  const EnvelopeRow& a = rows[std::max(step.operands[0], 0)];
  const EnvelopeRow& b = rows[std::max(step.operands[1], 0)];
  const NodeEnvelope& value = block.nodes[std::max(step.value, 0)];
  // Two factors of at most 26 digits have an exact product in double.
  const double product_error = digits_ <= 26 ? 1 : outward;
  switch (step.operation) {
    case error::BoundOperation::constant: y.fill(step.constant); break;
    case error::BoundOperation::magnitude:
      for_each_lane([&](std::size_t k) { y[k] = largest(value, k); });
      break;
    case error::BoundOperation::binade:
      for_each_lane([&](std::size_t k) { y[k] = binade(largest(value, k)); });
      break;
    case error::BoundOperation::reciprocal:
      for_each_lane([&](std::size_t k) {
        const double least = smallest(value, k);
        const double reciprocal = 1 / binade(least);
        y[k] = least > 0 ? reciprocal : infinity;
      });
      break;
    case error::BoundOperation::add:
      for_each_lane([&](std::size_t k) { y[k] = sum_up(a[k], b[k]); });
      break;
    case error::BoundOperation::multiply:
      for_each_lane([&](std::size_t k) { y[k] = a[k] * b[k] * product_error; });
      break;
    case error::BoundOperation::maximum:
      for_each_lane([&](std::size_t k) { y[k] = a[k] < b[k] ? b[k] : a[k]; });
      break;
  }
  round_up(y, smallest_[step.degree], wild);
}

void BoundEnvelope::raise(const EnvelopeBlock& block, EnvelopeRow& scaled, EnvelopeRow& fixed,
                          EnvelopeRow& wild) const {
  thread_local std::vector<EnvelopeRow> rows;
  rows.resize(std::max(rows.size(), steps_.size()));
  for (const Step& step : steps_) evaluate(step, block, rows, wild);
  for (const error::BoundCondition& condition : conditions_) {
    const EnvelopeRow& bound = rows[condition.bound];
    const NodeEnvelope& value = block.nodes[condition.value];
    for_each_lane([&](std::size_t k) { wild[k] = bound[k] <= smallest(value, k) ? wild[k] : 1; });
  }
  const EnvelopeRow& bound = rows[steps_.size() - 1];
  EnvelopeRow& target = steps_.back().degree == 1 ? scaled : fixed;
  for_each_lane([&](std::size_t k) { target[k] = target[k] < bound[k] ? bound[k] : target[k]; });
}

}  // namespace mixcmp::profile
