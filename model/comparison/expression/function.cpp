#include "model/comparison/expression/function.hpp"

#include "model/base/common/check.hpp"

namespace mixcmp::inline expression {

std::string_view to_string(Function function) {
  switch (function) {
    case Function::exp: return "exp";
    case Function::exp2: return "exp2";
    case Function::expm1: return "expm1";
    case Function::log: return "log";
    case Function::log2: return "log2";
    case Function::log1p: return "log1p";
    case Function::sin: return "sin";
    case Function::cos: return "cos";
    case Function::tan: return "tan";
    case Function::atan: return "atan";
    case Function::sinh: return "sinh";
    case Function::cosh: return "cosh";
    case Function::tanh: return "tanh";
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::inline expression
