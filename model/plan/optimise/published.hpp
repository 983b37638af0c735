#pragma once

#include <optional>
#include <string_view>

namespace mixcmp::optimise {

/// The paper's results for one of its two devices, from Tables III and IV and section V.
struct PublishedFigures {
  const char* device;  ///< our name of it
  int technology_nm;
  // Table III, and C_lut(com).
  int reference_luts;
  int reference_dsps;
  double reference_mhz;
  int communication_luts;
  // Table IV.
  int baseline_references;
  double baseline_per_s;
  int lanes_worst, lanes_best;
  int references_worst, references_best;
  double lane_mhz_low, lane_mhz_high;                    ///< "clock frequency"
  double worst_per_s, best_per_s;                        ///< scenario II; the best of scenario I
  double gain_worst, gain_best;                          ///< "mixed precision gain", as printed
  double speedup_baseline, speedup_worst, speedup_best;  ///< "normalised speedup", as printed
  const char* cpu;
  int cpu_cores;
  double cpu_core_per_s, cpu_per_s;

  /// A clock that the lanes of both published systems reach: the lower of T(equ) / p_L of scenarios
  /// I and II, at most the highest clock printed.
  double lane_mhz() const;
};

std::optional<PublishedFigures> published(std::string_view device);

}  // namespace mixcmp::optimise
