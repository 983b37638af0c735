#include "model/comparison/expression/syntax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tao/pegtl.hpp>

#include "model/base/common/quote.hpp"
#include "model/comparison/expression/failure.hpp"

namespace mixcmp::inline expression {
namespace {

namespace pegtl = tao::pegtl;

/// A function whose arguments are being read.
struct OpenCall {
  std::string function;
  std::size_t column;
  std::size_t first_argument;  ///< index on the stack of parts
  std::string index;           ///< empty without "k in"
  std::size_t index_column = 0;
};

struct OpenBracket {
  char character;
  std::size_t column;
};

/// The state of the descent. Complete parts wait on a stack until an operation or a call joins
/// them.
class Gathering {
public:
  explicit Gathering(std::size_t outer_nesting) : outer_nesting_(outer_nesting) {}

  void push(Syntax::Kind kind, std::size_t column, std::string text);
  void set_column(std::size_t column) { parts_.back().column = column; }
  void join(Operation operation);
  void add_subscript();
  void raise_to_power();
  void open(char character, std::size_t column);
  void close() { open_brackets_.pop_back(); }
  void begin_call(std::string function, std::size_t column);
  void begin_index(std::string name, std::size_t column);
  void end_call(Syntax::Kind kind);
  void begin_signs(bool negative) { negative_signs_.push_back(negative); }
  void end_signs(std::size_t column);

  const OpenBracket& open_bracket() const { return open_brackets_.back(); }
  /// Whether the open call has only read a name, which may be meant as an index.
  bool may_have_read_index() const;
  Syntax finish();

private:
  Syntax pop();
  std::size_t nesting() const { return outer_nesting_ + open_brackets_.size(); }

  std::size_t outer_nesting_;
  std::vector<Syntax> parts_;
  std::vector<OpenCall> calls_;
  std::vector<bool> negative_signs_;
  std::vector<OpenBracket> open_brackets_;
};

void Gathering::push(Syntax::Kind kind, std::size_t column, std::string text) {
  parts_.push_back({.kind = kind,
                    .column = column,
                    .text = std::move(text),
                    .nesting = nesting(),
                    .parts = {},
                    .operations = {},
                    .index = {}});
}

Syntax Gathering::pop() {
  Syntax last = std::move(parts_.back());
  parts_.pop_back();
  return last;
}

/// Joins the last two parts. A chain of operations with the same precedence is extended, so a long
/// sum is not a deep tree. Parentheses around the first operands change nothing: (a + b) + c is a +
/// b + c.
void Gathering::join(Operation operation) {
  const auto is_sum = [](Operation o) { return o == Operation::add || o == Operation::subtract; };
  Syntax last = pop();
  const bool goes_on = parts_.back().kind == Syntax::Kind::chain &&
                       is_sum(parts_.back().operations.back()) == is_sum(operation);
  if (!goes_on) {
    Syntax first = pop();
    push(Syntax::Kind::chain, first.column, {});
    parts_.back().parts.push_back(std::move(first));
  }
  parts_.back().operations.push_back(operation);
  parts_.back().parts.push_back(std::move(last));
}

void Gathering::add_subscript() {
  Syntax subscript = pop();
  parts_.back().parts.push_back(std::move(subscript));
}

void Gathering::raise_to_power() {
  Syntax exponent = pop();
  Syntax base = pop();
  push(Syntax::Kind::power, base.column, {});
  parts_.back().parts.push_back(std::move(base));
  parts_.back().parts.push_back(std::move(exponent));
}

void Gathering::open(char character, std::size_t column) {
  open_brackets_.push_back({character, column});
  if (nesting() > max_nesting) {
    fail(column, "nested too deeply", {}, fmt::format("at most {} levels", max_nesting));
  }
}

void Gathering::begin_call(std::string function, std::size_t column) {
  calls_.push_back({.function = std::move(function),
                    .column = column,
                    .first_argument = parts_.size(),
                    .index = {}});
}

void Gathering::begin_index(std::string name, std::size_t column) {
  calls_.back().index = std::move(name);
  calls_.back().index_column = column;
}

bool Gathering::may_have_read_index() const {
  const OpenCall& call = calls_.back();
  const Syntax& last = parts_.back();
  return call.index.empty() && parts_.size() == call.first_argument + 1 &&
         last.kind == Syntax::Kind::name && last.parts.empty();
}

void Gathering::end_call(Syntax::Kind kind) {
  OpenCall call = std::move(calls_.back());
  calls_.pop_back();
  const auto first = parts_.begin() + static_cast<long>(call.first_argument);
  std::vector<Syntax> arguments(std::make_move_iterator(first),
                                std::make_move_iterator(parts_.end()));
  parts_.erase(first, parts_.end());
  if (kind == Syntax::Kind::call && !call.index.empty()) kind = Syntax::Kind::reduction;
  push(kind, call.column, std::move(call.function));
  parts_.back().parts = std::move(arguments);
  parts_.back().index = std::move(call.index);
  parts_.back().index_column = call.index_column;
}

void Gathering::end_signs(std::size_t column) {
  Syntax operand = pop();
  push(negative_signs_.back() ? Syntax::Kind::negation : Syntax::Kind::identity, column, {});
  parts_.back().parts.push_back(std::move(operand));
  negative_signs_.pop_back();
}

Syntax Gathering::finish() {
  MIXCMP_CHECK(parts_.size() == 1);
  return pop();
}

namespace rules {

using namespace pegtl;

// Rules have the names of a grammar.
// NOLINTBEGIN(readability-identifier-naming)
struct gap : star<space> {};
struct identifier_letter : ranges<'a', 'z', 'A', 'Z', '0', '9', '_'> {};
struct identifier : seq<ranges<'a', 'z', 'A', 'Z', '_'>, star<identifier_letter>> {};

// The points of "0..3" do not belong to a number.
struct point : seq<one<'.'>, not_at<one<'.'>>> {};
template <class Digit>
struct mantissa : sor<seq<plus<Digit>, opt<point, star<Digit>>>, seq<one<'.'>, plus<Digit>>> {};
template <char... Letter>
struct scale : opt<one<Letter...>, opt<one<'+', '-'>>, plus<digit>> {};
struct number : sor<seq<one<'0'>, one<'x', 'X'>, mantissa<xdigit>, scale<'p', 'P'>>,
                    seq<mantissa<digit>, scale<'e', 'E'>>> {};

struct expression;
struct open : one<'('> {};
struct close : one<')'> {};
struct close_call : one<')'> {};
struct group : if_must<open, gap, expression, close> {};

struct function_name : seq<identifier, at<gap, one<'('>>> {};
struct index_name : seq<identifier, at<plus<space>, string<'i', 'n'>, not_at<identifier_letter>>> {
};
struct dots : string<'.', '.'> {};
struct comma : one<','> {};
struct index_range
    : if_must<index_name, gap, string<'i', 'n'>, gap, expression, dots, gap, expression> {};
struct indexed_term : if_must<index_range, comma, gap, expression> {};
struct argument_list : seq<must<expression>, star<if_must<one<','>, gap, expression>>> {};
struct arguments : sor<at<one<')'>>, indexed_term, argument_list> {};
struct call : if_must<function_name, gap, open, gap, arguments, close_call> {};

struct open_bracket : one<'['> {};
struct close_bracket : one<']'> {};
struct subscript : if_must<open_bracket, gap, expression, close_bracket> {};
struct variable_name : identifier {};
struct variable : seq<variable_name, star<gap, subscript>> {};

template <char Quote>
struct quoted_text : seq<one<Quote>, until<one<Quote>>> {};
struct text : sor<quoted_text<'"'>, quoted_text<'\''>> {};

struct primary : sor<group, number, text, call, variable> {};
struct exponent_signs : plus<one<'-'>, gap> {};
struct negative_exponent : if_must<exponent_signs, primary> {};
struct exponent : sor<negative_exponent, primary> {};
struct power : if_must<one<'^'>, gap, exponent, gap> {};
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
struct whole_range : must<gap, index_range, eof> {};
// NOLINTEND(readability-identifier-naming)

constexpr std::string_view operand = "a number, a name, a function call, '(' or '-'";

template <class Rule>
constexpr std::string_view accepted = operand;
template <>
constexpr std::string_view accepted<close> = "an operator or ')'";
template <>
constexpr std::string_view accepted<close_call> = "an operator, ',' or ')'";
template <>
constexpr std::string_view accepted<close_bracket> = "an operator or ']'";
template <>
constexpr std::string_view accepted<dots> = "an operator or '..' and the last value of the index";
template <>
constexpr std::string_view accepted<comma> = "an operator or ',' and the term";
template <>
constexpr std::string_view accepted<index_range> = "an index and its values: k in 0..3";
template <>
constexpr std::string_view accepted<eof> = "an operator + - * / or the end";

}  // namespace rules

std::string quoted(char c) {
  const bool printable = ' ' <= c && c <= '~';
  return printable ? fmt::format("'{}'", c)
                   : fmt::format("byte 0x{:02x}", static_cast<unsigned char>(c));
}

template <class Input>
std::size_t column_of(const Input& in) {
  return in.position().byte + 1;
}

template <class Rule>
struct Control : pegtl::normal<Rule> {
  template <class Input>
  [[noreturn]] static void raise(const Input& in, Gathering& gathering) {
    const std::string received = in.empty() ? "the end" : quoted(in.peek_char());
    std::string message = in.empty() ? "unexpected end" : "unexpected character";
    std::string accepted(rules::accepted<Rule>);
    if constexpr (std::is_same_v<Rule, rules::index_range>) {
      fail(column_of(in), "no index and its values",
           in.empty() ? "the end" : in_quotes(std::string(in.current(), in.end())), accepted);
    }
    if constexpr (std::is_same_v<Rule, rules::close> || std::is_same_v<Rule, rules::close_call> ||
                  std::is_same_v<Rule, rules::close_bracket>) {
      const OpenBracket& open = gathering.open_bracket();
      message = fmt::format("the '{}' at character {} of the text is not closed", open.character,
                            open.column);
    }
    if constexpr (std::is_same_v<Rule, rules::close_call>) {
      if (!in.empty() && gathering.may_have_read_index()) {
        message = "unexpected character";
        accepted = "\"in\" after an index (k in 0..3), " + accepted;
      }
    }
    fail(column_of(in), message, received, accepted);
  }
};

template <class Rule>
struct Action : pegtl::nothing<Rule> {};

template <Syntax::Kind kind>
struct Push {
  template <class Input>
  static void apply(const Input& in, Gathering& gathering) {
    gathering.push(kind, column_of(in), in.string());
  }
};
template <>
struct Action<rules::text> {
  template <class Input>
  static void apply(const Input& in, Gathering& gathering) {
    const std::string quoted = in.string();
    gathering.push(Syntax::Kind::text, column_of(in), quoted.substr(1, quoted.size() - 2));
  }
};
template <>
struct Action<rules::number> : Push<Syntax::Kind::number> {};
template <>
struct Action<rules::variable_name> : Push<Syntax::Kind::name> {};

template <Operation operation>
struct Join {
  static void apply0(Gathering& gathering) { gathering.join(operation); }
};
template <>
struct Action<rules::addition> : Join<Operation::add> {};
template <>
struct Action<rules::subtraction> : Join<Operation::subtract> {};
template <>
struct Action<rules::multiplication> : Join<Operation::multiply> {};
template <>
struct Action<rules::division> : Join<Operation::divide> {};

template <>
struct Action<rules::power> {
  static void apply0(Gathering& gathering) { gathering.raise_to_power(); }
};
template <>
struct Action<rules::subscript> {
  static void apply0(Gathering& gathering) { gathering.add_subscript(); }
};

struct Open {
  template <class Input>
  static void apply(const Input& in, Gathering& gathering) {
    gathering.open(in.peek_char(), column_of(in));
  }
};
template <>
struct Action<rules::open> : Open {};
template <>
struct Action<rules::open_bracket> : Open {};

struct Close {
  static void apply0(Gathering& gathering) { gathering.close(); }
};
template <>
struct Action<rules::close> : Close {};
template <>
struct Action<rules::close_call> : Close {};
template <>
struct Action<rules::close_bracket> : Close {};

template <>
struct Action<rules::group> {
  template <class Input>
  static void apply(const Input& in, Gathering& gathering) {
    gathering.set_column(column_of(in));
  }
};
struct BeginSigns {
  template <class Input>
  static void apply(const Input& in, Gathering& gathering) {
    const std::string signs = in.string();
    gathering.begin_signs(std::count(signs.begin(), signs.end(), '-') % 2 != 0);
  }
};
template <>
struct Action<rules::minus_signs> : BeginSigns {};
template <>
struct Action<rules::exponent_signs> : BeginSigns {};

struct EndSigns {
  template <class Input>
  static void apply(const Input& in, Gathering& gathering) {
    gathering.end_signs(column_of(in));
  }
};
template <>
struct Action<rules::negation> : EndSigns {};
template <>
struct Action<rules::negative_exponent> : EndSigns {};
template <>
struct Action<rules::function_name> {
  template <class Input>
  static void apply(const Input& in, Gathering& gathering) {
    gathering.begin_call(in.string(), column_of(in));
  }
};
template <>
struct Action<rules::index_name> {
  template <class Input>
  static void apply(const Input& in, Gathering& gathering) {
    gathering.begin_index(in.string(), column_of(in));
  }
};
template <>
struct Action<rules::call> {
  static void apply0(Gathering& gathering) { gathering.end_call(Syntax::Kind::call); }
};

template <class Rule>
Result<Gathering> gather(const std::string& text, Gathering gathering) {
  pegtl::memory_input in(text, "");
  try {
    pegtl::parse<Rule, Action, Control>(in, gathering);
    return gathering;
  } catch (Failure& failure) {
    return std::move(failure.error);
  }
}

}  // namespace

Result<Syntax> parse_syntax(const std::string& text, std::size_t outer_nesting) {
  MIXCMP_TRY(gathering, gather<rules::whole>(text, Gathering(outer_nesting)));
  return gathering.finish();
}

Result<Syntax> parse_range_syntax(const std::string& text) {
  Gathering gathering(0);
  gathering.begin_call({}, 1);
  MIXCMP_TRY(gathered, gather<rules::whole_range>(text, std::move(gathering)));
  gathered.end_call(Syntax::Kind::range);
  return gathered.finish();
}

}  // namespace mixcmp::inline expression
