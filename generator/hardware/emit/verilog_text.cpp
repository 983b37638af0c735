#include "generator/hardware/emit/verilog_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "model/base/common/check.hpp"

namespace mixcmp::emit {
namespace {

constexpr std::array<Token, 9> long_operators = {
    ">>>", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||"};

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$' || c == '\'';
}

/// The token that a text begins with. The text must not begin with a blank or a comment.
Token first_token(std::string_view text) {
  if (is_word(text.front())) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_word);
    return text.substr(0, static_cast<std::size_t>(end - text.begin()));
  }
  for (const Token token : long_operators) {
    if (text.starts_with(token)) return text.substr(0, token.size());
  }
  return text.substr(0, 1);
}

bool opens(Token token) {
  return token == "(" || token == "[" || token == "{";
}

bool closes(Token token) {
  return token == ")" || token == "]" || token == "}";
}

}  // namespace

Tokens tokens_of(std::string_view text, Token last) {
  Tokens tokens;
  while (!text.empty() && (last.empty() || tokens.empty() || tokens.back() != last)) {
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

Token Cursor::take() {
  MIXCMP_CHECK(!at_end());
  return tokens_[at_++];
}

bool Cursor::take_if(Token wanted) {
  const bool found = peek() == wanted;
  if (found) ++at_;
  return found;
}

void Cursor::expect(Token wanted) {
  MIXCMP_CHECK(take_if(wanted));
}

Tokens Cursor::take_until(std::initializer_list<Token> ends) {
  Tokens taken;
  for (int depth = 0;;) {
    const Token next = peek();
    if (depth == 0 && std::find(ends.begin(), ends.end(), next) != ends.end()) return taken;
    if (opens(next)) ++depth;
    if (closes(next)) --depth;
    taken.push_back(take());
  }
}

Tokens Cursor::take_bracketed() {
  MIXCMP_CHECK(opens(peek()));
  take();
  Tokens inside = take_until({")", "]", "}"});
  take();
  return inside;
}

}  // namespace mixcmp::emit
