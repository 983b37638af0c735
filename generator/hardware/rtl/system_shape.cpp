#include "generator/hardware/rtl/system_shape.hpp"

#include <algorithm>
#include <bit>

namespace mixcmp::rtl {

int SystemShape::channel_bits() const {
  return std::max(1, static_cast<int>(std::bit_width(static_cast<unsigned>(channels() - 1))));
}

int SystemShape::payload_bits() const {
  return operands == scene::OperandStore::carried ? ((operand_bits() - 1) >> beat_bits) + 1
                                                  : ask_bits();
}

int SystemShape::operand_bits() const {
  return total_width(input_formats);
}

std::vector<OperandPort> SystemShape::operand_ports() const {
  std::vector<OperandPort> ports;
  int low = 0;
  for (std::size_t k = 0; k < input_ports.size(); ++k) {
    const int width = input_formats[k].width();
    ports.push_back({input_ports[k], low, width});
    low += width;
  }
  return ports;
}

int SystemShape::channel_latency_cycles() const {
  const bool merges = order == scene::ResultOrder::tagged && recomputes();
  return (merges ? 5 : 4) + input_registers;
}

SystemShape second_tier_shape(const SystemShape& shape) {
  SystemShape tier = shape;
  tier.lane_groups = {*shape.second_tier};
  tier.second_tier.reset();
  tier.lanes = shape.second_lanes();
  tier.lanes_per_group = 1;
  tier.tag_bits = shape.channel_bits() + shape.slot_bits;
  tier.slot_bits = shape.second_tier_slot_bits;
  tier.order = scene::ResultOrder::in_order;
  if (shape.refetches()) {
    tier.asking_bits = shape.ask_bits();
    tier.tag_bits += tier.asking_bits;
  } else {
    tier.input_registers = 0;  // operands come out of registers
  }
  return tier;
}

}  // namespace mixcmp::rtl
