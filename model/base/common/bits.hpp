#pragma once

#include <string>

namespace mixcmp::inline common {

/// A packed floating-point encoding in its low bits; wide enough for binary128.
__extension__ using Bits = unsigned __int128;

/// The low `count` bits set, 0 <= count <= 128.
constexpr Bits low_mask(int count) {
  return count >= 128 ? ~Bits{0} : (Bits{1} << count) - 1;
}

/// `width` bits as ceil(width / 4) hexadecimal digits, without prefix.
std::string to_hex(Bits bits, int width);

}  // namespace mixcmp::inline common
