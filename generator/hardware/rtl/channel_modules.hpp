#pragma once

#include "generator/hardware/rtl/system_shape.hpp"

/// Channels: modules that surround one datapath of a system with its streams.
namespace mixcmp::rtl {

/// The template of the scoreboard or reorder buffer around a lane with this latency.
TemplateInstance tracker_template(const SystemShape& shape, int lane_latency_cycles);
/// The template of the streams around a reference with this schedule.
TemplateInstance reference_port_template(const SystemShape& shape,
                                         const datapath::Schedule& reference);

/// A wire between a crossbar and channels, with one field per channel. Its name is that of the
/// channel's port, with the name of the side, such as "lane" or "reference", in place of the first
/// letter.
struct Bundle {
  std::string port;
  int width;

  std::string wire(const std::string& side) const { return side + port.substr(1); }
};
/// The ports of a lane's channel, or of a group's, through which it asks.
std::vector<Bundle> asking_bundles(const SystemShape& shape);
/// The ports of a channel that the lanes of `shape` ask.
std::vector<Bundle> asked_bundles(const SystemShape& shape);

/// The streams by which each of `count` channels fetches operands again. `vector`: the ports have
/// one field per channel, padded to bytes.
void add_refetch_ports(std::vector<Port>& ports, const SystemShape& shape, int count, bool vector);

/// The counters of a channel around lanes.
const std::vector<std::string>& channel_counters();

/// A lane, or a group of lanes in lock step, with its scoreboard or reorder buffer. It takes a
/// stream of comparisons and the answers of the references; it gives a stream of results and one of
/// requests for recomputation.
Module lane_channel_module(const SystemShape& shape, const DatapathGroup& lane);

/// A lane of the second tier with its reorder buffer. Lanes ask it as they ask a reference, and it
/// asks references as a lane does. It exists only for a shape with a second tier.
Module second_tier_channel_module(const SystemShape& shape);

/// A reference datapath with the reference_port that feeds it; only for a shape that recomputes().
Module reference_channel_module(const SystemShape& shape, const DatapathGroup& reference);

}  // namespace mixcmp::rtl
