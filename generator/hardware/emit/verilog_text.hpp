#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

namespace mixcmp::emit {

using Token = std::string_view;
using Tokens = std::vector<Token>;

/// The tokens of a template's Verilog, without comments and compiler directives; up to the first
/// `last`, if that is given.
Tokens tokens_of(std::string_view text, Token last = {});

/// Tokens, and the place of the next one to read.
class Cursor {
public:
  explicit Cursor(Tokens tokens) : tokens_(std::move(tokens)) {}

  /// The next token; empty at the end.
  Token peek() const { return at_end() ? Token() : tokens_[at_]; }
  bool at_end() const { return at_ == tokens_.size(); }
  Token take();
  bool take_if(Token wanted);
  void expect(Token wanted);

  /// The tokens up to one of `ends` that stands outside of brackets.
  Tokens take_until(std::initializer_list<Token> ends);
  /// The tokens between an opening bracket, which is next, and the one that closes it; takes both.
  Tokens take_bracketed();

private:
  Tokens tokens_;
  std::size_t at_ = 0;
};

}  // namespace mixcmp::emit
