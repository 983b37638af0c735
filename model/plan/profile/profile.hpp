#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/base/number/bound.hpp"
#include "model/base/number/verdict.hpp"
#include "model/comparison/data/comparisons.hpp"
#include "model/comparison/expression/typed_graph.hpp"
#include "model/cost/performance/pairwise_flow.hpp"
#include "model/scene/scene.hpp"

/// Errors, recomputations and wrong verdicts of a scene's comparisons at every precision: figures 4
/// and 5 of the paper, and a check against exact arithmetic. docs/choosing.md explains the
/// numbers, and docs/theory.md proves that the fast method counts exactly.
namespace mixcmp::profile {

/// How the counts are found. Both methods give the same counts.
enum class ProfileMethod {
  envelope,     ///< drops comparisons once every further precision decides them rightly
  brute_force,  ///< runs every comparison through every lane; all true verdicts by MPFR
};

struct ProfileOptions {
  int first_precision = settings::limits::lane_precision.least;
  int last_precision = settings::limits::lane_precision.most;
  /// Comparisons for figure 4 and for the profiled constants; 0: both are left out.
  std::uint64_t error_samples = 1'000'000;
  /// The bounds of the lanes that are counted. Empty: lanes of every kind, and lanes without a
  /// bound.
  std::vector<Bound> bounds = {};
  /// Rates count one random comparison from each stretch of so many consecutive ones; with 1, all.
  std::uint64_t stretch = 1;
  unsigned threads = 0;  ///< 0: as many as the machine has
  ProfileMethod method = ProfileMethod::envelope;
  /// Called with the name of the current step and its completed fraction, 0..1; from any thread,
  /// but one call at a time.
  std::function<void(const std::string&, double)> progress = {};
};

/// Rejects formats that double does not hold (unless references are exact and it holds their
/// operands), precisions that no lane can have, and profiled lanes without samples; the error names
/// the field or option.
Result<Done> check_profile(const scene::Scene& scene, const ProfileOptions& options);

/// Figure 4: the relative error of f and g at one precision; with several parts the largest.
struct ErrorAtPrecision {
  int precision = 0;
  /// Measured: the maximum of |f_L - f_T| / |f_T|, rounded up to 64 bits; f_T is correct to 128
  /// bits. None if no comparison has such an error.
  std::optional<mpq_class> f, g;
  /// Comparisons left out of f (or g): in some part f_L is not finite, or not zero although f_T is.
  std::uint64_t f_unbounded = 0, g_unbounded = 0;
  /// Proven bounds for every comparison; none if no relative bound exists.
  std::optional<double> f_bound, g_bound;
};

struct ErrorProfile {
  LaneInputs inputs = LaneInputs::exact;
  std::uint64_t comparisons = 0;  ///< measured: f_T and g_T have a value in some part
  std::vector<ErrorAtPrecision> precisions;
  std::string no_f_bound, no_g_bound;  ///< why the last precision has no bound
};

/// One profile for each of `inputs`; the true values are computed once for all.
std::vector<ErrorProfile> profile_errors(const scene::Scene& scene, const data::Comparisons& data,
                                         const std::vector<LaneInputs>& inputs,
                                         const ProfileOptions& options);

enum class SchemeKind {
  lanes_alone,  ///< the order of f_L and g_L: no error bound, no recomputation
  profiled,     ///< the paper's decision with the constants of figure 4
  certified,
};

/// The counts of one scheme at one precision.
struct SchemeCounts {
  bool exists = false;
  std::uint64_t undecided = 0;  ///< recomputed
  /// Verdicts that differ from the order of the operands' real numbers f and g. An undecided
  /// comparison has the reference's verdict.
  std::uint64_t wrong = 0;
  std::uint64_t wrong_by_lane = 0;  ///< those that a lane decided; 0 if certified

  friend bool operator==(const SchemeCounts&, const SchemeCounts&) = default;
};

struct SchemeProfile {
  std::string name;            ///< "lanes_alone", or the name of its bound
  std::optional<Bound> bound;  ///< none: lanes without a bound
  SchemeKind kind = SchemeKind::certified;
  std::vector<SchemeCounts> counts;  ///< one per precision
  std::string reason;                ///< why there is no lane at some precision

  bool exists() const;  ///< whether there is a lane at any precision
};

/// Figure 5 and the wrong verdicts.
struct RateProfile {
  LaneInputs inputs = LaneInputs::exact;
  int first_precision = settings::limits::lane_precision.least;
  std::uint64_t comparisons = 0;      ///< how many were counted: all, or a sample
  std::uint64_t reference_wrong = 0;  ///< wrong verdicts of the reference datapath itself
  std::uint64_t true_verdicts = 0;    ///< how many true verdicts MPFR had to compute
  /// Undetermined true verdicts; no verdict counts as wrong for these.
  std::uint64_t undetermined = 0;
  std::uint64_t emulated = 0;  ///< lane evaluations
  /// The pairs, with those marked whose true verdict an engine of the scene reports; null if the
  /// data are no pairs, no engine holds their items, or only a sample was counted.
  std::shared_ptr<const performance::PairwiseData> pairs = {};
  std::vector<SchemeProfile> schemes;
};

/// The sizes of the sets that a pairwise engine compares on these data; none if they are no pairs.
std::optional<performance::ItemSet> set_of(const data::Comparisons& data);

RateProfile profile_rates(const scene::Scene& scene, const data::Comparisons& data,
                          const ErrorProfile& errors, const ProfileOptions& options);

}  // namespace mixcmp::profile
