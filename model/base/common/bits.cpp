#include "model/base/common/bits.hpp"

namespace mixcmp::inline common {

std::string to_hex(Bits bits, int width) {
  std::string text;
  for (int shift = (width - 1) / 4 * 4; shift >= 0; shift -= 4) {
    text += "0123456789abcdef"[static_cast<int>(bits >> shift) & 15];
  }
  return text;
}

}  // namespace mixcmp::inline common
