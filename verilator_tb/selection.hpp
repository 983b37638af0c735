#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "generator/hardware/emit/signature.hpp"
#include "model/base/number/operand_format.hpp"
#include "model/comparison/data/comparisons.hpp"

namespace mixcmp::verilator_tb {

enum class Sampling {
  first,   ///< the first `limit` comparisons
  random,  ///< one from each of `limit` equal strata: spread over all, without repetition
};

/// The comparisons of a scene that a run takes. Positions 0 .. size() - 1 map to rising indices, so
/// results in order of position are also in order of index.
class Selection {
public:
  struct Options {
    std::uint64_t limit = 0;  ///< 0: all
    std::uint64_t start = 0;  ///< of Sampling::first: the index of the first one
    Sampling sampling = Sampling::first;
    std::uint64_t seed = 1;
    std::optional<std::uint64_t> only;  ///< only this comparison
  };

  Selection(std::uint64_t available, const Options& options);

  std::uint64_t size() const { return size_; }
  std::uint64_t index(std::uint64_t position) const;

  /// The `count` positions from `first` on, as 0 .. count - 1.
  Selection part(std::uint64_t first, std::uint64_t count) const;

private:
  std::uint64_t stratum_start(std::uint64_t position) const;

  std::uint64_t available_;
  Options options_;
  std::uint64_t whole_size_;  ///< of the selection that this is a part of
  std::uint64_t first_ = 0;   ///< position of the first one there
  std::uint64_t size_;
};

/// Packs operands side by side into `tdata`, the first lowest, each in its format; they are given
/// in `encoding`. The bits above are padding; all are set to `padding`, so that a system that reads
/// them is detected.
void pack_operands(std::span<const Bits> operands, FloatFormat encoding,
                   std::span<const OperandFormat> formats, bool padding,
                   std::span<std::uint8_t> tdata);

/// The operands of positions first .. first + count - 1 as a simulator takes them.
std::vector<std::uint8_t> stimulus(const data::Comparisons& comparisons, const Selection& selection,
                                   const emit::Signature& signature, std::uint64_t first,
                                   std::uint64_t count);

}  // namespace mixcmp::verilator_tb
