#include "generator/tasks/profile.hpp"

#include <fmt/core.h>

#include <utility>

#include "generator/faces/api/state.hpp"
#include "model/base/number/double.hpp"

namespace mixcmp::api {
namespace {

profile::ProfileOptions internal_options(const ProfileOptions& options, FloatFormat reference) {
  const settings::Limits possible = settings::lane_precisions(reference);
  return {.first_precision = options.first_precision.value_or(possible.least),
          .last_precision = options.last_precision.value_or(possible.most),
          .error_samples = options.error_samples,
          .threads = options.threads,
          .progress = options.progress};
}

/// Refuses numbers that no profile can have.
void check_numbers(const ProfileOptions& options) {
  constexpr std::uint64_t most_samples = std::uint64_t{1} << 40;
  if (options.error_samples > most_samples) {
    fail({.field = "error_samples",
          .message = "no number of samples",
          .received = std::to_string(options.error_samples),
          .accepted = fmt::format("0..{}", most_samples)});
  }
  const unsigned most_threads = settings::limits::threads.most;
  if (options.threads > most_threads) {
    fail({.field = "threads",
          .message = "too many",
          .received = std::to_string(options.threads),
          .accepted = fmt::format("0..{}, where 0 is one a processor", most_threads)});
  }
}

std::optional<double> as_double(const std::optional<mpq_class>& value) {
  return value ? std::optional(nearest_double(*value)) : std::nullopt;
}

RelativeErrors public_errors(const profile::ErrorAtPrecision& errors) {
  return {.precision = errors.precision,
          .f = as_double(errors.f),
          .g = as_double(errors.g),
          .f_bound = errors.f_bound,
          .g_bound = errors.g_bound};
}

Scheme public_scheme(const profile::SchemeProfile& scheme, int first_precision) {
  Scheme result{.name = scheme.name,
                .certified = scheme.kind == profile::SchemeKind::certified,
                .counts = {}};
  for (std::size_t k = 0; k < scheme.counts.size(); ++k) {
    const profile::SchemeCounts& counts = scheme.counts[k];
    if (!counts.exists) continue;
    result.counts.push_back({.precision = first_precision + static_cast<int>(k),
                             .undecided = counts.undecided,
                             .wrong = counts.wrong,
                             .wrong_by_lane = counts.wrong_by_lane});
  }
  return result;
}

}  // namespace

Profile profile(const Scene& scene, const ProfileOptions& options) {
  const SceneState& state = Access::state(scene);
  const scene::Scene& internal = state.loaded.scene;
  check_numbers(options);
  data_of(state, "a profile needs data to measure");
  const report::ProfileReport report =
      value_or_throw(tasks::measure_profile(state.loaded, {.counted = {internal.reduced.inputs}},
                                            internal_options(options, internal.reference.format)),
                     state);
  const profile::RateProfile& rates = report.rates.front();
  Profile result{.comparisons = rates.comparisons,
                 .reference_wrong = rates.reference_wrong,
                 .undetermined = rates.undetermined,
                 .errors = {},
                 .schemes = {}};
  for (const auto& each : report.errors.front().precisions) {
    result.errors.push_back(public_errors(each));
  }
  for (const profile::SchemeProfile& each : rates.schemes) {
    result.schemes.push_back(public_scheme(each, rates.first_precision));
  }
  return result;
}

}  // namespace mixcmp::api
