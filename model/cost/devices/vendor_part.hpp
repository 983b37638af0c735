#pragma once

#include <span>
#include <string>
#include <string_view>

namespace mixcmp::devices {

/// A device under its own name and under its vendor's.
struct NamedPart {
  std::string name;         ///< "artix7-200t"
  std::string vendor_name;  ///< "XC7A200T"
};

/// The list of devices for a user who has written the unknown name `received`. First comes the
/// device that the vendor calls so ("xc7a200t-2fbg676"), one of the same family, or the one with
/// the nearest name, and the reason.
std::string list_for(std::string_view received, std::span<const NamedPart> parts);

}  // namespace mixcmp::devices
