#include "model/comparison/expression/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "model/base/common/nearest.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/literal.hpp"
#include "model/comparison/expression/callable.hpp"
#include "model/comparison/expression/failure.hpp"
#include "model/comparison/expression/name.hpp"
#include "model/comparison/expression/syntax.hpp"
#include "model/comparison/expression/text.hpp"

namespace mixcmp::inline expression {
namespace {

constexpr int max_power = 1024;
constexpr long max_power_denominator = 1'000'000;
// Powers up to this one are products.
constexpr int max_whole_power = 16;
constexpr std::size_t max_nodes = 4096;
// The most terms of all reductions in one text. With more terms, the graph would exceed max_nodes
// operations, unless some have no effect.
constexpr long max_terms = max_nodes;
// The greatest value of an index or a subscript.
constexpr long max_integer = 999'999;

template <class T>
T value_or_throw(Result<T> result) {
  if (!result.ok()) throw Failure{result.error()};
  return std::move(result).value();
}

/// The value of a subexpression: a constant or a node. Constants stay outside the graph until an
/// operation needs a node.
struct Value {
  std::size_t column;
  std::optional<mpq_class> constant;
  NodeId node = -1;
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
    case Operation::square_root:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

/// Builds the nodes for a text's syntax.
class GraphBuilder {
public:
  GraphBuilder(Graph& graph, std::span<const LetDefinition> lets,
               std::span<const IndexValue> indices, ReadPoints read_points)
      : graph_(graph),
        lets_(lets),
        indices_(indices.begin(), indices.end()),
        read_points_(std::move(read_points)) {}

  Value parse(const std::string& text) { return value_of(value_or_throw(parse_syntax(text, 0))); }
  IndexRange range(const Syntax& syntax);
  NodeId node_of(const Value& value) {
    return value.constant ? graph_.constant(*value.constant) : value.node;
  }
  /// Refuses an index with the name of an input, which could be mistaken for it. To be called after
  /// all texts are parsed.
  void check_index_names() const;
  std::set<std::string> used_lets() const;

private:
  /// The place where an index was introduced.
  struct IndexPlace {
    std::size_t column;
    std::string let;  ///< empty in the text itself
  };

  Value value_of(const Syntax& syntax);
  Value number(const Syntax& syntax) const;
  Value name(const Syntax& syntax);
  Value plain_name(const Syntax& syntax, const std::string& name);
  Value chain(const Syntax& syntax);
  Value power(const Syntax& syntax);
  Value call(const Syntax& syntax);
  Value remainder(const Syntax& syntax);
  Value angle(const Syntax& syntax);
  Value interpolated(const Syntax& syntax);
  Value limited(const Syntax& syntax);
  /// The value of an expression without inputs.
  mpq_class constant(const Syntax& syntax, const std::string& accepted);
  mpq_class exponent(const Syntax& syntax);
  Value reduction(const Syntax& syntax);

  Value applied(Operation operation, const Value& a, const Value& b);
  Value applied(const Function& function, const Value& argument);
  /// The value of a new node of the graph.
  Value made(std::size_t column, NodeId node) const;
  Value raised(const Value& base, int exponent);
  Value joined_pairwise(Operation operation, std::vector<Value> values);
  const Value& let_value(const LetDefinition& let, const Syntax& use);

  std::string subscripted_name(const Syntax& syntax);
  long integer(const Syntax& syntax);
  void check_index_name(const Syntax& syntax) const;
  const LetDefinition* find_let(const std::string& name) const;
  const IndexValue* find_index(const std::string& name) const;
  [[noreturn]] void fail_unknown(const Syntax& syntax, const std::string& name) const;
  /// ", with k = 0", or nothing if no index has a value.
  std::string index_values() const;

  Graph& graph_;
  std::span<const LetDefinition> lets_;
  std::map<std::string, Value> let_values_;
  std::vector<std::string> open_lets_;
  std::vector<IndexValue> indices_;  ///< indices of the enclosing reductions, innermost last
  ReadPoints read_points_;
  std::map<std::string, IndexPlace> index_places_;
  std::set<std::string> input_names_;
  bool constants_only_ = false;  ///< while an end of an index range, a subscript or a limit is read
  long terms_ = 0;
};

Value GraphBuilder::value_of(const Syntax& syntax) {
  const auto value = [&] {
    switch (syntax.kind) {
      case Syntax::Kind::number: return number(syntax);
      case Syntax::Kind::text:
        fail(syntax.column, "a text in quotes is no number", syntax.text,
             "the file of a table: table(\"points.csv\", x)");
      case Syntax::Kind::name: return name(syntax);
      case Syntax::Kind::negation: {
        const Value operand = value_of(syntax.parts[0]);
        return applied(Operation::negate, operand, operand);
      }
      case Syntax::Kind::identity: return value_of(syntax.parts[0]);
      case Syntax::Kind::power: return power(syntax);
      case Syntax::Kind::chain: return chain(syntax);
      case Syntax::Kind::call: return call(syntax);
      case Syntax::Kind::reduction: return reduction(syntax);
      case Syntax::Kind::range: break;
    }
    MIXCMP_CHECK(false);
  };
  Value result = value();
  result.column = syntax.column;
  return result;
}

Value GraphBuilder::number(const Syntax& syntax) const {
  const std::optional<mpq_class> value = parse_literal(syntax.text);
  if (!value) {
    fail(syntax.column, "the constant is too long", fmt::format("{:.40}", syntax.text),
         fmt::format("at most {} bits", max_constant_bits));
  }
  return {.column = syntax.column, .constant = value};
}

Value GraphBuilder::name(const Syntax& syntax) {
  if (const IndexValue* index = find_index(syntax.text)) {
    if (!syntax.parts.empty()) {
      fail(syntax.column, "an index takes no subscript", syntax.text + "[...]", syntax.text);
    }
    return {.column = syntax.column, .constant = index->value};
  }
  const std::string name = syntax.parts.empty() ? syntax.text : subscripted_name(syntax);
  if (const LetDefinition* let = find_let(name)) return let_value(*let, syntax);
  if (!syntax.parts.empty() && find_let(syntax.text) != nullptr) {
    fail(syntax.column, "a let takes no subscript", syntax.text + "[...]",
         fmt::format("{}, or a let named {}", syntax.text, name));
  }
  return plain_name(syntax, name);
}

/// The value of a name that is neither an index nor a let: an input.
Value GraphBuilder::plain_name(const Syntax& syntax, const std::string& name) {
  if (is_function_name(name)) {
    fail(syntax.column, fmt::format("the function {} needs its arguments", name), name,
         name + "(...)");
  }
  if (constants_only_) fail_unknown(syntax, name);
  const std::string problem = name_problem(name);
  if (!problem.empty()) fail(syntax.column, problem, name, std::string(accepted_names()));
  input_names_.insert(name);
  return {.column = syntax.column, .node = graph_.input(name)};
}

/// The plain name for a name with subscripts: p_2_3 for p[2][3].
std::string GraphBuilder::subscripted_name(const Syntax& syntax) {
  std::string name = syntax.text;
  for (const Syntax& subscript : syntax.parts) {
    const long value = integer(subscript);
    if (value < 0) {
      fail(subscript.column, "a subscript below zero" + index_values(), std::to_string(value),
           fmt::format("0..{}", max_integer));
    }
    name += fmt::format("_{}", value);
  }
  return name;
}

/// The integer value of a range's bound or of a subscript.
long GraphBuilder::integer(const Syntax& syntax) {
  const std::string accepted = fmt::format("an integer of at most {} either side", max_integer);
  const mpq_class value = constant(syntax, accepted);
  const bool is_whole = value.get_den() == 1;
  if (!is_whole || abs(value) > max_integer) {
    fail(syntax.column, (is_whole ? "too large" : "not an integer") + index_values(),
         to_text(value), accepted);
  }
  return value.get_num().get_si();
}

Value GraphBuilder::chain(const Syntax& syntax) {
  Value value = value_of(syntax.parts[0]);
  for (std::size_t k = 0; k < syntax.operations.size(); ++k) {
    value = applied(syntax.operations[k], value, value_of(syntax.parts[k + 1]));
  }
  return value;
}

/// Whole powers are products and quotients, and x^0.5 is a root: floating point has them too.
Value GraphBuilder::power(const Syntax& syntax) {
  const Value base = value_of(syntax.parts[0]);
  const mpq_class exponent = this->exponent(syntax.parts[1]);
  if (exponent == mpq_class(1, 2)) return applied(Operation::square_root, base, base);
  if (exponent.get_den() != 1 || exponent > max_whole_power) {
    return applied(Function::power_of(exponent), base);
  }
  const Value whole = raised(base, static_cast<int>(mpz_class(abs(exponent.get_num())).get_si()));
  if (exponent > 0) return whole;
  return applied(Operation::divide, {.column = base.column, .constant = 1}, whole);
}

mpq_class GraphBuilder::exponent(const Syntax& syntax) {
  const mpq_class exponent =
      constant(syntax, "a number, or numbers and + - * / ^; exp2(y * log2(x)) is x^y for any y");
  const bool is_whole_reciprocal = exponent.get_den() == 1 && exponent < 0;
  const mpq_class most = is_whole_reciprocal ? max_whole_power : max_power;
  if (exponent == 0 || abs(exponent) > most || exponent.get_den() > max_power_denominator) {
    fail(syntax.column, "power out of range" + index_values(), to_text(exponent),
         fmt::format("a number other than 0 of at most {} either side ({} if it is whole and below "
                     "0), a fraction over at most {}",
                     max_power, max_whole_power, max_power_denominator));
  }
  return exponent;
}

/// Square and multiply, from the exponent's highest bit down.
Value GraphBuilder::raised(const Value& base, int exponent) {
  if (exponent == 1) return base;
  if (exponent % 2 != 0) return applied(Operation::multiply, raised(base, exponent - 1), base);
  const Value root = raised(base, exponent / 2);
  return applied(Operation::multiply, root, root);
}

Value GraphBuilder::call(const Syntax& syntax) {
  const Callable& function = callable_of(syntax);
  check_arguments(syntax, function);
  switch (function.arguments) {
    case Callable::Arguments::value_and_limits: return limited(syntax);
    case Callable::Arguments::value_and_divisor: return remainder(syntax);
    case Callable::Arguments::y_and_x: return angle(syntax);
    case Callable::Arguments::file_and_value: return interpolated(syntax);
    case Callable::Arguments::one:
    case Callable::Arguments::two_or_more: break;
  }
  std::vector<Value> values;
  for (const Syntax& part : syntax.parts) values.push_back(value_of(part));
  if (function.function) return applied(*function.function, values[0]);
  if (!function.reduces()) return applied(*function.operation, values[0], values[0]);
  return joined_pairwise(*function.operation, std::move(values));
}

/// The value of mod(value, divisor).
Value GraphBuilder::remainder(const Syntax& syntax) {
  const Value dividend = value_of(syntax.parts[0]);
  const Syntax& given = syntax.parts[1];
  const mpq_class divisor = constant(given, "a number above 0, or numbers and + - * / ^");
  if (divisor <= 0) {
    fail(given.column, "mod divides by a number above 0" + index_values(), to_text(divisor),
         "a number above 0");
  }
  if (!dividend.constant) return applied(Function::remainder_by(divisor), dividend);
  const mpz_class quotient = floor_of(*dividend.constant / divisor);
  return {.column = dividend.column, .constant = *dividend.constant - quotient * divisor};
}

/// The value of atan2(y, x), the angle from the x axis to (x, y), above -pi and at most pi. Where
/// both are positive it is pi / 4 + atan((y - x) / (y + x)).
Value GraphBuilder::angle(const Syntax& syntax) {
  const Value y = value_of(syntax.parts[0]), x = value_of(syntax.parts[1]);
  const auto number = [&](int value) { return Value{.column = y.column, .constant = value}; };
  const auto unary = [&](Operation operation, const Value& a) { return applied(operation, a, a); };
  if (x.constant && y.constant && *x.constant == 0 && *y.constant == 0) {
    fail(y.column, "atan2 has no value there" + index_values(), "0, 0", "a direction");
  }
  const Value across = unary(Operation::absolute, x), up = unary(Operation::absolute, y);
  const Value ratio = applied(Operation::divide, applied(Operation::subtract, up, across),
                              applied(Operation::add, up, across));
  const Value eighth = applied(Function::atan, number(1));
  const Value turned = applied(Operation::subtract, eighth, applied(Function::atan, ratio));
  const Value half = applied(Operation::subtract, applied(Operation::multiply, number(2), eighth),
                             applied(Operation::multiply, applied(Function::sign, x), turned));
  return applied(Operation::multiply, applied(Function::sign, y), half);
}

/// The value of table("points.csv", value, degree).
Value GraphBuilder::interpolated(const Syntax& syntax) {
  const Syntax& file = syntax.parts[0];
  if (file.kind != Syntax::Kind::text) {
    fail(file.column, "the first argument of table is a file", file.text, "a file in quotes");
  }
  const long degree = syntax.parts.size() == 2 ? 1 : integer(syntax.parts[2]);
  if (degree < 1 || degree > Interpolation::most_degree) {
    fail(syntax.parts[2].column, "the degree of a table is out of range", std::to_string(degree),
         fmt::format("1..{}", Interpolation::most_degree));
  }
  if (!read_points_) {
    fail(file.column, "a table is read only for a scene's file", file.text, "f and g of a scene");
  }
  Result<Interpolation> table = read_points_(file.text, static_cast<int>(degree));
  if (!table.ok()) {
    Error error = table.error();
    error.column = static_cast<int>(file.column);
    throw Failure{std::move(error)};
  }
  return applied(Function::through(file.text, *table), value_of(syntax.parts[1]));
}

/// The value of within(value, low, high).
Value GraphBuilder::limited(const Syntax& syntax) {
  const Value value = value_of(syntax.parts[0]);
  if (value.constant) {
    fail(value.column, "a constant needs no limits", to_text(*value.constant),
         "an expression of inputs");
  }
  const auto limit = [&](const Syntax& end) {
    return constant(end, "a number, or numbers and + - * / ^");
  };
  const Range limits = {.low = limit(syntax.parts[1]), .high = limit(syntax.parts[2])};
  const auto refuse = [&](const char* message) {
    fail(syntax.parts[1].column, message + index_values(),
         fmt::format("[{}, {}]", to_text(limits.low), to_text(limits.high)),
         "a least value and one that is not below it");
  };
  if (limits.low > limits.high) refuse("the limits are empty");
  if (!graph_.limit(value.node, limits)) refuse("no number is within all limits of this value");
  return value;
}

mpq_class GraphBuilder::constant(const Syntax& syntax, const std::string& accepted) {
  const bool outer = std::exchange(constants_only_, true);
  const Value value = value_of(syntax);
  constants_only_ = outer;
  if (!value.constant) {
    fail(syntax.column, "not a constant", "an input, a root or a function", accepted);
  }
  return *value.constant;
}

constexpr std::string_view reducing_functions = "sum, product, min or max";

Value GraphBuilder::reduction(const Syntax& syntax) {
  const Callable& function = callable_of(syntax);
  if (!function.reduces()) {
    fail(syntax.column, fmt::format("{} takes no index", syntax.text), syntax.index + " in",
         std::string(reducing_functions));
  }
  const IndexRange values = range(syntax);
  terms_ += values.last - values.first + 1;
  if (terms_ > max_terms) {
    fail(syntax.column, "too many terms", fmt::format("{}..{}", values.first, values.last),
         fmt::format("at most {} in one expression, its lets included", max_terms));
  }
  std::vector<Value> terms;
  indices_.push_back({.name = values.name, .value = values.first});
  for (long k = values.first; k <= values.last; ++k) {
    indices_.back().value = k;
    terms.push_back(value_of(syntax.parts[2]));
  }
  indices_.pop_back();
  return joined_pairwise(*function.operation, std::move(terms));
}

IndexRange GraphBuilder::range(const Syntax& syntax) {
  check_index_name(syntax);
  index_places_.try_emplace(syntax.index,
                            IndexPlace{.column = syntax.index_column,
                                       .let = open_lets_.empty() ? "" : open_lets_.back()});
  const long first = integer(syntax.parts[0]);
  const long last = integer(syntax.parts[1]);
  if (first > last) {
    fail(syntax.parts[0].column, "an empty range" + index_values(),
         fmt::format("{}..{}", first, last), "a first value and one that is not below it");
  }
  return {.name = syntax.index, .first = first, .last = last};
}

void GraphBuilder::check_index_name(const Syntax& syntax) const {
  const auto hides = [&](std::string_view what) {
    fail(syntax.index_column, fmt::format("the index {} hides {}", syntax.index, what),
         syntax.index, "a name of no let, function, input or other index around it");
  };
  if (find_let(syntax.index) != nullptr) hides("a let");
  if (is_function_name(syntax.index)) hides("a function");
  if (find_index(syntax.index) != nullptr) hides("an index");
}

void GraphBuilder::check_index_names() const {
  for (const auto& [index, place] : index_places_) {
    if (!input_names_.contains(index)) continue;
    throw Failure{{.column = static_cast<int>(place.column),
                   .field = place.let.empty() ? "" : "let." + place.let,
                   .message = fmt::format("the index {} has the name of an input", index),
                   .received = index,
                   .accepted = "a name of no let, function, input or other index around it"}};
  }
}

/// Joins neighbours, then neighbouring results, and so on; an odd one waits for the next round.
/// This is a balanced tree: its error and depth grow with the logarithm of the number of terms.
Value GraphBuilder::joined_pairwise(Operation operation, std::vector<Value> values) {
  while (values.size() > 1) {
    const std::size_t pairs = values.size() / 2;
    for (std::size_t k = 0; k < pairs; ++k) {
      values[k] = applied(operation, values[2 * k], values[2 * k + 1]);
    }
    if (values.size() % 2 != 0) values[pairs] = values.back();
    values.resize(values.size() - pairs, values[0]);
  }
  return values[0];
}

/// Applies the operation to a and b. The caller passes the operand of a unary operation twice.
Value GraphBuilder::applied(Operation operation, const Value& a, const Value& b) {
  if (operation == Operation::divide && b.constant && *b.constant == 0) {
    fail(b.column, "division by zero" + index_values(), "0", "a divisor other than zero");
  }
  if (operation == Operation::square_root && a.constant && *a.constant < 0) {
    fail(a.column, "square root of a negative constant" + index_values(),
         a.constant->get_str().substr(0, 40), "a constant of at least zero");
  }
  if (a.constant && b.constant && operation != Operation::square_root) {
    const Value result{.column = a.column, .constant = fold(operation, *a.constant, *b.constant)};
    if (!is_too_long(*result.constant)) return result;
    fail(a.column, "the constant is too long", {},
         fmt::format("at most {} bits", max_constant_bits));
  }
  const bool scales =
      operation == Operation::divide && b.constant && is_power_of_two(mpq_class(abs(*b.constant)));
  // Division by a power of two becomes a multiplication: both scale exactly, and no divider is
  // needed.
  if (scales)
    return applied(Operation::multiply, a, {.column = b.column, .constant = 1 / *b.constant});
  const NodeId first = node_of(a);
  return made(a.column, arity(operation) == 1 ? graph_.apply(operation, first)
                                              : graph_.apply(operation, first, node_of(b)));
}

Value GraphBuilder::applied(const Function& function, const Value& argument) {
  if (argument.constant && function == Function::sign) {
    return {.column = argument.column, .constant = *argument.constant < 0 ? -1 : 1};
  }
  if (argument.constant && !domain(function).contains(*argument.constant)) {
    fail(argument.column,
         fmt::format("{} has no value there{}", applied_text(function, "x"), index_values()),
         to_text(*argument.constant), accepted_arguments(function));
  }
  return made(argument.column, graph_.apply(function, node_of(argument)));
}

Value GraphBuilder::made(std::size_t column, NodeId node) const {
  if (graph_.nodes().size() > max_nodes) {
    fail(column, "the expressions are too large", {},
         fmt::format("at most {} different operations, inputs and constants", max_nodes));
  }
  return {.column = column, .node = node};
}

/// Parses a let on its first use. The indices around that use are not visible in the let.
const Value& GraphBuilder::let_value(const LetDefinition& let, const Syntax& use) {
  const auto known = let_values_.find(let.name);
  if (known != let_values_.end()) return known->second;
  const auto open = std::find(open_lets_.begin(), open_lets_.end(), let.name);
  if (open != open_lets_.end()) {
    fail(use.column, "a let needs itself",
         fmt::format("{} -> {}", fmt::join(open, open_lets_.end(), " -> "), let.name),
         "lets without cycles");
  }
  const std::size_t nesting = use.nesting + 1;
  if (nesting > max_nesting) {
    fail(use.column, "nested too deeply", {}, fmt::format("at most {} levels", max_nesting));
  }
  open_lets_.push_back(let.name);
  const std::vector<IndexValue> outer_indices = std::exchange(indices_, {});
  const bool outer_constants_only = std::exchange(constants_only_, false);
  try {
    const Value value = value_of(value_or_throw(parse_syntax(let.text, nesting)));
    open_lets_.pop_back();
    indices_ = outer_indices;
    constants_only_ = outer_constants_only;
    return let_values_.emplace(let.name, value).first->second;
  } catch (Failure& failure) {
    if (failure.error.field.empty()) failure.error.field = "let." + let.name;
    throw;
  }
}

const LetDefinition* GraphBuilder::find_let(const std::string& name) const {
  const auto found = std::find_if(lets_.begin(), lets_.end(),
                                  [&](const LetDefinition& known) { return known.name == name; });
  return found == lets_.end() ? nullptr : &*found;
}

const IndexValue* GraphBuilder::find_index(const std::string& name) const {
  const auto found = std::find_if(indices_.begin(), indices_.end(),
                                  [&](const IndexValue& index) { return index.name == name; });
  return found == indices_.end() ? nullptr : &*found;
}

void GraphBuilder::fail_unknown(const Syntax& syntax, const std::string& name) const {
  std::vector<std::string> known;
  for (const IndexValue& index : indices_) known.push_back(index.name);
  for (const LetDefinition& let : lets_) {
    const bool is_open =
        std::find(open_lets_.begin(), open_lets_.end(), let.name) != open_lets_.end();
    if (!is_open) known.push_back(let.name);
  }
  fail(syntax.column, "unknown constant", name,
       known.empty() ? "an index of a reduction around it, or a let that is a constant"
                     : list_with_nearest(name, known));
}

std::string GraphBuilder::index_values() const {
  std::string text;
  for (const IndexValue& index : indices_) {
    text += fmt::format("{} {} = {}", text.empty() ? ", with" : ",", index.name, index.value);
  }
  return text;
}

std::set<std::string> GraphBuilder::used_lets() const {
  std::set<std::string> names;
  for (const auto& [name, value] : let_values_) names.insert(name);
  return names;
}

}  // namespace

Result<NodeId> parse_expression(Graph& graph, const std::string& text,
                                std::span<const LetDefinition> lets,
                                std::set<std::string>* used_lets,
                                std::span<const IndexValue> indices,
                                const ReadPoints& read_points) {
  GraphBuilder builder(graph, lets, indices, read_points);
  try {
    const NodeId root = builder.node_of(builder.parse(text));
    builder.check_index_names();
    if (used_lets != nullptr) used_lets->merge(builder.used_lets());
    return root;
  } catch (Failure& failure) {
    return std::move(failure.error);
  }
}

Result<IndexRange> parse_index_range(const std::string& text, std::span<const LetDefinition> lets) {
  MIXCMP_TRY(syntax, parse_range_syntax(text));
  Graph scratch;
  GraphBuilder builder(scratch, lets, {}, {});
  try {
    return builder.range(syntax);
  } catch (Failure& failure) {
    return std::move(failure.error);
  }
}

bool is_function_name(const std::string& name) {
  return find_callable(name) != nullptr;
}

}  // namespace mixcmp::inline expression
