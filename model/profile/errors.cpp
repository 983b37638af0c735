#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "model/error/error_analysis.hpp"
#include "model/profile/error_worker.hpp"
#include "model/profile/systems.hpp"

namespace mixcmp::model {
namespace {

/// |1/t - 1| for every t of the bound, as a double above.
std::optional<double> relative_to_truth(const std::optional<RelativeBound>& bound) {
  if (!bound) return std::nullopt;
  const mpq_class above = 1 / bound->low - 1, below = 1 - 1 / bound->high;
  const double largest = std::max(above, below).get_d();
  return std::nextafter(largest, std::numeric_limits<double>::infinity());
}

void add_bounds(const Scene& scene, const TypedGraph& graph, ErrorAtPrecision& error,
                ErrorProfile& profile) {
  const ErrorAnalysis analysis = analyse_errors(graph, scene.nonnegative_inputs());
  const NodeBound &f = analysis.nodes[graph.f], &g = analysis.nodes[graph.g];
  error.f_bound = relative_to_truth(f.relative);
  error.g_bound = relative_to_truth(g.relative);
  profile.no_f_bound = f.relative ? "" : f.reason;
  profile.no_g_bound = g.relative ? "" : g.reason;
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

std::vector<ErrorProfile> profile_errors(const Scene& scene, const Comparisons& data,
                                         const std::vector<LaneInputs>& inputs,
                                         const ProfileOptions& options) {
  const OperandSource source(data);
  const std::uint64_t seed = scene.data ? scene.data->seed : 1;
  ErrorJob job{scene, source, Permutation(data.size(), seed), {}};
  for (const LaneInputs each : inputs) {
    for (int precision = options.first_precision; precision <= options.last_precision;
         ++precision) {
      TypedGraph graph = graph_at(scene, precision, each);
      Emulator emulator(Lane{graph, UlpDistanceDecision{.guard_ulp = 0, .nonnegative = false}});
      job.lanes.push_back({std::move(graph), std::move(emulator)});
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
      const TypedGraph& graph = job.lanes[lane].graph;
      ErrorAtPrecision error{.precision = precision,
                             .f = judge_error(job, graph, tally.f[lane].sample).f,
                             .g = judge_error(job, graph, tally.g[lane].sample).g};
      add_bounds(scene, graph, error, profile);
      profile.precisions.push_back(std::move(error));
    }
  }
  return profiles;
}

}  // namespace mixcmp::model
