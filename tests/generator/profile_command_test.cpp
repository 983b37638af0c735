#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/support/program.hpp"

/// `mixcmp profile` as a user calls it.
namespace mixcmp::test::profile_command_test {
namespace {

namespace fs = std::filesystem;

class ProfileCommand : public ProgramTest {
protected:
  ProfileCommand() {
    write_scene("scene.toml", "binary64",
                "[data]\nitems = \"uniform_spheres\"\n"
                "count = 200\nradius_max = 40\nseed = 1\npairs = \"all\"\n");
  }

  void write_scene(const std::string& name, const std::string& reference, const std::string& data) {
    std::ofstream(path(name))
        << "[comparison]\nname = \"spheres\"\n"
        << "f = \"(cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2\"\ng = \"(ri + rj)^2\"\n"
        << "[inputs]\n\"c*\" = { range = [0, 100] }\n\"r*\" = { range = [0, 100] }\n"
        << "[reference]\nformat = \"" << reference << "\"\n[reduced]\nformat = \"s8e8\"\n"
        << "[system]\nlanes = 1\nreferences = 1\n"
        << data;
  }

  Outcome profile(const std::string& arguments, const std::string& environment = "") {
    return mixcmp("profile " + arguments, environment);
  }

  void expect_profile_refused(const std::string& arguments, const std::string& words) {
    expect_refused("profile " + arguments, words);
  }
};

TEST_F(ProfileCommand, CountsEverySchemeAtEveryPrecision) {
  const Outcome run = profile("scene.toml --last 20 --json");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto report = nlohmann::json::parse(run.output);
  EXPECT_EQ(report.at("comparisons"), 19900);
  EXPECT_EQ(report.at("relative_errors").size(), 2u);
  const auto& rates = report.at("recomputation_rates");
  ASSERT_EQ(rates.size(), 1u);
  for (const auto& scheme : rates[0].at("schemes")) {
    ASSERT_EQ(scheme.at("precisions").size(), 17u) << scheme.at("scheme");
    const std::uint64_t first = scheme.at("precisions")[0].at("undecided");
    const std::uint64_t last = scheme.at("precisions")[16].at("undecided");
    if (scheme.at("scheme") == "lanes_alone") {
      EXPECT_GT(scheme.at("precisions")[0].at("wrong"), 0);
    } else {
      EXPECT_GT(first, last) << scheme.at("scheme");
    }
    if (!scheme.at("certified")) continue;
    for (const auto& row : scheme.at("precisions")) EXPECT_EQ(row.at("wrong"), 0);
  }
}

TEST_F(ProfileCommand, CountsTheBoundsThatAreAskedFor) {
  const Outcome run =
      profile("scene.toml --last 20 --bounds constant,fixed_norm --json --accept 0");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto report = nlohmann::json::parse(run.output);
  const auto& schemes = report.at("recomputation_rates")[0].at("schemes");
  ASSERT_EQ(schemes.size(), 2u);
  EXPECT_EQ(schemes[0].at("scheme"), "constant");
  EXPECT_EQ(schemes[1].at("scheme"), "fixed_norm");
  for (const auto& point : report.at("trade")[0].at("points")) {
    EXPECT_TRUE(point.at("scheme") == "constant" || point.at("scheme") == "fixed_norm");
  }
}

/// References of integers are exact lanes, and are priced as these.
TEST_F(ProfileCommand, AdvisesExactLanesOfIntegersWithoutRecomputations) {
  std::ofstream(path("integers.csv")) << "x,y,z\n-121,17,88\n3,4,-5\n127,-128,0\n64,1,-8\n";
  std::ofstream(path("integers.toml"))
      << "[comparison]\nname = \"n\"\nf = \"x * y\"\ng = \"z^2\"\n[inputs]\n\"*\" = { format = "
         "\"int8\" }\n[data]\nfile = \"integers.csv\"\n";
  const Outcome run = profile("integers.toml --samples 0");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("L = 7 costs least: lanes in q7"), std::string::npos) << run.output;
  EXPECT_NE(
      run.output.find("and recompute nothing, since they are exact; a reference takes 1 times"),
      std::string::npos)
      << run.output;
}

/// The shortlist of `characterise --quick` is made of the advice, so the advice names a lane that
/// exists, by rates of this run.
TEST_F(ProfileCommand, EndsWithAdviceThatSaysWhatItStandsOn) {
  const std::string arguments = "scene.toml --last 20 --bounds constant,fixed_norm";
  const Outcome run = profile(arguments + " --json");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto report = nlohmann::json::parse(run.output);
  const auto& cheapest = report.at("cheapest");
  EXPECT_EQ(cheapest.at("basis").get<std::string>().rfind("recomputation rates counted", 0), 0u);
  const auto& lanes = cheapest.at("lanes");
  ASSERT_EQ(lanes.size(), 2u) << cheapest;
  EXPECT_EQ(lanes[0].at("bound"), "fixed_norm") << cheapest;
  EXPECT_LT(lanes[0].at("device_share"), lanes[1].at("device_share"));
  const int precision = lanes[0].at("precision");
  for (const auto& scheme : report.at("recomputation_rates")[0].at("schemes")) {
    if (scheme.at("scheme") != "fixed_norm") continue;
    const double undecided = scheme.at("precisions")[precision - 4].at("undecided");
    EXPECT_DOUBLE_EQ(lanes[0].at("recomputation_rate"), undecided / 19900);
  }
  const Outcome text = profile(arguments);
  EXPECT_NE(text.output.find(fmt::format("L = {} costs least: lanes in q{}", precision, precision)),
            std::string::npos)
      << text.output;
  const std::string command = cheapest.at("try")[1];
  const Outcome followed = mixcmp("check" + command.substr(std::string("mixcmp verify").size()));
  EXPECT_EQ(followed.exit_code, 0) << command << "\n" << followed.output;
}

/// Fixed-point rates are the same without relative errors, so the profile does not measure these.
TEST_F(ProfileCommand, FixedPointAloneMeasuresNoRelativeErrors) {
  const Outcome without = profile("scene.toml --last 12 --bounds fixed_norm --json");
  const Outcome with = profile("scene.toml --last 12 --bounds fixed_norm --samples 50 --json");
  ASSERT_EQ(without.exit_code, 0) << without.output;
  ASSERT_EQ(with.exit_code, 0) << with.output;
  const auto report = nlohmann::json::parse(without.output);
  const auto measured = nlohmann::json::parse(with.output);
  EXPECT_EQ(report.at("recomputation_rates")[0].at("schemes"),
            measured.at("recomputation_rates")[0].at("schemes"));
  EXPECT_EQ(measured.at("relative_errors")[0].at("comparisons"), 50);
  for (const auto& errors : report.at("relative_errors")) {
    EXPECT_EQ(errors.at("comparisons"), 0);
    EXPECT_TRUE(errors.at("precisions")[0].at("f_error").is_null());
  }
}

TEST_F(ProfileCommand, LanesThatNeedMeasuredErrorsSayThatNoneWas) {
  const Outcome run = profile("scene.toml --last 12 --samples 0");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("none was measured"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("profiled: no relative error was measured"), std::string::npos)
      << run.output;
}

TEST_F(ProfileCommand, RefusesBoundsThatItDoesNotCount) {
  expect_profile_refused("scene.toml --bounds running_3", "running_3");
  expect_profile_refused("scene.toml --bounds norm", "fixed_norm");
}

TEST_F(ProfileCommand, BruteForceFindsTheSame) {
  const std::string arguments = "scene.toml --set data.count=30 --both-inputs";
  EXPECT_EQ(profile(arguments).output, profile(arguments + " --brute-force --threads 1").output);
}

TEST_F(ProfileCommand, WritesFigures) {
  const Outcome run = profile("scene.toml --last 12 -o out");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const std::string figure4 = read("out/figure4.csv"), figure5 = read("out/figure5.csv");
  EXPECT_EQ(std::count(figure4.begin(), figure4.end(), '\n'), 1 + 2 * 9);
  // The reference, and ten schemes.
  EXPECT_EQ(std::count(figure5.begin(), figure5.end(), '\n'), 1 + 1 + 10 * 9);
  EXPECT_NE(figure4.find("\nrounded,12,"), std::string::npos);
  EXPECT_NE(figure5.find("\nexact,12,relative,19900,"), std::string::npos);
  EXPECT_FALSE(fs::exists(path("out") / "figure4.gnuplot"));
}

TEST_F(ProfileCommand, WeighsSchemes) {
  write("areas.csv", "scheme,precision,luts\nlanes_alone,4,1\n");
  const Outcome run =
      profile("scene.toml --last 12 -o out --accept 0 --accept 100000 --areas areas.csv --json");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto report = nlohmann::json::parse(run.output);
  EXPECT_EQ(report.at("trade")[0].at("points").size(), 10u * 9);
  ASSERT_EQ(report.at("advice").size(), 2u);
  EXPECT_EQ(report.at("advice")[0].get<std::string>().rfind("certified, no wrong verdict", 0), 0u);
  EXPECT_NE(report.at("advice")[1].get<std::string>().find("lanes_alone"), std::string::npos);
  const std::string csv = read("out/trade.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 10 * 9);
  expect_profile_refused("scene.toml --accept -1", "--accept");
  expect_profile_refused("scene.toml --areas nowhere.csv",
                         "nowhere.csv: --areas: cannot read the file");
}

TEST_F(ProfileCommand, WithoutGnuplotOnlyThePicturesAreMissing) {
  const Outcome before =
      profile("scene.toml --last 7 -o out", instead_of("gnuplot", "echo '<svg></svg>'"));
  ASSERT_EQ(before.exit_code, 0) << before.output;
  ASSERT_TRUE(fs::exists(path("out") / "figure5.svg"));
  const Outcome run = profile("scene.toml --last 6 -o out", "PATH=/nowhere");
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_NE(run.output.find("not done: out/figure5.svg: gnuplot does not run (apt-get install "),
            std::string::npos)
      << run.output;
  EXPECT_TRUE(fs::exists(path("out") / "figure5.csv"));
  EXPECT_FALSE(fs::exists(path("out") / "figure5.svg"));
}

TEST_F(ProfileCommand, WhatNoRunHasMadeStays) {
  const std::string drawing = instead_of("gnuplot", "echo '<svg></svg>'");
  fs::create_directories(path("out/trade.svg"));
  write("out/trade.csv", "my own measurements");
  const Outcome run = profile("scene.toml --last 6 -o out", drawing);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(read("out/trade.csv"), "my own measurements");
  EXPECT_TRUE(fs::is_directory(path("out/trade.svg")));
  EXPECT_NE(run.output.find("out/trade.csv: not of this run"), std::string::npos) << run.output;
  fs::remove(path("out/trade.svg"));
  ASSERT_EQ(profile("scene.toml --last 6 --trade -o out", drawing).exit_code, 0);
  ASSERT_NE(read("out/trade.csv"), "my own measurements");
  write("out/trade.svg", "edited");
  ASSERT_EQ(profile("scene.toml --last 6 -o out", drawing).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("out/trade.csv"))) << "the run before made it";
  EXPECT_EQ(read("out/trade.svg"), "edited");
}

TEST_F(ProfileCommand, WhatAKilledRunHasSetAsideIsRemoved) {
  const std::string drawing = instead_of("gnuplot", "echo '<svg></svg>'");
  fs::create_directories(path("out"));
  write("out/.mixcmp-stale-999999999-trade.csv", "of the run before the killed one");
  ASSERT_EQ(profile("scene.toml --last 6 -o out", drawing).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("out/.mixcmp-stale-999999999-trade.csv")));
}

TEST_F(ProfileCommand, WhatGnuplotLeavesIsAPictureOrAnError) {
  for (const char* left : {"exit 0", "echo '<svg>'; exit 0", "echo '<svg></svg>'; exit 1",
                           "echo '<svg></svg>'; echo and more", "echo words; echo '<svg></svg>'"}) {
    const Outcome run = profile("scene.toml --last 6 -o out", instead_of("gnuplot", left));
    EXPECT_EQ(run.exit_code, 1) << left << "\n" << run.output;
    EXPECT_NE(run.output.find("out/figure4.svg: gnuplot draws no picture"), std::string::npos)
        << run.output;
    EXPECT_FALSE(fs::exists(path("out") / "figure4.svg")) << left;
  }
}

TEST_F(ProfileCommand, ResultsThatAreReplacedKeepPermissionsAndLinks) {
  fs::create_directory(path("out"));
  write("out/figure4.csv", "old");
  fs::permissions(path("out/figure4.csv"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("../elsewhere.csv", path("out/figure5.csv"));
  ASSERT_EQ(profile("scene.toml --last 5 -o out").exit_code, 0);
  EXPECT_EQ(fs::status(path("out/figure4.csv")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_TRUE(fs::is_symlink(path("out/figure5.csv")));
  EXPECT_EQ(read("elsewhere.csv"), read("out/figure5.csv"));
}

TEST_F(ProfileCommand, ResultsReplaceNoInput) {
  fs::create_directory(path("out"));
  write("out/trade.csv", "scheme,precision,luts\nreference,0,9000\nrelative,8,500\n");
  expect_profile_refused("scene.toml --areas out/trade.csv -o out", "would be written over");
  EXPECT_EQ(read("out/trade.csv").substr(0, 7), "scheme,");
  write("empty.csv", "scheme,precision,luts\n");
  expect_profile_refused("scene.toml --areas empty.csv", "only the header");
}

TEST_F(ProfileCommand, RefusesWhatCannotBeProfiled) {
  expect_profile_refused("scene.toml --first 3", "--first: received 3; accepted 4..52");
  expect_profile_refused("scene.toml --first 9 --last 8", "L = 9..8");
  expect_profile_refused("scene.toml --last 53", "--last: received 53; accepted 4..52");
  expect_profile_refused("scene.toml --samples -1", "--samples");
  expect_profile_refused("scene.toml --samples 0 --bounds profiled", "samples: the constants of");
  expect_profile_refused("scene.toml --threads 0", "--threads");
  write_scene("wide.toml", "binary128", "[data]\nitems = \"uniform_spheres\"\npairs = \"all\"\n");
  expect_profile_refused("wide.toml", "wide.toml: reference.format");
  write_scene("empty.toml", "binary64", "");
  expect_profile_refused("empty.toml", "empty.toml: data: a profile needs data");
  write_scene("narrow.toml", "binary32", "[data]\nitems = \"uniform_spheres\"\npairs = \"all\"\n");
  expect_profile_refused("narrow.toml --last 25", "accepted 4..24");
}

TEST_F(ProfileCommand, WritesNothingWhereItCannot) {
  write("file", "");
  expect_profile_refused("scene.toml -o file/out", "file/out: cannot be written");
}

}  // namespace
}  // namespace mixcmp::test::profile_command_test
