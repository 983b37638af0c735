#pragma once

#include <map>

#include "model/cost/devices/device.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::datapath {

/// The sums of a lane that adders behind embedded multipliers make, each with the product that
/// joins it there: the product has one register, and the adder stands where a second one would.
/// Such a product has one reader and loses no bits. If the sum has bits below those of the product,
/// they do not go through the adder.
///
/// In (a * b + c * d) + e * f the second and the third product join. The first one's multiplier
/// hands its result to the second, and that to the third, without look-up tables. There are no such
/// sums if the device's multipliers have no adders.
std::map<NodeId, NodeId> multiplier_sums(const fixed::FixedLane& lane,
                                         const devices::DelayTable& delays);

}  // namespace mixcmp::datapath
