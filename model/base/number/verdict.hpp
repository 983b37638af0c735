#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

/// The answer to one comparison, and its encoding in hardware, emulator and reports. The simulation
/// harness also includes this header, so it includes only the standard library.
namespace mixcmp::inline number {

/// The order of f and g. The values are those of the two verdict bits in hardware.
enum class Verdict {
  less = 0,
  equal = 1,
  greater = 2,
  unordered = 3,  ///< f or g has no value
};
inline constexpr std::array all_verdicts = {Verdict::less, Verdict::equal, Verdict::greater,
                                            Verdict::unordered};
std::string_view to_string(Verdict verdict);
/// "less", or "undetermined" if there is no verdict.
std::string_view to_string(const std::optional<Verdict>& truth);

/// The answer of a lane or a reference: a verdict, or "undecided". One byte each, for batches.
enum class Decision : std::uint8_t {
  less = 0,
  equal = 1,
  greater = 2,
  unordered = 3,
  undecided = 4,
};
constexpr Decision decision_of(Verdict verdict) {
  return static_cast<Decision>(verdict);
}
constexpr Decision decision_of(const std::optional<Verdict>& verdict) {
  return verdict ? decision_of(*verdict) : Decision::undecided;
}

/// A set of verdicts. Bit v of its mask stands for the verdict with the value v, as in the
/// parameter REPORT of rtl_templates/engine/pairwise_engine.v.
class VerdictSet {
public:
  constexpr VerdictSet() = default;
  constexpr VerdictSet(std::initializer_list<Verdict> verdicts) {
    for (const Verdict verdict : verdicts) insert(verdict);
  }

  constexpr void insert(Verdict verdict) { mask_ |= 1u << static_cast<unsigned>(verdict); }
  constexpr bool contains(Verdict verdict) const {
    return (mask_ >> static_cast<unsigned>(verdict) & 1u) != 0;
  }
  constexpr unsigned mask() const { return mask_; }

  friend bool operator==(const VerdictSet&, const VerdictSet&) = default;

private:
  unsigned mask_ = 0;
};

/// The answer to one comparison as hardware gives it, in m_axis_tdata of a stream and in
/// m_axis_tuser of an engine's report (docs/ports.md). Bits 1 and 0 are the verdict. Bit 2 is set
/// if a reference has recomputed it. Bit 3 is set if it stays undecided, and then the verdict bits
/// have no meaning.
class ResultWord {
public:
  explicit constexpr ResultWord(std::uint32_t bits) : bits_(bits) {}
  static constexpr ResultWord decided(Verdict verdict) {
    return ResultWord(static_cast<std::uint32_t>(verdict));
  }
  static constexpr ResultWord recomputed(Verdict verdict) {
    return ResultWord(recomputed_flag | static_cast<std::uint32_t>(verdict));
  }
  static constexpr ResultWord undecided() { return ResultWord(undecided_flag); }

  constexpr std::uint32_t bits() const { return bits_; }
  constexpr Verdict verdict() const { return static_cast<Verdict>(bits_ & verdict_mask); }
  constexpr bool is_recomputed() const { return (bits_ & recomputed_flag) != 0; }
  constexpr bool is_undecided() const { return (bits_ & undecided_flag) != 0; }
  constexpr bool is_decided_by_lane() const { return !is_recomputed() && !is_undecided(); }
  /// Whether hardware may give it: no unknown bit, and not both recomputed and undecided.
  constexpr bool is_possible() const {
    const std::uint32_t known = verdict_mask | recomputed_flag | undecided_flag;
    return (bits_ & ~known) == 0 && !(is_recomputed() && is_undecided());
  }

  friend constexpr bool operator==(ResultWord a, ResultWord b) {
    return a.meaningful_bits() == b.meaningful_bits();
  }

private:
  static constexpr std::uint32_t verdict_mask = 3;
  static constexpr std::uint32_t recomputed_flag = 4;
  static constexpr std::uint32_t undecided_flag = 8;

  constexpr std::uint32_t meaningful_bits() const {
    return is_undecided() ? bits_ & ~verdict_mask : bits_;
  }

  std::uint32_t bits_;
};

}  // namespace mixcmp::inline number
