#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/base/number/verdict.hpp"
#include "model/comparison/data/operand_source.hpp"
#include "model/design/design.hpp"
#include "model/judge/emulator/emulator.hpp"

namespace mixcmp::verilator_tb {

/// The answers of a design's lanes and references, by the emulator: a hundred times as fast as the
/// golden model, with which it agrees bit for bit (docs/emulator.md). Thread-safe.
class AnswerEmulator {
public:
  /// Comparisons that are emulated at a time: their operands fit the second-level cache.
  static constexpr std::size_t batch_size = 2048;

  explicit AnswerEmulator(const design::Design& design);

  /// Comparisons that are emulated together, with memory for intermediate results. Only one thread
  /// may fill and use a batch.
  class Batch {
  public:
    explicit Batch(std::size_t inputs)
        : operands(inputs, batch_size), undecided_(inputs, batch_size), decisions_(batch_size) {}

    data::OperandBlock operands;

  private:
    friend class AnswerEmulator;
    data::OperandBlock undecided_;        ///< those of `operands` that the lane does not decide
    std::vector<std::size_t> positions_;  ///< [undecided]: its position in the batch
    std::vector<Decision> decisions_;
  };

  /// Whether the emulator itself computes lanes of the design's group number `group`. Other lanes
  /// are left to the golden model.
  bool emulates(std::size_t group) const;
  /// The answers of a lane of group `group` to the comparisons whose operands `batch` holds.
  void find(std::size_t group, Batch& batch, std::span<ResultWord> words) const;

private:
  /// Copies the decisions of a lane, and gathers in `batch` the comparisons that it left undecided.
  void decide(const emulator::Emulator& lane, Batch& batch, std::span<ResultWord> words) const;
  /// Asks the second tier, and keeps in `batch` only the comparisons that it also leaves undecided.
  void decide_again(Batch& batch, std::span<ResultWord> words) const;
  void recompute(Batch& batch, std::span<ResultWord> words) const;

  std::vector<emulator::Emulator> lanes_;  ///< one per group
  std::optional<emulator::Emulator> second_tier_;
  bool marks_second_tier_;
  std::optional<emulator::Emulator> reference_;
};

}  // namespace mixcmp::verilator_tb
