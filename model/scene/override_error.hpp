#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "model/base/common/result.hpp"

namespace mixcmp::scene {

/// Reads a scene with these overrides and returns the resulting error; none: it succeeds.
using Attempt = std::function<std::optional<Error>(std::span<const std::string> overrides)>;

/// If an override caused the error, returns the error with "--set section.key" as its place, and
/// its own file and line in brackets. Overrides are added one by one to find the first that causes
/// it. An error that occurs without any override, or that already names an option, is returned
/// unchanged.
Error with_setting(Error error, std::span<const std::string> overrides, const Attempt& attempt);

}  // namespace mixcmp::scene
