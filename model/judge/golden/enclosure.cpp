#include "model/judge/golden/enclosure.hpp"

#include <algorithm>

#include "model/judge/golden/encoding.hpp"
#include "model/lane/function/taylor.hpp"

namespace mixcmp::golden {
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

bool is_point(const Interval& x) {
  return mpfr_equal_p(x.low.get(), x.high.get()) != 0;
}

bool is_finite(const Interval& x) {
  return mpfr_number_p(x.low.get()) != 0 && mpfr_number_p(x.high.get()) != 0;
}

/// Whether |x| < 2^exponent.
bool is_below(const BigFloat& x, std::int64_t exponent) {
  return mpfr_zero_p(x.get()) != 0 || mpfr_get_exp(x.get()) <= exponent;
}

/// Whether the interval is so narrow around zero that a number with this separation must be zero.
bool is_proven_zero(const Interval& x, const Separation& separation) {
  const auto least = separation.least_exponent();
  return least && is_below(x.low, *least) && is_below(x.high, *least);
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

/// The hull of the operation on all four pairs of ends. It encloses products, and quotients whose
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

Knowledge enclose_quotient(Interval& y, const Interval& a, const Interval& b, BigFloat& scratch) {
  if (is_zero(b)) return Knowledge::undefined;
  if (may_be_zero(b)) return Knowledge::uncertain;
  hull(y, a, b, mpfr_div, scratch);
  return Knowledge::enclosed;
}

Knowledge enclose_root(Interval& y, const Interval& x) {
  if (mpfr_sgn(x.high.get()) < 0) return Knowledge::undefined;
  if (mpfr_sgn(x.low.get()) < 0) return Knowledge::uncertain;
  mpfr_sqrt(y.low.get(), x.low.get(), MPFR_RNDD);
  mpfr_sqrt(y.high.get(), x.high.get(), MPFR_RNDU);
  return Knowledge::enclosed;
}

/// The precision of the ends is kept. Where the function has a pole, mpfi gives NaN or an infinity.
Knowledge enclose_function(Interval& y, const Interval& x, const Function& function) {
  const Domain accepted = domain(function);
  const auto is_below = [&](const BigFloat& number) {
    if (!accepted.low) return false;
    const int order = mpfr_cmp_q(number.get(), accepted.low->at.get_mpq_t());
    return accepted.low->is_open ? order <= 0 : order < 0;
  };
  const auto is_above = [&](const BigFloat& number) {
    return accepted.high && mpfr_cmp_q(number.get(), accepted.high->at.get_mpq_t()) > 0;
  };
  if (is_below(x.high) || is_above(x.low)) return Knowledge::undefined;
  if (is_below(x.low) || is_above(x.high)) return Knowledge::uncertain;
  const mpfr_prec_t precision = y.low.precision();
  mpfi_t argument, value;
  mpfi_init2(argument, precision);
  mpfi_init2(value, precision);
  mpfi_interv_fr(argument, x.low.get(), x.high.get());
  function::enclose(function, value, argument);
  mpfi_get_left(y.low.get(), value);
  mpfi_get_right(y.high.get(), value);
  mpfi_clear(argument);
  mpfi_clear(value);
  return is_finite(y) ? Knowledge::enclosed : Knowledge::uncertain;
}

bool is_commutative(Operation operation) {
  return operation == Operation::add || operation == Operation::multiply || is_choice(operation);
}

/// Computes both ends by one operation that is monotone in both operands.
void monotone(Interval& y, const Interval& a, const Interval& b, Operate operate) {
  operate(y.low.get(), a.low.get(), b.low.get(), MPFR_RNDD);
  operate(y.high.get(), a.high.get(), b.high.get(), MPFR_RNDU);
}

}  // namespace

mpfr_prec_t last_precision(FloatFormat format) {
  return std::max(1 << 14, 4 << format.exponent_bits());
}

Enclosure::Enclosure(const Graph& graph, mpfr_prec_t precision)
    : Enclosure(graph, {graph.f(), graph.g()}, precision) {}

Enclosure::Enclosure(const Graph& graph, Sides part, mpfr_prec_t precision)
    : graph_(graph),
      part_(part),
      needed_(needed_nodes(graph, part)),
      known_(needed_.size(), false),
      scratch_(precision) {
  MIXCMP_CHECK(precision >= encoding_precision);
  values_.reserve(graph.nodes().size());
  for (size_t id = 0; id < graph.nodes().size(); ++id) {
    values_.push_back({BigFloat(precision), BigFloat(precision)});
  }
}

Knowledge Enclosure::compute(FloatFormat format, std::span<const Bits> inputs) {
  separations_.clear();
  equal_.clear();
  Knowledge knowledge = Knowledge::enclosed;
  for (NodeId id = 0; id < static_cast<NodeId>(values_.size()); ++id) {
    if (!needed_[id]) continue;
    known_[id] = false;
    if (!operands_are_known(id)) continue;
    const Knowledge one = compute_node(id, format, inputs);
    if (one == Knowledge::undefined) return one;
    // An interval beyond MPFR's exponents is never finite, whatever the number of digits.
    known_[id] = one == Knowledge::enclosed && is_finite(values_[id]);
    if (!known_[id]) knowledge = Knowledge::uncertain;
    if (known_[id]) decide_zero(id);
  }
  return knowledge;
}

bool Enclosure::operands_are_known(NodeId id) const {
  const Node& node = graph_.nodes()[id];
  for (int k = 0; k < arity(node.operation); ++k) {
    if (!known_[node.operands[k]]) return false;
  }
  return true;
}

void Enclosure::decide_zero(NodeId id) {
  Interval& y = values_[id];
  if (!may_be_zero(y) || is_point(y)) return;
  const Node& node = graph_.nodes()[id];
  const bool cancels =
      node.operation == Operation::subtract && are_equal(node.operands[0], node.operands[1]);
  if (!cancels && !is_proven_zero(y, separation(id))) return;
  mpfr_set_zero(y.low.get(), 1);
  mpfr_set_zero(y.high.get(), 1);
}

bool Enclosure::are_equal() {
  return are_equal(part_.f, part_.g);
}

bool Enclosure::are_equal(NodeId a, NodeId b) {
  if (a == b) return true;
  const auto [found, is_new] = equal_.try_emplace({a, b}, false);
  if (!is_new) return found->second;
  return equal_[{a, b}] = are_proven_equal(a, b);
}

/// By the intervals and separations of two nodes, or by what they are computed from.
bool Enclosure::are_proven_equal(NodeId a, NodeId b) {
  Interval difference{BigFloat(scratch_.precision()), BigFloat(scratch_.precision())};
  const Interval &x = values_[a], &y = values_[b];
  mpfr_sub(difference.low.get(), x.low.get(), y.high.get(), MPFR_RNDD);
  mpfr_sub(difference.high.get(), x.high.get(), y.low.get(), MPFR_RNDU);
  if (is_zero(difference)) return true;
  if (!may_be_zero(difference)) return false;
  return is_proven_zero(difference, separation_of_sum(separation(a), separation(b))) ||
         apply_the_same(a, b);
}

/// Whether two nodes are the same operation on equal operands, such as exp(a) and exp(b) with a =
/// b. Functions have no separation that would prove it.
bool Enclosure::apply_the_same(NodeId a, NodeId b) {
  const Node &first = graph_.nodes()[a], &second = graph_.nodes()[b];
  const int count = arity(first.operation);
  if (count == 0 || first.operation != second.operation || first.function != second.function) {
    return false;
  }
  const auto same = [&](int k, int other) {
    return are_equal(first.operands[k], second.operands[other]);
  };
  if (same(0, 0) && (count == 1 || same(1, 1))) return true;
  return is_commutative(first.operation) && same(0, 1) && same(1, 0);
}

const Separation& Enclosure::separation(NodeId id) {
  if (separations_.empty()) separations_.resize(values_.size());
  if (!separations_[id]) separations_[id] = find_separation(id);
  return *separations_[id];
}

/// If the interval is a point, the separation is that of the number, whatever it was computed from.
Separation Enclosure::find_separation(NodeId id) {
  if (is_point(values_[id])) return separation_of(values_[id].low);
  const Node& node = graph_.nodes()[id];
  const auto a = [&]() -> const Separation& { return separation(node.operands[0]); };
  const auto b = [&]() -> const Separation& { return separation(node.operands[1]); };
  switch (node.operation) {
    case Operation::constant: return separation_of(node.value);
    case Operation::negate:
    case Operation::absolute: return a();
    case Operation::add:
    case Operation::subtract: return separation_of_sum(a(), b());
    case Operation::multiply: return separation_of_product(a(), b());
    case Operation::square: return separation_of_product(a(), a());
    case Operation::divide: return separation_of_quotient(a(), b());
    case Operation::square_root: return separation_of_root(a(), id);
    case Operation::minimum:
    case Operation::maximum: return separation_of_either(a(), b());
    case Operation::function: return no_separation();
    case Operation::input:  // an input's interval is a point
    case Operation::convert:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
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
    case Operation::convert:
    case Operation::look_up:
    case Operation::fused_sum: MIXCMP_CHECK(false); break;  // no real number is rounded
    case Operation::function: return enclose_function(y, a, *node.function);
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
    case Operation::divide: return enclose_quotient(y, a, b, scratch_);
    case Operation::square_root: return enclose_root(y, a);
    case Operation::minimum: monotone(y, a, b, mpfr_min); break;
    case Operation::maximum: monotone(y, a, b, mpfr_max); break;
  }
  return Knowledge::enclosed;
}

}  // namespace mixcmp::golden
