#include "model/fixed/running_bound.hpp"

#include <algorithm>

#include "model/fixed/node_enclosure.hpp"
#include "model/fixed/root_error.hpp"
#include "model/number/dyadic.hpp"

namespace mixcmp::fixed {
namespace {

/// Eight steps are three bits in hardware: with a bit of a threshold they fit one table of a LUT.
constexpr int most_last_step = 7;

/// What both ranges contain; the first where they have nothing in common: no comparison that a
/// lane decides is there.
Range common(const Range& whole, const Range& part) {
  const Range both = {std::max(whole.low, part.low), std::min(whole.high, part.high)};
  return both.low <= both.high ? both : whole;
}

/// Encloses all nodes again, for comparisons of one step.
class StepEnclosure {
public:
  StepEnclosure(const std::vector<FixedNode>& nodes, int bits, const std::vector<NodeId>& watched,
                int step, int last_step)
      : bits_(bits), nodes_(nodes) {
    for (NodeId id = 0; id < static_cast<NodeId>(nodes_.size()); ++id) {
      enclose(nodes_[id]);
      if (std::find(watched.begin(), watched.end(), id) == watched.end()) continue;
      const mpq_class beyond = magnitude_in_step(nodes_[id], step, last_step);
      narrow(nodes_[id].value, {-beyond, beyond - nodes_[id].format.unit()});
    }
  }

  const FixedNode& node(NodeId id) const { return nodes_[id]; }

private:
  static void narrow(Range& whole, const Range& part) { whole = common(whole, part); }

  /// Narrows value and error to what follows from those of the operands.
  void enclose(FixedNode& node) const {
    if (arity(node.operation) == 0) return;
    const FixedNode& a = nodes_[node.operands[0]];
    const FixedNode& b = nodes_[node.operands[arity(node.operation) - 1]];
    const mpq_class unit = node.format.unit();
    if (is_common_cut(node)) {
      narrow(node.value, cut_value(a, bits_, node.most_dropped));
      return narrow(node.error, cut_error(a, node.most_dropped));
    }
    Range value = a.value, error = a.error;
    mpq_class dropped = unit * (1 - power_of_two(-node.dropped_bits));
    if (node.operation == Operation::square_root) {
      value = {root_of(a.value.low, root_digits), root_above(a.value.high, root_digits)};
      error = root_error(nodes_, node.operands[0]);
      dropped = unit;
    } else if (node.operation != Operation::convert) {
      value = exact_value(node.operation, a.value, b.value);
      error = exact_error(node.operation, a, b);
    }
    narrow(node.value, rounded_down(value, unit));
    narrow(node.error, {error.low - dropped, error.high});
  }

  int bits_;
  std::vector<FixedNode> nodes_;
};

/// From which distance on the sign is that of the real difference. Proof: docs/fixed_point.md,
/// theorem 3.
mpz_class threshold_of(const FixedNode& difference) {
  const mpq_class unit = difference.format.unit();
  return std::max<mpz_class>(floor_of(difference.error.high / unit) + 1,
                             -ceiling_of(difference.error.low / unit));
}

/// The last step that leaves each watched magnitude a bit.
int last_step_of(const std::vector<FixedNode>& nodes, const std::vector<NodeId>& watched) {
  int last = most_last_step;
  for (const NodeId id : watched) last = std::min(last, nodes[id].format.magnitude_bits() - 1);
  return last;
}

}  // namespace

mpq_class magnitude_in_step(const FixedNode& watched, int step, int last_step) {
  return scaled(watched.format.unit(), watched.format.magnitude_bits() - last_step + step);
}

std::optional<RunningThresholds> running_thresholds(const std::vector<FixedNode>& nodes, int bits,
                                                    NodeId difference,
                                                    std::vector<NodeId> watched) {
  const int last = last_step_of(nodes, watched);
  if (watched.empty() || last < 1) return std::nullopt;
  RunningThresholds thresholds;
  for (int step = 0; step <= last; ++step) {
    const StepEnclosure enclosure(nodes, bits, watched, step, last);
    thresholds.of_steps.push_back(threshold_of(enclosure.node(difference)));
  }
  thresholds.watched = std::move(watched);
  return thresholds;
}

}  // namespace mixcmp::fixed
