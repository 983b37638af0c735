#include "generator/hardware/rtl/net_names.hpp"

#include <fmt/core.h>

#include <cstdlib>

#include "model/base/common/check.hpp"
#include "model/comparison/expression/text.hpp"

namespace mixcmp::rtl {
namespace {

using error::BoundGraph;
using error::BoundNode;
using error::BoundOperation;

/// The most characters of a spelled-out name: readers skip longer identifiers.
constexpr std::size_t longest_spelled_name = 28;

std::string role(Operation operation) {
  switch (operation) {
    case Operation::input: return "operand";
    case Operation::constant: return "constant";
    case Operation::convert: return "rounded";
    case Operation::negate: return "negated";
    case Operation::absolute: return "magnitude";
    case Operation::add: return "sum";
    case Operation::subtract: return "difference";
    case Operation::multiply: return "product";
    case Operation::square: return "square";
    case Operation::divide: return "quotient";
    case Operation::square_root: return "root";
    case Operation::minimum: return "smaller";
    case Operation::maximum: return "larger";
    case Operation::fused_sum: return "fused_sum";
    case Operation::look_up: return "coefficient";
    case Operation::function: break;
  }
  MIXCMP_CHECK(false);
}

std::string spelled(Operation operation, const std::string& a, const std::string& b) {
  switch (operation) {
    case Operation::input: return a;
    case Operation::constant: return "constant";
    case Operation::convert: return a + "_rounded";
    case Operation::negate: return a + "_negated";
    case Operation::absolute: return a + "_magnitude";
    case Operation::add: return a + "_plus_" + b;
    case Operation::subtract: return a + "_minus_" + b;
    case Operation::multiply: return a + "_times_" + b;
    case Operation::square: return a + "_squared";
    case Operation::divide: return a + "_over_" + b;
    case Operation::square_root: return a + "_root";
    case Operation::minimum: return a + "_min_" + b;
    case Operation::maximum: return a + "_max_" + b;
    case Operation::look_up:
    case Operation::fused_sum: return role(operation);
    case Operation::function: break;
  }
  MIXCMP_CHECK(false);
}

std::string unless_too_long(std::string spelled_name, std::string role) {
  return spelled_name.size() > longest_spelled_name ? std::move(role) : std::move(spelled_name);
}

std::string spelled_or_role(Operation operation, const std::string& a, const std::string& b) {
  return unless_too_long(spelled(operation, a, b), role(operation));
}

/// exp_c2, exp_t or exp_of_x; x_beyond, reached and piece where pieces begin at the points of a
/// table.
std::string name_in_function(const fixed::FixedNode& node, const std::string& argument) {
  // "table" is a keyword.
  const bool is_table = node.function->kind() == Function::table;
  const std::string function = is_table ? "points" : to_string(*node.function);
  const bool is_sign = node.function->kind() == Function::sign;
  if (is_table && node.operation == Operation::add) return "piece";
  if (is_table && node.operation == Operation::subtract) {
    return node.format.is_signed ? argument + "_beyond" : function + "_t";
  }
  if (is_sign && node.words[1] == 0) return "reached";
  if (node.operation == Operation::look_up && !is_sign) {
    return node.power < 0 ? function + "_start" : fmt::format("{}_c{}", function, node.power);
  }
  if (fixed::is_floating_code(node)) return argument + "_floating";
  if (node.conversion == fixed::Conversion::place) return function + "_t";
  return unless_too_long(function + "_of_" + argument, function);
}

std::string spelled_or_role(const fixed::FixedNode& node, const std::string& a,
                            const std::string& b) {
  if (node.function && node.operation != Operation::constant) return name_in_function(node, a);
  if (node.operation != Operation::convert) return spelled_or_role(node.operation, a, b);
  const std::string role = fixed::is_limit(node)   ? "limited"
                           : fixed::is_reach(node) ? "near"
                                                   : "cut";
  return unless_too_long(a + "_" + role, role);
}

std::string bound_role(BoundOperation operation, const std::string& value) {
  switch (operation) {
    case BoundOperation::constant: return "constant";
    case BoundOperation::magnitude: return value + "_ceiling";
    case BoundOperation::binade: return value + "_binade";
    case BoundOperation::reciprocal: return value + "_inverse";
    case BoundOperation::add: return "error_sum";
    case BoundOperation::multiply: return "error_product";
    case BoundOperation::maximum: return "error_maximum";
  }
  MIXCMP_CHECK(false);
}

/// A number as text: "2^-17", or with four digits of the significand "1.205 * 2^-17".
std::string binary_text(const mpq_class& value) {
  if (value == 0) return "0";
  const auto length = [](const mpz_class& x) {
    return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2));
  };
  long exponent = length(value.get_num()) - length(value.get_den());
  const auto significand = [&] {
    mpq_class scaled;
    const auto power = static_cast<unsigned long>(std::labs(exponent));
    (exponent >= 0 ? mpq_div_2exp : mpq_mul_2exp)(scaled.get_mpq_t(), value.get_mpq_t(), power);
    return scaled;
  };
  if (significand() < 1) --exponent;
  if (significand() == 1) return fmt::format("2^{}", exponent);
  return fmt::format("{:.4g} * 2^{}", significand().get_d(), exponent);
}

}  // namespace

std::string NamePool::unique(const std::string& wanted) {
  std::string name = wanted;
  for (int count = 2; !taken_.insert(name).second; ++count) {
    name = fmt::format("{}_{}", wanted, count);
  }
  return name;
}

std::string part_suffix(std::size_t part, std::size_t parts) {
  return parts == 1 ? "" : fmt::format("_{}", part);
}

std::vector<std::string> name_nodes(const TypedGraph& graph, const std::vector<std::string>& ports,
                                    NamePool& pool) {
  const std::vector<Sides>& parts = graph.parts;
  std::vector<std::string> names;
  for (NodeId id = 0; id < static_cast<NodeId>(graph.nodes.size()); ++id) {
    const TypedNode& node = graph.nodes[id];
    if (node.operation == Operation::input) {
      names.push_back(ports[node.input]);
      continue;
    }
    const int count = arity(node.operation);
    const std::string a = count > 0 ? names[node.operands[0]] : "";
    const std::string b = count > 1 ? names[node.operands[1]] : "";
    std::string wanted = spelled_or_role(node.operation, a, b);
    for (std::size_t part = parts.size(); part-- > 0;) {
      if (id == parts[part].g) wanted = "g" + part_suffix(part, parts.size());
      if (id == parts[part].f) wanted = "f" + part_suffix(part, parts.size());
    }
    names.push_back(pool.unique(wanted));
  }
  return names;
}

std::vector<std::string> name_nodes(const fixed::FixedLane& lane,
                                    const std::vector<std::string>& ports, NamePool& pool) {
  std::vector<std::string> spellings, names;
  for (NodeId id = 0; id < static_cast<NodeId>(lane.nodes.size()); ++id) {
    const fixed::FixedNode& node = lane.nodes[id];
    if (node.operation == Operation::input) {
      const std::string& port = ports[node.input];
      const bool is_encoding = node.is_encoding;
      spellings.push_back(is_encoding ? port + "_encoding" : port);
      const bool is_port = fixed::is_read_as_it_arrives(lane, node) && node.dropped_bits == 0;
      names.push_back(is_port ? port : pool.unique(port + (is_encoding ? "_encoding" : "_fixed")));
      continue;
    }
    const int count = arity(node.operation);
    const std::string a = count > 0 ? spellings[node.operands[0]] : "";
    const std::string b = count > 1 ? spellings[node.operands[1]] : "";
    std::string wanted = fixed::is_code_of_encoding(lane.nodes, node)
                             ? to_string(*node.function) + "_code"
                             : spelled_or_role(node, a, b);
    for (std::size_t part = lane.parts.size(); part-- > 0;) {
      if (id != lane.parts[part].difference) continue;
      wanted = "difference" + part_suffix(part, lane.parts.size());
    }
    names.push_back(pool.unique(wanted));
    spellings.push_back(names.back());
  }
  return names;
}

std::string formula(Operation operation, const std::string& a, const std::string& b) {
  switch (operation) {
    case Operation::input:
    case Operation::constant:
    case Operation::convert: return a;
    case Operation::negate: return "-" + a;
    case Operation::absolute: return "|" + a + "|";
    case Operation::add: return a + " + " + b;
    case Operation::subtract: return a + " - " + b;
    case Operation::multiply: return a + " * " + b;
    case Operation::square: return a + "^2";
    case Operation::divide: return a + " / " + b;
    case Operation::square_root: return "sqrt(" + a + ")";
    case Operation::minimum: return "min(" + a + ", " + b + ")";
    case Operation::maximum: return "max(" + a + ", " + b + ")";
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

/// The terms of a fused sum; `text` gives the text of a node.
template <class Text>
std::string sum_formula(const std::vector<FusedTerm>& terms, const Text& text) {
  std::string formula;
  for (const FusedTerm& term : terms) {
    const bool first = formula.empty();
    formula += first ? (term.negated ? "-" : "") : (term.negated ? " - " : " + ");
    formula += text(term.a);
    if (term.is_product()) formula += term.is_square() ? "^2" : " * " + text(term.b);
  }
  return formula;
}

std::string formula(const TypedGraph& graph, NodeId id, const std::vector<std::string>& names) {
  const TypedNode& node = graph.nodes[id];
  const int count = arity(node.operation);
  const auto text = [&](NodeId source) {
    const bool constant = graph.nodes[source].operation == Operation::constant;
    return constant ? to_text(graph.nodes[source].value) : names[source];
  };
  if (node.operation == Operation::fused_sum) return sum_formula(node.terms, text);
  if (count == 0) return names[id];
  return formula(node.operation, text(node.operands[0]), count > 1 ? text(node.operands[1]) : "");
}

std::vector<std::string> name_bounds(const BoundGraph& bound, const std::string& suffix,
                                     const std::vector<std::string>& values, NamePool& pool) {
  std::vector<std::string> names;
  for (std::size_t id = 0; id < bound.nodes.size(); ++id) {
    const BoundNode& node = bound.nodes[id];
    const std::string value = node.value < 0 ? "" : values[node.value];
    const bool last = id + 1 == bound.nodes.size();
    names.push_back(pool.unique(last ? "error_bound" + suffix : bound_role(node.operation, value)));
  }
  return names;
}

std::string bound_formula(const BoundGraph& bound, int id, const std::vector<std::string>& bounds,
                          const std::vector<std::string>& values) {
  const BoundNode& node = bound.nodes[id];
  const auto operand = [&](int k) {
    const int source = node.operands[k];
    const bool constant = bound.nodes[source].operation == BoundOperation::constant;
    return constant ? binary_text(bound.nodes[source].constant) : bounds[source];
  };
  switch (node.operation) {
    case BoundOperation::constant: return binary_text(node.constant);
    case BoundOperation::magnitude: return "|" + values[node.value] + "|";
    case BoundOperation::binade: return "the power of two at or below |" + values[node.value] + "|";
    case BoundOperation::reciprocal:
      return "a power of two at or above 1 / |" + values[node.value] + "|";
    case BoundOperation::add: return operand(0) + " + " + operand(1);
    case BoundOperation::multiply: return operand(0) + " * " + operand(1);
    case BoundOperation::maximum: return "max(" + operand(0) + ", " + operand(1) + ")";
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::rtl
