#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.hpp"

/// `mixcmp new`: the scene file that it writes, and its questions.
namespace mixcmp::test::new_command_test {
namespace {

namespace fs = std::filesystem;

class NewCommand : public ProgramTest {
protected:
  NewCommand() {
    write("points.csv", "x,y,r\n1,2,3\n4,5.5,6\n7,-8,0.5\n");
    write("others.csv", "x,y,d\n1,2,3\n4,5,6\n");
  }

  /// The output of `check --json` for a scene file.
  nlohmann::json checked(const std::string& scene) {
    const Outcome run = mixcmp("check " + scene + " --json");
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return nlohmann::json::parse(run.output, nullptr, false);
  }

  /// Runs the program on a terminal of its own, where a user types these lines.
  Outcome on_terminal(const std::string& lines, const std::string& arguments) {
    return shell(
        fmt::format("cd '{}' && printf '{}' | TERM=xterm script -qec \"'{}' {}\" /dev/null",
                    directory_.path().string(), lines, MIXCMP_PROGRAM, arguments));
  }
};

TEST_F(NewCommand, CheckAcceptsWhatItWritesAtOnce) {
  const Outcome run =
      mixcmp("new near --f '(xi - xj)^2 + (yi - yj)^2' --g '(ri + rj)^2' --data points.csv --json");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto report = nlohmann::json::parse(run.output);
  EXPECT_EQ(report.at("scene"), "near.toml");
  EXPECT_EQ(report.at("pairs"), "all") << "no column is called xi";
  EXPECT_EQ(report.at("comparisons"), 3);
  const std::string text = read("near.toml");
  EXPECT_NE(text.find("yj = { range = \"data\" }          # now -8 to 5.5\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("mixcmp optimise near.toml -o near_plan.toml"), std::string::npos);
  const auto scene = checked("near.toml");
  EXPECT_EQ(scene.at("name"), "near");
  EXPECT_EQ(scene.at("data").at("inputs").size(), 6u);
}

TEST_F(NewCommand, RowsAreComparisonsWhereInputsAreColumns) {
  const Outcome run = mixcmp(
      "new rows --f 'x * y' --g 'r' --data points.csv --device ecp5-85k "
      "--reference binary32");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("3 comparisons, pairs = rows"), std::string::npos) << run.output;
  EXPECT_NE(read("rows.toml").find("24 bits of significand, the leading one included, and 8 "),
            std::string::npos);
  EXPECT_EQ(read("rows.toml").find("\npairs = "), std::string::npos);
  EXPECT_NE(read("rows.toml").find("here 100.\n"), std::string::npos) << "the ECP5's";
  checked("rows.toml");
}

/// A .npy file of two-dimensional rows in C order, whose numbers are these bytes.
std::string npy(const std::string& type, int rows, int columns, const std::string& numbers) {
  const std::string header = fmt::format(
      "{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {})}}\n", type, rows, columns);
  return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' + header +
         numbers;
}

/// A .npy file of one row, whose integers have 8 bytes each.
std::string npy_of_int64(const std::vector<std::int64_t>& row) {
  std::string numbers(8 * row.size(), '\0');
  std::memcpy(numbers.data(), row.data(), numbers.size());
  return npy("<i8", 1, static_cast<int>(row.size()), numbers);
}

const std::string three_columns = " --column x=0 --column y=1 --column z=2";

TEST_F(NewCommand, OperandsArriveAsTheIntegersOfTheFile) {
  write("bytes.npy", npy("|i1", 2, 3, "\x01\x02\xfd\x04\x80\x7f"));
  const std::string data = " --data bytes.npy" + three_columns;
  ASSERT_EQ(mixcmp("new whole --f 'x * y' --g z" + data).exit_code, 0);
  const std::string text = read("whole.toml");
  EXPECT_NE(text.find("y = { format = \"int8\" }          # now -128 to 2\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("[reference]\nformat = \"exact\"\n"), std::string::npos) << text;
  const Outcome checked = mixcmp("check whole.toml");
  EXPECT_NE(checked.output.find("in hardware an exact lane in q7"), std::string::npos)
      << checked.output;

  const Outcome floats = mixcmp("new floats --reference s53e8 --f 'x * y' --g z" + data);
  EXPECT_EQ(floats.output.find("note"), std::string::npos) << "the user has said so";
  EXPECT_NE(read("floats.toml").find("x = { range = \"data\" }"), std::string::npos);
}

TEST_F(NewCommand, WhatTakesNoIntegersIsTold) {
  write("bytes.npy", npy("|i1", 2, 3, "\x01\x02\xfd\x04\x80\x7f"));
  write("singles.npy", npy("<f4", 1, 1, std::string("\0\0\x80\x3f", 4)));
  const Outcome quotient = mixcmp("new ratio --f 'x / y' --g z --data bytes.npy" + three_columns);
  ASSERT_EQ(quotient.exit_code, 0) << quotient.output;
  EXPECT_NE(quotient.output.find("note: the data have integers, but operands arrive in s53e8: "),
            std::string::npos)
      << quotient.output;
  checked("ratio.toml");
  const Outcome both = mixcmp(
      "new both --f xi --g yj --data bytes.npy --with singles.npy --column x=0 "
      "--with-column y=0");
  EXPECT_NE(both.output.find("not all columns have integers"), std::string::npos) << both.output;
  expect_refused("new half --reference exact --f x --g r --data points.csv",
                 "--reference: reference.format: exact references need operands in fixed point");
}

/// NumPy's integers have 64 bits, of which few are needed.
TEST_F(NewCommand, IntegersTooWideForAnExactLaneAreThoseThatTheDataNeed) {
  write("wide.npy", npy_of_int64({5, -900, 7}));
  ASSERT_EQ(mixcmp("new wide --f 'x - y' --g z --data wide.npy" + three_columns).exit_code, 0);
  EXPECT_NE(read("wide.toml").find("y = { format = \"int11\" }         # now -900 to -900\n"),
            std::string::npos)
      << read("wide.toml");
  write("widest.npy", npy_of_int64({5, (std::int64_t{1} << 60) + 1, 7}));
  const Outcome widest = mixcmp("new widest --f 'x - y' --g z --data widest.npy" + three_columns);
  ASSERT_EQ(widest.exit_code, 0) << widest.output;
  EXPECT_NE(widest.output.find("operands arrive in s53e8"), std::string::npos) << widest.output;
}

TEST_F(NewCommand, NumbersInSinglePrecisionMakeTheReferenceOne) {
  const auto reference = [&](const std::string& type, const std::string& numbers,
                             const std::string& options = "") {
    write("numbers.npy", npy(type, 1, 2, numbers));
    fs::remove(path("scene_of_numbers.toml"));
    const Outcome run = mixcmp(
        "new scene_of_numbers --f x --g y --data numbers.npy --column x=0 "
        "--column y=1 " +
        options);
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return checked("scene_of_numbers.toml").at("datapaths").at("reference").at("format");
  };
  EXPECT_EQ(reference("<f4", std::string("\0\0\x80\x3f\0\0\0\x40", 8)), "s24e8");
  EXPECT_EQ(reference("<f4", std::string("\0\0\x80\x3f\0\0\0\x40", 8), "--reference s53e11"),
            "s53e11");
  EXPECT_EQ(reference("<f2", std::string("\0\x3c\0\x40", 4)), "s24e8");
  EXPECT_EQ(reference("<f8", std::string("\0\0\0\0\0\0\xf0\x3f\0\0\0\0\0\0\0\x40", 16)), "s53e8");
}

TEST_F(NewCommand, NarrowFloatsArriveAsSuch) {
  write("halves.npy", npy("<f2", 1, 2, std::string("\0\x3c\0\x40", 4)));
  ASSERT_EQ(mixcmp("new halves --f x --g y --data halves.npy --column x=0 --column y=1").exit_code,
            0);
  EXPECT_NE(read("halves.toml").find("x = { format = \"s11e5\", range = \"data\" } # now 1 to 1\n"),
            std::string::npos)
      << read("halves.toml");
  checked("halves.toml");
}

TEST_F(NewCommand, WholeNumbersInTextLeaveTheChoice) {
  const std::string command = " --f '(x - y)^2' --g d --data others.csv";
  ASSERT_EQ(mixcmp("new whole" + command).exit_code, 0);
  EXPECT_NE(read("whole.toml").find("# \"*\" = { format = \"uint3\" }\n"), std::string::npos);
  ASSERT_EQ(mixcmp("new integers --reference exact" + command).exit_code, 0);
  EXPECT_NE(read("integers.toml").find("\nx = { format = \"uint3\" }"), std::string::npos);
  checked("integers.toml");
  ASSERT_EQ(mixcmp("new halves --f '(x - y)^2' --g r --data points.csv").exit_code, 0);
  EXPECT_EQ(read("halves.toml").find("are whole"), std::string::npos);
}

/// Only fixed point has functions. The reference's bits follow from the ranges, and every verb
/// takes the scene as it is.
TEST_F(NewCommand, FunctionsMakeReferencesInFixedPoint) {
  write("moves.csv", "u,d,beta\n0.5,1,1\n0.25,2.5,0.5\n0.75,0.3,1\n0.1,8,0.125\n0.3,1.2,1\n");
  const Outcome run =
      mixcmp("new annealing --f u --g 'exp(-d * beta)' --data moves.csv --device ecp5-85k");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const std::string text = read("annealing.toml");
  EXPECT_NE(text.find("d = { format = \"s24e8\", range = \"data\" }"), std::string::npos) << text;
  EXPECT_NE(text.find("[reference]\nformat = \"q"), std::string::npos) << text;
  EXPECT_NE(text.find("verify annealing_plan.toml"), std::string::npos) << text;
  checked("annealing.toml");
  const Outcome plan =
      mixcmp("optimise annealing.toml --predict-only --first 13 --last 13 -o annealing_plan.toml");
  ASSERT_EQ(plan.exit_code, 0) << plan.output;
  const Outcome profile = mixcmp("profile annealing.toml --first 12 --last 13");
  EXPECT_EQ(profile.exit_code, 0) << profile.output;
  const Outcome generated = mixcmp("generate annealing_plan.toml -o rtl --no-prove");
  EXPECT_EQ(generated.exit_code, 0) << generated.output;
}

/// Without data each input has some range, from which operands are drawn.
TEST_F(NewCommand, FunctionsHaveRangesWithoutData) {
  const std::vector<std::pair<std::string, std::string>> comparisons = {
      {"log(w1 * t1) - ((x - m1) * t1)^2 / 2", "log(w2 * t2) - ((x - m2) * t2)^2 / 2"},
      {"cosh(a - b) - cos(c - d)", "m"}};
  for (const auto& [f, g] : comparisons) {
    fs::remove(directory_.path() / "drawn.toml");
    const Outcome run = mixcmp("new drawn --f '" + f + "' --g '" + g + "'");
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const std::string text = read("drawn.toml");
    EXPECT_NE(text.find("range = [0.0625, 1] }"), std::string::npos) << text;
    EXPECT_EQ(checked("drawn.toml").at("data").at("comparisons"), 8192);
  }
}

TEST_F(NewCommand, TheUsersBitsAreTheReferences) {
  const Outcome run = mixcmp("new mine --f 'exp(x)' --g y --reference q33");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(read("mine.toml").find("format = \"q33\""), std::string::npos);
  const Outcome refused = mixcmp("new other --f 'exp(x)' --g y --reference s53e11");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.output.find("has no exp"), std::string::npos) << refused.output;
}

TEST_F(NewCommand, ASecondFileAndColumnsOfOtherNamesAreTakenOver) {
  fs::create_directories(path("scenes"));
  const Outcome run = mixcmp(
      "new far --f '(pi[0] - pj[0])^2 + (pi[1] - pj[1])^2' --g 'dj^2' --data points.csv "
      "--with others.csv --column p=x,y --with-column p=0,1 -o scenes/far.toml");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const std::string text = read("scenes/far.toml");
  EXPECT_NE(text.find("file = \"../points.csv\"\nwith = \"../others.csv\"\npairs = \"cross\"\n"
                      "columns = { p = [\"x\", \"y\"] }\nwith_columns = { p = [0, 1] }\n"),
            std::string::npos)
      << text;
  const auto scene = checked("scenes/far.toml");
  EXPECT_EQ(scene.at("data").at("comparisons"), 6);
}

/// A user who has not given --pairs is not told that --pairs is wrong.
TEST_F(NewCommand, AGuessedPairingIsNamedWithItsReason) {
  const std::string both = "new a --data points.csv --with others.csv --f 'x * y' --g ";
  const std::string guess =
      " (pairs = cross is a guess, since --with gives a second file; --pairs chooses): received x";
  expect_refused(both + "dj", "--with: data.pairs: ");
  expect_refused(both + "dj", guess);
  expect_refused("new a --data points.csv --f '(xi - xj)^2' --g zj",
                 "(pairs = all is a guess, since all inputs end in i or j; --pairs chooses)");
  expect_refused("new a --data points.csv --f '(xi - xj)^2' --g r",
                 "(pairs = rows is a guess, since not all inputs end in i or j; --pairs chooses)");
  const Outcome given = mixcmp(both + "dj --pairs cross");
  EXPECT_NE(given.output.find("--pairs: data.pairs: "), std::string::npos) << given.output;
  EXPECT_EQ(given.output.find("guess"), std::string::npos) << given.output;
  const Outcome plain = mixcmp("new a --data points.csv --f x --g z");
  EXPECT_EQ(plain.output.find("guess"), std::string::npos) << plain.output;
}

TEST_F(NewCommand, WithoutDataTheSceneStillReads) {
  ASSERT_EQ(mixcmp("new bare --f 'x^2' --g 'y'").exit_code, 0);
  EXPECT_NE(read("bare.toml").find("# y = { range = [0, 100] }\n"), std::string::npos);
  checked("bare.toml");
}

TEST_F(NewCommand, TheNextCommandsWorkFromWhereTheUserStands) {
  fs::create_directories(path("a folder"));
  const Outcome run =
      mixcmp("new near --f x --g y --data points.csv -o 'a folder/near.toml' --json");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto next = nlohmann::json::parse(run.output).at("next");
  ASSERT_EQ(next.size(), 5u);
  EXPECT_EQ(next[0], "mixcmp check 'a folder/near.toml'");
  EXPECT_EQ(next[1], "mixcmp optimise 'a folder/near.toml' -o 'a folder/near_plan.toml'");
  EXPECT_EQ(next[4], "mixcmp report 'a folder/near_plan.toml'");
  EXPECT_EQ(mixcmp(next[0].get<std::string>().substr(7)).exit_code, 0);
  EXPECT_EQ(read("a folder/near.toml").find("a folder"), std::string::npos)
      << "the file's head names the file as seen from its folder";
}

TEST_F(NewCommand, AFolderThatIsNotThereIsToldBeforeTheDataAreRead) {
  const Outcome run = mixcmp("new near --f x --g y --data points.csv -o nodir/near.toml");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.output.find("nodir"), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("--data"), std::string::npos) << run.output;
}

TEST_F(NewCommand, NeverReplacesAFile) {
  write("here.toml", "mine");
  expect_refused("new here --f x --g y --data points.csv", "here.toml: is not replaced");
  EXPECT_EQ(read("here.toml"), "mine");
}

TEST_F(NewCommand, AMistakeNamesItsOptionAndLeavesNoFile) {
  const std::string all = "new a --data points.csv ";
  expect_refused(all + "--f 'x + sqr(y)' --g r",
                 "--f: comparison.f: unknown function at character 5 of the text: received sqr; "
                 "accepted sqrt (the nearest)");
  expect_refused(all + "--f x --g '(y'", "--g: comparison.g: ");
  expect_refused(all + "--f x --g z", "z: no such column, which the input z needs");
  expect_refused(all + "--f xi --g zj --column z=w", "w: no such column, which the input zj needs");
  expect_refused(all + "--f x --g y --column z", "--column: no column: received \"z\"");
  expect_refused(all + "--f x --g y --device hx8k", "accepted ice40-hx8k, ice40hx8k, ");
  expect_refused(all + "--f x --g y --reference s9", "--reference: reference.format");
  expect_refused("new a --f x --g y --data none.csv", "--data: data.file: cannot read the file");
  expect_refused("new 9a --f x --g y", "NAME: comparison.name");
  expect_refused("new a --f x </dev/null", "--g: missing");
  EXPECT_FALSE(fs::exists(path("a.toml")));
}

TEST_F(NewCommand, AsksOnATerminalForWhatIsMissing) {
  if (shell("command -v script").exit_code != 0) GTEST_SKIP() << "no script(1), of bsdutils";
  const Outcome run = on_terminal("asked\\nx * w\\n\\nr\\npoints.csv\\nw=y\\n", "new");
  ASSERT_TRUE(fs::exists(path("asked.toml"))) << run.output;
  const std::string text = read("asked.toml");
  EXPECT_NE(text.find("f = \"x * w\"\ng = \"r\"\n"), std::string::npos) << text;
  EXPECT_NE(text.find("columns = { w = \"y\" }\n"), std::string::npos) << text;
  checked("asked.toml");
}

TEST_F(NewCommand, AsksAgainAfterAMistake) {
  if (shell("command -v script").exit_code != 0) GTEST_SKIP() << "no script(1), of bsdutils";
  write("taken.toml", "mine");
  const Outcome run = on_terminal(
      "9a\\ntaken\\nagain\\nx +\\nx * w\\nsqr(r)\\nr\\nnone.csv\\npoints.csv\\nw\\nw=y\\n", "new");
  for (const char* mistake :
       {"NAME: comparison.name", "taken.toml: is not replaced", "--f: comparison.f",
        "unknown function", "--data: data.file: cannot read", "--column: no column"}) {
    EXPECT_NE(run.output.find(mistake), std::string::npos) << mistake << "\n" << run.output;
  }
  ASSERT_TRUE(fs::exists(path("again.toml"))) << run.output;
  const std::string text = read("again.toml");
  EXPECT_NE(text.find("f = \"x * w\"\ng = \"r\"\n"), std::string::npos) << text;
  EXPECT_NE(text.find("columns = { w = \"y\" }\n"), std::string::npos) << text;
  EXPECT_EQ(read("taken.toml"), "mine");
}

TEST_F(NewCommand, ChecksItsOptionsBeforeItAsks) {
  if (shell("command -v script").exit_code != 0) GTEST_SKIP() << "no script(1), of bsdutils";
  const Outcome run = on_terminal("", "new early --f 'x +'");
  EXPECT_NE(run.output.find("--f: comparison.f"), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("g, the other side"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace mixcmp::test::new_command_test
