#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "model/common/result.hpp"

namespace mixcmp::model {

/// A mistake that was found after the scene was read, in something that the key `error.field` says:
/// the same with the file and the line of that key, or of the section where it is missing. One that
/// has a line already, or whose key is none of the scene's, stays as it is.
Error located(Error error, const std::filesystem::path& scene,
              std::span<const std::string> overrides);

}  // namespace mixcmp::model
