#pragma once

#include <filesystem>

#include "model/comparison/expression/interpolation.hpp"

namespace mixcmp::data {

/// Reads the interpolation of a degree through the points of a comma-separated file whose first
/// record names its columns: x and y are the first two. Their numbers are rounded to binary64.
/// Errors name the file.
Result<Interpolation> read_points(const std::filesystem::path& path, int degree);

}  // namespace mixcmp::data
