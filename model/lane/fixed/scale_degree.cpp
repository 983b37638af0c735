#include "model/lane/fixed/scale_degree.hpp"

#include <fmt/core.h>

#include <map>
#include <optional>
#include <string>

#include "model/base/common/check.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/lane/fixed/affine_nodes.hpp"

namespace mixcmp::fixed {
namespace {

constexpr std::size_t most_characters = 60;

/// None: the value is always zero, which has every degree.
using Degree = std::optional<mpq_class>;

/// The numbers that are multiplied by t in the definition of a degree.
enum class Scaled { inputs, affine };

Error refused(const Graph& graph, Scaled scaled, NodeId node, const std::string& why) {
  const bool inputs = scaled == Scaled::inputs;
  return {.field = "reduced.format",
          .message = fmt::format("{} f and g that are homogeneous of one degree{}; {}: {}",
                                 inputs ? "block floating point needs" : "guard digits need",
                                 inputs ? "" : " in what is linear in the operands", why,
                                 to_text(graph, node, most_characters)),
          .received = {},
          .accepted = inputs ? "f and g such as a*b and c^2; or qW with a range for each input, or "
                               "a floating-point format"
                             : "f and g such as (a-b)^2 and c^2; or a format without guard "
                               "digits, such as q13"};
}

std::string shown(const Degree& degree) {
  return degree ? to_text(*degree) : "any";
}

/// The degrees of all nodes, operands first.
class DegreeFinder {
public:
  DegreeFinder(const Graph& graph, Scaled scaled)
      : graph_(graph), scaled_(scaled), affine_(affine_nodes(graph)) {}

  Result<Degree> find(NodeId id) {
    if (const auto known = known_.find(id); known != known_.end()) return known->second;
    MIXCMP_TRY(degree, compute(id));
    return known_[id] = degree;
  }

  Result<mpq_class> of_part(const Sides& sides) {
    if (scaled_ == Scaled::affine && affine_[sides.f] && affine_[sides.g]) return mpq_class(0);
    MIXCMP_TRY(f, find(sides.f));
    MIXCMP_TRY(g, find(sides.g));
    if (f && g && *f != *g) {
      return refused(graph_, scaled_, sides.f,
                     fmt::format("f has the degree {} and g {}", shown(f), shown(g)));
    }
    return f ? *f : g.value_or(0);
  }

private:
  Result<Degree> compute(NodeId id) {
    const Node& node = graph_.nodes()[id];
    const bool constant = node.operation == Operation::constant;
    if (scaled_ == Scaled::affine && affine_[id] && !constant) return Degree(1);
    Degree operands[2];
    for (int k = 0; k < arity(node.operation); ++k) {
      MIXCMP_TRY(operand, find(node.operands[k]));
      operands[k] = operand;
    }
    if (graph_.limits().contains(id)) {
      return refused(graph_, scaled_, id, "a limit does not grow");
    }
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
      case Operation::function:
        return refused(graph_, scaled_, id, "a function other than a power does not scale");
      case Operation::look_up:
      case Operation::fused_sum: break;
    }
    MIXCMP_CHECK(false);
  }

  static Degree product(const Degree& a, const Degree& b) {
    return a && b ? Degree(*a + *b) : Degree();
  }

  Result<Degree> common(NodeId id, const Degree& a, const Degree& b) const {
    if (!a || !b) return a ? a : b;
    if (*a == *b) return a;
    return refused(graph_, scaled_, id,
                   fmt::format("operands of degrees {} and {}", shown(a), shown(b)));
  }

  const Graph& graph_;
  Scaled scaled_;
  std::vector<bool> affine_;
  std::map<NodeId, Degree> known_;
};

Result<std::vector<mpq_class>> degrees_of(const Graph& graph, Scaled scaled) {
  DegreeFinder finder(graph, scaled);
  std::vector<mpq_class> degrees;
  for (const Sides& sides : graph.parts()) {
    MIXCMP_TRY(degree, finder.of_part(sides));
    degrees.push_back(degree);
  }
  return degrees;
}

}  // namespace

Result<std::vector<mpq_class>> scale_degrees(const Graph& graph) {
  return degrees_of(graph, Scaled::inputs);
}

Result<std::vector<mpq_class>> cut_degrees(const Graph& graph) {
  return degrees_of(graph, Scaled::affine);
}

}  // namespace mixcmp::fixed
