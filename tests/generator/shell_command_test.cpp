#include <fmt/core.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

#include "tests/support/program.hpp"

/// The program's messages about itself: its version, completions for shells, manual pages.
namespace mixcmp::test::shell_command_test {
namespace {

namespace fs = std::filesystem;

class ShellCommand : public ProgramTest {
protected:
  /// The words that the program offers behind these words, one a line; the last word is the one to
  /// complete.
  std::string offered(const std::string& words) {
    const Outcome run = mixcmp("--complete " + words);
    EXPECT_EQ(run.exit_code, 0) << words;
    return std::regex_replace(run.output, std::regex("\t.*"), "");
  }

  /// What bash makes of them where the line ends in these words.
  std::string bash(const std::string& words) {
    EXPECT_EQ(mixcmp("completion bash >script").exit_code, 0);
    write("complete", fmt::format("source ./script\nCOMP_WORDBREAKS=' ='\nCOMP_WORDS=('{}' {})\n"
                                  "COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))\n"
                                  "compopt() {{ echo \"compopt $*\"; }}\n_mixcmp\n"
                                  "printf '%s\\n' \"${{COMPREPLY[@]}}\"\n",
                                  MIXCMP_PROGRAM, words));
    return shell(fmt::format("cd '{}' && bash complete", directory_.path().string())).output;
  }

  bool has(const std::string& tool) { return shell("command -v " + tool).exit_code == 0; }

  std::vector<std::string> verbs() {
    std::vector<std::string> names;
    std::istringstream lines(offered("''"));
    for (std::string line; std::getline(lines, line);) names.push_back(line);
    return names;
  }

  /// Runs a checker on each page and returns its findings.
  std::string findings(const std::string& checker) {
    EXPECT_EQ(mixcmp("manual -o pages").exit_code, 0);
    return shell(fmt::format("cd '{}/pages' && for page in *; do {} ; done",
                             directory_.path().string(), checker))
        .output;
  }
};

TEST_F(ShellCommand, TheVersionNamesACommitInOneLine) {
  const Outcome run = mixcmp("--version");
  EXPECT_EQ(run.exit_code, 0);
  const std::regex line(R"(mixcmp \d+\.\d+\.\d+ \(commit ([0-9a-f]{40}(, modified)?|unknown)\)\n)");
  EXPECT_TRUE(std::regex_match(run.output, line)) << run.output;
}

TEST_F(ShellCommand, TheFullVersionNamesCompilerLibrariesAndTools) {
  const Outcome run = mixcmp("--version --json", instead_of("yosys", "echo Yosys 7.8"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto report = nlohmann::json::parse(run.output);
  EXPECT_EQ(report.at("tools").at("yosys"), "Yosys 7.8");
  const std::regex numbers(R"(\d+\.\d+.*)");
  for (const char* library : {"MPFR", "GMP"}) {
    EXPECT_TRUE(std::regex_match(report.at("libraries").at(library).get<std::string>(), numbers));
  }
  EXPECT_FALSE(report.at("compiler").get<std::string>().empty());
  const Outcome text = mixcmp("--version --verbose", "PATH=/nonexistent");
  EXPECT_TRUE(std::regex_search(text.output, std::regex("yosys +not found"))) << text.output;
}

TEST_F(ShellCommand, TheOptionsOfTheVersionGoWithItAlone) {
  expect_refused("--json", "--json requires --version");
  expect_refused("--verbose check scene.toml", "--verbose requires --version");
}

TEST_F(ShellCommand, VerbsOptionsAndValuesComplete) {
  const std::string all = offered("''");
  EXPECT_EQ(all.find("--"), std::string::npos) << all;
  for (const char* verb : {"check\n", "generate\n", "optimise\n", "completion\n", "manual\n"}) {
    EXPECT_NE(all.find(verb), std::string::npos) << all;
  }
  EXPECT_EQ(offered("gen"), "generate\n");
  EXPECT_EQ(offered("--vers"), "--version\n");
  EXPECT_EQ(offered("generate --form"), "--format\n");
  EXPECT_EQ(offered("generate scene.toml --no"), "--no-prove\n");
  EXPECT_EQ(offered("optimise --use-multipliers l"), "logic\n");
  EXPECT_EQ(offered("optimise --use-multipliers=l"), "--use-multipliers=logic\n");
  EXPECT_EQ(offered("completion ''"), "bash\nzsh\nfish\n");
  EXPECT_EQ(offered("manual rep"), "report\n");
  EXPECT_EQ(offered("check --quiet --form"), "--format\n") << "a flag takes no word";
}

TEST_F(ShellCommand, EachArgumentCompletesInItsPlace) {
  EXPECT_EQ(offered("sweep ''"), "plan\nrun\nmerge\n");
  EXPECT_EQ(offered("sweep --shard 1/2 m"), "merge\n");
  EXPECT_EQ(offered("sweep --shard=1/2 m"), "merge\n");
  EXPECT_EQ(offered("sweep plan ''"), ":path\n");
  EXPECT_EQ(offered("sweep plan file ''"), "") << "there are two arguments";
  EXPECT_EQ(offered("sweep plan --sh"), "--shard\n");
}

TEST_F(ShellCommand, PathsAndFreeTextsAreLeftToTheShell) {
  EXPECT_EQ(offered("check ''"), ":path\n");
  EXPECT_EQ(offered("generate -o some"), ":path\n");
  EXPECT_EQ(offered("generate --format ''"), "");
}

TEST_F(ShellCommand, OptionsAreOfferedAgainOnlyIfTheyMayBeRepeated) {
  EXPECT_EQ(offered("generate --quiet --q"), "");
  EXPECT_EQ(offered("generate -o folder --outp"), "") << "--output by its other name";
  EXPECT_EQ(offered("generate --set a=1 --se"), "--set\n");
}

TEST_F(ShellCommand, CandidatesHaveTheirHelp) {
  EXPECT_EQ(mixcmp("--complete --vers").output, "--version\tprint version and commit\n");
  EXPECT_NE(mixcmp("--complete manual gen").output.find("generate\tthe verb that"),
            std::string::npos);
}

TEST_F(ShellCommand, CompletionRunsNothingAndFailsOnNothing) {
  for (const char* words : {"", "nosuchverb ''", "check --nosuchoption=", "check $'\\1' x", "=",
                            "manual generate", "check missing.toml"}) {
    const Outcome run = mixcmp(fmt::format("--complete {}", words));
    EXPECT_EQ(run.exit_code, 0) << words;
    EXPECT_EQ(run.output.find("mixcmp: "), std::string::npos) << run.output;
  }
  EXPECT_EQ(offered("manual generate"), "generate\n");
  EXPECT_EQ(mixcmp("--help").output.find("--complete"), std::string::npos);
}

TEST_F(ShellCommand, BashTakesCandidatesFromTheProgram) {
  EXPECT_EQ(bash("gen"), "generate\n");
  EXPECT_EQ(bash("completion ''"), "bash\nzsh\nfish\n");
  EXPECT_EQ(bash("optimise --use-multipliers = l"), "logic\n");
  EXPECT_EQ(bash("generate --set a = 1 ''"), "compopt -o default\n\n");
  EXPECT_EQ(bash("generate --format ''"), "\n");
}

TEST_F(ShellCommand, CompletionsListEveryOptionThatHelpLists) {
  const std::regex name("--[a-z][a-z-]*");
  for (const std::string& verb : verbs()) {
    const std::string help = mixcmp(verb + " --help").output;
    const std::string options = offered(verb + " --");
    for (std::sregex_iterator it(help.begin(), help.end(), name), end; it != end; ++it) {
      // In running text a name may be that of another program's or verb's option.
      const bool is_listed = help.find("  " + it->str()) != std::string::npos ||
                             help.find("," + it->str()) != std::string::npos;
      if (!is_listed) continue;
      EXPECT_NE(options.find(it->str() + "\n"), std::string::npos) << verb << " " << it->str();
    }
  }
}

TEST_F(ShellCommand, ZshTakesCandidatesFromTheProgram) {
  if (!has("zsh")) GTEST_SKIP() << "zsh is not installed";
  mixcmp("completion zsh >_mixcmp");
  // Its builtins print what they are given.
  write("run",
        "_describe() { print -rl -- $lines }\n_files() { print files }\n"
        "compset() { [[ $words[-1] == $~2* ]] }\n"
        "words=(\"$@\") CURRENT=$#\nsource ./_mixcmp\n");
  const auto complete = [&](const std::string& words) {
    return shell(fmt::format("cd '{}' && zsh -f run '{}' {}", directory_.path().string(),
                             MIXCMP_PROGRAM, words))
        .output;
  };
  EXPECT_EQ(complete("--vers"), "--version:print version and commit\n");
  EXPECT_TRUE(complete("generate --no-p").starts_with("--no-prove:"));
  EXPECT_EQ(complete("check ''"), "files\n");
  EXPECT_TRUE(complete("optimise --use-multipliers=l").starts_with("logic:"));
  EXPECT_EQ(complete("generate --output=some"), "files\n");
  EXPECT_EQ(complete("nosuchverb"), "\n") << "nothing";
}

TEST_F(ShellCommand, FishCompletesVerbsOptionsAndWords) {
  if (!has("fish")) GTEST_SKIP() << "fish is not installed";
  mixcmp("completion fish >mixcmp.fish");
  const auto complete = [&](const std::string& line) {
    return shell(fmt::format("cd '{0}' && HOME='{0}' fish --no-config -c 'source mixcmp.fish; "
                             "complete -C \"{1} {2}\"'",
                             directory_.path().string(), MIXCMP_PROGRAM, line))
        .output;
  };
  EXPECT_TRUE(complete("gen").starts_with("generate\t")) << complete("gen");
  EXPECT_TRUE(complete("generate --no-p").starts_with("--no-prove\t"));
  EXPECT_TRUE(complete("optimise --use-multipliers l").starts_with("logic\t"));
  EXPECT_TRUE(complete("optimise --use-multipliers=l").starts_with("--use-multipliers=logic\t"));
  EXPECT_EQ(complete("check mixc"), "mixcmp.fish\n");
  EXPECT_EQ(complete("generate --format mixc"), "");
}

TEST_F(ShellCommand, EveryVerbHasAPageWithEveryOption) {
  ASSERT_EQ(mixcmp("manual -o pages").exit_code, 0);
  const std::string program = read("pages/mixcmp.1");
  for (const std::string& verb : verbs()) {
    const std::string page = read("pages/mixcmp-" + verb + ".1");
    EXPECT_EQ(page, mixcmp("manual " + verb).output) << verb;
    EXPECT_NE(program.find(".BR mixcmp\\-" + verb + " (1)"), std::string::npos) << verb;
    std::istringstream options(offered(verb + " --"));
    for (std::string option; std::getline(options, option);) {
      std::string escaped;
      for (const char c : option) escaped += c == '-' ? std::string("\\-") : std::string(1, c);
      EXPECT_NE(page.find("\\fB" + escaped + "\\fR"), std::string::npos) << verb << option;
    }
  }
}

TEST_F(ShellCommand, PagesAreCleanForManAndMandoc) {
  if (!has("man")) GTEST_SKIP() << "man-db is not installed";
  EXPECT_EQ(findings("man --warnings -E UTF-8 -l -Tutf8 -Z $page 2>&1 >/dev/null"), "");
  if (!has("mandoc")) GTEST_SKIP() << "mandoc is not installed";
  // A page without a date is the same from build to build.
  EXPECT_EQ(findings("mandoc -T lint -W warning $page | grep -v 'missing date'"), "");
}

TEST_F(ShellCommand, AManualOfNoVerbIsRefused) {
  expect_refused("manual chek", "VERB: received chek; accepted check (the nearest)");
  expect_refused("completion tcsh", "mixcmp: completion: ");
  expect_refused("manual check -o pages", "excludes");
  EXPECT_FALSE(fs::exists(path("pages")));
}

}  // namespace
}  // namespace mixcmp::test::shell_command_test
