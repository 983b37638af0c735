#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/emulator/code.hpp"

namespace mixcmp::emulator {

/// One pass of the code over `count` comparisons, a block at a time, with the scratch memory for
/// it.
class Execution {
public:
  enum class Scope {
    values,    ///< f and g
    decision,  ///< bounds, too
  };
  /// `operands` has one array of `count` doubles per input.
  Execution(const Code& code, std::span<const double* const> operands, std::size_t count,
            Scope scope);

  /// Computes the next block; false after the last.
  bool next();

  /// The block's first comparison, its number of comparisons, and their columns, which are filled
  /// up to whole vectors with copies of the first.
  std::size_t first() const { return first_; }
  std::size_t size() const { return size_; }
  const Block& block() const { return block_; }
  /// Whether double cannot be trusted with comparison k of this block.
  bool doubtful(std::size_t k) const { return any_doubt_ && (doubts_[k] >> 63) != 0; }
  bool any_doubt() const { return any_doubt_; }

private:
  void point_to_operands();
  double* scratch_column(int index);

  const Code& code_;
  std::span<const double* const> operands_;
  std::size_t count_;
  Scope scope_;
  std::size_t block_size_;
  std::unique_ptr<double[]> memory_;
  double* scratch_;
  std::vector<const double*> columns_;
  std::vector<double*> results_;
  Block block_{};
  std::size_t first_ = 0, size_ = 0;
  bool any_doubt_ = false;
  std::array<std::uint64_t, max_block_size> doubts_;
};

}  // namespace mixcmp::emulator
