#pragma once

#include <string_view>

namespace mixcmp::emit {

/// MIXCMP_VERSION is the version of the CMake project.
inline constexpr std::string_view version = MIXCMP_VERSION;

}  // namespace mixcmp::emit
