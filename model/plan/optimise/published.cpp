#include "model/plan/optimise/published.hpp"

#include <algorithm>
#include <array>

namespace mixcmp::optimise {
namespace {

constexpr std::array<PublishedFigures, 2> devices = {{
    {.device = "virtex5-lx330t",
     .technology_nm = 65,
     .reference_luts = 17198,
     .reference_dsps = 0,
     .reference_mhz = 223,
     .communication_luts = 4790,
     .baseline_references = 9,
     .baseline_per_s = 2e9,
     .lanes_worst = 24,
     .lanes_best = 32,
     .references_worst = 1,
     .references_best = 1,
     .lane_mhz_low = 199,
     .lane_mhz_high = 337,
     .worst_per_s = 8.17e9,
     .best_per_s = 10.6e9,
     .gain_worst = 4.09,
     .gain_best = 5.29,
     .speedup_baseline = 4.08,
     .speedup_worst = 16.7,
     .speedup_best = 21.6,
     .cpu = "Intel Core 2 6420",
     .cpu_cores = 2,
     .cpu_core_per_s = 0.24e9,
     .cpu_per_s = 0.49e9},
    {.device = "virtex6-lx760",
     .technology_nm = 40,
     .reference_luts = 7350,
     .reference_dsps = 40,
     .reference_mhz = 285,
     .communication_luts = 11440,
     .baseline_references = 17,
     .baseline_per_s = 4.8e9,
     .lanes_worst = 87,
     .lanes_best = 108,
     .references_worst = 3,
     .references_best = 1,
     .lane_mhz_low = 285,
     .lane_mhz_high = 408,
     .worst_per_s = 35.5e9,
     .best_per_s = 41.3e9,
     .gain_worst = 7.37,
     .gain_best = 8.61,
     .speedup_baseline = 2.09,
     .speedup_worst = 15.4,
     .speedup_best = 18,
     .cpu = "Intel Xeon E5420",
     .cpu_cores = 8,
     .cpu_core_per_s = 0.29e9,
     .cpu_per_s = 2.3e9},
}};

}  // namespace

double PublishedFigures::lane_mhz() const {
  const double worst = worst_per_s / lanes_worst / 1e6;
  const double best = best_per_s / lanes_best / 1e6;
  return std::min({worst, best, lane_mhz_high});
}

std::optional<PublishedFigures> published(std::string_view device) {
  for (const PublishedFigures& known : devices) {
    if (device == known.device) return known;
  }
  return std::nullopt;
}

}  // namespace mixcmp::optimise
