#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
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

  /// undecided / comparisons. If none of n comparisons was undecided, it is 3 / n, at most 1. The
  /// true rate is below 3 / n with 95 % confidence (rule of three), and no plan should rely on a
  /// lower one.
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

  /// Raises each rate, and the share of each verdict, to the larger of the two, for scenario II.
  /// What only one of the two has is used unchanged.
  void raise_to(const Rates& other);

  /// The rates on data of which the part `of_other`, in [0, 1], is the other data. What only one of
  /// the two has is left out.
  Rates mixed_with(const Rates& other, double of_other) const;

  /// The part of the comparisons, 0..1, whose verdict is one of these. None if it was not counted:
  /// figure5.csv does not have it.
  std::optional<double> share_of(VerdictSet verdicts) const;

  /// Lanes in fixed point have one rate for all kinds of inputs.
  std::optional<Rate> find(const RateKey& key) const;
  /// From the file's row of the reference, if it has one.
  const std::optional<Origin>& origin() const { return origin_; }
  bool empty() const { return rates_.empty(); }
  std::vector<RateKey> keys() const;

private:
  using VerdictShares = std::array<double, all_verdicts.size()>;

  std::map<RateKey, Rate> rates_;
  std::optional<VerdictShares> verdicts_;
  std::optional<Origin> origin_;
};

}  // namespace mixcmp::optimise
