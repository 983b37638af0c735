#pragma once

#include <span>
#include <string>

#include "model/base/common/result.hpp"
#include "model/scene/scene_source.hpp"

namespace mixcmp::scene {

/// Adds a place to an error that was found after the scene had been read: the file and line of the
/// key that `error.field` names, or of its section if the scene does not have the key. An error is
/// returned unchanged if it already names a line or "--set", or names a section that the scene does
/// not have.
Error with_location(Error error, const SceneSource& scene, std::span<const std::string> overrides);

}  // namespace mixcmp::scene
