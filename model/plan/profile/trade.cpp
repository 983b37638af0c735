#include "model/plan/profile/trade.hpp"

#include "model/design/design.hpp"
#include "model/plan/profile/schemes.hpp"

namespace mixcmp::profile {
namespace {

double per_million(std::uint64_t count, const RateProfile& rates) {
  return 1e6 * static_cast<double>(count) / static_cast<double>(rates.comparisons);
}

TradePoint make_point(const RateProfile& rates, const SchemeProfile& scheme,
                      const SchemeCounts& counts) {
  TradePoint point{.scheme = scheme.name, .kind = scheme.kind};
  point.wrong_per_million = per_million(counts.wrong, rates);
  point.rate = static_cast<double>(counts.undecided) / static_cast<double>(rates.comparisons);
  return point;
}

/// The counts of these lanes; null if the profile left them out.
const SchemeProfile* find(const RateProfile& rates, const SchemeLanes& lanes) {
  for (const SchemeProfile& scheme : rates.schemes) {
    if (scheme.name == lanes.name) return &scheme;
  }
  return nullptr;
}

double rough_luts(const design::Lane& lane) {
  return std::visit([](const auto& made) { return estimated::lane_luts(made); }, lane);
}

void price(const Trade& trade, const design::Lane& lane, const estimated::MeasuredAreas& areas,
           TradePoint& point) {
  const std::optional<double> measured = areas.of(point.scheme, point.precision);
  point.measured = measured.has_value();
  point.lane_luts = measured ? *measured : rough_luts(lane);
  const double share = point.rate * (1 + trade.slack);
  point.per_kiloluts = 1000 / (point.lane_luts + share * trade.reference_luts);
}

bool qualifies(const TradePoint& point, double undetermined_per_million,
               double accepted_per_million) {
  const bool proven = point.kind == SchemeKind::certified;
  return (proven || accepted_per_million > 0) &&
         point.wrong_per_million + undetermined_per_million <= accepted_per_million;
}

}  // namespace

Trade make_trade(const scene::Scene& scene, const RateProfile& rates, const ErrorProfile& errors,
                 const estimated::MeasuredAreas& areas) {
  const design::ReferenceDatapath reference = design::datapath_or_model(scene);
  Trade trade{.inputs = rates.inputs,
              .slack = scene.system.slack,
              .reference_luts = areas.reference().value_or(estimated::reference_luts(reference)),
              .reference_measured = areas.reference().has_value(),
              .reference_wrong_per_million = per_million(rates.reference_wrong, rates),
              .undetermined_per_million = per_million(rates.undetermined, rates),
              .points = {}};
  for (const SchemeLanes& scheme : make_schemes(scene, errors)) {
    const SchemeProfile* counted = find(rates, scheme);
    for (std::size_t k = 0; counted != nullptr && k < scheme.lanes.size(); ++k) {
      if (!scheme.lanes[k]) continue;
      TradePoint point = make_point(rates, *counted, counted->counts[k]);
      point.precision = rates.first_precision + static_cast<int>(k);
      price(trade, *scheme.lanes[k], areas, point);
      trade.points.push_back(std::move(point));
    }
  }
  return trade;
}

const TradePoint* cheapest(const Trade& trade, double accepted_per_million) {
  const TradePoint* best = nullptr;
  for (const TradePoint& point : trade.points) {
    if (!qualifies(point, trade.undetermined_per_million, accepted_per_million)) continue;
    if (best == nullptr || point.per_kiloluts > best->per_kiloluts) best = &point;
  }
  return best;
}

}  // namespace mixcmp::profile
