#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/data/comparisons.hpp"
#include "model/expression/typed_graph.hpp"
#include "model/scene/bound_choice.hpp"
#include "model/scene/scene.hpp"

/// What a scene's comparisons do at every precision: figures 4 and 5 of the paper, and the truth.
/// docs/profile.md says what the numbers mean and proves that the fast way counts exactly.
namespace mixcmp::model {

/// How the counts are found; both give the same.
enum class ProfileMethod {
  envelope,     ///< comparisons that are decided, rightly, at every further precision are dropped
  brute_force,  ///< every comparison through every lane, every true verdict by MPFR
};

struct ProfileOptions {
  int first_precision = limits::lane_precision.least;
  int last_precision = limits::lane_precision.most;
  std::uint64_t error_samples = 1'000'000;  ///< for figure 4 and the profiled constants
  unsigned threads = 0;                     ///< 0: as many as the machine has
  ProfileMethod method = ProfileMethod::envelope;
  /// Called with what is being done and the share that is, 0..1; from any thread, one at a time.
  std::function<void(const std::string&, double)> progress = {};
};

/// Errors name the scene's field: a reference that double does not hold, precisions that no lane
/// can have.
Result<Done> check_profile(const Scene& scene, const ProfileOptions& options);

/// Figure 4: the relative error of f and g at one precision; of several parts the largest.
struct ErrorAtPrecision {
  int precision = 0;
  /// Measured: maximum of |f_L - f_T| / |f_T|, upward to 64 bits, f_T right to 128 digits.
  mpq_class f = 0, g = 0;
  /// Proven for every comparison; none where no relative bound exists.
  std::optional<double> f_bound, g_bound;
};

struct ErrorProfile {
  LaneInputs inputs = LaneInputs::exact;
  std::uint64_t comparisons = 0;  ///< measured: those with finite f_T and g_T of some part
  std::vector<ErrorAtPrecision> precisions;
  std::string no_f_bound, no_g_bound;  ///< why, where there is none at the last precision
};

/// One profile for each of `inputs`; the true values are computed once for all.
std::vector<ErrorProfile> profile_errors(const Scene& scene, const Comparisons& data,
                                         const std::vector<LaneInputs>& inputs,
                                         const ProfileOptions& options);

enum class SystemKind {
  lanes_alone,  ///< the order of f_L and g_L: no error bound, no recomputation
  profiled,     ///< the paper's decision with the constants of figure 4
  certified,
};

/// What one kind of system did at one precision.
struct SystemCounts {
  bool exists = false;
  std::uint64_t undecided = 0;  ///< recomputed
  /// Verdicts that differ from the order of the real numbers f and g of the operands; an undecided
  /// comparison has the reference's verdict.
  std::uint64_t wrong = 0;
  std::uint64_t wrong_by_lane = 0;  ///< of these, what a lane decided; 0 of every certified system

  friend bool operator==(const SystemCounts&, const SystemCounts&) = default;
};

struct SystemProfile {
  std::string name;                  ///< "lanes_alone", or as its bound is called
  std::optional<BoundChoice> bound;  ///< none: lanes alone
  SystemKind kind = SystemKind::certified;
  std::vector<SystemCounts> counts;  ///< one a precision
  std::string reason;                ///< why it does not exist, where it does not
};

/// Figure 5 and the wrong verdicts.
struct RateProfile {
  LaneInputs inputs = LaneInputs::exact;
  int first_precision = limits::lane_precision.least;
  std::uint64_t comparisons = 0;
  std::uint64_t reference_wrong = 0;  ///< verdicts of the reference datapath alone
  std::uint64_t true_verdicts = 0;    ///< how many it took MPFR to decide
  /// The true verdicts that stayed undetermined; nobody is called wrong there.
  std::uint64_t undetermined = 0;
  std::uint64_t emulated = 0;  ///< lane evaluations
  std::vector<SystemProfile> systems;
};

RateProfile profile_rates(const Scene& scene, const Comparisons& data, const ErrorProfile& errors,
                          const ProfileOptions& options);

}  // namespace mixcmp::model
