#include "model/comparison/expression/formula.hpp"

#include <algorithm>
#include <tuple>

namespace mixcmp::inline expression {

std::strong_ordering operator<=>(const Formula& a, const Formula& b) {
  const auto of_nodes = [](const Node& x, const Node& y) {
    const auto rest = [](const Node& node) {
      return std::tie(node.operation, node.operands, node.function);
    };
    const auto order = rest(x) <=> rest(y);
    return order == 0 ? cmp(x.value, y.value) <=> 0 : order;
  };
  const auto order = std::lexicographical_compare_three_way(
      a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), of_nodes);
  if (order != 0 || !a.arguments || !b.arguments) {
    return order != 0 ? order : a.arguments.has_value() <=> b.arguments.has_value();
  }
  const auto low = cmp(a.arguments->low, b.arguments->low) <=> 0;
  return low != 0 ? low : cmp(a.arguments->high, b.arguments->high) <=> 0;
}

}  // namespace mixcmp::inline expression
