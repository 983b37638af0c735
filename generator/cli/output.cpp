#include "generator/cli/output.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "generator/cli/exit.hpp"
#include "generator/cli/scratch.hpp"
#include "model/common/file.hpp"
#include "model/common/process.hpp"

namespace mixcmp::cli {

namespace fs = std::filesystem;

namespace {

model::Error cannot_write(const fs::path& path) {
  return {.file = path.string(),
          .message = fmt::format("cannot be written: {}", std::strerror(errno))};
}

}  // namespace

model::Result<model::Done> check_outputs(const std::vector<fs::path>& outputs,
                                         const std::vector<fs::path>& inputs) {
  std::vector<fs::path> taken;
  for (const fs::path& input : inputs) {
    if (!input.empty()) taken.push_back(fs::weakly_canonical(input));
  }
  for (const fs::path& output : outputs) {
    if (output.empty()) continue;
    const fs::path place = fs::weakly_canonical(output);
    if (std::find(taken.begin(), taken.end(), place) != taken.end()) {
      return model::Error{.file = output.string(),
                          .message = "would be written over",
                          .received = "the name of an input, or of another output",
                          .accepted = "a name of its own"};
    }
    taken.push_back(place);
  }
  return model::Done{};
}

model::Result<model::Done> write_file(const fs::path& file, const std::string& text) {
  std::error_code failed;
  const fs::path path = fs::is_symlink(file, failed) ? fs::weakly_canonical(file) : file;
  // A pipe or a device takes what it is given; it is not replaced by a file.
  const bool is_special = fs::exists(path) && !fs::is_regular_file(path);
  if (is_special) return model::write_in_place(path, text);
  const fs::path unfinished = path.string() + ".part";
  const bool written = model::write_in_place(unfinished, text).ok();
  if (written) fs::rename(unfinished, path, failed);
  if (written && !failed) return model::Done{};
  const model::Error error = cannot_write(path);
  fs::remove(unfinished, failed);
  return error;
}

bool draw(const fs::path& directory, const std::string& name, const std::string& script) {
  const Scratch scratch;
  value_or_exit(write_file(scratch.path() / "script.gnuplot", script));
  const auto drawn = model::run_tool({"gnuplot", "script.gnuplot"}, scratch.path(),
                                     scratch.path() / "gnuplot.log", {});
  if (!drawn.ok()) return false;
  std::ostringstream picture;
  picture << std::ifstream(scratch.path() / (name + ".svg"), std::ios::binary).rdbuf();
  value_or_exit(write_file(directory / (name + ".svg"), picture.str()));
  return true;
}

model::Result<model::Done> prepare_directory(const fs::path& directory) {
  if (directory.empty()) return model::Done{};
  std::error_code failed;
  fs::create_directories(directory, failed);
  if (!failed && access(directory.c_str(), W_OK | X_OK) == 0) return model::Done{};
  if (failed) errno = failed.value();
  return cannot_write(directory);
}

void warn_of_no_pictures() {
  fmt::print(stderr, "mixcmp: no pictures: gnuplot does not run (apt-get install gnuplot-nox)\n");
}

void show_progress(const std::string& line) {
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\x1b[K{}", line);
}

}  // namespace mixcmp::cli
