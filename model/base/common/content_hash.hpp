#pragma once

#include <string>
#include <string_view>

#include "model/base/common/bits.hpp"

namespace mixcmp::inline common {

/// 128-bit FNV-1a over a sequence of texts. It identifies contents and is not cryptographic.
class ContentHash {
public:
  /// Texts are told apart: "ab", "c" and "a", "bc" differ.
  ContentHash& add(std::string_view text) {
    add_bytes(std::to_string(text.size()) + ":");
    add_bytes(text);
    return *this;
  }

  std::string hex() const { return to_hex(state_, 128); }

private:
  void add_bytes(std::string_view text) {
    constexpr Bits prime = (Bits{1} << 88) + 0x13b;
    for (const char c : text) state_ = (state_ ^ static_cast<unsigned char>(c)) * prime;
  }

  Bits state_ = (Bits{0x6c62272e07bb0142u} << 64) + 0x62b821756295c58du;
};

}  // namespace mixcmp::inline common
