#include "model/comparison/expression/graph_copy.hpp"

#include <utility>

namespace mixcmp::inline expression {

GraphCopy::GraphCopy(const Graph& from, Replace replace)
    : from_(from), replace_(std::move(replace)), copies_(from.nodes().size(), -1) {
  for (std::size_t k = 0; k < from.inputs().size(); ++k) {
    to_.input(from.inputs()[k]);
    const auto format = from.arriving_format(static_cast<int>(k));
    if (format) to_.arrives_in(static_cast<int>(k), *format);
  }
}

NodeId GraphCopy::made(NodeId id) {
  if (replace_) {
    if (const auto other = replace_(id, *this)) return *other;
  }
  const Node& node = from_.nodes()[static_cast<std::size_t>(id)];
  const auto operand = [&](std::size_t k) {
    return k < static_cast<std::size_t>(arity(node.operation)) ? copy(node.operands[k]) : -1;
  };
  switch (node.operation) {
    case Operation::input: return to_.input(from_.inputs()[static_cast<std::size_t>(node.input)]);
    case Operation::constant: return to_.constant(node.value);
    case Operation::function: return to_.apply(*node.function, operand(0));
    default: break;
  }
  const NodeId first = operand(0);
  return to_.apply(node.operation, first, operand(1));
}

NodeId GraphCopy::copy(NodeId id) {
  NodeId& known = copies_[static_cast<std::size_t>(id)];
  if (known >= 0) return known;
  known = made(id);
  const auto limits = from_.limits().find(id);
  if (limits != from_.limits().end() && !to_.limit(known, limits->second)) {
    limits_are_possible_ = false;
  }
  return known;
}

std::vector<Sides> GraphCopy::copy(std::vector<Sides> parts) {
  for (Sides& part : parts) {
    const NodeId f = copy(part.f);
    part = {f, copy(part.g)};
  }
  return parts;
}

bool GraphCopy::lacks_an_input() const {
  for (std::size_t id = 0; id < copies_.size(); ++id) {
    if (from_.nodes()[id].operation == Operation::input && copies_[id] < 0) return true;
  }
  return false;
}

std::optional<Graph> GraphCopy::compared(std::vector<Sides> parts) && {
  if (!limits_are_possible_) return std::nullopt;
  to_.compare(std::move(parts), from_.combination());
  return std::move(to_);
}

}  // namespace mixcmp::inline expression
