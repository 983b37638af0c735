#pragma once

#include <string>
#include <vector>

#include "model/cost/estimated/cost_model.hpp"
#include "model/plan/profile/profile.hpp"

namespace mixcmp::profile {

/// The wrong verdicts and the area of one scheme at one precision.
struct TradePoint {
  std::string scheme;
  SchemeKind kind = SchemeKind::certified;
  int precision = 0;
  double wrong_per_million = 0;
  double rate = 0;
  double lane_luts = 0;
  bool measured = false;  ///< false: lane_luts is from the cost model
  /// Comparisons per cycle from 1000 LUTs, which include the lane's share of a reference: 1000 /
  /// (lane + rate (1 + R_S) reference).
  double per_kiloluts = 0;
};

struct Trade {
  LaneInputs inputs = LaneInputs::exact;
  double slack = 0;  ///< R_S
  double reference_luts = 0;
  bool reference_measured = false;
  double reference_wrong_per_million = 0;
  /// Comparisons per million whose truth is undetermined. No point's wrong_per_million includes
  /// them; `cheapest` adds them.
  double undetermined_per_million = 0;
  std::vector<TradePoint> points;  ///< ordered by scheme, then by precision
};

/// Makes a point of every lane that exists. `rates` must have been counted with the constants of
/// `errors`.
Trade make_trade(const scene::Scene& scene, const RateProfile& rates, const ErrorProfile& errors,
                 const estimated::MeasuredAreas& areas);

/// The point with the most comparisons per LUT among those with at most `accepted_per_million`
/// wrong verdicts per million, where each undetermined truth counts as one. For 0 only certified
/// schemes qualify. Null if no point qualifies.
const TradePoint* cheapest(const Trade& trade, double accepted_per_million);

}  // namespace mixcmp::profile
