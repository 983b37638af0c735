#pragma once

#include <string>
#include <vector>

#include "model/base/common/result.hpp"

namespace mixcmp::cli {

/// Makes the checks of `mixcmp verify` that come before its simulation: on its arguments, which are
/// these words, and on the scene, its data and the portion that they name.
Result<Done> check_verify(const std::vector<std::string>& words);

}  // namespace mixcmp::cli
