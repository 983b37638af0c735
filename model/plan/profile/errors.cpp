#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "model/base/number/double.hpp"
#include "model/lane/error/error_analysis.hpp"
#include "model/plan/profile/error_worker.hpp"
#include "model/plan/profile/in_double.hpp"
#include "model/plan/profile/schemes.hpp"

namespace mixcmp::profile {
namespace {

/// The largest |1/t - 1| over all t in the bound, rounded up to a double; 0 if the bound is exact.
std::optional<double> relative_to_truth(const std::optional<error::RelativeBound>& bound) {
  if (!bound) return std::nullopt;
  const mpq_class above = 1 / bound->low - 1, below = 1 - 1 / bound->high;
  const mpq_class largest = std::max(above, below);
  if (largest == 0) return 0;
  return std::nextafter(largest.get_d(), std::numeric_limits<double>::infinity());
}

/// Raises `all` to the bound of one part; `all` becomes none if a part has no bound.
void add_bound(std::optional<double>& all, std::string& reason, const error::NodeBound& side) {
  const std::optional<double> bound = relative_to_truth(side.relative);
  if (!bound) reason = side.reason;
  all = bound && all ? std::optional(std::max(*all, *bound)) : std::nullopt;
}

void add_bounds(const scene::Scene& scene, const ErrorLane& lane, ErrorAtPrecision& error,
                ErrorProfile& profile) {
  error.f_bound = error.g_bound = 0;
  profile.no_f_bound = profile.no_g_bound = "";
  for (const ErrorPart& part : lane) {
    const error::ErrorAnalysis analysis =
        error::analyse_errors(part.graph, scene.nonnegative_inputs());
    add_bound(error.f_bound, profile.no_f_bound, analysis.nodes[part.graph.f()]);
    add_bound(error.g_bound, profile.no_g_bound, analysis.nodes[part.graph.g()]);
  }
}

ErrorLane lane_of(const TypedGraph& graph) {
  ErrorLane lane;
  for (std::size_t k = 0; k < graph.parts.size(); ++k) {
    TypedGraph part = part_of(graph, k).graph;
    emulator::Emulator emulator(part);
    lane.push_back({std::move(part), std::move(emulator)});
  }
  return lane;
}

ErrorTally run(const ErrorJob& job, std::uint64_t samples, const ProfileOptions& options) {
  ErrorTally total;
  total.f.resize(job.lanes.size());
  total.g.resize(job.lanes.size());
  std::mutex mutex;
  WorkSplit split{.size = samples, .block = ErrorWorker::block, .threads = options.threads};
  if (options.progress) {
    split.progress = [&](double share) { options.progress("relative errors", share); };
  }
  run_workers(split, [&](const BlockSource& next) {
    ErrorWorker worker(job);
    worker.run(next);
    const std::lock_guard lock(mutex);
    total.add(worker.tally());
  });
  return total;
}

}  // namespace

namespace {

/// The profiles of a scene that has no lanes in floating point whose errors could be measured.
std::vector<ErrorProfile> without_errors(const std::vector<LaneInputs>& inputs,
                                         const ProfileOptions& options) {
  std::vector<ErrorProfile> profiles;
  for (const LaneInputs each : inputs) {
    ErrorProfile& profile = profiles.emplace_back(ErrorProfile{.inputs = each, .precisions = {}});
    for (int precision = options.first_precision; precision <= options.last_precision;
         ++precision) {
      profile.precisions.push_back({.precision = precision});
    }
  }
  return profiles;
}

}  // namespace

std::vector<ErrorProfile> profile_errors(const scene::Scene& scene, const data::Comparisons& data,
                                         const std::vector<LaneInputs>& inputs,
                                         const ProfileOptions& options) {
  if (scene.graph.first_function()) return without_errors(inputs, options);
  if (!fits_double(scene.reference.format)) {
    const InDouble same = in_double(scene, data);
    return profile_errors(same.scene, same.data, inputs, options);
  }
  const data::OperandSource source(data);
  const std::uint64_t seed = scene.data ? scene.data->seed : 1;
  ErrorJob job{scene, source, data::Permutation(data.size(), seed), {}};
  for (const LaneInputs each : inputs) {
    for (int precision = options.first_precision; precision <= options.last_precision;
         ++precision) {
      job.lanes.push_back(lane_of(graph_at(scene, precision, each)));
    }
  }
  const ErrorTally tally = run(job, std::min(options.error_samples, data.size()), options);
  std::vector<ErrorProfile> profiles;
  std::size_t lane = 0;
  for (const LaneInputs each : inputs) {
    ErrorProfile& profile = profiles.emplace_back();
    profile.inputs = each;
    profile.comparisons = tally.comparisons;
    for (int precision = options.first_precision; precision <= options.last_precision;
         ++precision, ++lane) {
      const LargestError& f = tally.f[lane];
      const LargestError& g = tally.g[lane];
      ErrorAtPrecision error{
          .precision = precision, .f_unbounded = f.unbounded, .g_unbounded = g.unbounded};
      if (f.unbounded < tally.comparisons) {
        error.f = judge_error(job, job.lanes[lane], f.sample).f;
      }
      if (g.unbounded < tally.comparisons) {
        error.g = judge_error(job, job.lanes[lane], g.sample).g;
      }
      add_bounds(scene, job.lanes[lane], error, profile);
      profile.precisions.push_back(std::move(error));
    }
  }
  return profiles;
}

}  // namespace mixcmp::profile
