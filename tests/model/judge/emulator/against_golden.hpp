#pragma once

#include <functional>
#include <vector>

#include "model/judge/emulator/emulator.hpp"

/// Judges the emulator by the golden model, bit for bit, on every instruction set of this machine.
namespace mixcmp::test {

/// The operands of comparisons: one column per input, of encodings in the graph's input format.
using Operands = std::vector<std::vector<Bits>>;

/// The operands of comparisons as doubles.
class OperandBatch {
public:
  OperandBatch(FloatFormat format, const Operands& operands);
  std::size_t count() const { return columns_.empty() ? 0 : columns_.front().size(); }
  emulator::OperandColumns columns() const { return pointers_; }

private:
  std::vector<std::vector<double>> columns_;
  std::vector<const double*> pointers_;
};

/// Runs `test` once for each instruction set, and leaves the best one chosen.
void for_each_instruction_set(const std::function<void()>& test);

/// Compares decide, compare and compute with the golden model. One failure names the first
/// comparison that differs. Returns how many calls of the golden model the emulator made per
/// instruction set and function.
std::uint64_t expect_golden(const error::Lane& lane, const Operands& operands);
std::uint64_t expect_golden(const TypedGraph& reference, const Operands& operands);

/// Compares decide with the golden model, for all parts together.
void expect_golden_decisions(const error::Lane& lane, const Operands& operands);
void expect_golden_decisions(const TypedGraph& reference, const Operands& operands);

}  // namespace mixcmp::test
