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
/// format must fit a double. Thread-safe.
class ExpectedWords {
public:
  ExpectedWords(const design::Design& design, const data::Comparisons& comparisons);

  /// Whether the emulator computes lanes of the design's group number `group` itself; others it
  /// leaves to the golden model.
  bool emulates(std::size_t group) const;
  /// The answers of a lane of group `group` to these comparisons.
  std::vector<ResultWord> find(std::size_t group, std::span<const std::uint64_t> indices) const;

private:
  using LaneEmulator = std::variant<emulator::Emulator, emulator::FixedEmulator>;
  struct Batch;

  void find_batch(const LaneEmulator& lane, Batch& batch, std::span<ResultWord> words) const;
  void recompute(Batch& batch, std::span<ResultWord> words) const;

  data::OperandSource source_;
  std::vector<LaneEmulator> lanes_;  ///< one a group
  std::optional<emulator::Emulator> reference_;
};

}  // namespace mixcmp::verilator_tb
