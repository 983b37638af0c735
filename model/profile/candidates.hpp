#pragma once

#include <cstdint>
#include <vector>

#include "model/data/operand_source.hpp"
#include "model/emulator/emulator.hpp"

namespace mixcmp::model {

/// Comparisons that some system has not settled, with all that counting needs.
class Candidates {
public:
  Candidates(std::size_t inputs, std::size_t capacity);

  std::size_t size() const { return operands_.size(); }
  std::size_t capacity() const { return operands_.capacity(); }
  const OperandBlock& operands() const { return operands_; }
  OperandBlock& operands() { return operands_; }

  /// The order of the real numbers f and g; `undecided` where it is undetermined.
  std::vector<Decision> truth;
  std::vector<Decision> reference;  ///< what the reference datapath answers
  /// Bit k: system k is still to be looked at.
  std::vector<std::uint32_t> systems;

  /// Bit k: an operand may fail a range check of system k.
  std::vector<std::uint32_t> failing;

  void append(const Candidates& from, std::size_t row, std::uint32_t systems_left);

private:
  OperandBlock operands_;
};

}  // namespace mixcmp::model
