#pragma once

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <stdio.h>
#include <sys/wait.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test {

/// The exit code of a run of the program, and its output.
struct Outcome {
  int exit_code;
  std::string output;         ///< stdout and stderr, but for progress
  std::string progress = {};  ///< lines that come where a machine is slow
};

/// Moves lines of progress out of the output.
inline void separate_progress(Outcome& run) {
  std::istringstream lines(std::exchange(run.output, ""));
  for (std::string line; std::getline(lines, line);) {
    if (!lines.eof()) line += "\n";
    (line.starts_with("mixcmp: progress: ") ? run.progress : run.output) += line;
  }
}

/// Calls the program MIXCMP_PROGRAM as a user does, in a folder of its own.
class ProgramTest : public testing::Test {
protected:
  static Outcome shell(const std::string& command) {
    FILE* pipe = popen(("{ " + command + "; } 2>&1").c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("no shell");
    Outcome run{0, "", ""};
    std::array<char, 4096> block;
    for (std::size_t read = 0; (read = fread(block.data(), 1, block.size(), pipe)) > 0;) {
      run.output.append(block.data(), read);
    }
    run.exit_code = WEXITSTATUS(pclose(pipe));
    separate_progress(run);
    return run;
  }

  /// `environment`: variables that stand before the program.
  Outcome mixcmp(const std::string& arguments, const std::string& environment = "") {
    return shell(fmt::format("cd '{}' && {} '{}' {}", directory_.path().string(), environment,
                             MIXCMP_PROGRAM, arguments));
  }

  std::filesystem::path path(const std::string& name) const { return directory_.path() / name; }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
  }

  std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }

  /// Writes an executable shell script.
  void write_script(const std::string& name, const std::string& commands) const {
    write(name, "#!/bin/sh\n" + commands + "\n");
    std::filesystem::permissions(path(name), std::filesystem::perms::owner_all);
  }

  /// A variable for `mixcmp`: the shell commands run in the place of the tool of that name.
  std::string instead_of(const std::string& tool, const std::string& commands) const {
    std::filesystem::create_directories(path("fake"));
    write_script("fake/" + tool, commands);
    return fmt::format("PATH='{}':\"$PATH\"", path("fake").string());
  }

  /// An Icarus that answers "less" where a lane or a reference of the system has found "greater".
  std::string wrong_icarus() const {
    return instead_of("iverilog", R"sh(
real=$(PATH=${PATH#*:} command -v iverilog)
[ "$1" != -V ] || { echo 'Icarus Verilog version 1.0 (wrong)'; exit; }
range=$(sed -n 's/^  wire \(.*\)m_axis_tdata;$/\1/p' testbench.v)
sed -i "s/\.m_axis_tdata(m_axis_tdata)/.m_axis_tdata(answers)/
  s/^  wire .*m_axis_tdata;$/&\n  wire ${range}answers;\n  assign m_axis_tdata = answers \& ~2;/" \
  testbench.v
exec "$real" "$@"
)sh");
  }

  void expect_refused(const std::string& arguments, const std::string& words) {
    const Outcome run = mixcmp(arguments);
    EXPECT_EQ(run.exit_code, 1) << arguments << "\n" << run.output;
    EXPECT_NE(run.output.find(words), std::string::npos) << arguments << "\n" << run.output;
  }

  ScratchDirectory directory_;
};

}  // namespace mixcmp::test
