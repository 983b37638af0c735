#include "model/plan/optimise/plan_set.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/plan/optimise/unbeaten.hpp"

namespace mixcmp::optimise {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// A choice counts as better if it is so by this factor: rounding is no gain.
constexpr double worth_counting = 1 - 1e-12;

using Seconds = std::vector<double>;  // by data set

double total(const Seconds& seconds) {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

Seconds faster_of(Seconds a, const Seconds& b) {
  for (std::size_t s = 0; s < a.size(); ++s) a[s] = std::min(a[s], b[s]);
  return a;
}

/// The seconds that a plan saves; infinite if it serves a set that was not served.
double gain_of(const Seconds& seconds, const Seconds& plan) {
  double gain = 0;
  for (std::size_t s = 0; s < seconds.size(); ++s) {
    if (plan[s] < seconds[s]) gain += seconds[s] - plan[s];
  }
  return gain;
}

/// The plans that are not at least as slow as another one on every set.
std::vector<std::size_t> useful_plans(const PlanSeconds& plans) {
  return unbeaten(plans.size(), [&](std::size_t a, std::size_t b) {
    for (std::size_t s = 0; s < plans[a].size(); ++s) {
      if (plans[a][s] > plans[b][s]) return false;
    }
    return a < b || plans[a] != plans[b];
  });
}

class Search {
public:
  Search(const PlanSeconds& plans, PlanChoice known) : plans_(plans), best_(std::move(known)) {}

  PlanChoice run(int most) {
    extend(useful_plans(plans_), Seconds(plans_.front().size(), infinite), most);
    return best_;
  }

private:
  /// Tries all choices of at most `left` of these plans beside the chosen ones, which take
  /// `seconds`.
  void extend(const std::vector<std::size_t>& plans, const Seconds& seconds, int left) {
    if (!chosen_.empty()) note(seconds);
    if (left == 0) return;
    std::vector<std::pair<double, std::size_t>> gains;
    for (const std::size_t plan : plans) gains.emplace_back(gain_of(seconds, plans_[plan]), plan);
    std::stable_sort(gains.begin(), gains.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    for (std::size_t k = 0; k < gains.size(); ++k) {
      double most_gained = 0;
      for (std::size_t j = k; j < gains.size() && j < k + static_cast<std::size_t>(left); ++j) {
        most_gained += gains[j].first;
      }
      const double bound = total(seconds) - most_gained;  // NaN, thus no bound, for infinite ones
      if (bound >= best_.seconds * worth_counting) return;
      std::vector<std::size_t> others;
      for (std::size_t j = k + 1; j < gains.size(); ++j) others.push_back(gains[j].second);
      chosen_.push_back(gains[k].second);
      extend(others, faster_of(seconds, plans_[gains[k].second]), left - 1);
      chosen_.pop_back();
    }
  }

  void note(const Seconds& seconds) {
    if (total(seconds) < best_.seconds * worth_counting) best_ = {chosen_, total(seconds)};
  }

  const PlanSeconds& plans_;
  std::vector<std::size_t> chosen_;
  PlanChoice best_;
};

void check(const PlanSeconds& plans, int most) {
  MIXCMP_CHECK(!plans.empty() && most >= 1);
  for (const Seconds& each : plans) MIXCMP_CHECK(each.size() == plans.front().size());
}

/// The plans in the order in which each is best by itself.
void sort_plans(PlanChoice& choice, const PlanSeconds& plans) {
  std::sort(choice.plans.begin(), choice.plans.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(total(plans[a]), a) < std::pair(total(plans[b]), b);
  });
}

}  // namespace

std::vector<PlanChoice> choose_plans(const PlanSeconds& plans, int most) {
  check(plans, most);
  std::vector<PlanChoice> choices;
  PlanChoice best{.plans = {}, .seconds = infinite};
  for (int k = 1; k <= most; ++k) {
    best = Search(plans, std::move(best)).run(k);
    sort_plans(best, plans);
    choices.push_back(best);
  }
  return choices;
}

std::vector<PlanChoice> choose_plans_exhaustively(const PlanSeconds& plans, int most) {
  check(plans, most);
  std::vector<PlanChoice> choices;
  PlanChoice best{.plans = {}, .seconds = infinite};
  for (int k = 1; k <= most; ++k) {
    for (std::uint64_t subset = 1; subset < std::uint64_t{1} << plans.size(); ++subset) {
      PlanChoice choice;
      Seconds seconds(plans.front().size(), infinite);
      for (std::size_t plan = 0; plan < plans.size(); ++plan) {
        if ((subset >> plan & 1) == 0) continue;
        choice.plans.push_back(plan);
        seconds = faster_of(seconds, plans[plan]);
      }
      choice.seconds = total(seconds);
      if (choice.plans.size() > static_cast<std::size_t>(k)) continue;
      if (choice.seconds < best.seconds * worth_counting) best = choice;
    }
    sort_plans(best, plans);
    choices.push_back(best);
  }
  return choices;
}

}  // namespace mixcmp::optimise
