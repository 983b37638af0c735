#include "model/lane/fixed/root_error.hpp"

#include <algorithm>

#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/norm_bound.hpp"

namespace mixcmp::fixed {
namespace {

/// A root is computed from `least` or more, and its radicand exceeds the real one by `error` >= 0.
/// The root then exceeds the real one by at most the result.
mpq_class raised_by(const mpq_class& error, const mpq_class& least) {
  if (least < error) return root_above(error, root_digits);
  return root_above(least, root_digits) - root_of(mpq_class(least - error), root_digits);
}

/// A root is computed from `least` or more, and its radicand falls short of the real one by `error`
/// >= 0. The root then falls short of the real one by at most the result.
mpq_class lowered_by(const mpq_class& error, const mpq_class& least) {
  return root_above(least + error, root_digits) - root_of(least, root_digits);
}

}  // namespace

bool is_nonnegative(const std::vector<FixedNode>& nodes, NodeId id) {
  const FixedNode& node = nodes[id];
  if (node.value.low < 0) return false;
  if (node.value.low - node.error.high >= 0) return true;
  const auto operand = [&](int k) { return is_nonnegative(nodes, node.operands[k]); };
  switch (node.operation) {
    case Operation::input:  // of a format without a sign
    case Operation::square:
    case Operation::absolute:
    case Operation::square_root: return true;
    case Operation::add:
    case Operation::multiply:
    case Operation::minimum: return operand(0) && operand(1);
    case Operation::convert: return follows_operands(node) && operand(0);
    case Operation::maximum: return operand(0) || operand(1);
    case Operation::constant:
    case Operation::negate:
    case Operation::subtract:
    case Operation::divide:
    case Operation::look_up:
    case Operation::fused_sum: return false;
    case Operation::function: break;
  }
  MIXCMP_CHECK(false);
}

Range root_error(const std::vector<FixedNode>& nodes, NodeId radicand) {
  const FixedNode& node = nodes[radicand];
  const mpq_class least = std::max<mpq_class>(0, node.value.low);
  Range error = {-lowered_by(std::max<mpq_class>(0, -node.error.low), least),
                 raised_by(std::max<mpq_class>(0, node.error.high), least)};
  if (const auto norm = squared_norm(nodes, radicand)) {
    const mpq_class lost = norm->dropped == 0 ? 0 : lowered_by(norm->dropped, least);
    error.low = std::max<mpq_class>(error.low, -norm->error - lost);
    error.high = std::min(error.high, norm->error);
  }
  return error;
}

}  // namespace mixcmp::fixed
