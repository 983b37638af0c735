#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/base/number/verdict.hpp"
#include "model/lane/error/lane.hpp"
#include "model/lane/fixed/reference_datapath.hpp"

namespace mixcmp::emulator {

/// Operands of a batch: one array of doubles per input, each a number of the reference format.
/// Every NaN stands for the format's quiet NaN. Fastest are arrays aligned to 64 bytes, and batches
/// of at least some hundred comparisons.
using OperandColumns = std::span<const double* const>;

/// Evaluates lanes and references on batches of comparisons with SIMD operations in double,
/// bit-exact with the golden model. `decide` equals evaluate_lane, or evaluate_reference if made
/// from a reference; `compute` equals evaluate. docs/emulator.md proves it.
///
/// If double cannot be trusted (a result that may be out of range, a NaN), the comparison falls
/// back to the golden model by itself. Some lanes always do: those with a precision above 53, more
/// than 11 exponent bits, or integers of more than 125 bits. Lanes with integers of 54 to 125 bits
/// are slow, since they are computed one comparison after the other. Results do not depend on how
/// comparisons are split into batches. Thread-safe: all members are const, scratch memory belongs
/// to the call.
class Emulator {
public:
  explicit Emulator(const error::Lane& lane);
  explicit Emulator(fixed::FixedLane lane);
  /// A reference datapath: never undecided. Its graph may have up to 53 digits.
  explicit Emulator(const TypedGraph& reference);
  explicit Emulator(const fixed::ReferenceDatapath& reference);
  ~Emulator();
  Emulator(Emulator&&) noexcept;
  Emulator& operator=(Emulator&&) noexcept;

  void decide(OperandColumns operands, std::size_t count, std::span<Decision> decisions) const;

  /// Decides as the lane would without its error bound: by the order of the computed f and g
  /// (unordered for a NaN). Not for lanes in fixed point.
  void compare(OperandColumns operands, std::size_t count, std::span<Decision> decisions) const;

  /// Computes f and g as doubles (the nearest ones if the format has more digits or exponents), and
  /// whether any operation was exceptional. The comparison must have only one part. Not for lanes
  /// in fixed point.
  void compute(OperandColumns operands, std::size_t count, std::span<double> f, std::span<double> g,
               std::span<std::uint8_t> exceptional) const;

  /// False if a part is left to the golden model in every comparison.
  bool is_emulated() const;
  /// Comparisons that fell back to the golden model since construction.
  std::uint64_t fallbacks() const;

  /// The instruction set that run-time dispatch chose, "AVX2".
  static const char* instruction_set();

private:
  class Program;
  class FloatProgram;
  class FixedProgram;
  template <class Answer>
  void combine(OperandColumns operands, std::span<Decision> decisions, Answer answer) const;

  Combination combination_ = Combination::all;
  std::vector<std::unique_ptr<const Program>> parts_;
};

}  // namespace mixcmp::emulator
