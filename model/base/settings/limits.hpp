#pragma once

#include <algorithm>
#include <string>

#include "model/base/number/float_format.hpp"
#include "model/base/number/lane_format.hpp"

namespace mixcmp::settings {

/// The whole numbers `least`..`most`, both included, that a user may give for a quantity.
struct Limits {
  int least;
  int most;

  constexpr bool allow(int value) const { return least <= value && value <= most; }
};

/// "4..52", the form of limits in messages, helps and documentation.
std::string to_string(Limits limits);

/// Limits of a scene's numbers. All checks and messages use these, and a test compares
/// docs/scene_file.md with them.
namespace limits {

inline constexpr Limits lane_precision{4, 52};  ///< L; and at most the reference's precision
inline constexpr Limits fixed_bits{2, 48};      ///< W, at most the reference's with guard digits
inline constexpr Limits reference_precision{11, FloatFormat::max_precision};
inline constexpr Limits exponent_bits{FloatFormat::min_exponent_bits,
                                      FloatFormat::max_exponent_bits};
inline constexpr Limits bound_digits{1, 8};     ///< of a running bound; 1: only exponents
inline constexpr Limits lanes{1, 512};          ///< p_L, in all groups together
inline constexpr Limits engine_lanes{1, 4096};  ///< p_L of a pairwise engine, in all groups
inline constexpr Limits references{0, 16};      ///< p_H, in all groups; a group has at least 1
inline constexpr Limits initiation_interval{1, 64};
inline constexpr Limits target_mhz{1, 2000};
inline constexpr Limits input_registers{0, 2};
inline constexpr Limits request_beats{1, 16};  ///< powers of two
inline constexpr Limits tag_bits{1, 64};
inline constexpr Limits counter_bits{8, 64};        ///< or 0: no counters
inline constexpr Limits read_counter_bits{16, 64};  ///< of counters on an AXI4-Lite port
inline constexpr Limits engine_capacity{2, 65'536};
inline constexpr Limits lanes_per_group{1, 64};
inline constexpr Limits report_streams{1, 64};
inline constexpr Limits items{1, 1 << 24};  ///< rows of generated data
inline constexpr Limits threads{1, 1024};   ///< threads, and tools that run at a time
inline constexpr Limits seeds{1, 1000};     ///< router seeds

/// p_L of a system whose lanes take streams in groups of this size: as many groups as there may be
/// single lanes, but no more lanes than a pairwise engine has.
constexpr Limits lanes_in_groups(int group) {
  return {lanes.least, std::min(lanes.most * group, engine_lanes.most)};
}

}  // namespace limits

/// The precisions of a lane with a reference of this format.
Limits lane_precisions(FloatFormat reference);
/// The bits W of a fixed-point lane with a reference of this format.
Limits lane_fixed_bits(FloatFormat reference);
/// Whether the limits allow W, and W with the guard digits.
bool allow(Limits lane_fixed_bits, const FixedPoint& format);

}  // namespace mixcmp::settings
