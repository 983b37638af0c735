#include "generator/hardware/emit/constants.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "model/base/common/bits.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::emit {
namespace {

struct Operator {
  Token name;
  int precedence;
  long long (*apply)(long long, long long);
};

const Operator* find_operator(Token name) {
  static constexpr std::array<Operator, 17> operators = {{
      {"||", 1, [](long long a, long long b) -> long long { return a != 0 || b != 0; }},
      {"&&", 2, [](long long a, long long b) -> long long { return a != 0 && b != 0; }},
      {"&", 3, [](long long a, long long b) { return a & b; }},
      {"==", 4, [](long long a, long long b) -> long long { return a == b; }},
      {"!=", 4, [](long long a, long long b) -> long long { return a != b; }},
      {"<", 5, [](long long a, long long b) -> long long { return a < b; }},
      {">", 5, [](long long a, long long b) -> long long { return a > b; }},
      {"<=", 5, [](long long a, long long b) -> long long { return a <= b; }},
      {">=", 5, [](long long a, long long b) -> long long { return a >= b; }},
      {"<<", 6, [](long long a, long long b) { return a << b; }},
      {">>", 6, [](long long a, long long b) { return a >> b; }},
      {">>>", 6, [](long long a, long long b) { return a >> b; }},
      {"+", 7, [](long long a, long long b) { return a + b; }},
      {"-", 7, [](long long a, long long b) { return a - b; }},
      {"*", 8, [](long long a, long long b) { return a * b; }},
      {"/", 8, [](long long a, long long b) { return a / b; }},
      {"%", 8, [](long long a, long long b) { return a % b; }},
  }};
  const auto found = std::find_if(operators.begin(), operators.end(),
                                  [&](const Operator& each) { return each.name == name; });
  return found == operators.end() ? nullptr : &*found;
}

/// The value of a literal from its base on: 'b101, 'hff, 'd10.
long long based(std::string_view text) {
  MIXCMP_CHECK(text.size() > 2);
  const int base = text[1] == 'b' ? 2 : text[1] == 'h' ? 16 : 10;
  long long number = 0;
  std::from_chars(text.data() + 2, text.data() + text.size(), number, base);
  return number;
}

}  // namespace

/// Computes one constant expression.
class Expression {
public:
  Expression(const Tokens& tokens, const Constants& constants)
      : cursor_(tokens), constants_(constants) {}

  long long value() {
    const long long result = choice();
    MIXCMP_CHECK(cursor_.at_end());
    return result;
  }

private:
  long long choice() {
    const long long condition = operation(1);
    if (!cursor_.take_if("?")) return condition;
    const long long yes = choice();
    cursor_.expect(":");
    const long long no = choice();
    return condition != 0 ? yes : no;
  }

  /// Evaluates an operation whose operators bind at least as tightly as `precedence`.
  long long operation(int precedence) {
    long long left = primary();
    for (;;) {
      const Operator* const next = find_operator(cursor_.peek());
      if (next == nullptr || next->precedence < precedence) return left;
      cursor_.take();
      left = next->apply(left, operation(next->precedence + 1));
    }
  }

  long long primary() {
    if (cursor_.take_if("-")) return -primary();
    if (cursor_.take_if("(")) {
      const long long inner = choice();
      cursor_.expect(")");
      return inner;
    }
    if (cursor_.take_if("{")) return joined();
    const Token word = cursor_.take();
    long long number = 0;
    const char* const end_of_word = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), end_of_word, number);
    if (error != std::errc()) return named(word);
    return end == end_of_word ? number : based(std::string_view(end, end_of_word));
  }

  long long named(Token name) {
    if (!cursor_.take_if("(")) return constants_.value_of(name);
    std::vector<long long> arguments;
    do arguments.push_back(choice());
    while (cursor_.take_if(","));
    cursor_.expect(")");
    return constants_.call(name, arguments);
  }

  /// The value of a repeated bit, such as {(WIDTH + 1) {1'b1}}, or of a bit in front of repeated
  /// ones, such as {1'b1, {(WIDTH - 1) {1'b0}}}; behind the first bracket.
  long long joined() {
    const long long first = primary();
    if (cursor_.peek() == "{") return repeated(first).bits;
    cursor_.expect(",");
    cursor_.expect("{");
    const Repeated behind = repeated(primary());
    cursor_.expect("}");
    return (first << behind.count) | behind.bits;
  }

  struct Repeated {
    int count;
    long long bits;
  };

  Repeated repeated(long long count) {
    cursor_.expect("{");
    const long long bit = primary();
    cursor_.expect("}");
    cursor_.expect("}");
    const auto ones = static_cast<long long>(low_mask(static_cast<int>(count)));
    return {static_cast<int>(count), bit == 0 ? 0 : ones};
  }

  Cursor cursor_;
  const Constants& constants_;
};

long long Constants::value(const Tokens& expression) const {
  return Expression(expression, *this).value();
}

long long Constants::value_of(Token name) const {
  const auto known = values_.find(name);
  if (known != values_.end()) return known->second;
  const auto defined = expressions_.find(name);
  if (defined != expressions_.end()) return value(defined->second);
  MIXCMP_CHECK(outer_ != nullptr);
  return outer_->value_of(name);
}

void Constants::define_function(Cursor& cursor) {
  cursor.expect("integer");
  Function& function = functions_[cursor.take()];
  cursor.expect(";");
  while (cursor.peek() == "input" || cursor.peek() == "integer") {
    const bool is_input = cursor.take() == "input";
    if (is_input) cursor.expect("integer");
    if (is_input) function.inputs.push_back(cursor.peek());
    cursor.take_until({";"});
    cursor.expect(";");
  }
  function.body = take_statement(cursor);
  cursor.expect("endfunction");
}

const Constants::Function* Constants::find_function(Token name) const {
  const auto found = functions_.find(name);
  if (found != functions_.end()) return &found->second;
  return outer_ == nullptr ? nullptr : outer_->find_function(name);
}

long long Constants::call(Token name, const std::vector<long long>& arguments) const {
  const Function* const function = find_function(name);
  MIXCMP_CHECK(function != nullptr && function->inputs.size() == arguments.size());
  Constants inside(this);
  for (std::size_t k = 0; k < arguments.size(); ++k) inside.set(function->inputs[k], arguments[k]);
  inside.run(function->body);
  return inside.value_of(name);
}

void Constants::run(const Tokens& statement) {
  Cursor cursor(statement);
  run(cursor);
}

void Constants::run(Cursor& cursor) {
  if (cursor.take_if("begin")) {
    while (!cursor.take_if("end")) run(cursor);
  } else if (cursor.take_if("for")) {
    run_for(cursor);
  } else if (cursor.take_if("while")) {
    run_while(cursor);
  } else if (cursor.take_if("if")) {
    run_if(cursor);
  } else {
    assign(cursor.take_until({";"}));
    cursor.expect(";");
  }
}

void Constants::assign(const Tokens& assignment) {
  MIXCMP_CHECK(assignment.size() > 2 && assignment[1] == "=");
  set(assignment.front(), value({assignment.begin() + 2, assignment.end()}));
}

void Constants::run_for(Cursor& cursor) {
  Cursor head(cursor.take_bracketed());
  const Tokens body = take_statement(cursor);
  assign(head.take_until({";"}));
  head.expect(";");
  const Tokens condition = head.take_until({";"});
  head.expect(";");
  const Tokens step = head.take_until({Token()});
  for (; value(condition) != 0; assign(step)) run(body);
}

void Constants::run_while(Cursor& cursor) {
  const Tokens condition = cursor.take_bracketed();
  const Tokens body = take_statement(cursor);
  while (value(condition) != 0) run(body);
}

void Constants::run_if(Cursor& cursor) {
  const bool holds = value(cursor.take_bracketed()) != 0;
  const Tokens yes = take_statement(cursor);
  const Tokens no = cursor.take_if("else") ? take_statement(cursor) : Tokens();
  if (holds) {
    run(yes);
  } else if (!no.empty()) {
    run(no);
  }
}

namespace {

void move_statement(Cursor& from, Tokens& to);

void move_while(Cursor& from, Tokens& to, std::initializer_list<Token> ends) {
  const Tokens taken = from.take_until(ends);
  to.insert(to.end(), taken.begin(), taken.end());
}

/// Moves "(...)".
void move_bracketed(Cursor& from, Tokens& to) {
  to.push_back(from.take());
  move_while(from, to, {")"});
  to.push_back(from.take());
}

void move_block(Cursor& from, Token end, Tokens& to) {
  for (int depth = 0;;) {
    if (depth == 0 && from.peek() == end) break;
    const Token token = from.take();
    if (token == "begin" || token == "case") ++depth;
    if (token == "end" || token == "endcase") --depth;
    to.push_back(token);
  }
  to.push_back(from.take());
}

void move_statement(Cursor& from, Tokens& to) {
  const Token first = from.peek();
  if (first == "begin" || first == "case") {
    to.push_back(from.take());
    move_block(from, first == "begin" ? "end" : "endcase", to);
  } else if (first == "for" || first == "while" || first == "if") {
    to.push_back(from.take());
    move_bracketed(from, to);
    move_statement(from, to);
    if (first != "if" || from.peek() != "else") return;
    to.push_back(from.take());
    move_statement(from, to);
  } else {
    move_while(from, to, {";"});
    to.push_back(from.take());
  }
}

}  // namespace

Tokens take_statement(Cursor& cursor) {
  Tokens taken;
  move_statement(cursor, taken);
  return taken;
}

}  // namespace mixcmp::emit
