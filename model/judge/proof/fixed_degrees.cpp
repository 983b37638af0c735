#include "model/judge/proof/fixed_degrees.hpp"

#include <optional>

namespace mixcmp::proof {
namespace {

using fixed::FixedNode;

/// None: zero, which has every degree.
using Degree = std::optional<mpq_class>;

/// The degree of a result; none if its operands differ in degree.
std::optional<Degree> degree_of(const FixedNode& node, const std::vector<Degree>& degrees) {
  const auto degree = [&](int k) { return degrees[node.operands[k]]; };
  switch (node.operation) {
    case Operation::input: return std::nullopt;
    case Operation::constant: return node.constant == 0 ? Degree() : Degree(0);
    case Operation::square_root: return degree(0) ? Degree(*degree(0) / 2) : Degree();
    case Operation::square:
    case Operation::multiply: {
      const Degree other = degree(node.operation == Operation::square ? 0 : 1);
      return degree(0) && other ? Degree(*degree(0) + *other) : Degree();
    }
    default: {
      const Degree other = degree(arity(node.operation) - 1);
      if (degree(0) && other && *degree(0) != *other) return std::nullopt;
      return degree(0) ? degree(0) : other;
    }
  }
}

}  // namespace

bool is_homogeneous(const std::vector<FixedNode>& nodes, Scaled scaled) {
  std::vector<bool> counts;
  std::vector<Degree> degrees;
  for (const FixedNode& node : nodes) {
    const bool is_constant = node.operation == Operation::constant;
    const bool begins = scaled == Scaled::operands ? node.operation == Operation::input
                                                   : fixed::is_common_cut(node);
    bool some = begins, all = true;
    for (int k = 0; k < arity(node.operation); ++k) {
      const bool fixed = nodes[node.operands[k]].operation == Operation::constant;
      some = some || (counts[node.operands[k]] && !fixed);
      all = all && counts[node.operands[k]];
    }
    counts.push_back(is_constant || some);
    degrees.push_back(begins ? Degree(1) : Degree());
    if (begins || !counts.back()) continue;
    if (!all || fixed::is_limit(node)) return false;
    const auto degree = degree_of(node, degrees);
    if (!degree) return false;
    degrees.back() = *degree;
  }
  return true;
}

}  // namespace mixcmp::proof
