#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/hardware/rtl/module.hpp"
#include "generator/hardware/rtl/net_names.hpp"

namespace mixcmp::rtl {

/// Bits of a net.
struct BitRange {
  int low;
  int width;
};

/// Consumes the bits of a net that nothing reads. The net has `bits` bits, and `read` are read.
void consume_unread(const std::string& name, int bits, const std::vector<BitRange>& read,
                    std::vector<ModuleItem>& items);

/// Consumes the bits that nothing reads of delayed values and of the nets `read_in_part`, whose
/// widths it gives. A delay line takes a whole value, and the units behind it may read only some of
/// its bits.
void consume_unread_bits(std::vector<ModuleItem>& items,
                         const std::map<std::string, int>& read_in_part, NamePool& pool);

}  // namespace mixcmp::rtl
