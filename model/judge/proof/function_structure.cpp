#include "model/judge/proof/function_structure.hpp"

#include <algorithm>

#include "model/judge/proof/jump_enclosure.hpp"

namespace mixcmp::proof {
namespace {

using fixed::Conversion;
using fixed::FixedNode;

/// Collects the nodes below a result.
class Below {
public:
  Below(const std::vector<FixedNode>& nodes, NodeId result)
      : nodes_(nodes), found_{result, -1, {}} {
    const FixedNode& node = nodes[result];
    is_right_ = node.operation == Operation::look_up ? from_argument(node.operands[0])
                                                     : inside(node.operands[0]);
  }

  std::optional<FunctionNodes> found() const {
    return is_right_ && found_.argument >= 0 ? std::optional(found_) : std::nullopt;
  }

private:
  /// The argument itself or its floating-point code.
  bool from_argument(NodeId id) {
    if (fixed::is_floating_code(nodes_[id]) || fixed::is_code_of_encoding(nodes_, nodes_[id])) {
      found_.inside.insert(id);
      id = nodes_[id].operands[0];
    }
    if (found_.argument < 0) found_.argument = id;
    return found_.argument == id;
  }

  bool inside(NodeId id) {
    const FixedNode& node = nodes_[id];
    if (node.operation == Operation::constant) return true;
    found_.inside.insert(id);
    if (reads_argument(node)) {
      const NodeId read = node.operands[0];
      return is_step(nodes_[read]) ? inside(read) : from_argument(read);
    }
    if (node.operation == Operation::subtract && is_step(node)) {
      return from_argument(node.operands[0]) && inside(node.operands[1]);
    }
    if (node.operation != Operation::multiply && node.operation != Operation::add) return false;
    return inside(node.operands[0]) && inside(node.operands[1]);
  }

  const std::vector<FixedNode>& nodes_;
  FunctionNodes found_;
  bool is_right_;
};

/// The inside nodes that the lane's criteria read, or nodes outside.
bool any_read_outside(const fixed::FixedLane& lane, const std::set<NodeId>& inside,
                      const std::set<NodeId>& results) {
  for (NodeId id = 0; id < static_cast<NodeId>(lane.nodes.size()); ++id) {
    if (inside.contains(id) || results.contains(id)) continue;
    const FixedNode& node = lane.nodes[id];
    for (int k = 0; k < arity(node.operation); ++k) {
      if (inside.contains(node.operands[k])) return true;
    }
  }
  return std::any_of(lane.parts.begin(), lane.parts.end(), [&](const fixed::FixedPart& part) {
    const std::vector<NodeId> read = fixed::read_by(part.criterion);
    return inside.contains(part.difference) ||
           std::any_of(read.begin(), read.end(), [&](NodeId id) { return inside.contains(id); });
  });
}

}  // namespace

bool is_place(const FixedNode& node) {
  return node.conversion == Conversion::place;
}

bool reads_argument(const FixedNode& node) {
  return node.operation == Operation::look_up || is_place(node);
}

bool is_step(const FixedNode& node) {
  if (!node.function) return false;
  if (node.operation == Operation::look_up) {
    return node.function->kind() == Function::sign && node.words[1] == 0;
  }
  const bool is_sum = node.operation == Operation::add || node.operation == Operation::subtract;
  return is_sum && node.function->kind() == Function::table;
}

std::optional<std::vector<FunctionNodes>> functions_of(const fixed::FixedLane& lane) {
  std::vector<FunctionNodes> functions;
  std::set<NodeId> inside, results;
  const auto add = [&](NodeId result) {
    const auto found = Below(lane.nodes, result).found();
    if (!found) return false;
    inside.insert(found->inside.begin(), found->inside.end());
    results.insert(result);
    functions.push_back(*found);
    return true;
  };
  const auto count = static_cast<NodeId>(lane.nodes.size());
  for (NodeId id = 0; id < count; ++id) {
    if (!is_remainder(lane.nodes[id])) continue;
    const auto found = nodes_of_remainder(lane.nodes, id);
    if (!found) return std::nullopt;
    inside.insert(found->inside.begin(), found->inside.end());
    results.insert(id);
    functions.push_back(*found);
  }
  for (NodeId id = 0; id < count; ++id) {
    if (lane.nodes[id].conversion == Conversion::function_value && !add(id)) return std::nullopt;
  }
  for (NodeId id = 0; id < count; ++id) {  // other tables have the values themselves
    const bool is_table = lane.nodes[id].operation == Operation::look_up;
    if (is_table && !inside.contains(id) && !add(id)) return std::nullopt;
  }
  for (NodeId id = 0; id < count; ++id) {  // an encoding is no number that others may compute with
    const FixedNode& node = lane.nodes[id];
    if (node.is_encoding || fixed::is_limited_encoding(lane.nodes, node)) inside.insert(id);
  }
  if (any_read_outside(lane, inside, results)) return std::nullopt;
  return functions;
}

}  // namespace mixcmp::proof
