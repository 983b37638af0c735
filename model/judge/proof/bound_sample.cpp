#include "model/judge/proof/bound_sample.hpp"

#include <algorithm>
#include <cstdint>
#include <random>

#include "model/base/common/check.hpp"
#include "model/base/number/exact.hpp"

namespace mixcmp::proof {
namespace {

mpq_class random_number(std::mt19937_64& random) {
  constexpr std::uint64_t most_doublings = 400;
  const mpz_class digits = random() | 1;
  const mpz_class divisor = mpz_class(1) << (random() % most_doublings);
  mpq_class number(digits, divisor);
  number.canonicalize();
  return number;
}

}  // namespace

BoundSample::BoundSample(const TypedGraph& graph, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (const TypedNode& node : graph.nodes) {
    const bool constant =
        node.operation == Operation::constant && !node.format.is_infinite(node.constant);
    magnitudes_.push_back(constant ? mpq_class(abs(to_rational(node.format, node.constant)))
                                   : random_number(random));
    binades_.push_back(random_number(random));
    reciprocals_.push_back(random_number(random));
  }
}

mpq_class BoundSample::value(const std::vector<error::BoundNode>& bounds, error::BoundId id) const {
  if (id == error::no_bound_node) return 0;
  const error::BoundNode& node = bounds[id];
  const auto operand = [&](int k) { return value(bounds, node.operands[k]); };
  switch (node.operation) {
    case error::BoundOperation::constant: return node.constant;
    case error::BoundOperation::magnitude: return magnitude(node.value);
    case error::BoundOperation::binade: return binade(node.value);
    case error::BoundOperation::reciprocal: return reciprocal(node.value);
    case error::BoundOperation::add: return operand(0) + operand(1);
    case error::BoundOperation::multiply: return operand(0) * operand(1);
    case error::BoundOperation::maximum: return std::max(operand(0), operand(1));
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::proof
