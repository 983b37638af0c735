#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/common/folder_lock.hpp"
#include "model/common/result.hpp"
#include "model/devices/device.hpp"

namespace mixcmp::cli {

/// Checks that no output is an input or another output; empty paths are no outputs.
model::Result<model::Done> check_outputs(const std::vector<std::filesystem::path>& outputs,
                                         const std::vector<std::filesystem::path>& inputs);

/// Locks a work folder, which is made where there is none, for as long as the result lives. The
/// user is told where another run must end first.
model::FolderLock lock_folder(const std::filesystem::path& folder);
void tell_waiting(const std::filesystem::path& folder);

/// Draws what the gnuplot script says. Without gnuplot, adds the picture to `not_done`; ends the
/// program where the picture cannot be drawn or written.
void draw(const std::filesystem::path& svg, const std::string& script,
          std::vector<std::string>& not_done);

/// Ends the program with ExitCode::incomplete where the device has a router and this machine has
/// not.
void end_if_router_is_missing(const model::Device& device);

}  // namespace mixcmp::cli
