#include "model/lane/error/exactness.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/lane/error/range_analysis.hpp"

namespace mixcmp::error {
namespace {

/// A power of two that divides every value of a node; none: no such power is known.
using Quantum = std::optional<mpq_class>;

/// The largest power of two that divides a dyadic rational. None for other rationals, and for 0,
/// which every power of two divides.
Quantum quantum_of(const mpq_class& value) {
  if (value == 0 || mpz_popcount(value.get_den_mpz_t()) != 1) return std::nullopt;
  const mp_bitcnt_t zeros = mpz_scan1(value.get_num_mpz_t(), 0);
  return mpq_class(mpz_class(1) << zeros, value.get_den());
}

class ExactnessAnalyser {
public:
  ExactnessAnalyser(const TypedGraph& graph, const std::vector<std::optional<Range>>& ranges,
                    const std::vector<std::optional<mpq_class>>& grids)
      : graph_(graph), ranges_(analyse_ranges(graph, ranges)), declared_(ranges), grids_(grids) {}

  std::vector<bool> run() {
    std::vector<bool> exact;
    for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
      Quantum quantum = quantum_of_result(id);
      if (quantum && !fits(id, *quantum)) quantum.reset();
      quanta_.push_back(quantum);
      exact.push_back(quantum.has_value());
    }
    return exact;
  }

private:
  Quantum quantum_of_result(NodeId id) const {
    const TypedNode& node = graph_.nodes[id];
    const Quantum none;
    const Quantum& a = node.operands[0] < 0 ? none : quanta_[node.operands[0]];
    const Quantum& b = node.operands[1] < 0 ? none : quanta_[node.operands[1]];
    switch (node.operation) {
      case Operation::input: return declared_[node.input] ? grids_[node.input] : none;
      case Operation::constant: return constant(node);
      case Operation::convert:
      case Operation::negate:
      case Operation::absolute: return a;
      case Operation::add:
      case Operation::subtract:
      case Operation::minimum:
      case Operation::maximum: return a && b ? Quantum(std::min(*a, *b)) : none;
      case Operation::multiply: return a && b ? Quantum(*a * *b) : none;
      case Operation::square: return a ? Quantum(*a * *a) : none;
      case Operation::divide: return quotient(a, graph_.nodes[node.operands[1]]);
      case Operation::square_root:
      case Operation::fused_sum: return none;
    }
    MIXCMP_CHECK(false);
  }

  /// The quantum of a constant that the format holds exactly. Zero is a multiple of every power of
  /// two; its quantum is set to 1.
  static Quantum constant(const TypedNode& node) {
    if (node.format.is_infinite(node.constant)) return std::nullopt;
    if (to_rational(node.format, node.constant) != node.value) return std::nullopt;
    return node.value == 0 ? Quantum(1) : quantum_of(node.value);
  }

  static Quantum quotient(const Quantum& a, const TypedNode& divisor) {
    const bool scales =
        divisor.operation == Operation::constant && is_power_of_two(abs(divisor.value));
    if (!a || !scales) return std::nullopt;
    return mpq_class(*a / abs(divisor.value));
  }

  /// Whether multiples of `quantum` in the node's range are numbers of the format: at most 2^P
  /// quanta, and neither too large nor too small.
  bool fits(NodeId id, const mpq_class& quantum) const {
    const NodeRange& range = ranges_[static_cast<std::size_t>(id)];
    const FloatFormat format = graph_.nodes[id].format;
    const mpq_class most =
        std::max<mpq_class>(abs(range.value.low), abs(range.value.high)) / quantum;
    if (range.may(Event::overflow) || most > mpz_class(1) << format.precision()) return false;
    const bool gradual = graph_.arithmetic.subnormals == Subnormals::gradual;
    return quantum >= to_rational(format, gradual ? Bits{1} : format.smallest_normal(false));
  }

  const TypedGraph& graph_;
  std::vector<NodeRange> ranges_;
  const std::vector<std::optional<Range>>& declared_;
  const std::vector<std::optional<mpq_class>>& grids_;
  std::vector<Quantum> quanta_;
};

}  // namespace

std::vector<bool> exact_on_grid(const TypedGraph& graph,
                                const std::vector<std::optional<Range>>& ranges,
                                const std::vector<std::optional<mpq_class>>& grids) {
  MIXCMP_CHECK(ranges.size() == grids.size());
  return ExactnessAnalyser(graph, ranges, grids).run();
}

}  // namespace mixcmp::error
