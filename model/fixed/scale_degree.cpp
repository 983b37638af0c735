#include "model/fixed/scale_degree.hpp"

#include <fmt/core.h>

#include <map>
#include <optional>
#include <string>

#include "model/common/check.hpp"
#include "model/expression/text.hpp"

namespace mixcmp::fixed {
namespace {

constexpr std::size_t most_characters = 60;

/// None: the value is always zero, which has every degree.
using Degree = std::optional<mpq_class>;

Error refused(const Graph& graph, NodeId node, const std::string& why) {
  return {.field = "reduced.format",
          .message = fmt::format("block floating point needs f and g that are homogeneous of one "
                                 "degree; {}: {}",
                                 why, to_text(graph, node, most_characters)),
          .received = {},
          .accepted =
              "f and g such as a*b and c^2; or qW with a range for each input, or a "
              "floating-point format"};
}

std::string shown(const Degree& degree) {
  return degree ? to_text(*degree) : "any";
}

/// The degrees of all nodes, operands first.
class DegreeFinder {
public:
  explicit DegreeFinder(const Graph& graph) : graph_(graph) {}

  Result<Degree> find(NodeId id) {
    if (const auto known = known_.find(id); known != known_.end()) return known->second;
    MIXCMP_TRY(degree, compute(id));
    return known_[id] = degree;
  }

  Result<mpq_class> of_part(const Sides& sides) {
    MIXCMP_TRY(f, find(sides.f));
    MIXCMP_TRY(g, find(sides.g));
    if (f && g && *f != *g) {
      return refused(graph_, sides.f,
                     fmt::format("f has the degree {} and g {}", shown(f), shown(g)));
    }
    return f ? *f : g.value_or(0);
  }

private:
  Result<Degree> compute(NodeId id) {
    const Node& node = graph_.nodes()[id];
    Degree operands[2];
    for (int k = 0; k < arity(node.operation); ++k) {
      MIXCMP_TRY(operand, find(node.operands[k]));
      operands[k] = operand;
    }
    if (graph_.limits().contains(id)) return refused(graph_, id, "a limit does not grow");
    switch (node.operation) {
      case Operation::input: return Degree(1);
      case Operation::constant: return node.value == 0 ? Degree() : Degree(0);
      case Operation::convert:
      case Operation::negate:
      case Operation::absolute: return operands[0];
      case Operation::square: return product(operands[0], operands[0]);
      case Operation::square_root: return operands[0] ? Degree(*operands[0] / 2) : Degree();
      case Operation::multiply: return product(operands[0], operands[1]);
      case Operation::divide:
        return operands[0] && operands[1] ? Degree(*operands[0] - *operands[1]) : Degree();
      case Operation::add:
      case Operation::subtract:
      case Operation::minimum:
      case Operation::maximum: return common(id, operands[0], operands[1]);
    }
    MIXCMP_CHECK(false);
  }

  static Degree product(const Degree& a, const Degree& b) {
    return a && b ? Degree(*a + *b) : Degree();
  }

  Result<Degree> common(NodeId id, const Degree& a, const Degree& b) const {
    if (!a || !b) return a ? a : b;
    if (*a == *b) return a;
    return refused(graph_, id, fmt::format("operands of degrees {} and {}", shown(a), shown(b)));
  }

  const Graph& graph_;
  std::map<NodeId, Degree> known_;
};

}  // namespace

Result<std::vector<mpq_class>> scale_degrees(const Graph& graph) {
  DegreeFinder finder(graph);
  std::vector<mpq_class> degrees;
  for (const Sides& sides : graph.parts()) {
    MIXCMP_TRY(degree, finder.of_part(sides));
    degrees.push_back(degree);
  }
  return degrees;
}

}  // namespace mixcmp::fixed
