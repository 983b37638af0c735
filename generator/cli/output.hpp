#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/common/result.hpp"

namespace mixcmp::cli {

/// No output may be an input, nor the same as another output; empty paths are none.
model::Result<model::Done> check_outputs(const std::vector<std::filesystem::path>& outputs,
                                         const std::vector<std::filesystem::path>& inputs);

/// Complete or not at all; through a link to its target, into a pipe or a device as it comes.
model::Result<model::Done> write_file(const std::filesystem::path& path, const std::string& text);

/// A directory that cannot be written should not cost a long run first. An empty path is none.
model::Result<model::Done> prepare_directory(const std::filesystem::path& directory);

/// Runs the gnuplot script, which writes NAME.svg, elsewhere, so that no picture is ever half
/// there. False where gnuplot cannot run; ends the program where the picture cannot be written.
bool draw(const std::filesystem::path& directory, const std::string& name,
          const std::string& script);

/// On stderr.
void warn_of_no_pictures();

/// A line on stderr that is overwritten, on a terminal only; empty clears it.
void show_progress(const std::string& line);

}  // namespace mixcmp::cli
