#include "model/plan/optimise/throughput_bound.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <vector>

#include "model/cost/performance/performance.hpp"
#include "model/plan/optimise/feasibility.hpp"

namespace mixcmp::optimise {
namespace {

constexpr std::size_t resources = std::size(devices::bounded_resources);
constexpr double infinity = std::numeric_limits<double>::infinity();
/// Prices of all resources are multiples of 1 / price_steps, and their sum is 1.
constexpr int price_steps = 10;
/// Plans may exceed equation 10 by their allowance for rounding.
constexpr double rounding = 1 + 1e-9;

/// A part of the room for each resource.
using Parts = std::array<double, resources>;

double cost_of(const Parts& parts, const Parts& prices) {
  double cost = 0;
  for (std::size_t r = 0; r < resources; ++r) cost += parts[r] * prices[r];
  return cost;
}

/// The kinds of a problem by what one comparison per second takes of the room.
class Relaxation {
public:
  explicit Relaxation(const AllocationProblem& problem) : problem_(problem) {
    room_ = amounts_of(performance::usable(problem.available, problem.slack));
    const Amounts fixed = amounts_of(problem.communication.fixed);
    for (std::size_t r = 0; r < resources; ++r) room_[r] -= fixed[r];
    for (const ReferenceKind& kind : problem.references) {
      if (problem.max_references == 0 || !fits(kind.area)) continue;
      references_.push_back({part_of(kind.area, 1), throughput_per_s(kind)});
      fastest_reference_ = std::max(fastest_reference_, throughput_per_s(kind));
    }
    needs_reference_ =
        std::none_of(problem.lanes.begin(), problem.lanes.end(),
                     [](const LaneKind& lane) { return lane.recomputation_rate == 0; });
    const devices::Area port = least_port();
    for (const LaneKind& kind : problem.lanes) {
      const bool is_served = kind.recomputation_rate == 0 || !references_.empty();
      if (is_served && fits(kind.area)) add(kind, port);
    }
  }

  double bound() const {
    if (lanes_.empty()) return 0;
    const double least = std::min(problem_.max_lanes * fastest_lane_, most_served_);
    Parts best{};
    double priced = infinity;
    for_each_price([&](const Parts& prices) {
      if (const double bound = bound_at(prices); bound < priced) {
        priced = bound;
        best = prices;
      }
    });
    refine(best, priced);
    return std::min(least, priced) * rounding;
  }

private:
  struct Lane {
    Parts parts;
    double recomputation_rate;
  };
  struct Reference {
    Parts parts;  ///< of one, whatever its throughput
    double per_s;
  };

  bool fits(const devices::Area& area) const {
    const Amounts amounts = amounts_of(area);
    return std::equal(amounts.begin(), amounts.end(), room_.begin(), std::less_equal<>());
  }

  /// What each comparison per second takes of the room, if this area makes so many. A resource
  /// without room is not used by anything that fits.
  Parts part_of(const devices::Area& area, double per_s) const {
    const Amounts amounts = amounts_of(area);
    Parts parts{};
    for (std::size_t r = 0; r < resources; ++r) {
      if (room_[r] > 0) {
        parts[r] = static_cast<double>(amounts[r]) / static_cast<double>(room_[r]) / per_s;
      }
    }
    return parts;
  }

  /// The least area of a crossbar's port; nothing if a plan may do without a crossbar.
  devices::Area least_port() const {
    const std::vector<devices::Area>& shares = problem_.communication.crossbar;
    devices::Area least;
    if (!needs_reference_ || shares.size() < 2) return least;
    for (const devices::Resource& resource : devices::bounded_resources) {
      int& amount = least.*resource.amount;
      amount = shares[1].*resource.amount;
      for (std::size_t k = 2; k < shares.size(); ++k) {
        amount = std::min(amount, shares[k].*resource.amount / static_cast<int>(k));
      }
    }
    return least;
  }

  void add(const LaneKind& kind, const devices::Area& port) {
    const double per_s = throughput_per_s(kind);
    const int ports = kind.group / lanes_per_port(problem_);
    lanes_.push_back(
        {part_of(kind.area + ports * port, kind.group * per_s), kind.recomputation_rate});
    fastest_lane_ = std::max(fastest_lane_, per_s);
    const double served =
        kind.recomputation_rate == 0
            ? infinity
            : problem_.max_references * fastest_reference_ / kind.recomputation_rate;
    most_served_ = std::max(most_served_, served);
  }

  double bound_at(const Parts& prices) const {
    double one_reference = infinity, reference_per_s = infinity;
    for (const Reference& reference : references_) {
      const double cost = cost_of(reference.parts, prices);
      one_reference = std::min(one_reference, cost);
      reference_per_s = std::min(reference_per_s, cost / reference.per_s);
    }
    double least_lane = infinity, least = infinity;
    for (const Lane& lane : lanes_) {
      const double cost = cost_of(lane.parts, prices);
      const double rate = lane.recomputation_rate;
      least_lane = std::min(least_lane, cost);
      least = std::min(least, rate > 0 ? cost + rate * reference_per_s : cost);
    }
    const double room = needs_reference_ ? std::max(0.0, 1 - one_reference) : 1;
    return std::min(quotient(1, least), quotient(room, least_lane));
  }

  /// Shifts prices from one resource to another while that lowers the bound, in ever smaller steps.
  void refine(Parts& prices, double& bound) const {
    constexpr double finest = 0.001;
    for (double step = 0.5 / price_steps; step > finest; step /= 2) {
      while (shift_one(prices, bound, step)) {
      }
    }
  }

  bool shift_one(Parts& prices, double& bound, double step) const {
    for (std::size_t from = 0; from < resources; ++from) {
      for (std::size_t to = 0; to < resources; ++to) {
        if (from == to || prices[from] < step) continue;
        Parts shifted = prices;
        shifted[from] -= step;
        shifted[to] += step;
        const double lower = bound_at(shifted);
        if (lower >= bound) continue;
        prices = shifted;
        bound = lower;
        return true;
      }
    }
    return false;
  }

  static double quotient(double room, double cost) { return cost > 0 ? room / cost : infinity; }

  template <class Use>
  static void for_each_price(const Use& use) {
    static_assert(resources == 4);
    const auto price = [](int steps) { return double(steps) / price_steps; };
    for (int a = 0; a <= price_steps; ++a) {
      for (int b = 0; a + b <= price_steps; ++b) {
        for (int c = 0; a + b + c <= price_steps; ++c) {
          use({price(a), price(b), price(c), price(price_steps - a - b - c)});
        }
      }
    }
  }

  const AllocationProblem& problem_;
  Amounts room_{};
  std::vector<Reference> references_;
  std::vector<Lane> lanes_;
  bool needs_reference_ = false;  ///< each lane may ask for one
  double fastest_reference_ = 0;
  double fastest_lane_ = 0;
  double most_served_ = 0;
};

}  // namespace

double throughput_bound(const AllocationProblem& problem) {
  return Relaxation(problem).bound();
}

}  // namespace mixcmp::optimise
