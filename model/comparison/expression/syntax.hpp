#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/comparison/expression/graph.hpp"

namespace mixcmp::inline expression {

/// The deepest nesting of parentheses, brackets, calls and lets. Each level takes a dozen stack
/// frames of recursive descent.
constexpr std::size_t max_nesting = 100;

/// The syntax tree of a text. Names and functions are not looked up yet, and a reduction's term
/// occurs once.
struct Syntax {
  enum class Kind {
    number,
    text,       ///< in quotes
    name,       ///< parts: the subscripts
    negation,   ///< parts: the operand
    identity,   ///< parts: the operand, after an even number of minus signs
    power,      ///< parts: the base, the exponent
    chain,      ///< parts: operands, joined from the left
    call,       ///< parts: the arguments
    reduction,  ///< parts: first and last value of the index, the term
    range,      ///< parts: first and last value of the index; always the whole text
  };

  Kind kind;
  std::size_t column;   ///< 1-based
  std::string text;     ///< a number's digits, a text without its quotes, a name, a function's name
  std::size_t nesting;  ///< levels around it, including those outside the text
  std::vector<Syntax> parts;
  std::vector<Operation> operations;  ///< operations of a chain: operations[k] joins parts[k + 1]
  std::string index;                  ///< index of a reduction or a range
  std::size_t index_column = 0;
};

/// Reads an expression; docs/scene_file.md has the grammar. `outer_nesting` levels are around it.
Result<Syntax> parse_syntax(const std::string& text, std::size_t outer_nesting);

/// Reads "k in 0..3".
Result<Syntax> parse_range_syntax(const std::string& text);

}  // namespace mixcmp::inline expression
