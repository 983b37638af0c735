#include "model/golden/enclosure.hpp"

#include "model/golden/encoding.hpp"

namespace mixcmp::model::golden {
namespace {

using Operate = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

std::vector<bool> needed_nodes(const Graph& graph, Sides part) {
  std::vector<bool> needed(graph.nodes().size(), false);
  needed[part.f] = needed[part.g] = true;
  for (auto id = static_cast<NodeId>(needed.size()) - 1; id >= 0; --id) {
    const Node& node = graph.nodes()[id];
    for (int k = 0; needed[id] && k < arity(node.operation); ++k) needed[node.operands[k]] = true;
  }
  return needed;
}

bool is_zero(const Interval& x) {
  return mpfr_zero_p(x.low.get()) != 0 && mpfr_zero_p(x.high.get()) != 0;
}

bool may_be_zero(const Interval& x) {
  return mpfr_sgn(x.low.get()) <= 0 && mpfr_sgn(x.high.get()) >= 0;
}

void negate(Interval& y, const Interval& x) {
  mpfr_neg(y.low.get(), x.high.get(), MPFR_RNDD);
  mpfr_neg(y.high.get(), x.low.get(), MPFR_RNDU);
}

void absolute(Interval& y, const Interval& x) {
  negate(y, x);
  if (mpfr_sgn(x.high.get()) <= 0) return;
  mpfr_max(y.high.get(), y.high.get(), x.high.get(), MPFR_RNDU);
  if (mpfr_sgn(x.low.get()) >= 0) {
    mpfr_set(y.low.get(), x.low.get(), MPFR_RNDD);
  } else {
    mpfr_set_zero(y.low.get(), 1);
  }
}

/// The hull of the operation on all four pairs of ends: right for products, and for quotients whose
/// divisor keeps its sign.
void hull(Interval& y, const Interval& a, const Interval& b, Operate operate, BigFloat& scratch) {
  operate(y.low.get(), a.low.get(), b.low.get(), MPFR_RNDD);
  operate(y.high.get(), a.low.get(), b.low.get(), MPFR_RNDU);
  const auto include = [&](const BigFloat& first, const BigFloat& second) {
    operate(scratch.get(), first.get(), second.get(), MPFR_RNDD);
    mpfr_min(y.low.get(), y.low.get(), scratch.get(), MPFR_RNDD);
    operate(scratch.get(), first.get(), second.get(), MPFR_RNDU);
    mpfr_max(y.high.get(), y.high.get(), scratch.get(), MPFR_RNDU);
  };
  include(a.low, b.high);
  include(a.high, b.low);
  include(a.high, b.high);
}

Knowledge divide(Interval& y, const Interval& a, const Interval& b, BigFloat& scratch) {
  if (is_zero(b)) return Knowledge::undefined;
  if (may_be_zero(b)) return Knowledge::uncertain;
  hull(y, a, b, mpfr_div, scratch);
  return Knowledge::enclosed;
}

Knowledge square_root(Interval& y, const Interval& x) {
  if (mpfr_sgn(x.high.get()) < 0) return Knowledge::undefined;
  if (mpfr_sgn(x.low.get()) < 0) return Knowledge::uncertain;
  mpfr_sqrt(y.low.get(), x.low.get(), MPFR_RNDD);
  mpfr_sqrt(y.high.get(), x.high.get(), MPFR_RNDU);
  return Knowledge::enclosed;
}

/// Both ends by the same operation, which grows with both operands.
void monotone(Interval& y, const Interval& a, const Interval& b, Operate operate) {
  operate(y.low.get(), a.low.get(), b.low.get(), MPFR_RNDD);
  operate(y.high.get(), a.high.get(), b.high.get(), MPFR_RNDU);
}

}  // namespace

Enclosure::Enclosure(const Graph& graph, mpfr_prec_t precision)
    : Enclosure(graph, {graph.f(), graph.g()}, precision) {}

Enclosure::Enclosure(const Graph& graph, Sides part, mpfr_prec_t precision)
    : graph_(graph), part_(part), needed_(needed_nodes(graph, part)), scratch_(precision) {
  MIXCMP_CHECK(precision >= encoding_precision);
  values_.reserve(graph.nodes().size());
  for (size_t id = 0; id < graph.nodes().size(); ++id) {
    values_.push_back({BigFloat(precision), BigFloat(precision)});
  }
}

Knowledge Enclosure::compute(FloatFormat format, std::span<const Bits> inputs) {
  Knowledge knowledge = Knowledge::enclosed;
  for (size_t id = 0; id < values_.size() && knowledge == Knowledge::enclosed; ++id) {
    if (needed_[id]) knowledge = compute_node(static_cast<NodeId>(id), format, inputs);
  }
  return knowledge;
}

Knowledge Enclosure::compute_node(NodeId id, FloatFormat format, std::span<const Bits> inputs) {
  const Node& node = graph_.nodes()[id];
  Interval& y = values_[id];
  const Interval& a = values_[node.operands[0] < 0 ? id : node.operands[0]];
  const Interval& b = values_[node.operands[1] < 0 ? id : node.operands[1]];
  switch (node.operation) {
    case Operation::input:
      decode(y.low, format, inputs[node.input]);
      decode(y.high, format, inputs[node.input]);
      return mpfr_number_p(y.low.get()) != 0 ? Knowledge::enclosed : Knowledge::undefined;
    case Operation::constant:
      mpfr_set_q(y.low.get(), node.value.get_mpq_t(), MPFR_RNDD);
      mpfr_set_q(y.high.get(), node.value.get_mpq_t(), MPFR_RNDU);
      break;
    case Operation::convert: MIXCMP_CHECK(false); break;  // real numbers have no format
    case Operation::negate: negate(y, a); break;
    case Operation::absolute: absolute(y, a); break;
    case Operation::add: monotone(y, a, b, mpfr_add); break;
    case Operation::subtract:
      mpfr_sub(y.low.get(), a.low.get(), b.high.get(), MPFR_RNDD);
      mpfr_sub(y.high.get(), a.high.get(), b.low.get(), MPFR_RNDU);
      break;
    case Operation::multiply: hull(y, a, b, mpfr_mul, scratch_); break;
    case Operation::square:
      absolute(y, a);
      monotone(y, y, y, mpfr_mul);
      break;
    case Operation::divide: return divide(y, a, b, scratch_);
    case Operation::square_root: return square_root(y, a);
    case Operation::minimum: monotone(y, a, b, mpfr_min); break;
    case Operation::maximum: monotone(y, a, b, mpfr_max); break;
  }
  return Knowledge::enclosed;
}

}  // namespace mixcmp::model::golden
