#include "generator/faces/cli/output.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "generator/faces/cli/exit.hpp"
#include "generator/synthesis/characterise/tools.hpp"
#include "model/base/common/content_hash.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"
#include "model/base/common/process.hpp"

namespace mixcmp::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* results_list = ".mixcmp-results";

/// The file that a path leads to; nullopt for a pipe or a device, which several outputs may share.
std::optional<fs::path> file_at(const fs::path& path) {
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  if (fs::exists(status) && !fs::is_regular_file(status)) return std::nullopt;
  // A link may lead to a file that does not exist yet: OutputFile creates it there.
  const auto target = follow_links(fs::absolute(path));
  const fs::path named = target.ok() ? *target : fs::absolute(path);
  const fs::path place = fs::weakly_canonical(named, failed);
  return failed ? named : place;
}

/// Whether a picture begins and ends as an SVG does: a full disk can cut it, a tool can talk into
/// it.
bool is_whole_svg(std::string_view picture) {
  const std::size_t last = picture.find_last_not_of(" \n");
  if (last == std::string_view::npos) return false;
  const bool begins = picture.starts_with("<?xml") || picture.starts_with("<svg");
  return begins && picture.substr(0, last + 1).ends_with("</svg>");
}

}  // namespace

Result<Done> check_outputs(const std::vector<fs::path>& outputs,
                           const std::vector<fs::path>& inputs) {
  std::vector<fs::path> taken;
  for (const fs::path& input : inputs) {
    if (const auto file = input.empty() ? std::nullopt : file_at(input)) taken.push_back(*file);
  }
  for (const fs::path& output : outputs) {
    const auto file = output.empty() ? std::nullopt : file_at(output);
    if (!file) continue;
    if (std::find(taken.begin(), taken.end(), *file) != taken.end()) {
      return Error{.file = output.string(),
                   .message = "would be written over",
                   .received = "the name of an input, or of another output",
                   .accepted = "a name of its own"};
    }
    taken.push_back(*file);
  }
  return Done{};
}

Result<Done> check_writable(const std::vector<fs::path>& outputs) {
  for (const fs::path& output : outputs) {
    if (output.empty() || !file_at(output)) continue;
    // Opened and left uncommitted, a file stays as it is.
    MIXCMP_TRY(possible, OutputFile::open(output));
  }
  return Done{};
}

Result<Done> check_replaced_folder(const fs::path& folder, const std::vector<fs::path>& inputs) {
  const auto own = file_at(folder / "any");
  for (const fs::path& input : inputs) {
    const auto file = input.empty() ? std::nullopt : file_at(input);
    if (!own || !file || file->parent_path() != own->parent_path()) continue;
    return Error{.file = folder.string(),
                 .message = "holds an input, and would be replaced as a whole",
                 .received = input.string(),
                 .accepted = "another folder"};
  }
  return Done{};
}

void tell_waiting(const fs::path& folder) {
  show_progress("");
  tell(fmt::format("{}: waiting for another run", folder.string()));
}

FolderLock lock_folder(const fs::path& folder) {
  return value_or_exit(FolderLock::take(folder, tell_waiting));
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
  const auto drawn = capture({"gnuplot"}, {.input = script, .seconds = 60});
  if (!drawn.ok() && drawn.error().kind == ErrorKind::missing_tool) {
    not_done_.push_back(path + ": gnuplot does not run (apt-get install gnuplot-nox)");
    leave_out(name);
    return;
  }
  Captured picture = value_or_exit(drawn);
  if (picture.in_time && picture.status != 0 && picture.errors.empty()) {
    picture.errors = "gnuplot " + how_it_ended(picture.status) + " and says nothing";
  }
  if (!picture.succeeded() || !is_whole_svg(picture.output)) {
    fail(Error{.file = path,
               .message = "gnuplot draws no picture",
               .received = picture.in_time ? picture.errors : "nothing in a minute",
               .accepted = "a gnuplot that runs and knows the terminal svg"});
  }
  add(name, std::move(picture.output));
}

void write_together(const std::vector<std::pair<fs::path, std::string>>& files) {
  std::vector<OutputFile> written;
  for (const auto& [path, text] : files) {
    written.push_back(value_or_exit(OutputFile::open(path)));
    written.back().write(text);
    value_or_exit(written.back().write_out());
  }
  for (OutputFile& file : written) value_or_exit(file.commit());
}

void ResultFiles::stage(const std::string& name, const std::string& text) {
  written_.push_back(value_or_exit(OutputFile::open(folder_ / name)));
  written_.back().write(text);
  value_or_exit(written_.back().write_out());
}

void ResultFiles::write_out() {
  MIXCMP_CHECK(files_.size() == names_.size());
  value_or_exit(make_writable_folder(folder_));
  std::string list;
  for (const File& file : files_) {
    if (!file.text) continue;
    stage(file.name, *file.text);
    list += fmt::format("{} {}\n", ContentHash().add(*file.text).hex(), file.name);
  }
  const Result<std::string> before = read_file(folder_ / results_list);
  // Until all files are in place the list names old and new ones: should this run be killed, the
  // next one recognises both as mixcmp's.
  const std::string known = before.ok() ? *before : "";
  value_or_exit(write_kept_file(folder_ / results_list, known + list));
  set_stale_aside(known);
  stage(results_list, list);
}

/// `known`: the list of the runs before.
void ResultFiles::set_stale_aside(const std::string& known) {
  StaleFiles::clear_abandoned(folder_);
  for (const File& file : files_) {
    const fs::path path = folder_ / file.name;
    if (file.text || !path_exists(path)) continue;
    const auto content = read_file(path);
    const bool ours =
        content.ok() && known.find(fmt::format("{} {}\n", ContentHash().add(*content).hex(),
                                               file.name)) != std::string::npos;
    if (ours) {
      value_or_exit(stale_.set_aside(path));
    } else {
      tell(fmt::format("{}: not of this run, and not as a run has left it: it stays",
                       path.string()));
    }
  }
}

std::vector<std::string> ResultFiles::commit() {
  for (OutputFile& file : written_) value_or_exit(file.commit());
  stale_.remove();
  return not_done_;
}

void end_if_router_is_missing(const devices::Device& device) {
  const characterise::Router* router = characterise::router_of(device);
  if (router == nullptr) return;
  const auto version = characterise::router_version(*router);
  if (!version.ok()) end_if_incomplete({"clocks: " + version.error().to_string()});
}

}  // namespace mixcmp::cli
