#include "model/lane/error/bound_graph_builder.hpp"

#include <algorithm>
#include <utility>

namespace mixcmp::error {
namespace {

bool same(const BoundNode& a, const BoundNode& b) {
  return a.operation == b.operation && a.operands == b.operands && a.value == b.value &&
         a.constant == b.constant;
}

}  // namespace

BoundId BoundGraphBuilder::constant(const mpq_class& value) {
  if (value == 0) return no_bound_node;
  return intern({.operation = BoundOperation::constant, .constant = value});
}

BoundId BoundGraphBuilder::of_value(BoundOperation operation, NodeId value) {
  return intern({.operation = operation, .value = value, .constant = {}});
}

BoundId BoundGraphBuilder::add(BoundId a, BoundId b) {
  if (a == no_bound_node || b == no_bound_node) return std::max(a, b);
  const mpq_class *first = constant_of(a), *second = constant_of(b);
  if (first != nullptr && second != nullptr) return constant(*first + *second);
  if (a > b) std::swap(a, b);
  return intern({.operation = BoundOperation::add, .operands = {a, b}, .constant = {}});
}

/// A constant factor becomes the second operand. Two constant factors in a row are folded into one.
BoundId BoundGraphBuilder::multiply(BoundId a, BoundId b) {
  if (a == no_bound_node || b == no_bound_node) return no_bound_node;
  if (constant_of(a) != nullptr) std::swap(a, b);
  const mpq_class* factor = constant_of(b);
  if (factor != nullptr) {
    if (*factor == 1) return a;
    if (const mpq_class* other = constant_of(a)) return constant(*other * *factor);
    const BoundNode inner = nodes_[a];
    if (inner.operation == BoundOperation::multiply) {
      if (const mpq_class* known = constant_of(inner.operands[1])) {
        return multiply(inner.operands[0], constant(*known * *factor));
      }
    }
  }
  if (factor == nullptr && a > b) std::swap(a, b);
  return intern({.operation = BoundOperation::multiply, .operands = {a, b}, .constant = {}});
}

BoundId BoundGraphBuilder::maximum(BoundId a, BoundId b) {
  if (a == no_bound_node || b == no_bound_node || a == b) return std::max(a, b);
  const mpq_class *first = constant_of(a), *second = constant_of(b);
  if (first != nullptr && second != nullptr) return constant(std::max(*first, *second));
  if (a > b) std::swap(a, b);
  return intern({.operation = BoundOperation::maximum, .operands = {a, b}, .constant = {}});
}

const mpq_class* BoundGraphBuilder::constant_of(BoundId id) const {
  const BoundNode& node = nodes_[id];
  return node.operation == BoundOperation::constant ? &node.constant : nullptr;
}

BoundId BoundGraphBuilder::intern(BoundNode node) {
  const auto known = std::find_if(nodes_.begin(), nodes_.end(),
                                  [&](const BoundNode& other) { return same(node, other); });
  if (known != nodes_.end()) return static_cast<BoundId>(known - nodes_.begin());
  nodes_.push_back(std::move(node));
  return static_cast<BoundId>(nodes_.size()) - 1;
}

}  // namespace mixcmp::error
