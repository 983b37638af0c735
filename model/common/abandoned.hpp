#pragma once

#include <filesystem>
#include <string_view>

namespace mixcmp::inline common {

/// Locks (flock) a file or folder with a temporary name that was just made, for as long as the
/// descriptor is open. False if another run took it for abandoned in the meantime.
bool try_lock_new(int descriptor);

/// Removes from `folder` our user's files and folders whose names begin with `prefix` and that are
/// not locked: they were left by a process that was killed. What cannot be removed stays, which is
/// no error, since it is nobody's result.
void remove_abandoned(const std::filesystem::path& folder, std::string_view prefix);

}  // namespace mixcmp::inline common
