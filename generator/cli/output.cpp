#include "generator/cli/output.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "generator/cli/exit.hpp"
#include "model/characterise/tools.hpp"
#include "model/common/output_file.hpp"
#include "model/common/process.hpp"

namespace mixcmp::cli {

namespace fs = std::filesystem;

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

void tell_waiting(const fs::path& folder) {
  show_progress("");
  tell(fmt::format("{}: waiting for another run", folder.string()));
}

model::FolderLock lock_folder(const fs::path& folder) {
  return value_or_exit(model::FolderLock::take(folder, [&] { tell_waiting(folder); }));
}

void draw(const fs::path& svg, const std::string& script, std::vector<std::string>& not_done) {
  const auto drawn = model::capture({"gnuplot"}, {.input = script, .seconds = 60});
  if (!drawn.ok() && drawn.error().kind == model::ErrorKind::missing_tool) {
    not_done.push_back(
        fmt::format("{}: gnuplot does not run (apt-get install gnuplot-nox)", svg.string()));
    return;
  }
  const model::Captured picture = value_or_exit(drawn);
  const bool is_svg = picture.output.find("<svg") != std::string::npos &&
                      picture.output.find("</svg>") != std::string::npos;
  if (!picture.succeeded() || !is_svg) {
    fail(model::Error{.file = svg.string(),
                      .message = "gnuplot draws no picture",
                      .received = picture.in_time ? picture.errors : "nothing in a minute",
                      .accepted = "a gnuplot that runs and knows the terminal svg"});
  }
  value_or_exit(model::write_file(svg, picture.output));
}

void end_if_router_is_missing(const model::Device& device) {
  if (!model::is_routed(device)) return;
  const auto version = model::router_version(device);
  if (!version.ok()) end_if_incomplete({"clocks: " + version.error().to_string()});
}

}  // namespace mixcmp::cli
