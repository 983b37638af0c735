#include "generator/cli/output.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "generator/cli/exit.hpp"
#include "generator/cli/scratch.hpp"
#include "model/common/process.hpp"

namespace mixcmp::cli {

namespace fs = std::filesystem;

namespace {

model::Error cannot_write(const fs::path& path) {
  return {.file = path.string(),
          .message = fmt::format("cannot be written: {}", std::strerror(errno))};
}

}  // namespace

model::Result<model::Done> write_file(const fs::path& path, const std::string& text) {
  const fs::path unfinished = path.string() + ".part";
  std::ofstream stream(unfinished, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code failed;
  if (stream) fs::rename(unfinished, path, failed);
  if (stream && !failed) return model::Done{};
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
