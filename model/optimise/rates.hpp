#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/profile/profile.hpp"

namespace mixcmp::model {

/// A kind of lane as far as its recomputation rate R_R goes.
struct RateKey {
  LaneInputs inputs = LaneInputs::exact;
  BoundChoice bound;
  int precision = 0;  ///< L

  friend auto operator<=>(const RateKey&, const RateKey&) = default;
};

/// R_R as it was counted.
struct Rate {
  std::uint64_t undecided = 0;
  std::uint64_t comparisons = 0;

  /// undecided / comparisons. Where none of n comparisons was undecided 3 / n: with 95 % confidence
  /// the true rate is below that (the rule of three), and no plan should lean on less.
  double value() const;
};

/// Recomputation rates of every kind of lane, by precision.
class Rates {
public:
  static Rates of(const std::vector<RateProfile>& profiles);
  /// figure5.csv of `mixcmp profile`. Errors name the line and the column.
  static Result<Rates> read(const std::filesystem::path& path);

  /// The larger of each, for scenario II: what only one of the two knows stays.
  void raise_to(const Rates& other);

  std::optional<Rate> find(const RateKey& key) const;
  bool empty() const { return rates_.empty(); }
  std::vector<RateKey> keys() const;

private:
  std::map<RateKey, Rate> rates_;
};

}  // namespace mixcmp::model
