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

/// How the devices are listed to a user who has written the unknown name `received`: first the
/// device that the vendor calls so ("xc7a200t-2fbg676"), the device of the same family if there is
/// one, or the one with the nearest name, and why.
std::string list_for(std::string_view received, std::span<const NamedPart> parts);

}  // namespace mixcmp::devices
