#pragma once

#include <map>
#include <vector>

#include "generator/hardware/emit/verilog_text.hpp"

namespace mixcmp::emit {

/// The constants that a place in a module's Verilog sees: parameters, variables of generate loops,
/// and functions. A constant that is defined by an expression is computed when it is asked for.
/// Texts and outer constants must live as long.
class Constants {
public:
  explicit Constants(const Constants* outer = nullptr) : outer_(outer) {}

  void set(Token name, long long value) { values_[name] = value; }
  void define(Token name, Tokens expression) { expressions_[name] = std::move(expression); }
  /// Takes a function, from behind the word "function" to "endfunction".
  void define_function(Cursor& cursor);

  /// The value of a constant expression. Every name in it must be known.
  long long value(const Tokens& expression) const;
  long long value_of(Token name) const;
  /// Carries out "name = expression".
  void assign(const Tokens& assignment);

private:
  struct Function {
    std::vector<Token> inputs;
    Tokens body;
  };
  friend class Expression;

  const Function* find_function(Token name) const;
  long long call(Token name, const std::vector<long long>& arguments) const;
  /// Runs one statement of a function.
  void run(Cursor& cursor);
  void run(const Tokens& statement);
  void run_for(Cursor& cursor);
  void run_while(Cursor& cursor);
  void run_if(Cursor& cursor);

  const Constants* outer_;
  std::map<Token, long long> values_;
  std::map<Token, Tokens> expressions_;
  std::map<Token, Function> functions_;
};

/// The tokens of a statement, which may be a block.
Tokens take_statement(Cursor& cursor);

}  // namespace mixcmp::emit
