#pragma once

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <stdio.h>
#include <sys/wait.h>

#include <array>
#include <stdexcept>
#include <string>

#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test {

/// What a run of the program left on the terminal.
struct Outcome {
  int exit_code;
  std::string output;  ///< stdout and stderr
};

/// Calls the program MIXCMP_PROGRAM as a user does, in a folder of its own.
class ProgramTest : public testing::Test {
protected:
  static Outcome shell(const std::string& command) {
    FILE* pipe = popen(("{ " + command + "; } 2>&1").c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("no shell");
    Outcome run{0, ""};
    std::array<char, 4096> block;
    for (std::size_t read = 0; (read = fread(block.data(), 1, block.size(), pipe)) > 0;) {
      run.output.append(block.data(), read);
    }
    run.exit_code = WEXITSTATUS(pclose(pipe));
    return run;
  }

  /// `environment`: variables that stand before the program.
  Outcome mixcmp(const std::string& arguments, const std::string& environment = "") {
    return shell(fmt::format("cd '{}' && {} '{}' {}", directory_.path().string(), environment,
                             MIXCMP_PROGRAM, arguments));
  }

  void expect_refused(const std::string& arguments, const std::string& words) {
    const Outcome run = mixcmp(arguments);
    EXPECT_EQ(run.exit_code, 1) << arguments << "\n" << run.output;
    EXPECT_NE(run.output.find(words), std::string::npos) << arguments << "\n" << run.output;
  }

  ScratchDirectory directory_;
};

}  // namespace mixcmp::test
