#pragma once

#include <set>

#include "generator/synthesis/components/component_list.hpp"
#include "model/cost/devices/device.hpp"
#include "model/plan/optimise/rates.hpp"

namespace mixcmp::components {

/// The cost of a lane by rough areas.
struct LaneEstimate {
  measured::Lane key;
  int precision = 0;
  devices::Area area;  ///< of the lane without its streams
  double rate = 0;     ///< of recomputation
  double share = 0;    ///< of the device, for one comparison: C(L) + R_R C(H)
};

/// The lanes that are worth measuring.
struct Shortlist {
  std::set<measured::Lane> lanes;
  std::vector<LaneEstimate> best;  ///< the best lane of each kind, the least share first
  double reference_share = 0;      ///< of the device, for one reference
  int candidates = 0;              ///< lanes that were considered
  double seconds = 0;              ///< rough time of one processor to map all components, for areas
};

/// Chooses among the lanes that `query` asks for before anything is synthesised. A comparison takes
/// the share C(L) + R_R C(H) of the device by equations 10 and 11 of the paper, here with rough
/// areas (estimated/cost_model.hpp) and `rates`. A kind of lane is a bound and a choice of inputs.
/// For each kind, the best L and its two neighbours are chosen, unless that best takes more than
/// 5/4 of the best of all. Lanes without a rate are left out.
Result<Shortlist> shortlist(ComponentMaker& maker, const ComponentQuery& query,
                            const devices::Device& device, const optimise::Rates& rates);

}  // namespace mixcmp::components
