#include "generator/hardware/datapath/multiplier_sums.hpp"

#include <algorithm>
#include <vector>

#include "generator/hardware/datapath/fixed_units.hpp"

namespace mixcmp::datapath {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;

/// The widest sum that the adder behind a multiplier makes: DSP48 has 48 bits.
constexpr int adder_bits = 48;

/// How often each node is read, by other nodes, decisions and as an output.
std::vector<int> reader_counts(const FixedLane& lane) {
  std::vector<int> counts(lane.nodes.size(), 0);
  for (const FixedNode& node : lane.nodes) {
    for (int k = 0; k < arity(node.operation); ++k) ++counts[node.operands[k]];
  }
  for (const fixed::FixedPart& part : lane.parts) {
    ++counts[part.difference];
    for (const NodeId id : fixed::read_by(part.criterion)) ++counts[id];
  }
  for (const NodeId id : lane.outputs) ++counts[id];
  return counts;
}

/// Whether one multiplier makes the whole product. Factors are in two's complement, and
/// fixed_product does not exchange them.
bool is_one_product(const FixedLane& lane, const FixedNode& node,
                    const devices::MultiplierSize& size) {
  const bool squares = node.operation == Operation::square;
  if (!squares && node.operation != Operation::multiply) return false;
  const int a = operand_bits(lane.nodes, node, 0);
  const int b = squares ? a : operand_bits(lane.nodes, node, 1);
  return node.dropped_bits == 0 && a - 1 <= size.a_bits && b - 1 <= size.b_bits;
}

class Search {
public:
  Search(const FixedLane& lane, const devices::MultiplierSize& size)
      : lane_(lane), size_(size), readers_(reader_counts(lane)) {}

  std::map<NodeId, NodeId> run() const {
    std::map<NodeId, NodeId> found;
    for (NodeId sum = 0; sum < static_cast<NodeId>(lane_.nodes.size()); ++sum) {
      const FixedNode& node = lane_.nodes[sum];
      if (node.operation != Operation::add || node.dropped_bits > 0) continue;
      if (node.format.width > adder_bits) continue;
      for (const int k : {1, 0}) {
        if (!joins(node, k)) continue;
        found[sum] = node.operands[k];
        break;
      }
    }
    return found;
  }

private:
  bool joins(const FixedNode& sum, int operand) const {
    const NodeId product = sum.operands[operand];
    return readers_[product] == 1 && is_one_product(lane_, lane_.nodes[product], size_);
  }

  const FixedLane& lane_;
  devices::MultiplierSize size_;
  std::vector<int> readers_;
};

}  // namespace

std::map<NodeId, NodeId> multiplier_sums(const FixedLane& lane, const devices::DelayTable& delays) {
  if (!delays.multiplier_sums) return {};
  return Search(lane, delays.multiplier_size).run();
}

}  // namespace mixcmp::datapath
