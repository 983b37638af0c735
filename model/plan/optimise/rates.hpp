#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/plan/profile/profile.hpp"

namespace mixcmp::optimise {

/// The properties of a lane on which its recomputation rate R_R depends.
struct RateKey {
  LaneInputs inputs = LaneInputs::exact;
  Bound bound;
  int precision = 0;  ///< L, or W of fixed point

  friend auto operator<=>(const RateKey&, const RateKey&) = default;
};

/// A recomputation rate R_R as counted on data.
struct Rate {
  std::uint64_t undecided = 0;
  std::uint64_t comparisons = 0;
  bool is_exact = false;  ///< the lane has no error, so no comparison is ever undecided

  /// undecided / comparisons. If none of n comparisons was undecided, it is 3 / n, at most 1. The
  /// true rate is below 3 / n with 95 % confidence (rule of three), and no plan should rely on a
  /// lower one. Only an exact lane has 0.
  double value() const;
};

/// Recomputation rates of every kind of lane, by precision.
class Rates {
public:
  /// The reference and the data that rates were counted with.
  struct Origin {
    int reference_precision = 0;
    std::uint64_t comparisons = 0;
  };

  static Rates of(const std::vector<profile::RateProfile>& profiles);
  /// Reads figure5.csv as written by `mixcmp profile`. Errors name the line and the column.
  static Result<Rates> read(const std::filesystem::path& path);

  /// Raises each rate to the larger of the two, for scenario II, and takes the pairs of which more
  /// are reported. What only one of the two has is used unchanged.
  void raise_to(const Rates& other);

  /// The rates on data of which the part `of_other`, in [0, 1], is the other data. What only one of
  /// the two has is left out.
  Rates mixed_with(const Rates& other, double of_other) const;

  /// The part of the pairs, 0..1, that an engine of the scene reports. None if it was not counted:
  /// the data are no pairs, or the rates are from figure5.csv, which does not have it.
  std::optional<double> reported_share() const;
  /// Cycles for each pair in an engine of these numbers; none where reported_share has none.
  std::optional<double> cycles_per_pair(const performance::PairwiseEngine& engine) const;

  /// Takes the pairs to be those of a set of this size, of which none is reported.
  void assume_nothing_reported(const performance::ItemSet& set);

  /// Lanes in fixed point have one rate for all kinds of inputs.
  std::optional<Rate> find(const RateKey& key) const;
  /// From the file's row of the reference, if it has one.
  const std::optional<Origin>& origin() const { return origin_; }
  bool empty() const { return rates_.empty(); }
  std::vector<RateKey> keys() const;

private:
  /// Data sets of pairs, each with its part of the comparisons.
  struct PairsOfSet {
    double part;
    std::shared_ptr<const performance::PairwiseFlow> flow;
  };

  std::map<RateKey, Rate> rates_;
  std::vector<PairsOfSet> pairs_;
  std::optional<Origin> origin_;
};

}  // namespace mixcmp::optimise
