#pragma once

#include <string_view>

namespace mixcmp::gen {

/// MIXCMP_VERSION is the version of the CMake project.
inline constexpr std::string_view version = MIXCMP_VERSION;

}  // namespace mixcmp::gen
