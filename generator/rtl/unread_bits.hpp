#pragma once

#include <string>
#include <vector>

#include "generator/rtl/module.hpp"

namespace mixcmp::rtl {

/// Bits of a net.
struct BitRange {
  int low;
  int width;
};

/// Consumes what nothing reads of a net of `bits` bits of which `read` are read.
void consume_unread(const std::string& name, int bits, const std::vector<BitRange>& read,
                    std::vector<ModuleItem>& items);

}  // namespace mixcmp::rtl
