#include "generator/hardware/emit/template_ports.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "generator/hardware/emit/templates.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::emit {
namespace {

using Token = std::string_view;
using Tokens = std::vector<Token>;

constexpr std::array<Token, 8> long_operators = {"<<", ">>", "<=", ">=", "==", "!=", "&&", "||"};

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$' || c == '\'';
}

/// The token that a text begins with. The text must not begin with a blank or a comment.
Token first_token(std::string_view text) {
  if (is_word(text.front())) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_word);
    return text.substr(0, static_cast<std::size_t>(end - text.begin()));
  }
  const bool is_long = std::find(long_operators.begin(), long_operators.end(), text.substr(0, 2)) !=
                       long_operators.end();
  return text.substr(0, is_long ? 2 : 1);
}

/// The tokens of a template's head: from "module" to the end of its ports.
Tokens tokens_of_head(std::string_view text) {
  Tokens tokens;
  while (tokens.empty() || tokens.back() != ";") {
    MIXCMP_CHECK(!text.empty());
    if (text.starts_with("//") || text.starts_with('`')) {
      text.remove_prefix(std::min(text.find('\n'), text.size()));
    } else if (std::isspace(static_cast<unsigned char>(text.front())) != 0) {
      text.remove_prefix(1);
    } else {
      tokens.push_back(first_token(text));
      text.remove_prefix(tokens.back().size());
    }
  }
  return tokens;
}

/// Tokens, and the place of the next one to read.
class Cursor {
public:
  explicit Cursor(Tokens tokens) : tokens_(std::move(tokens)) {}

  Token peek() const { return at_ < tokens_.size() ? tokens_[at_] : Token(); }
  Token take() {
    MIXCMP_CHECK(at_ < tokens_.size());
    return tokens_[at_++];
  }
  bool take_if(Token wanted) {
    const bool found = peek() == wanted;
    if (found) ++at_;
    return found;
  }
  void expect(Token wanted) { MIXCMP_CHECK(take_if(wanted)); }

  /// The tokens up to one of `ends` that stands outside of brackets.
  Tokens take_until(std::initializer_list<Token> ends) {
    Tokens taken;
    for (int depth = 0;;) {
      const Token next = peek();
      if (depth == 0 && std::find(ends.begin(), ends.end(), next) != ends.end()) return taken;
      if (next == "(" || next == "[" || next == "{") ++depth;
      if (next == ")" || next == "]" || next == "}") --depth;
      taken.push_back(take());
    }
  }

private:
  Tokens tokens_;
  std::size_t at_ = 0;
};

/// A declaration of a parameter or a port.
struct Declaration {
  Token name;
  Tokens high;   ///< the first end of a range [high:0]; empty: no range
  Tokens value;  ///< a parameter's default
  rtl::Direction direction = rtl::Direction::input;
};

struct Head {
  std::vector<Declaration> parameters;
  std::vector<Declaration> ports;
};

Tokens take_range(Cursor& cursor) {
  if (!cursor.take_if("[")) return {};
  Tokens high = cursor.take_until({":"});
  cursor.expect(":");
  cursor.expect("0");
  cursor.expect("]");
  return high;
}

Declaration take_parameter(Cursor& cursor) {
  cursor.expect("parameter");
  Declaration parameter;
  parameter.high = take_range(cursor);
  parameter.name = cursor.take();
  cursor.expect("=");
  parameter.value = cursor.take_until({",", ")"});
  return parameter;
}

Declaration take_port(Cursor& cursor) {
  Declaration port;
  const Token direction = cursor.take();
  MIXCMP_CHECK(direction == "input" || direction == "output");
  port.direction = direction == "input" ? rtl::Direction::input : rtl::Direction::output;
  if (!cursor.take_if("wire")) cursor.expect("reg");
  port.high = take_range(cursor);
  port.name = cursor.take();
  return port;
}

Head head_of(std::string_view text) {
  Cursor cursor(tokens_of_head(text));
  Head head;
  cursor.expect("module");
  cursor.take();
  if (cursor.take_if("#")) {
    cursor.expect("(");
    do head.parameters.push_back(take_parameter(cursor));
    while (cursor.take_if(","));
    cursor.expect(")");
  }
  cursor.expect("(");
  do head.ports.push_back(take_port(cursor));
  while (cursor.take_if(","));
  cursor.expect(")");
  return head;
}

/// Computes constant expressions of a head, for one instance.
class Evaluator {
public:
  Evaluator(const Head& head, const rtl::Instance& instance) {
    for (const Declaration& parameter : head.parameters) defaults_[parameter.name] = &parameter;
    for (const rtl::Parameter& parameter : instance.parameters) given_[parameter.name] = &parameter;
  }

  long long value(const Tokens& expression) {
    Cursor cursor(expression);
    const long long result = choice(cursor);
    MIXCMP_CHECK(cursor.peek().empty());
    return result;
  }

  /// The value of a parameter that the head declares.
  long long parameter(Token name) {
    const auto given = given_.find(name);
    if (given == given_.end()) {
      const auto declared = defaults_.find(name);
      MIXCMP_CHECK(declared != defaults_.end());
      return value(declared->second->value);
    }
    if (const auto* number = std::get_if<long long>(&given->second->value)) return *number;
    return static_cast<long long>(std::get<rtl::Literal>(given->second->value).value);
  }

private:
  struct Operator {
    Token name;
    int precedence;
    long long (*apply)(long long, long long);
  };

  static const Operator* find_operator(Token name) {
    static constexpr std::array<Operator, 15> operators = {{
        {"||", 1, [](long long a, long long b) -> long long { return a != 0 || b != 0; }},
        {"&&", 2, [](long long a, long long b) -> long long { return a != 0 && b != 0; }},
        {"==", 3, [](long long a, long long b) -> long long { return a == b; }},
        {"!=", 3, [](long long a, long long b) -> long long { return a != b; }},
        {"<", 4, [](long long a, long long b) -> long long { return a < b; }},
        {">", 4, [](long long a, long long b) -> long long { return a > b; }},
        {"<=", 4, [](long long a, long long b) -> long long { return a <= b; }},
        {">=", 4, [](long long a, long long b) -> long long { return a >= b; }},
        {"<<", 5, [](long long a, long long b) { return a << b; }},
        {">>", 5, [](long long a, long long b) { return a >> b; }},
        {"+", 6, [](long long a, long long b) { return a + b; }},
        {"-", 6, [](long long a, long long b) { return a - b; }},
        {"*", 7, [](long long a, long long b) { return a * b; }},
        {"/", 7, [](long long a, long long b) { return a / b; }},
        {"%", 7, [](long long a, long long b) { return a % b; }},
    }};
    const auto found = std::find_if(operators.begin(), operators.end(),
                                    [&](const Operator& each) { return each.name == name; });
    return found == operators.end() ? nullptr : &*found;
  }

  long long choice(Cursor& cursor) {
    const long long condition = operation(cursor, 1);
    if (!cursor.take_if("?")) return condition;
    const long long yes = choice(cursor);
    cursor.expect(":");
    const long long no = choice(cursor);
    return condition != 0 ? yes : no;
  }

  /// Evaluates an operation whose operators bind at least as tightly as `precedence`.
  long long operation(Cursor& cursor, int precedence) {
    long long left = primary(cursor);
    for (;;) {
      const Operator* const next = find_operator(cursor.peek());
      if (next == nullptr || next->precedence < precedence) return left;
      cursor.take();
      left = next->apply(left, operation(cursor, next->precedence + 1));
    }
  }

  long long primary(Cursor& cursor) {
    if (cursor.take_if("-")) return -primary(cursor);
    if (cursor.take_if("(")) {
      const long long inner = choice(cursor);
      cursor.expect(")");
      return inner;
    }
    if (cursor.take_if("{")) return repeated(cursor);
    const Token word = cursor.take();
    long long number = 0;
    const char* const end_of_word = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), end_of_word, number);
    if (error != std::errc()) return parameter(word);
    return end == end_of_word ? number : based(std::string_view(end, end_of_word));
  }

  /// The value of a repeated bit, such as {(WIDTH + 1) {1'b1}}, behind its first bracket.
  long long repeated(Cursor& cursor) {
    const long long count = primary(cursor);
    cursor.expect("{");
    const long long bit = primary(cursor);
    cursor.expect("}");
    cursor.expect("}");
    return bit == 0 ? 0 : static_cast<long long>(low_mask(static_cast<int>(count)));
  }

  /// The value of a literal from its base on: 'b101, 'hff, 'd10.
  static long long based(std::string_view text) {
    MIXCMP_CHECK(text.size() > 2);
    const int base = text[1] == 'b' ? 2 : text[1] == 'h' ? 16 : 10;
    long long number = 0;
    std::from_chars(text.data() + 2, text.data() + text.size(), number, base);
    return number;
  }

  std::map<Token, const Declaration*> defaults_;
  std::map<Token, const rtl::Parameter*> given_;
};

/// The declaration of a parameter; null if there is none.
const Declaration* find_parameter(const Head& head, const std::string& name) {
  const auto found = std::find_if(head.parameters.begin(), head.parameters.end(),
                                  [&](const Declaration& each) { return each.name == name; });
  return found == head.parameters.end() ? nullptr : &*found;
}

/// The fault of a parameter that an instance gives; empty if there is none.
std::string fault_of(const rtl::Parameter& given, const Head& head, Evaluator& evaluator) {
  const Declaration* const declared = find_parameter(head, given.name);
  if (declared == nullptr) return "there is no parameter " + given.name;
  const auto* literal = std::get_if<rtl::Literal>(&given.value);
  if (literal == nullptr || declared->high.empty()) return "";
  const long long width = evaluator.value(declared->high) + 1;
  if (width == literal->width) return "";
  return fmt::format("parameter {} has {} bits, and gets {}", given.name, width, literal->width);
}

}  // namespace

Result<std::vector<rtl::Port>> template_ports(const rtl::Instance& instance) {
  if (!is_template(instance.module)) return Error{.message = "there is no such module"};
  const Head head = head_of(template_text(instance.module));
  Evaluator evaluator(head, instance);
  for (const rtl::Parameter& given : instance.parameters) {
    const std::string fault = fault_of(given, head, evaluator);
    if (!fault.empty()) return Error{.message = fault};
  }
  std::vector<rtl::Port> ports;
  for (const Declaration& port : head.ports) {
    const long long width = port.high.empty() ? 1 : evaluator.value(port.high) + 1;
    ports.push_back(
        {port.direction, static_cast<int>(width), std::string(port.name), !port.high.empty()});
  }
  return ports;
}

std::optional<long long> template_parameter(const rtl::Instance& instance,
                                            const std::string& name) {
  if (!is_template(instance.module)) return std::nullopt;
  const Head head = head_of(template_text(instance.module));
  if (find_parameter(head, name) == nullptr) return std::nullopt;
  return Evaluator(head, instance).parameter(name);
}

std::vector<rtl::Parameter> template_parameters(const rtl::TemplateInstance& instance) {
  const Head head = head_of(template_text(instance.module));
  const rtl::Instance as_instance{instance.module, {}, instance.parameters, {}};
  Evaluator evaluator(head, as_instance);
  std::vector<rtl::Parameter> parameters;
  for (const Declaration& declared : head.parameters) {
    const auto given =
        std::find_if(instance.parameters.begin(), instance.parameters.end(),
                     [&](const rtl::Parameter& each) { return each.name == declared.name; });
    if (given != instance.parameters.end()) {
      parameters.push_back(*given);
    } else if (declared.high.empty()) {
      parameters.push_back({std::string(declared.name), evaluator.parameter(declared.name)});
    } else {
      const int width = static_cast<int>(evaluator.value(declared.high)) + 1;
      const auto bits = static_cast<Bits>(evaluator.parameter(declared.name));
      parameters.push_back({std::string(declared.name), rtl::Literal{width, bits}});
    }
  }
  return parameters;
}

rtl::CheckedModules checked(std::vector<rtl::Module> modules) {
  return {std::move(modules), template_ports};
}

}  // namespace mixcmp::emit
