#pragma once

#include <string>
#include <vector>

#include "model/common/result.hpp"

namespace mixcmp::cli {

/// Checks what `mixcmp verify` checks before it simulates: its arguments, which are these words,
/// and the scene, its data and the portion that they name.
Result<Done> check_verify(const std::vector<std::string>& words);

}  // namespace mixcmp::cli
