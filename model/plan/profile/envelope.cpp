#include "model/plan/profile/envelope.hpp"

#include <algorithm>
#include <cmath>

#include "model/base/common/check.hpp"
#include "model/base/common/vector_clones.hpp"
#include "model/base/number/double.hpp"
#include "model/base/number/exact.hpp"
#include "model/plan/profile/envelope_kernels.hpp"

namespace mixcmp::profile {
namespace {

namespace kernels = envelope_kernels;

/// The exponents of double, with a margin for the errors of the smallest values.
constexpr int lowest_in_double = -900, highest_in_double = 900;

/// Whether the node's values are 0 or at least 2^lowest in magnitude, in every comparison.
bool is_never_tiny(const NodeMagnitude& magnitude, int lowest) {
  return magnitude.least != NodeMagnitude::unknown && magnitude.least >= lowest;
}

}  // namespace

Envelope::Envelope(const TypedGraph& lane, const Options& options)
    : options_(options), graph_(lane) {
  const FloatFormat format = lane.arithmetic.format, reference = options.reference;
  MIXCMP_CHECK(format.precision() == options.anchor && options.anchor <= options.last &&
               options.last <= settings::lane_precisions(reference).most &&
               reference.precision() <= 53);
  const bool nearest = lane.arithmetic.rounding == Rounding::nearest_even;
  unit_ = std::ldexp(1.0, (nearest ? 0 : 1) - options.anchor);
  lowest_ = 1 + std::max({format.min_exponent(), reference.min_exponent(), lowest_in_double});
  highest_ = std::min({format.max_exponent(), reference.max_exponent(), highest_in_double});
  graph_.nodes.push_back({.operation = Operation::subtract,
                          .operands = {lane.f(), lane.g()},
                          .operand_format = format,
                          .format = format,
                          .value = {}});
  for (const TypedNode& node : graph_.nodes) steps_.push_back(step(node));
  add_checks();
}

Envelope::Step Envelope::step(const TypedNode& node) const {
  Step step{.operation = node.operation, .operands = node.operands, .input = node.input};
  if (node.operation != Operation::constant) return step;
  step.constant = nearest_double(node.value);
  const double size = std::fabs(step.constant);
  const bool in_range = step.constant == 0
                            ? node.value == 0
                            : size >= std::ldexp(1.0, lowest_) && size < std::ldexp(1.0, highest_);
  if (!in_range) {
    step.constant_error = envelope_kernels::infinity;
  } else if (to_rational(node.format, node.constant) != node.value) {
    step.constant_error = std::ldexp(size, -anchor()) * envelope_kernels::outward;
  }
  return step;
}

void Envelope::add_checks() {
  const auto magnitudes = [&](int precision) {
    return node_magnitudes(graph_, precision, options_.inputs);
  };
  const auto in_double = magnitudes(53), in_reference = magnitudes(options_.reference.precision());
  std::vector<int> safe_until(steps_.size(), anchor() - 1);
  for (int precision = anchor(); precision <= options_.last; ++precision) {
    const auto in_lane = magnitudes(precision);
    for (std::size_t id = 0; id < steps_.size(); ++id) {
      Step& step = steps_[id];
      if (precision == anchor())
        step.may_be_large = !(in_lane[id].largest < std::ldexp(1.0, highest_));
      if (safe_until[id] == precision - 1 && is_never_tiny(in_lane[id], lowest_)) {
        safe_until[id] = precision;
      }
    }
  }
  for (std::size_t id = 0; id < steps_.size(); ++id) {
    const bool others =
        is_never_tiny(in_double[id], lowest_) && is_never_tiny(in_reference[id], lowest_);
    const int until = others ? safe_until[id] : anchor() - 1;
    steps_[id].never_tiny = until == options_.last;
    steps_[id].tiny_factor = std::ldexp(2.0, anchor() - until - 1);
  }
}

MIXCMP_VECTOR_CLONES void Envelope::check(const Step& step, const NodeEnvelope& node,
                                          EnvelopeRow& wild) const {
  if (step.may_be_large) {
    const double largest = std::ldexp(1.0, highest_) * (1 - 0x1p-40);
    envelope_kernels::for_each_lane([&](std::size_t k) {
      wild[k] = std::fabs(node.value[k]) + 2 * node.error[k] <= largest ? wild[k] : 1;
    });
  }
  if (!step.never_tiny) {
    const double tiny = std::ldexp(1.0, lowest_), factor = step.tiny_factor;
    envelope_kernels::for_each_lane([&](std::size_t k) {
      const double size = std::fabs(node.value[k]), error = node.error[k];
      const bool tame = size >= (tiny + factor * error) * envelope_kernels::outward;
      wild[k] = (tame | (size + error == 0)) ? wild[k] : 1;
    });
  }
}

MIXCMP_VECTOR_CLONES void Envelope::evaluate(std::span<const double* const> columns,
                                             EnvelopeBlock& block) const {
  block.nodes.resize(steps_.size());
  block.wild.fill(0);
  for (std::size_t id = 0; id < steps_.size(); ++id) {
    const Step& step = steps_[id];
    NodeEnvelope& y = block.nodes[id];
    const NodeEnvelope& a = block.nodes[std::max(step.operands[0], 0)];
    const NodeEnvelope& b = block.nodes[std::max(step.operands[1], 0)];
    switch (step.operation) {
      case Operation::input:
        std::copy_n(columns[step.input], envelope_width, y.value.begin());
        y.error.fill(0);
        break;
      case Operation::constant:
        y.value.fill(step.constant);
        y.error.fill(step.constant_error);
        break;
      case Operation::convert: envelope_kernels::converted(y, a, unit_); break;
      case Operation::negate: envelope_kernels::negated(y, a); break;
      case Operation::absolute: envelope_kernels::magnitude(y, a); break;
      case Operation::add: envelope_kernels::sum(y, a, b, 1, unit_); break;
      case Operation::subtract: envelope_kernels::sum(y, a, b, -1, unit_); break;
      case Operation::multiply: envelope_kernels::product(y, a, b, unit_); break;
      case Operation::square: envelope_kernels::square(y, a, unit_); break;
      case Operation::divide: envelope_kernels::quotient(y, a, b, unit_); break;
      case Operation::square_root: envelope_kernels::root(y, a, unit_); break;
      case Operation::minimum: envelope_kernels::selection(y, a, b, false); break;
      case Operation::maximum: envelope_kernels::selection(y, a, b, true); break;
      case Operation::function:
      case Operation::look_up:
      case Operation::fused_sum: MIXCMP_CHECK(!"lanes have no fused sums"); break;
    }
    check(step, y, block.wild);
  }
  const NodeEnvelope& last = block.nodes.back();
  envelope_kernels::for_each_lane(
      [&](std::size_t k) { block.wild[k] = last.error[k] <= 0x1p1000 ? block.wild[k] : 1; });
}

}  // namespace mixcmp::profile
