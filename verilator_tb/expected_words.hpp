#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/base/number/verdict.hpp"
#include "model/comparison/data/operand_source.hpp"
#include "model/design/design.hpp"
#include "verilator_tb/answer_emulator.hpp"

namespace mixcmp::verilator_tb {

/// The words with which lanes must answer to comparisons of given data, by the emulator. The
/// operands' format must fit a double. Thread-safe.
class ExpectedWords {
public:
  ExpectedWords(const design::Design& design, const data::Comparisons& comparisons)
      : source_(comparisons), emulator_(design) {}

  /// As of AnswerEmulator.
  bool emulates(std::size_t group) const { return emulator_.emulates(group); }
  /// The answers of a lane of group `group` to these comparisons.
  std::vector<ResultWord> find(std::size_t group, std::span<const std::uint64_t> indices) const;

private:
  data::OperandSource source_;
  AnswerEmulator emulator_;
};

}  // namespace mixcmp::verilator_tb
