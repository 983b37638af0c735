#pragma once

#include <string>
#include <string_view>

namespace mixcmp::inline expression {

/// The rule for names of scenes, inputs and lets, which become Verilog identifiers. A name is a
/// letter or '_', then letters, digits and '_', at most 64 in all. It is no Verilog or
/// SystemVerilog keyword and no word that a simulator reserves.
constexpr std::size_t max_name_length = 64;

/// How a name breaks the rule, in words; empty if it does not.
std::string name_problem(std::string_view name);

/// As name_problem, for a name of any length, such as one that the generator builds from several.
std::string identifier_problem(std::string_view name);

/// The accepted names, for an error about a name.
std::string_view accepted_names();

/// A name with subscripts as Verilog spells it: p_2 for p[2], p_* for the pattern p[*].
std::string name_spelling(std::string name);

/// The mistake in the brackets of a key like "p[2]" or the pattern "p[*]", in words; empty if there
/// is none.
std::string subscript_problem(std::string_view key);

/// The accepted subscripts, for an error about the brackets of a key.
std::string_view accepted_subscripts();

}  // namespace mixcmp::inline expression
