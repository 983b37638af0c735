#include "generator/synthesis/components/shortlist.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "model/base/common/check.hpp"
#include "model/cost/estimated/cost_model.hpp"
#include "model/design/design.hpp"
#include "model/design/slots.hpp"
#include "model/plan/optimise/crossover.hpp"
#include "model/plan/optimise/exact_lanes.hpp"

namespace mixcmp::components {
namespace {

using scene::Multipliers;

/// A kind of lane is left out if its best lane takes more than this factor times the best of all.
constexpr double margin = 1.25;
/// Seconds of Yosys for one component: at the start, and for each LUT of the rough area. Three
/// lanes of 598 to 1004 LUTs took 4.5 to 6.9 s on a machine that was not idle.
constexpr double seconds_to_begin = 2;
constexpr double seconds_per_lut = 0.005;

/// The part of a datapath that the estimate of LUTs leaves out.
estimated::Products products_of(Multipliers multipliers) {
  switch (multipliers) {
    case Multipliers::embedded: return estimated::Products::left_out;
    case Multipliers::logic: return estimated::Products::in_luts;
    case Multipliers::memory: return estimated::Products::squares_in_memory;
  }
  MIXCMP_CHECK(false);
}

/// The area of any datapath in the cost model. The memories of squares are not included.
template <class Datapath>
devices::Area rough_area(double (*luts)(const Datapath&, estimated::Products),
                         const Datapath& datapath, Multipliers multipliers,
                         const devices::MultiplierSize& size) {
  const bool embedded = multipliers == Multipliers::embedded;
  return {.luts = static_cast<int>(std::lround(luts(datapath, products_of(multipliers)))),
          .dsps = embedded ? estimated::embedded_multipliers(datapath, size) : 0};
}

/// The bits of a request for recomputation.
int request_bits(const scene::Scene& scene) {
  const bool carried = scene.system.operands == scene::OperandStore::carried;
  return (carried ? total_width(scene.operand_formats) : 0) + scene.system.tag_bits;
}

/// Lanes that are measured together: those of a pairwise engine's segment.
int lanes_at_once(const scene::Scene& scene) {
  const scene::EngineSpec& engine = scene.system.engine;
  return engine.kind == scene::EngineKind::pairwise ? engine.lanes_per_group : 1;
}

/// The rough area of the streams around one lane: its share of those of a group, or of a segment of
/// a pairwise engine. A LUT of memory keeps one bit of each of 64 comparisons.
devices::Area rough_streams(const scene::Scene& scene, int slots) {
  if (scene.system.engine.kind == scene::EngineKind::pairwise) return {.luts = 30};
  const bool in_blocks = scene.system.operand_memory == scene::OperandMemory::block;
  const int bits = in_blocks ? scene.system.tag_bits : request_bits(scene);
  return {.luts = (100 + bits * std::max(slots, 64) / 64) / scene.system.lanes_per_group};
}

/// The rough area of one lane's share of a crossbar. A LUT chooses between bits of two requests.
devices::Area rough_crossbar(const scene::Scene& scene, int ports) {
  return {.luts = 100 + request_bits(scene) * ports / 2};
}

class Shortlister {
public:
  Shortlister(ComponentMaker& maker, const ComponentQuery& query, const devices::Device& device,
              const optimise::Rates& rates)
      : maker_(maker), query_(query), device_(device), rates_(rates) {}

  Result<Shortlist> run() {
    weigh_shared_parts();
    MIXCMP_DO(weigh_second_tier());
    MIXCMP_TRY(keys, lanes_of(maker_.scene(), query_));
    for (const measured::Lane& key : keys) {
      MIXCMP_DO(weigh(key));
    }
    choose();
    return std::move(result_);
  }

private:
  struct Kind {
    Bound bound;
    std::optional<LaneInputs> inputs;
    friend auto operator<=>(const Kind&, const Kind&) = default;
  };
  struct Candidate {
    LaneEstimate estimate;
    double seconds;  ///< to map the lane
  };

  static double seconds_for(const devices::Area& area) {
    return seconds_to_begin + seconds_per_lut * area.luts;
  }

  void weigh_shared_parts() {
    const scene::Scene& scene = maker_.scene();
    const design::ReferenceDatapath reference = design::datapath_or_model(scene);
    for (const Multipliers multipliers : reference_multipliers(query_)) {
      const devices::Area area = rough_area(estimated::reference_luts, reference, multipliers,
                                            device_.delays.multiplier_size);
      reference_share_ =
          std::min(reference_share_, optimise::device_share(area, device_.available));
      result_.seconds += seconds_for(area);
    }
    for (const int ports : query_.crossbars)
      result_.seconds += seconds_for(rough_crossbar(scene, ports));
  }

  devices::Area area_of(const design::Lane& lane, Multipliers multipliers) const {
    const devices::MultiplierSize& size = device_.delays.multiplier_size;
    devices::Area area = std::visit(
        [&](const auto& made) { return rough_area(estimated::lane_luts, made, multipliers, size); },
        lane);
    if (multipliers == Multipliers::memory) {
      area.memories =
          estimated::memory_blocks(std::get<fixed::FixedLane>(lane), device_.delays.memory_block);
    }
    return area;
  }

  /// A lane of the second tier decides what lanes leave undecided; without one a reference does.
  Result<Done> weigh_second_tier() {
    share_of_next_ = reference_share_;
    MIXCMP_TRY(tier, design::design_second_tier(maker_.scene()));
    if (!tier) return Done{};
    const devices::Area area =
        area_of(tier->lane, tier->multipliers) + rough_streams(maker_.scene(), 0);
    share_of_next_ = std::min(share_of_next_, optimise::device_share(area, device_.available));
    return Done{};
  }

  std::optional<double> rate_of(const measured::Lane& key, int precision) const {
    if (optimise::is_exact(maker_.scene(), key)) return 0;
    const LaneInputs inputs = key.inputs.value_or(LaneInputs::exact);
    const auto rate = rates_.find({inputs, key.bound, precision});
    return rate ? std::optional(rate->value()) : std::nullopt;
  }

  /// A lane that does not exist is no candidate; the measurement gives the reason.
  Result<Done> weigh(const measured::Lane& key) {
    const std::optional<double> rate = rate_of(key, key.format.precision());
    if (!rate) return Done{};
    const Result<design::Lane> lane = maker_.lane(key);
    if (!lane.ok()) return Done{};
    MIXCMP_TRY(component, maker_.make(key));
    const devices::Area area = area_of(*lane, key.multipliers.value_or(Multipliers::embedded));
    const bool recomputes = *rate > 0 && maker_.scene().system.references.value_or(1) > 0;
    const int slots = design::slots_for(
        component.latency_cycles + maker_.scene().system.input_registers, recomputes);
    // Nothing waits beside a lane that decides everything.
    const devices::Area streams =
        *rate > 0 ? rough_streams(maker_.scene(), slots) : devices::Area{};
    const devices::Area all = area + streams;
    const double share = optimise::device_share(all, device_.available) + *rate * share_of_next_;
    const LaneEstimate estimate{key, key.format.precision(), area, *rate, share};
    const double seconds = seconds_for(lanes_at_once(maker_.scene()) * area);
    candidates_[{key.bound, key.inputs}].push_back({estimate, seconds});
    ++result_.candidates;
    return Done{};
  }

  static const LaneEstimate& best(const std::vector<Candidate>& kind) {
    return std::min_element(kind.begin(), kind.end(),
                            [](const Candidate& a, const Candidate& b) {
                              return a.estimate.share < b.estimate.share;
                            })
        ->estimate;
  }

  void choose() {
    for (const auto& [kind, all] : candidates_) result_.best.push_back(best(all));
    std::stable_sort(
        result_.best.begin(), result_.best.end(),
        [](const LaneEstimate& a, const LaneEstimate& b) { return a.share < b.share; });
    for (const auto& [kind, all] : candidates_) {
      if (best(all).share > margin * result_.best.front().share) continue;
      for (const Candidate& candidate : all) {
        if (std::abs(candidate.estimate.precision - best(all).precision) > 1) continue;
        result_.lanes.insert(candidate.estimate.key);
        result_.seconds += candidate.seconds;
      }
    }
    result_.reference_share = reference_share_;
  }

  ComponentMaker& maker_;
  const ComponentQuery& query_;
  const devices::Device& device_;
  const optimise::Rates& rates_;
  double reference_share_ = std::numeric_limits<double>::infinity();
  double share_of_next_ = 0;  ///< of the datapath that gets undecided comparisons
  std::map<Kind, std::vector<Candidate>> candidates_;
  Shortlist result_;
};

}  // namespace

Result<Shortlist> shortlist(ComponentMaker& maker, const ComponentQuery& query,
                            const devices::Device& device, const optimise::Rates& rates) {
  return Shortlister(maker, query, device, rates).run();
}

}  // namespace mixcmp::components
