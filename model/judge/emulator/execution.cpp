#include "model/judge/emulator/execution.hpp"

namespace mixcmp::emulator {

Execution::Execution(const Code& code, std::span<const double* const> operands, std::size_t count,
                     Scope scope)
    : code_(code), scope_(scope), blocks_(code.layout, operands, count) {}

bool Execution::next() {
  if (!blocks_.next()) return false;
  execute(code_.values, block());
  if (scope_ == Scope::decision) execute(code_.bounds, block());
  const bool safe = code_.window && all_inside(*code_.window, block());
  any_doubt_ = !safe && find_doubts(code_.ranges, block(), doubts_.data());
  return true;
}

}  // namespace mixcmp::emulator
