#pragma once

#include <fmt/core.h>

#include <string>

#include "tests/support/program.hpp"

namespace mixcmp::test {

/// A scene beside its data, and the folder that `generate --project` makes of it.
class ProjectTest : public ProgramTest {
protected:
  ProjectTest() {
    write("data.csv", data());
    write("scene.toml",
          "[comparison]\nname = \"scene\"\nf = \"a\"\ng = \"b\"\n"
          "[reference]\nformat = \"binary32\"\n"
          "[reduced]\nformat = \"s8e8\"\ninputs = \"rounded\"\n"
          "[system]\nlanes = 2\nreferences = 1\ndevice = \"ice40-hx8k\"\n"
          "[data]\nfile = \"data.csv\"\n");
  }

  /// Rows whose b differs from a by nothing, by too little for 8 bits, and by much.
  static std::string data() {
    std::string text = "a,b\n";
    constexpr double factors[] = {1, 1 + 1e-5, 1 - 1e-5, 1.5, 0.75};
    for (int k = 0; k < 150; ++k) {
      const double a = 1 + 0.37 * (k % 29);
      text += fmt::format("{:.7f},{:.7f}\n", a, a * factors[k % 5]);
    }
    return text;
  }

  /// Generates into the folder `rtl`.
  void generate(const std::string& arguments) {
    const Outcome run = mixcmp("generate scene.toml --no-prove -o rtl " + arguments);
    ASSERT_EQ(run.exit_code, 0) << run.output;
  }

  /// Runs a command in the test's folder.
  Outcome in_folder(const std::string& command) const {
    return shell(fmt::format("cd '{}' && {}", directory_.path().string(), command));
  }

  static bool is_installed(const std::string& tool) {
    return shell("command -v " + tool).exit_code == 0;
  }

  /// Runs the test bench with one line of a module in rtl changed by sed.
  Outcome run_changed(const std::string& file, const std::string& change) {
    const Outcome changed =
        in_folder(fmt::format("rm -rf changed && cp -r rtl changed && sed -i '{1}' changed/{0} && "
                              "! cmp -s changed/{0} rtl/{0}",
                              file, change));
    EXPECT_EQ(changed.exit_code, 0) << "nothing changed: " << change;
    return in_folder("changed/icarus/run work");
  }

  void expect_in(const std::string& text, const std::string& words) {
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  }
};

/// Projects of scenes with an engine.
class EngineProjectTest : public ProjectTest {
protected:
  /// Items whose differences tie, nearly tie, or are far apart.
  void write_pairs(const std::string& pairing = "pairs = \"all\"\n") {
    std::string data = "a,b\n";
    for (int k = 0; k < 12; ++k) {
      const double a = 1 + 0.37 * k;
      data += fmt::format("{:.7f},{:.7f}\n", a, k % 3 == 0 ? a : a * (1 + 0.003 * (k % 5)));
    }
    write("data.csv", data);
    write_engine("ai - aj", "bi - bj", "[engine]\nkind = \"pairwise\"\ncapacity = 16\n", pairing);
  }

  /// Points between centres, some of them in the middle of two.
  void write_chain() {
    write("data.csv", "p\n0.5\n1.0001\n1.75\n2.5\n2.9999\n3.25\n1\n3\n0\n4\n");
    write("centres.csv", "c\n0\n2\n4\n");
    write_engine("(p - ci)^2", "(p - cj)^2", "[engine]\nkind = \"arg_min\"\ntag_bits = 5\n",
                 "with = \"centres.csv\"\npairs = \"arg_min\"\n");
  }

  Outcome run_engine_changed(const std::string& file, const std::string& change) {
    Outcome run = run_changed(file, change);
    EXPECT_NE(run.exit_code, 0) << change << "\n" << run.output;
    return run;
  }

private:
  void write_engine(const std::string& f, const std::string& g, const std::string& engine,
                    const std::string& pairing) {
    write("scene.toml",
          fmt::format("[comparison]\nname = \"near\"\nf = \"{}\"\ng = \"{}\"\n"
                      "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"s8e8\"\n"
                      "[system]\nlanes = 2\nreferences = 1\ndevice = \"ice40-hx8k\"\n{}"
                      "[data]\nfile = \"data.csv\"\n{}",
                      f, g, engine, pairing));
  }
};

}  // namespace mixcmp::test
