#pragma once

#include <string>
#include <string_view>

namespace mixcmp::inline expression {

/// The rule for names of scenes, inputs and lets, which become Verilog identifiers: a letter or
/// '_', then letters, digits and '_', at most 64, no Verilog or SystemVerilog keyword and no word
/// that a simulator takes for its own.
constexpr std::size_t max_name_length = 64;

/// What breaks the rule, in words; empty if nothing does.
std::string name_problem(std::string_view name);

/// As name_problem, for a name of any length, such as one that the generator makes of several.
std::string identifier_problem(std::string_view name);

/// What an error about a name says is accepted.
std::string_view accepted_names();

/// A name with subscripts as Verilog spells it: p_2 for p[2], p_* for the pattern p[*].
std::string name_spelling(std::string name);

/// What is wrong with the brackets of a key like "p[2]" or the pattern "p[*]", in words; empty if
/// nothing is.
std::string subscript_problem(std::string_view key);

/// What an error about such a key says is accepted.
std::string_view accepted_subscripts();

}  // namespace mixcmp::inline expression
