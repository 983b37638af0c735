#pragma once

#include <filesystem>
#include <string_view>

namespace mixcmp::inline common {

/// Locks (flock) a new file or folder with a temporary name for as long as the descriptor is open.
/// False if another run removed it as abandoned in the meantime.
bool try_lock_new(int descriptor);

/// Removes from `folder` our user's files and folders whose names begin with `prefix` and that are
/// not locked: a killed process left them. One that cannot be removed stays. That is no error,
/// since it is nobody's result.
void remove_abandoned(const std::filesystem::path& folder, std::string_view prefix);

}  // namespace mixcmp::inline common
