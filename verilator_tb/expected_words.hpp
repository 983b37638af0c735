#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "model/data/operand_source.hpp"
#include "model/design/design.hpp"
#include "model/emulator/emulator.hpp"
#include "model/emulator/fixed_emulator.hpp"
#include "model/number/verdict.hpp"

namespace mixcmp::verilator_tb {

/// The words with which lanes must answer, by the emulator: a batch at a time, a hundred times as
/// fast as the golden model, with which it agrees bit for bit (docs/emulator.md). The operands'
/// format must fit a double.
class ExpectedWords {
public:
  ExpectedWords(const design::Design& design, const data::Comparisons& comparisons);

  /// Sets words[k] to the answer of a lane of the design's group number `group` to comparison
  /// indices[k].
  void find(std::size_t group, std::span<const std::uint64_t> indices, std::span<ResultWord> words);

private:
  using LaneEmulator = std::variant<emulator::Emulator, emulator::FixedEmulator>;

  void find_batch(const LaneEmulator& lane, std::span<const std::uint64_t> indices,
                  std::span<ResultWord> words);
  void recompute(std::span<ResultWord> words);

  data::OperandSource source_;
  std::vector<LaneEmulator> lanes_;  ///< one a group
  std::optional<emulator::Emulator> reference_;
  data::OperandBlock operands_;
  data::OperandBlock undecided_;        ///< those of `operands_` that the lane does not decide
  std::vector<std::size_t> positions_;  ///< in the batch, of each of `undecided_`
  std::vector<Decision> decisions_;
};

}  // namespace mixcmp::verilator_tb
