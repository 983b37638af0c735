#include "model/lane/error/sign.hpp"

#include "model/base/common/check.hpp"

namespace mixcmp::error {
namespace {

Sign product_sign(const Sign& a, const Sign& b) {
  return {either(both(a.nonnegative, b.nonnegative), both(a.nonpositive, b.nonpositive)),
          either(both(a.nonnegative, b.nonpositive), both(a.nonpositive, b.nonnegative))};
}

const std::set<int> nothing = {};

Sign constant_sign(const mpq_class& value) {
  return {value >= 0 ? SignProof(nothing) : std::nullopt,
          value <= 0 ? SignProof(nothing) : std::nullopt};
}

Sign term_sign(const FusedTerm& term, const std::vector<Sign>& signs) {
  Sign sign = signs[term.a];
  if (term.is_square()) sign = {nothing, std::nullopt};
  if (term.is_product() && !term.is_square()) sign = product_sign(sign, signs[term.b]);
  return term.negated ? sign.negated() : sign;
}

Sign sign_of(const TypedNode& node, const std::vector<Sign>& signs,
             const std::vector<bool>& input_nonnegative) {
  const Sign unknown;
  const Sign& a = node.operands[0] < 0 ? unknown : signs[node.operands[0]];
  const Sign& b = node.operands[1] < 0 ? unknown : signs[node.operands[1]];
  switch (node.operation) {
    case Operation::input:
      if (!input_nonnegative[node.input]) return unknown;
      return {std::set<int>{node.input}, std::nullopt};
    case Operation::constant: return constant_sign(node.value);
    case Operation::convert: return a;
    case Operation::negate: return a.negated();
    case Operation::add: return sum_sign(a, b);
    case Operation::subtract: return sum_sign(a, b.negated());
    case Operation::multiply:
    case Operation::divide: return product_sign(a, b);
    case Operation::absolute:
    case Operation::square:
    case Operation::square_root: return {nothing, std::nullopt};
    case Operation::minimum:
      return {both(a.nonnegative, b.nonnegative), either(a.nonpositive, b.nonpositive)};
    case Operation::maximum:
      return {either(a.nonnegative, b.nonnegative), both(a.nonpositive, b.nonpositive)};
    case Operation::fused_sum: return sum_sign(node.terms, signs);
    case Operation::function:
    case Operation::look_up: break;
  }
  MIXCMP_CHECK(false);
}

}  // namespace

SignProof both(const SignProof& a, const SignProof& b) {
  if (!a || !b) return std::nullopt;
  std::set<int> inputs = *a;
  inputs.insert(b->begin(), b->end());
  return inputs;
}

SignProof either(const SignProof& a, const SignProof& b) {
  if (!a || !b) return a ? a : b;
  return a->size() <= b->size() ? a : b;
}

Sign sum_sign(const Sign& a, const Sign& b) {
  return {both(a.nonnegative, b.nonnegative), both(a.nonpositive, b.nonpositive)};
}

Sign sum_sign(const std::vector<FusedTerm>& terms, const std::vector<Sign>& signs) {
  Sign sign = term_sign(terms.front(), signs);
  for (const FusedTerm& term : terms) sign = sum_sign(sign, term_sign(term, signs));
  return sign;
}

std::vector<Sign> analyse_signs(const TypedGraph& graph,
                                const std::vector<bool>& input_nonnegative) {
  std::vector<Sign> signs;
  for (const TypedNode& node : graph.nodes) {
    signs.push_back(sign_of(node, signs, input_nonnegative));
  }
  return signs;
}

}  // namespace mixcmp::error
