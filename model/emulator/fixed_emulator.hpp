#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "model/emulator/emulator.hpp"
#include "model/emulator/fixed_code.hpp"

namespace mixcmp::emulator {

/// Evaluates a lane in fixed point on batches of comparisons with SIMD operations in double, bit
/// for bit as golden::evaluate_lane. Lanes with integers of more than 53 bits fall back to the
/// golden model. Thread-safe: scratch memory belongs to the call.
class FixedEmulator {
public:
  explicit FixedEmulator(fixed::FixedLane lane);

  /// Operands as for Emulator.
  void decide(OperandColumns operands, std::size_t count, std::span<Decision> decisions) const;

  /// Whether double holds every integer.
  bool is_exact_in_double() const { return code_.has_value(); }
  /// Whether each input can be converted by itself beforehand. Double must hold every integer, and
  /// in block floating point the unit depends on all operands.
  bool can_convert_beforehand() const { return code_ && !code_->least_block_exponent; }
  /// Converts `count` operands of one input as the lane does; a NaN replaces one that it does not
  /// take. Operands that the lane does not read stay unchanged.
  void convert(int input, std::span<const double> operands, std::span<double> converted) const;
  /// Decides on converted operands.
  void decide_converted(OperandColumns converted, std::size_t count,
                        std::span<Decision> decisions) const;

  /// Comparisons that fell back to the golden model since construction.
  std::uint64_t fallbacks() const { return fallbacks_->load(std::memory_order_relaxed); }

private:
  Decision golden_decision(OperandColumns operands, std::size_t index) const;

  fixed::FixedLane lane_;
  std::optional<FixedCode> code_;
  std::unique_ptr<std::atomic<std::uint64_t>> fallbacks_;  ///< so that emulators can be moved
};

}  // namespace mixcmp::emulator
