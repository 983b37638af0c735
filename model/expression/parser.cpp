#include "model/expression/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <tao/pegtl.hpp>

#include "model/common/nearest.hpp"
#include "model/expression/literal.hpp"
#include "model/expression/name.hpp"

namespace mixcmp::model {
namespace {

namespace pegtl = tao::pegtl;

constexpr int max_power = 16;
constexpr std::size_t max_nodes = 4096;
// Parentheses, calls and lets inside one another: each level is a dozen frames of recursive
// descent.
constexpr std::size_t max_nesting = 100;

struct Function {
  std::string_view name;
  Operation operation;
};
constexpr std::array<Function, 4> functions = {{
    {"sqrt", Operation::square_root},
    {"abs", Operation::absolute},
    {"min", Operation::minimum},
    {"max", Operation::maximum},
}};

/// Carries an error out of the recursive descent; caught in parse_expression.
struct Failure {
  Error error;
};

[[noreturn]] void fail(std::size_t column, std::string message, std::string received = {},
                       std::string accepted = {}) {
  throw Failure{{.column = static_cast<int>(column),
                 .message = std::move(message),
                 .received = std::move(received),
                 .accepted = std::move(accepted)}};
}

/// A parsed subexpression. Constants stay outside the graph until an operation needs a node.
struct Value {
  std::size_t column;
  std::optional<mpq_class> constant;
  NodeId node = -1;
};

struct Call {
  std::string name;
  std::size_t column;
  std::size_t first_argument;
};

/// What one text's descent has gathered so far.
struct Stack {
  std::vector<Value> values;
  std::vector<Call> calls;
  std::vector<bool> negations;
  std::vector<std::size_t> open_parentheses;
};

mpq_class fold(Operation operation, const mpq_class& a, const mpq_class& b) {
  switch (operation) {
    case Operation::negate: return -a;
    case Operation::absolute: return abs(a);
    case Operation::add: return a + b;
    case Operation::subtract: return a - b;
    case Operation::multiply: return a * b;
    case Operation::square: return a * a;
    case Operation::divide: return a / b;
    case Operation::minimum: return std::min(a, b);
    case Operation::maximum: return std::max(a, b);
    case Operation::input:
    case Operation::constant:
    case Operation::convert:
    case Operation::square_root: break;
  }
  MIXCMP_CHECK(false);
}

class Builder {
public:
  Builder(Graph& graph, std::span<const LetDefinition> lets) : graph_(graph), lets_(lets) {}

  Value parse(const std::string& text, std::size_t outer_nesting);
  NodeId node_of(const Value& value) {
    return value.constant ? graph_.constant(*value.constant) : value.node;
  }

  void push_number(Stack& stack, std::size_t column, const std::string& text) const;
  void push_name(Stack& stack, std::size_t column, const std::string& name);
  void open(Stack& stack, std::size_t column) const;
  void call(Stack& stack);
  void raise_to_power(Stack& stack, std::size_t column, const std::string& text);
  /// Replaces the last arity(operation) values by the operation's result.
  void apply(Stack& stack, Operation operation);

  std::set<std::string> used_lets() const;

private:
  Value applied(Operation operation, const Value& a, const Value& b);
  Value power(const Value& base, int exponent);
  const Value& let_value(const LetDefinition& let, std::size_t column, std::size_t nesting);

  Graph& graph_;
  std::span<const LetDefinition> lets_;
  std::map<std::string, Value> let_values_;
  std::vector<std::string> open_lets_;
  std::size_t nesting_ = 0;  ///< of the text being parsed, lets and parentheses around it
};

namespace rules {

using namespace pegtl;

struct gap : star<space> {};
struct identifier
    : seq<ranges<'a', 'z', 'A', 'Z', '_'>, star<ranges<'a', 'z', 'A', 'Z', '0', '9', '_'>>> {};

template <class Digit>
struct mantissa : sor<seq<plus<Digit>, opt<one<'.'>, star<Digit>>>, seq<one<'.'>, plus<Digit>>> {};
template <char... Letter>
struct scale : opt<one<Letter...>, opt<one<'+', '-'>>, plus<digit>> {};
struct number : sor<seq<one<'0'>, one<'x', 'X'>, mantissa<xdigit>, scale<'p', 'P'>>,
                    seq<mantissa<digit>, scale<'e', 'E'>>> {};

struct expression;
struct open : one<'('> {};
struct close : one<')'> {};
struct group : if_must<open, gap, expression, close> {};

struct function_name : seq<identifier, at<gap, one<'('>>> {};
struct arguments
    : sor<at<one<')'>>, seq<must<expression>, star<if_must<one<','>, gap, expression>>>> {};
struct call : if_must<function_name, gap, open, gap, arguments, close> {};
struct variable : identifier {};

struct primary : sor<group, number, call, variable> {};
struct small_integer
    : seq<at<plus<digit>, not_at<sor<one<'.'>, ranges<'a', 'z', 'A', 'Z', '_'>>>>, plus<digit>> {};
struct power : if_must<one<'^'>, gap, small_integer, gap> {};
struct powered : seq<primary, gap, opt<power>> {};
struct minus_signs : plus<one<'-'>, gap> {};
struct negation : if_must<minus_signs, powered> {};
struct factor : sor<negation, powered> {};
struct multiplication : if_must<one<'*'>, gap, factor> {};
struct division : if_must<one<'/'>, gap, factor> {};
struct product : seq<factor, star<sor<multiplication, division>>> {};
struct addition : if_must<one<'+'>, gap, product> {};
struct subtraction : if_must<one<'-'>, gap, product> {};
struct expression : seq<product, star<sor<addition, subtraction>>> {};
struct whole : must<gap, expression, eof> {};

constexpr std::string_view operand = "a number, a name, a function call, '(' or '-'";

template <class Rule>
constexpr std::string_view accepted = operand;
template <>
constexpr std::string_view accepted<close> = "an operator or ')'";
template <>
constexpr std::string_view accepted<small_integer> = "an integer literal 1..16 after '^'";
template <>
constexpr std::string_view accepted<eof> = "an operator + - * / or the end";

}  // namespace rules

std::string quoted(char c) {
  const bool printable = ' ' <= c && c <= '~';
  return printable ? fmt::format("'{}'", c)
                   : fmt::format("byte 0x{:02x}", static_cast<unsigned char>(c));
}

template <class Rule>
struct Control : pegtl::normal<Rule> {
  template <class Input>
  [[noreturn]] static void raise(const Input& in, Builder&, Stack& stack) {
    const std::string received = in.empty() ? "the end" : quoted(in.peek_char());
    std::string message = in.empty() ? "unexpected end" : "unexpected character";
    if constexpr (std::is_same_v<Rule, rules::close>) {
      message = fmt::format("the '(' at column {} is not closed", stack.open_parentheses.back());
    }
    fail(in.position().byte + 1, message, received, std::string(rules::accepted<Rule>));
  }
};

template <class Rule>
struct Action : pegtl::nothing<Rule> {};

template <class Input>
std::size_t column_of(const Input& in) {
  return in.position().byte + 1;
}

template <>
struct Action<rules::number> {
  template <class Input>
  static void apply(const Input& in, Builder& builder, Stack& stack) {
    builder.push_number(stack, column_of(in), in.string());
  }
};
template <>
struct Action<rules::variable> {
  template <class Input>
  static void apply(const Input& in, Builder& builder, Stack& stack) {
    builder.push_name(stack, column_of(in), in.string());
  }
};
template <>
struct Action<rules::open> {
  template <class Input>
  static void apply(const Input& in, Builder& builder, Stack& stack) {
    builder.open(stack, column_of(in));
  }
};
template <>
struct Action<rules::close> {
  static void apply0(Builder&, Stack& stack) { stack.open_parentheses.pop_back(); }
};
template <>
struct Action<rules::function_name> {
  template <class Input>
  static void apply(const Input& in, Builder&, Stack& stack) {
    stack.calls.push_back({in.string(), column_of(in), stack.values.size()});
  }
};
template <>
struct Action<rules::call> {
  static void apply0(Builder& builder, Stack& stack) { builder.call(stack); }
};
template <>
struct Action<rules::small_integer> {
  template <class Input>
  static void apply(const Input& in, Builder& builder, Stack& stack) {
    builder.raise_to_power(stack, column_of(in), in.string());
  }
};
template <>
struct Action<rules::minus_signs> {
  template <class Input>
  static void apply(const Input& in, Builder&, Stack& stack) {
    const std::string signs = in.string();
    stack.negations.push_back(std::count(signs.begin(), signs.end(), '-') % 2 != 0);
  }
};
template <>
struct Action<rules::negation> {
  template <class Input>
  static void apply(const Input& in, Builder& builder, Stack& stack) {
    if (stack.negations.back()) builder.apply(stack, Operation::negate);
    stack.negations.pop_back();
    stack.values.back().column = column_of(in);
  }
};
template <>
struct Action<rules::group> {
  template <class Input>
  static void apply(const Input& in, Builder&, Stack& stack) {
    stack.values.back().column = column_of(in);
  }
};

template <Operation operation>
struct Apply {
  static void apply0(Builder& builder, Stack& stack) { builder.apply(stack, operation); }
};
template <>
struct Action<rules::addition> : Apply<Operation::add> {};
template <>
struct Action<rules::subtraction> : Apply<Operation::subtract> {};
template <>
struct Action<rules::multiplication> : Apply<Operation::multiply> {};
template <>
struct Action<rules::division> : Apply<Operation::divide> {};

Value Builder::parse(const std::string& text, std::size_t outer_nesting) {
  const std::size_t nesting_before = std::exchange(nesting_, outer_nesting);
  Stack stack;
  pegtl::memory_input in(text, "");
  pegtl::parse<rules::whole, Action, Control>(in, *this, stack);
  MIXCMP_CHECK(stack.values.size() == 1);
  nesting_ = nesting_before;
  return stack.values.back();
}

void Builder::push_number(Stack& stack, std::size_t column, const std::string& text) const {
  const std::optional<mpq_class> value = parse_literal(text);
  if (!value) {
    fail(column, "the constant is too long", fmt::format("{:.40}", text),
         fmt::format("at most {} bits", max_constant_bits));
  }
  stack.values.push_back({.column = column, .constant = value});
}

void Builder::push_name(Stack& stack, std::size_t column, const std::string& name) {
  const auto let = std::find_if(lets_.begin(), lets_.end(),
                                [&](const LetDefinition& known) { return known.name == name; });
  if (let != lets_.end()) {
    Value value = let_value(*let, column, nesting_ + stack.open_parentheses.size() + 1);
    value.column = column;
    stack.values.push_back(std::move(value));
    return;
  }
  if (is_function_name(name)) {
    fail(column, fmt::format("the function {} needs its arguments", name), name, name + "(...)");
  }
  const std::string problem = name_problem(name);
  if (!problem.empty()) fail(column, problem, name, std::string(accepted_names()));
  stack.values.push_back({.column = column, .node = graph_.input(name)});
}

const Value& Builder::let_value(const LetDefinition& let, std::size_t column, std::size_t nesting) {
  const auto known = let_values_.find(let.name);
  if (known != let_values_.end()) return known->second;
  const auto open = std::find(open_lets_.begin(), open_lets_.end(), let.name);
  if (open != open_lets_.end()) {
    fail(column, "a let needs itself",
         fmt::format("{} -> {}", fmt::join(open, open_lets_.end(), " -> "), let.name),
         "lets without cycles");
  }
  if (nesting > max_nesting) {
    fail(column, "nested too deeply", {}, fmt::format("at most {} levels", max_nesting));
  }
  open_lets_.push_back(let.name);
  try {
    const Value value = parse(let.text, nesting);
    open_lets_.pop_back();
    return let_values_.emplace(let.name, value).first->second;
  } catch (Failure& failure) {
    if (failure.error.field.empty()) failure.error.field = "let." + let.name;
    throw;
  }
}

void Builder::open(Stack& stack, std::size_t column) const {
  stack.open_parentheses.push_back(column);
  if (nesting_ + stack.open_parentheses.size() > max_nesting) {
    fail(column, "nested too deeply", {}, fmt::format("at most {} levels", max_nesting));
  }
}

void Builder::call(Stack& stack) {
  const Call call = std::move(stack.calls.back());
  stack.calls.pop_back();
  const auto function = std::find_if(functions.begin(), functions.end(),
                                     [&](const Function& f) { return f.name == call.name; });
  if (function == functions.end()) {
    std::vector<std::string> names;
    for (const Function& f : functions) names.emplace_back(f.name);
    fail(call.column, "unknown function", call.name, list_with_nearest(call.name, names));
  }
  const std::size_t count = stack.values.size() - call.first_argument;
  const auto needed = static_cast<std::size_t>(arity(function->operation));
  if (count != needed) {
    const auto arguments = [](std::size_t n) {
      return fmt::format("{} argument{}", n, n == 1 ? "" : "s");
    };
    fail(call.column, fmt::format("{} takes {}", call.name, arguments(needed)), arguments(count),
         arguments(needed));
  }
  apply(stack, function->operation);
  stack.values.back().column = call.column;
}

void Builder::raise_to_power(Stack& stack, std::size_t column, const std::string& text) {
  int exponent = 0;
  const auto status = std::from_chars(text.data(), text.data() + text.size(), exponent).ec;
  if (status != std::errc{} || exponent < 1 || exponent > max_power) {
    fail(column, "power out of range", fmt::format("{:.40}", text),
         std::string(rules::accepted<rules::small_integer>));
  }
  stack.values.back() = power(stack.values.back(), exponent);
}

void Builder::apply(Stack& stack, Operation operation) {
  const Value last = std::move(stack.values.back());
  stack.values.pop_back();
  if (arity(operation) == 1) {
    stack.values.push_back(applied(operation, last, last));
    return;
  }
  stack.values.back() = applied(operation, stack.values.back(), last);
}

/// For one operand, `b` is `a`.
Value Builder::applied(Operation operation, const Value& a, const Value& b) {
  if (operation == Operation::divide && b.constant && *b.constant == 0) {
    fail(b.column, "division by zero", "0", "a divisor other than zero");
  }
  if (operation == Operation::square_root && a.constant && *a.constant < 0) {
    fail(a.column, "square root of a negative constant", a.constant->get_str().substr(0, 40),
         "a constant of at least zero");
  }
  Value result{.column = a.column};
  if (a.constant && b.constant && operation != Operation::square_root) {
    result.constant = fold(operation, *a.constant, *b.constant);
    if (!is_too_long(*result.constant)) return result;
    fail(a.column, "the constant is too long", {},
         fmt::format("at most {} bits", max_constant_bits));
  }
  const NodeId first = node_of(a);
  result.node = arity(operation) == 1 ? graph_.apply(operation, first)
                                      : graph_.apply(operation, first, node_of(b));
  if (graph_.nodes().size() > max_nodes) {
    fail(a.column, "the expressions are too large", {},
         fmt::format("at most {} different operations", max_nodes));
  }
  return result;
}

/// Square and multiply, from the exponent's highest bit down.
Value Builder::power(const Value& base, int exponent) {
  if (exponent == 1) return base;
  if (exponent % 2 != 0) {
    return applied(Operation::multiply, power(base, exponent - 1), base);
  }
  const Value root = power(base, exponent / 2);
  return applied(Operation::multiply, root, root);
}

std::set<std::string> Builder::used_lets() const {
  std::set<std::string> names;
  for (const auto& [name, value] : let_values_) names.insert(name);
  return names;
}

}  // namespace

Result<NodeId> parse_expression(Graph& graph, const std::string& text,
                                std::span<const LetDefinition> lets,
                                std::set<std::string>* used_lets) {
  Builder builder(graph, lets);
  try {
    const NodeId root = builder.node_of(builder.parse(text, 0));
    if (used_lets != nullptr) used_lets->merge(builder.used_lets());
    return root;
  } catch (Failure& failure) {
    return std::move(failure.error);
  }
}

bool is_function_name(const std::string& name) {
  return std::any_of(functions.begin(), functions.end(),
                     [&](const Function& function) { return function.name == name; });
}

}  // namespace mixcmp::model
