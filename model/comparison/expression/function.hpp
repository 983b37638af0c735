#pragma once

#include <array>
#include <string_view>

namespace mixcmp::inline expression {

/// Functions of one argument, by their names in C.
enum class Function { exp, exp2, expm1, log, log2, log1p, sin, cos, tan, atan, sinh, cosh, tanh };

inline constexpr std::array all_functions = {
    Function::exp,   Function::exp2, Function::expm1, Function::log, Function::log2,
    Function::log1p, Function::sin,  Function::cos,   Function::tan, Function::atan,
    Function::sinh,  Function::cosh, Function::tanh};

std::string_view to_string(Function function);

}  // namespace mixcmp::inline expression
