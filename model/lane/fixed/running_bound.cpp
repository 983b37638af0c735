#include "model/lane/fixed/running_bound.hpp"

#include <algorithm>
#include <utility>

#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/node_enclosure.hpp"
#include "model/lane/fixed/root_error.hpp"

namespace mixcmp::fixed {
namespace {

/// Encloses all nodes again, for the comparisons of one step.
class StepEnclosure {
public:
  StepEnclosure(std::vector<FixedNode> nodes, int bits, const std::vector<NodeId>& watched,
                int step, int last_step)
      : bits_(bits), nodes_(std::move(nodes)) {
    for (NodeId id = 0; id < static_cast<NodeId>(nodes_.size()); ++id) {
      enclose(nodes_[id]);
      if (std::find(watched.begin(), watched.end(), id) == watched.end()) continue;
      const mpq_class beyond = magnitude_in_step(nodes_[id], step, last_step);
      narrow(nodes_[id].value, {-beyond, beyond - nodes_[id].format.unit()});
    }
  }

  const FixedNode& node(NodeId id) const { return nodes_[id]; }

private:
  /// Narrows value and error by those of the operands.
  void enclose(FixedNode& node) const {
    if (arity(node.operation) == 0 || !follows_operands(node)) return;
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

/// The least distance from zero at which the sign of a difference is certainly that of the real
/// difference. It is at most the first distance that no difference has. Proof: docs/fixed_point.md,
/// theorem 3.
mpz_class threshold_of(const FixedNode& difference) {
  const mpq_class unit = difference.format.unit();
  const mpz_class threshold = std::max<mpz_class>(floor_of(difference.error.high / unit) + 1,
                                                  -ceiling_of(difference.error.low / unit));
  return std::min(threshold, shifted_left(1, difference.format.magnitude_bits()));
}

/// Whether a node is computed from each of those before it. It is not from an operand whose
/// encoding it reads.
std::vector<bool> read_by(const std::vector<FixedNode>& nodes, NodeId result) {
  std::vector<bool> is_read(nodes.size(), false);
  is_read[static_cast<std::size_t>(result)] = true;
  for (NodeId id = result; id >= 0; --id) {
    const FixedNode& node = nodes[id];
    if (!is_read[static_cast<std::size_t>(id)]) continue;
    for (int k = 0; k < arity(node.operation); ++k) {
      is_read[static_cast<std::size_t>(node.operands[k])] = true;
    }
  }
  return is_read;
}

/// The last step, such that each watched magnitude keeps at least one bit.
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
  const std::vector<bool> is_read = read_by(nodes, difference);
  std::erase_if(watched, [&](NodeId id) {
    return nodes[id].format.magnitude_bits() < 2 || !is_read[static_cast<std::size_t>(id)];
  });
  const int last = last_step_of(nodes, watched);
  if (watched.empty() || last < 1) return std::nullopt;
  RunningThresholds thresholds;
  for (int step = 0; step <= last; ++step) {
    const StepEnclosure enclosure(nodes, bits, watched, step, last);
    thresholds.of_steps.push_back(threshold_of(enclosure.node(difference)));
  }
  if (thresholds.of_steps.front() == thresholds.of_steps.back()) return std::nullopt;
  thresholds.watched = std::move(watched);
  return thresholds;
}

}  // namespace mixcmp::fixed
