#include "generator/rtl/unread_bits.hpp"

#include <algorithm>

namespace mixcmp::rtl {
namespace {

std::vector<Operand> unread(const std::string& name, int bits,
                            const std::vector<BitRange>& ranges) {
  std::vector<bool> read(static_cast<std::size_t>(bits), false);
  for (const BitRange& range : ranges) std::fill_n(read.begin() + range.low, range.width, true);
  std::vector<Operand> slices;
  for (int low = 0; low < bits;) {
    int high = low;
    while (high + 1 < bits && read[high + 1] == read[low]) ++high;
    if (!read[low]) slices.push_back(slice(name, high, low));
    low = high + 1;
  }
  return slices;
}

}  // namespace

void consume_unread(const std::string& name, int bits, const std::vector<BitRange>& read,
                    std::vector<ModuleItem>& items) {
  std::vector<Operand> unused = unread(name, bits, read);
  if (unused.empty()) return;
  unused.insert(unused.begin(), literal(1, 0));
  items.push_back(Wire{1, "unused_" + name, all_bits(concatenation(std::move(unused)))});
}

}  // namespace mixcmp::rtl
