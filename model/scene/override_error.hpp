#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "model/common/result.hpp"

namespace mixcmp::scene {

/// Reads a scene with these overrides and returns the error that this gives; none: it succeeds.
using Attempt = std::function<std::optional<Error>(std::span<const std::string> overrides)>;

/// If an override caused the error, returns it with "--set section.key" as its place and the file
/// and line that it named in brackets. Overrides are added one by one to find the first that causes
/// it. An error that comes up without any override, or that names an option already, stays as it
/// is.
Error with_setting(Error error, std::span<const std::string> overrides, const Attempt& attempt);

}  // namespace mixcmp::scene
