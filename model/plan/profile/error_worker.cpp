#include "model/plan/profile/error_worker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/judge/golden/evaluate.hpp"
#include "model/plan/profile/largest_relative_error.hpp"

namespace mixcmp::profile {
namespace {

/// Beyond these exponents the low part of a true value might underflow, or its high part overflow.
constexpr mpfr_exp_t lowest_exponent = -800, highest_exponent = 1000;

}  // namespace

void LargestError::raise_to(double other, std::uint64_t other_sample) {
  if (other < error || (other == error && other_sample >= sample)) return;
  error = other;
  sample = other_sample;
}

void LargestError::add(const LargestError& other) {
  raise_to(other.error, other.sample);
  unbounded += other.unbounded;
}

void ErrorTally::add(const ErrorTally& other) {
  for (std::size_t lane = 0; lane < f.size(); ++lane) {
    f[lane].add(other.f[lane]);
    g[lane].add(other.g[lane]);
  }
  comparisons += other.comparisons;
}

JudgedError judge_error(const ErrorJob& job, const ErrorLane& lane, std::uint64_t sample) {
  std::vector<Bits> operands(job.source.data().input_count());
  job.source.data().fetch(job.permutation(sample), operands);
  JudgedError largest;
  for (std::size_t k = 0; k < lane.size(); ++k) {
    const TypedGraph& graph = lane[k].graph;
    golden::TrueValues truth(job.scene.graph, job.scene.graph.parts()[k]);
    if (!truth.compute(graph.input_format, operands)) continue;
    const std::vector<golden::Rounded> computed = golden::evaluate(graph, operands);
    LargestRelativeError f(graph.arithmetic.format), g(graph.arithmetic.format);
    f.measure(computed[graph.f()].bits, truth.f());
    g.measure(computed[graph.g()].bits, truth.g());
    largest.f = std::max(largest.f, f.value());
    largest.g = std::max(largest.g, g.value());
    largest.f_unbounded |= f.unbounded() > 0;
    largest.g_unbounded |= g.unbounded() > 0;
  }
  return largest;
}

ErrorWorker::ErrorWorker(const ErrorJob& job)
    : job_(job),
      operands_(job.source.data().input_count(), block),
      scratch_(error_truth_precision),
      f_(block),
      g_(block),
      exceptional_(block),
      f_unbounded_(block),
      g_unbounded_(block) {
  tally_.f.resize(job.lanes.size());
  tally_.g.resize(job.lanes.size());
  for (const Sides& part : job.scene.graph.parts()) {
    truths_.push_back({golden::TrueValues(job.scene.graph, part), {}, {}, {}});
    for (Truth* truth : {&truths_.back().f, &truths_.back().g}) {
      for (auto* values : {&truth->high, &truth->low, &truth->scale}) values->resize(block);
    }
  }
}

void ErrorWorker::run(const BlockSource& next) {
  std::uint64_t first = 0, count = 0;
  while (next(first, count)) {
    find_truth(first, count);
    for (std::size_t lane = 0; lane < job_.lanes.size(); ++lane) measure_lane(lane, first, count);
  }
}

bool ErrorWorker::keep(Truth& truth, golden::BigFloat& scratch, const golden::BigFloat& value,
                       std::size_t k) {
  truth.high[k] = truth.low[k] = truth.scale[k] = 0;
  if (!mpfr_regular_p(value.get())) {
    truth.scale[k] = std::numeric_limits<double>::infinity();
    return true;
  }
  const mpfr_exp_t exponent = mpfr_get_exp(value.get());
  if (exponent < lowest_exponent || exponent > highest_exponent) return false;
  truth.high[k] = mpfr_get_d(value.get(), MPFR_RNDN);
  mpfr_sub_d(scratch.get(), value.get(), truth.high[k], MPFR_RNDN);
  truth.low[k] = mpfr_get_d(scratch.get(), MPFR_RNDN);
  truth.scale[k] = 1 / std::fabs(truth.high[k]);
  return true;
}

void ErrorWorker::find_truth(std::uint64_t first, std::size_t count) {
  std::vector<std::uint64_t> indices;
  std::vector<Bits> operands(job_.source.data().input_count());
  for (PartTruth& part : truths_) part.extreme.clear();
  for (std::size_t k = 0; k < count; ++k) {
    indices.push_back(job_.permutation(first + k));
    job_.source.data().fetch(indices.back(), operands);
    bool measured = false;
    for (PartTruth& part : truths_) measured |= find_truth(part, operands, first, k);
    tally_.comparisons += measured ? 1 : 0;
  }
  job_.source.fetch(indices, operands_);
}

bool ErrorWorker::find_truth(PartTruth& part, std::span<const Bits> operands, std::uint64_t first,
                             std::size_t k) {
  part.f.scale[k] = part.g.scale[k] = 0;
  const FloatFormat format = job_.source.data().format();
  if (!part.values.compute(format, operands)) return false;
  const bool f_kept = keep(part.f, scratch_, part.values.f(), k);
  const bool g_kept = keep(part.g, scratch_, part.values.g(), k);
  if (!f_kept || !g_kept) {
    part.f.scale[k] = part.g.scale[k] = 0;
    part.extreme.push_back(first + k);
  }
  return true;
}

void ErrorWorker::measure_lane(std::size_t index, std::uint64_t first, std::size_t count) {
  const ErrorLane& lane = job_.lanes[index];
  std::fill_n(f_unbounded_.begin(), count, 0);
  std::fill_n(g_unbounded_.begin(), count, 0);
  for (std::size_t k = 0; k < lane.size(); ++k) {
    const PartTruth& truth = truths_[k];
    lane[k].emulator.compute(operands_.columns(), count, f_, g_, exceptional_);
    measure(truth.f, f_, first, count, tally_.f[index], f_unbounded_);
    measure(truth.g, g_, first, count, tally_.g[index], g_unbounded_);
    for (const std::uint64_t sample : truth.extreme) {
      const JudgedError judged = judge_error(job_, lane, sample);
      tally_.f[index].raise_to(judged.f.get_d(), sample);
      tally_.g[index].raise_to(judged.g.get_d(), sample);
      f_unbounded_[sample - first] |= judged.f_unbounded;
      g_unbounded_[sample - first] |= judged.g_unbounded;
    }
  }
  const auto set = [count](const std::vector<std::uint8_t>& flags) {
    return std::accumulate(flags.begin(), flags.begin() + static_cast<std::ptrdiff_t>(count),
                           std::uint64_t{0});
  };
  tally_.f[index].unbounded += set(f_unbounded_);
  tally_.g[index].unbounded += set(g_unbounded_);
}

void ErrorWorker::measure(const Truth& truth, const std::vector<double>& computed,
                          std::uint64_t first, std::size_t count, LargestError& largest,
                          std::vector<std::uint8_t>& unbounded) {
  for (std::size_t k = 0; k < count; ++k) {
    // The first difference is exact where it is small.
    const double difference = (computed[k] - truth.high[k]) - truth.low[k];
    const double error = difference == 0 ? 0 : std::fabs(difference) * truth.scale[k];
    // An error is infinite or NaN if the computed value is, or if that misses a true zero.
    const bool is_bounded = error < std::numeric_limits<double>::infinity();
    unbounded[k] |= static_cast<std::uint8_t>(truth.scale[k] != 0 && !is_bounded);
    if (error > largest.error && is_bounded) largest.raise_to(error, first + k);
  }
}

}  // namespace mixcmp::profile
