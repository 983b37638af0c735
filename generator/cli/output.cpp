#include "generator/cli/output.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "generator/cli/exit.hpp"
#include "model/characterise/tools.hpp"
#include "model/common/output_file.hpp"
#include "model/common/process.hpp"

namespace mixcmp::cli {

namespace fs = std::filesystem;

namespace {

/// The file that a path leads to; none for a pipe or a device, which several may share.
std::optional<fs::path> file_at(const fs::path& path) {
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  if (fs::exists(status) && !fs::is_regular_file(status)) return std::nullopt;
  const fs::path place = fs::weakly_canonical(path, failed);
  return failed ? fs::absolute(path) : place;
}

}  // namespace

model::Result<model::Done> check_outputs(const std::vector<fs::path>& outputs,
                                         const std::vector<fs::path>& inputs) {
  std::vector<fs::path> taken;
  for (const fs::path& input : inputs) {
    if (const auto file = input.empty() ? std::nullopt : file_at(input)) taken.push_back(*file);
  }
  for (const fs::path& output : outputs) {
    const auto file = output.empty() ? std::nullopt : file_at(output);
    if (!file) continue;
    if (std::find(taken.begin(), taken.end(), *file) != taken.end()) {
      return model::Error{.file = output.string(),
                          .message = "would be written over",
                          .received = "the name of an input, or of another output",
                          .accepted = "a name of its own"};
    }
    taken.push_back(*file);
  }
  return model::Done{};
}

void tell_waiting(const fs::path& folder) {
  show_progress("");
  tell(fmt::format("{}: waiting for another run", folder.string()));
}

model::FolderLock lock_folder(const fs::path& folder) {
  return value_or_exit(model::FolderLock::take(folder, [&] { tell_waiting(folder); }));
}

std::vector<fs::path> ResultFiles::paths(const fs::path& folder, Names names) {
  std::vector<fs::path> paths;
  for (const char* name : names) paths.push_back(folder / name);
  return paths;
}

void ResultFiles::put(const std::string& name, std::optional<std::string> text) {
  MIXCMP_CHECK(std::find(names_.begin(), names_.end(), name) != names_.end());
  files_.push_back({name, std::move(text)});
}

void ResultFiles::add(const std::string& name, std::string text) {
  put(name, std::move(text));
}

void ResultFiles::leave_out(const std::string& name) {
  put(name, std::nullopt);
}

void ResultFiles::add_picture(const std::string& name, const std::string& script) {
  const std::string path = (folder_ / name).string();
  const auto drawn = model::capture({"gnuplot"}, {.input = script, .seconds = 60});
  if (!drawn.ok() && drawn.error().kind == model::ErrorKind::missing_tool) {
    not_done_.push_back(path + ": gnuplot does not run (apt-get install gnuplot-nox)");
    leave_out(name);
    return;
  }
  model::Captured picture = value_or_exit(drawn);
  const bool is_svg = picture.output.find("<svg") != std::string::npos &&
                      picture.output.find("</svg>") != std::string::npos;
  if (!picture.succeeded() || !is_svg) {
    fail(model::Error{.file = path,
                      .message = "gnuplot draws no picture",
                      .received = picture.in_time ? picture.errors : "nothing in a minute",
                      .accepted = "a gnuplot that runs and knows the terminal svg"});
  }
  add(name, std::move(picture.output));
}

std::vector<std::string> ResultFiles::write() {
  MIXCMP_CHECK(files_.size() == names_.size());
  value_or_exit(model::make_writable_folder(folder_));
  for (const File& file : files_) {
    const fs::path path = folder_ / file.name;
    if (file.text) {
      value_or_exit(model::write_file(path, *file.text));
      continue;
    }
    std::error_code failed;
    fs::remove(path, failed);
    if (failed) fail(model::cannot_write(path, failed.value()));
  }
  return not_done_;
}

void end_if_router_is_missing(const model::Device& device) {
  if (!model::is_routed(device)) return;
  const auto version = model::router_version(device);
  if (!version.ok()) end_if_incomplete({"clocks: " + version.error().to_string()});
}

}  // namespace mixcmp::cli
