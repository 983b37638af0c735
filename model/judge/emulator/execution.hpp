#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "model/judge/emulator/code.hpp"
#include "model/judge/emulator/column_blocks.hpp"

namespace mixcmp::emulator {

/// One pass of the code over `count` comparisons, a block at a time.
class Execution {
public:
  enum class Scope {
    values,    ///< f and g
    decision,  ///< bounds as well
  };
  /// `operands` has one array of `count` doubles per input.
  Execution(const Code& code, std::span<const double* const> operands, std::size_t count,
            Scope scope);

  /// Computes the next block; false after the last.
  bool next();

  std::size_t first() const { return blocks_.first(); }
  std::size_t size() const { return blocks_.size(); }
  const Block& block() const { return blocks_.block(); }
  /// Whether double cannot be trusted for comparison k of this block.
  bool doubtful(std::size_t k) const { return any_doubt_ && (doubts_[k] >> 63) != 0; }
  bool any_doubt() const { return any_doubt_; }

private:
  const Code& code_;
  Scope scope_;
  ColumnBlocks blocks_;
  bool any_doubt_ = false;
  std::array<std::uint64_t, max_block_size> doubts_;
};

}  // namespace mixcmp::emulator
