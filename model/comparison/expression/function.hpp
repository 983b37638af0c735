#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace mixcmp::inline expression {

/// Functions of one argument, by their names in C.
enum class Function { exp, exp2, expm1, log, log2, log1p, sin, cos, tan, atan, sinh, cosh, tanh };

inline constexpr std::array all_functions = {
    Function::exp,   Function::exp2, Function::expm1, Function::log, Function::log2,
    Function::log1p, Function::sin,  Function::cos,   Function::tan, Function::atan,
    Function::sinh,  Function::cosh, Function::tanh};

std::string_view to_string(Function function);

/// A function with an end has values at all numbers above it; the others have values everywhere,
/// tan except at its poles, none of which is rational. log and log2: 0. log1p: -1.
std::optional<mpq_class> open_end(Function function);
/// The arguments at which it has one, for messages: "a number above 0".
std::string accepted_arguments(Function function);

}  // namespace mixcmp::inline expression
