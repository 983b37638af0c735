#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/data/comparisons.hpp"
#include "model/error/certified_lane.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::model {

/// One way to build and run a lane, at one precision, on all the data.
struct SystemCounts {
  std::string system;           ///< "certified relative", "profiled", "lanes alone", ...
  int precision = 0;            ///< L
  std::uint64_t undecided = 0;  ///< recomputed; recomputation rate = undecided / comparisons
  /// Verdicts that differ from the order of the real numbers f and g of the operands.
  std::uint64_t wrong = 0;
};

/// Figure 5 and its truth: every system at every precision, against exact arithmetic.
struct RateProfile {
  std::uint64_t comparisons = 0;
  std::uint64_t reference_wrong = 0;  ///< of the reference datapath alone
  std::vector<SystemCounts> counts;
};

/// Figure 4: measured and proven relative error of f and g at one precision.
struct ErrorAtPrecision {
  int precision = 0;
  LaneInputs inputs = LaneInputs::exact;
  double f = 0, g = 0;                     ///< measured maximum of |f_L - f_T| / |f_T|
  std::optional<double> f_bound, g_bound;  ///< certified; none where no relative bound exists
};

struct ProfileOptions {
  int first_precision = 4, last_precision = 52;
  std::uint64_t error_samples = 1'000'000;
  int threads = 0;  ///< 0: as many as the machine has; results do not depend on it
};

std::vector<ErrorAtPrecision> profile_errors(const Scene& scene, const Comparisons& data,
                                             const ProfileOptions& options);
RateProfile profile_rates(const Scene& scene, const Comparisons& data,
                          const ProfileOptions& options);

}  // namespace mixcmp::model
