#include "model/plan/optimise/switching.hpp"

#include <algorithm>
#include <cstddef>

#include "model/base/common/check.hpp"

namespace mixcmp::optimise {
namespace {

/// Sorted by rate; points with the same rate become one, their mean.
std::vector<RatePoint> in_order(std::vector<RatePoint> points) {
  std::stable_sort(points.begin(), points.end(),
                   [](const RatePoint& a, const RatePoint& b) { return a.rate < b.rate; });
  std::vector<RatePoint> merged;
  for (std::size_t first = 0; first < points.size();) {
    RatePoint mean = points[first];
    std::size_t end = first + 1;
    for (; end < points.size() && points[end].rate == mean.rate; ++end) {
      for (std::size_t j = 0; j < mean.seconds.size(); ++j) {
        mean.seconds[j] += points[end].seconds[j];
      }
    }
    for (double& each : mean.seconds) each /= static_cast<double>(end - first);
    merged.push_back(std::move(mean));
    first = end;
  }
  return merged;
}

/// The part of [0, 1], from one point to the next, where `plan` is no slower than any other.
RateRange best_part(const RatePoint& from, const RatePoint& to, std::size_t plan) {
  RateRange part{0, 1};
  for (std::size_t j = 0; j < from.seconds.size(); ++j) {
    const double begin = from.seconds[plan] - from.seconds[j];
    const double end = to.seconds[plan] - to.seconds[j];
    if (begin > 0 && end > 0) return {1, 0};
    if (begin > 0) part.first = std::max(part.first, begin / (begin - end));
    if (end > 0) part.second = std::min(part.second, begin / (begin - end));
  }
  return part;
}

}  // namespace

SwitchingRule::SwitchingRule(std::vector<std::vector<RatePoint>> points,
                             double reconfiguration_seconds)
    : reconfiguration_seconds_(reconfiguration_seconds), ahead_seconds_(points.size(), 0) {
  MIXCMP_CHECK(!points.empty() && reconfiguration_seconds > 0);
  for (std::vector<RatePoint>& each : points) {
    MIXCMP_CHECK(!each.empty());
    for (const RatePoint& point : each) MIXCMP_CHECK(point.seconds.size() == points.size());
    points_.push_back(in_order(std::move(each)));
  }
}

std::vector<double> SwitchingRule::seconds_at(double rate) const {
  const std::vector<RatePoint>& points = points_[loaded_];
  std::size_t above = 0;
  while (above < points.size() && points[above].rate <= rate) ++above;
  if (above == 0) return points.front().seconds;
  if (above == points.size()) return points.back().seconds;
  const RatePoint& low = points[above - 1];
  const RatePoint& high = points[above];
  const double part = (rate - low.rate) / (high.rate - low.rate);
  std::vector<double> seconds;
  for (std::size_t j = 0; j < low.seconds.size(); ++j) {
    seconds.push_back(low.seconds[j] + part * (high.seconds[j] - low.seconds[j]));
  }
  return seconds;
}

std::size_t SwitchingRule::next(std::uint64_t comparisons, std::uint64_t recomputations) {
  if (comparisons == 0) return loaded_;
  const auto count = static_cast<double>(comparisons);
  const std::vector<double> seconds = seconds_at(static_cast<double>(recomputations) / count);
  std::size_t best = loaded_;
  for (std::size_t j = 0; j < seconds.size(); ++j) {
    const double ahead = ahead_seconds_[j] + count * (seconds[loaded_] - seconds[j]);
    ahead_seconds_[j] = std::max(0.0, ahead);
    if (ahead_seconds_[j] > ahead_seconds_[best]) best = j;
  }
  if (ahead_seconds_[best] < reconfiguration_seconds_) return loaded_;
  loaded_ = best;
  std::fill(ahead_seconds_.begin(), ahead_seconds_.end(), 0.0);
  return loaded_;
}

std::vector<RateRange> SwitchingRule::best_rates(std::size_t plan) const {
  std::vector<RatePoint> points = points_[plan];
  points.insert(points.begin(), {std::min(0.0, points.front().rate), points.front().seconds});
  points.push_back({std::max(1.0, points.back().rate), points.back().seconds});
  std::vector<RateRange> ranges;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const double low = points[k].rate, high = points[k + 1].rate;
    const auto [begin, end] = best_part(points[k], points[k + 1], plan);
    if (low == high || begin > end) continue;
    const double from = low + begin * (high - low);
    const double to = low + end * (high - low);
    if (!ranges.empty() && from <= ranges.back().second) {
      ranges.back().second = to;
    } else if (from < to) {
      ranges.emplace_back(from, to);
    }
  }
  return ranges;
}

double configuration_seconds(const devices::Device& device) {
  constexpr double bits_per_lut = 600;
  constexpr double bits_per_s = 32 * 100e6;
  return device.available.luts * bits_per_lut / bits_per_s;
}

}  // namespace mixcmp::optimise
