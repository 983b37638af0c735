#include "model/comparison/expression/text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "model/comparison/expression/formula.hpp"

namespace mixcmp::inline expression {
namespace {

/// The precedence of a printed expression's outermost operator, lowest first.
enum class Binding {
  sum,
  product,
  sign,
  power,
  atom,
};

bool is_power(const Node& node) {
  return node.function && node.function->kind() == Function::power;
}

bool is_power(const TypedNode& /*node*/) {
  return false;
}

const Formula* formula_of(const Node& node) {
  const bool is_formula = node.function && node.function->kind() == Function::formula;
  return is_formula ? &node.function->expression() : nullptr;
}

const Formula* formula_of(const TypedNode& /*node*/) {
  return nullptr;
}

template <class AnyNode>
Binding binding_of(const AnyNode& node) {
  if (const Formula* formula = formula_of(node)) return binding_of(formula->nodes.back());
  switch (node.operation) {
    case Operation::add:
    case Operation::subtract:
    case Operation::fused_sum: return Binding::sum;
    case Operation::multiply:
    case Operation::divide: return Binding::product;
    case Operation::negate: return Binding::sign;
    case Operation::square: return Binding::power;
    case Operation::constant:
      if (to_text(node.value).find('/') != std::string::npos) return Binding::product;
      return node.value < 0 ? Binding::sign : Binding::atom;
    case Operation::input:
    case Operation::convert:
    case Operation::absolute:
    case Operation::square_root:
    case Operation::minimum:
    case Operation::maximum:
    case Operation::look_up: return Binding::atom;
    case Operation::function: return is_power(node) ? Binding::power : Binding::atom;
  }
  MIXCMP_CHECK(false);
}

/// Adds a formula of the argument to nodes, and returns its value.
NodeId append(std::vector<Node>& nodes, const Formula& formula, NodeId argument) {
  std::vector<NodeId> copies;
  for (Node node : formula.nodes) {
    if (node.operation == Operation::input) {
      copies.push_back(argument);
      continue;
    }
    for (NodeId& operand : node.operands) {
      if (operand >= 0) operand = copies[static_cast<std::size_t>(operand)];
    }
    copies.push_back(static_cast<NodeId>(nodes.size()));
    nodes.push_back(std::move(node));
  }
  return copies.back();
}

/// Prints nodes of a graph, with or without formats.
template <class AnyNode>
class Printer {
public:
  Printer(const std::vector<AnyNode>& nodes, const std::vector<std::string>& inputs,
          std::size_t max_length)
      : nodes_(nodes), inputs_(inputs), max_length_(max_length) {}

  std::string print(NodeId node) {
    expression(node, Binding::sum);
    if (text_.size() > max_length_) text_ = text_.substr(0, max_length_) + "...";
    return text_;
  }

private:
  /// Stops descending once the text is too long: shared nodes would print exponentially often.
  void expression(NodeId id, Binding least) {
    if (text_.size() > max_length_) return;
    const AnyNode& node = nodes_[static_cast<std::size_t>(id)];
    if (node.operation == Operation::convert) return expression(node.operands[0], least);
    const bool parenthesised = binding_of(node) < least;
    if (parenthesised) text_ += '(';
    body(node);
    if (parenthesised) text_ += ')';
  }

  void body(const AnyNode& node) {
    switch (node.operation) {
      case Operation::input: text_ += inputs_[static_cast<std::size_t>(node.input)]; return;
      case Operation::constant: text_ += to_text(node.value); return;
      case Operation::add: return infix(node, " + ", Binding::sum, Binding::product);
      case Operation::subtract: return infix(node, " - ", Binding::sum, Binding::product);
      case Operation::multiply: return infix(node, " * ", Binding::product, Binding::sign);
      case Operation::divide: return infix(node, " / ", Binding::product, Binding::sign);
      case Operation::negate: text_ += '-'; return expression(node.operands[0], Binding::power);
      case Operation::square:
        expression(node.operands[0], Binding::atom);
        text_ += "^2";
        return;
      case Operation::absolute: return call(node, "abs");
      case Operation::square_root: return call(node, "sqrt");
      case Operation::minimum: return call(node, "min");
      case Operation::maximum: return call(node, "max");
      case Operation::function: return function(node);
      case Operation::fused_sum: return terms(node);
      case Operation::look_up: return call(node, "look_up");
      case Operation::convert: break;
    }
    MIXCMP_CHECK(false);
  }

  void function(const Node& node) {
    if (const Formula* formula = formula_of(node)) {
      std::vector<Node> nodes = nodes_;
      const NodeId value = append(nodes, *formula, node.operands[0]);
      Printer whole(nodes, inputs_, max_length_);
      whole.expression(value, Binding::sum);
      text_ += whole.text_;
      return;
    }
    // The text before the argument, and the text behind it.
    const std::string whole = applied_text(*node.function, "#");
    const std::size_t argument = whole.rfind('#');
    text_ += whole.substr(0, argument);
    const bool is_alone = !is_power(node) && node.function->inner().is_identity();
    expression(node.operands[0], is_alone ? Binding::sum : Binding::atom);
    text_ += whole.substr(argument + 1);
  }

  void function(const TypedNode& /*node*/) { MIXCMP_CHECK(!"floating point has no functions"); }

  void terms(const Node& /*node*/) { MIXCMP_CHECK(!"only rounding makes a sum a fused one"); }

  void terms(const TypedNode& node) {
    for (const FusedTerm& term : node.terms) {
      const bool first = &term == &node.terms.front();
      if (first) text_ += term.negated ? "-" : "";
      if (!first) text_ += term.negated ? " - " : " + ";
      expression(term.a, term.is_square() ? Binding::atom : Binding::product);
      if (term.is_square()) text_ += "^2";
      if (!term.is_product() || term.is_square()) continue;
      text_ += " * ";
      expression(term.b, Binding::sign);
    }
  }

  void infix(const AnyNode& node, std::string_view sign, Binding left, Binding right) {
    expression(node.operands[0], left);
    text_ += sign;
    expression(node.operands[1], right);
  }

  void call(const AnyNode& node, std::string_view function) {
    text_ += function;
    text_ += '(';
    expression(node.operands[0], Binding::sum);
    if (arity(node.operation) == 2) {
      text_ += ", ";
      expression(node.operands[1], Binding::sum);
    }
    text_ += ')';
  }

  const std::vector<AnyNode>& nodes_;
  const std::vector<std::string>& inputs_;
  std::size_t max_length_;
  std::string text_;
};

/// The number of decimals that write `value` exactly; -1 if more than `most`.
int exact_decimals(const mpq_class& value, int most) {
  mpz_class power = 1;
  for (int decimals = 0; decimals <= most; ++decimals, power *= 10) {
    if (mpz_divisible_p(power.get_mpz_t(), value.get_den_mpz_t()) != 0) return decimals;
  }
  return -1;
}

std::string approximately(const mpq_class& value) {
  return "about " + rounded_text(value, 6);
}

}  // namespace

std::string rounded_text(const mpq_class& value, int digits) {
  const double nearby = value.get_d();
  if (value == 0 || (1e-300 < std::abs(nearby) && std::abs(nearby) < 1e300)) {
    return fmt::format("{:.{}g}", nearby, digits);
  }
  mp_exp_t exponent = 0;
  std::string text = mpf_class(value, 128).get_str(exponent, 10, static_cast<std::size_t>(digits));
  const std::size_t leading = text.starts_with('-') ? 2 : 1;
  if (text.size() > leading) text.insert(text.begin() + static_cast<long>(leading), '.');
  return fmt::format("{}e{:+03d}", text, exponent - 1);
}

std::string to_text(const mpq_class& value) {
  constexpr int most_decimals = 20;
  constexpr std::size_t most_characters = 24, most_of_a_fraction = 12;
  const int decimals = exact_decimals(value, most_decimals);
  if (decimals < 0) {
    const std::string fraction = value.get_str();
    return fraction.size() <= most_of_a_fraction ? fraction : approximately(value);
  }
  mpz_class scaled;
  mpz_ui_pow_ui(scaled.get_mpz_t(), 10, static_cast<unsigned long>(decimals));
  scaled = mpz_class(abs(value.get_num())) * scaled / value.get_den();
  std::string digits = scaled.get_str();
  if (digits.size() > most_characters) return approximately(value);
  const auto places = static_cast<std::size_t>(decimals);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (decimals > 0) digits.insert(digits.end() - decimals, '.');
  return fmt::format("{}{}", value < 0 ? "-" : "", digits);
}

std::string to_text(const std::vector<TypedNode>& nodes, const std::vector<std::string>& inputs,
                    NodeId node, std::size_t max_length) {
  return Printer(nodes, inputs, max_length).print(node);
}

std::string to_text(const std::vector<Node>& nodes, const std::vector<std::string>& inputs,
                    NodeId node, std::size_t max_length) {
  return Printer(nodes, inputs, max_length).print(node);
}

std::string to_text(const Graph& graph, NodeId node, std::size_t max_length) {
  return to_text(graph.nodes(), graph.inputs(), node, max_length);
}

}  // namespace mixcmp::inline expression
