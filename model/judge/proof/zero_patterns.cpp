#include "model/judge/proof/zero_patterns.hpp"

#include <set>
#include <vector>

#include "model/base/common/check.hpp"

namespace mixcmp::proof {
namespace {

bool is_inner(const Cone& cone, NodeId id) {
  return !cone.is_leaf[id] && arity(cone.graph->nodes[id].operation) > 0;
}

/// Whether the sum is zero only if both operands are. Operands may cancel only if both are exact.
bool adds_one_sign(const Cone& cone, const TypedNode& node) {
  return !(*cone.claims)[node.operands[0]].is_exact() ||
         !(*cone.claims)[node.operands[1]].is_exact();
}

bool is_constant(const Cone& cone, NodeId id) {
  return cone.graph->nodes[id].operation == Operation::constant;
}

/// Adds the atoms whose zeros decide whether `id` is zero.
void add_atoms(const Cone& cone, NodeId id, std::set<NodeId>& atoms) {
  if (is_constant(cone, id)) return;
  const TypedNode& node = cone.graph->nodes[id];
  if (!is_inner(cone, id)) {
    atoms.insert(id);
    return;
  }
  switch (node.operation) {
    case Operation::convert:
    case Operation::negate:
    case Operation::absolute:
    case Operation::square:
    case Operation::square_root: return add_atoms(cone, node.operands[0], atoms);
    case Operation::add:
    case Operation::subtract:
      if (!adds_one_sign(cone, node)) break;
      add_atoms(cone, node.operands[0], atoms);
      return add_atoms(cone, node.operands[1], atoms);
    case Operation::multiply:
    case Operation::divide: break;
    case Operation::input:
    case Operation::constant:
    case Operation::minimum:
    case Operation::maximum:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: MIXCMP_CHECK(false);
  }
  atoms.insert(id);
}

/// Whether a leaf is always zero: its claim excludes both signs. A constant is judged by its
/// encoding, since one that is rounded to zero has an absolute error only.
bool is_always_zero(const Cone& cone, NodeId id) {
  const TypedNode& node = cone.graph->nodes[id];
  if (is_constant(cone, id)) return node.format.is_zero(node.constant);
  const NodeClaim& claim = (*cone.claims)[id];
  return claim.nonnegative && claim.nonpositive;
}

/// Whether a node is zero because its operands are. Values of atoms in `pattern` are not
/// considered.
bool zero_by_operands(const TypedNode& node, const Zeros& zeros) {
  const bool a = zeros[node.operands[0]];
  const bool b = node.operands[1] >= 0 && zeros[node.operands[1]];
  switch (node.operation) {
    case Operation::convert:
    case Operation::negate:
    case Operation::absolute:
    case Operation::square:
    case Operation::square_root:
    case Operation::divide: return a;
    case Operation::multiply: return a || b;
    case Operation::add:
    case Operation::subtract: return a && b;
    case Operation::input:
    case Operation::constant:
    case Operation::minimum:
    case Operation::maximum:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

}  // namespace

std::vector<NodeId> zero_atoms(const Cone& cone) {
  std::set<NodeId> atoms;
  for (const NodeId id : nodes_of(cone)) {
    const TypedNode& node = cone.graph->nodes[id];
    if (!is_inner(cone, id)) continue;
    const bool sum = node.operation == Operation::add || node.operation == Operation::subtract;
    if (sum && adds_one_sign(cone, node)) {
      add_atoms(cone, node.operands[0], atoms);
      add_atoms(cone, node.operands[1], atoms);
    }
    if (node.operation == Operation::square_root) add_atoms(cone, node.operands[0], atoms);
  }
  return {atoms.begin(), atoms.end()};
}

Zeros zeros_from(const Cone& cone, const std::vector<NodeId>& atoms, unsigned long pattern) {
  Zeros zeros(cone.graph->nodes.size(), false), chosen = zeros, is_atom = zeros;
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    is_atom[atoms[k]] = true;
    chosen[atoms[k]] = (pattern >> k & 1) != 0;
  }
  for (const NodeId id : nodes_of(cone)) {
    const TypedNode& node = cone.graph->nodes[id];
    if (is_inner(cone, id) && node.operation == Operation::divide && zeros[node.operands[1]]) {
      return {};
    }
    const bool follows =
        is_inner(cone, id) ? zero_by_operands(node, zeros) : is_always_zero(cone, id);
    if (follows && is_atom[id] && !chosen[id]) return {};
    zeros[id] = chosen[id] || follows;
  }
  return zeros;
}

}  // namespace mixcmp::proof
