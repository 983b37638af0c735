#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "model/judge/workload/load_comparisons.hpp"
#include "tests/support/scratch_directory.hpp"

/// Tests the errors about mistakes in [data]: those of a key, wherever it is set, and those of a
/// table.
namespace mixcmp::test::data_mistakes_test {
namespace {

class DataMistakes : public testing::Test {
protected:
  DataMistakes() {
    write("points.csv", "x,y,phi\n1,2,3\n4,5,6\n");
    write("centres.csv", "c,d\n7,8\n9,1\n");
    write("one.csv", "c,d\n7,8\n");
    write("atom.pdb",
          "ATOM      1  N   MET A   1      11.000  12.000  13.000  1.00 10.00           N\n");
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_.path() / name, std::ios::binary) << text;
  }

  /// The error of a scene whose [data] is in line 6 and whose keys follow. If a plan is given, the
  /// plan is read.
  std::string error(const std::string& f, const std::string& g, const std::string& data,
                    const std::vector<std::string>& settings = {},
                    const std::string& plan = {}) const {
    write("scene.toml", "reference.format = \"binary64\"\n[comparison]\nname = \"n\"\nf = \"" + f +
                            "\"\ng = \"" + g + "\"\n[data]\n" + data);
    if (!plan.empty()) write("plan.toml", "scene = \"scene.toml\"\n" + plan);
    const Result<data::Comparisons> loaded =
        load(plan.empty() ? "scene.toml" : "plan.toml", settings);
    EXPECT_FALSE(loaded.ok());
    std::string text = loaded.ok() ? "" : loaded.error().to_string();
    const std::string path = directory_.path().string() + "/";
    for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path)) {
      text.erase(at, path.size());
    }
    return text;
  }

  Result<data::Comparisons> load(const std::string& file,
                                 const std::vector<std::string>& settings) const {
    const Result<scene::Scene> scene = scene::load_scene(directory_.path() / file, settings);
    if (!scene.ok()) return scene.error();
    return workload::load_comparisons(*scene);
  }

private:
  test::ScratchDirectory directory_;
};

const std::string arg_min = "file = \"points.csv\"\nwith = \"centres.csv\"\npairs = \"arg_min\"\n";

TEST_F(DataMistakes, TwoNamesOfOneColumn) {
  const std::string rows = "file = \"points.csv\"\n";
  EXPECT_EQ(error("p[0]", "p[1]", rows + "[data.columns]\np = [\"x\", \"y\"]\np_0 = \"y\"\n"),
            "scene.toml:10: data.columns.p_0: a second column for p_0: received data.columns.p_0 "
            "beside data.columns.p; accepted one of them");
  EXPECT_EQ(error("p[0]", "y", rows + "columns = { \"p[0]\" = \"x\", p_0 = \"y\" }\n"),
            "scene.toml:8: data.columns.p_0: a second column for p_0: received data.columns.p_0 "
            "beside data.columns.p[0]; accepted one of them");
}

TEST_F(DataMistakes, KeysOfColumnsAreNamesOrSubscripts) {
  EXPECT_EQ(error("p[0]", "y", "file = \"points.csv\"\ncolumns = { \"p[0\" = \"x\" }\n"),
            "scene.toml:8: data.columns.p[0: a bracket without its other half: received \"p[0\"; "
            "accepted \"p[2]\", the pattern \"p[*]\", or the name p_2");
  EXPECT_EQ(error("p[0]", "y", "file = \"points.csv\"\ncolumns = { p = [] }\n"),
            "scene.toml:8: data.columns.p: not a column: received an array of 0; accepted the "
            "name of a column, its number counted from 0, or a list of these");
}

TEST_F(DataMistakes, AMissingColumnIsToldWithItsInputAndTheRule) {
  const std::string rule =
      ", which the input phi needs: an input ending in i or j is of a candidate of ";
  EXPECT_EQ(error("phi * ci", "phi * cj", arg_min),
            "centres.csv:1: ph: no such column" + rule +
                "centres.csv, any other of a row of points.csv: received nothing; accepted c, d");
  EXPECT_EQ(error("phi * cxi", "phi * cxj", arg_min, {"data.with=atom.pdb"}),
            "--set: data.with: no column ph" + rule +
                "atom.pdb, any other of a row of points.csv: received nothing in atom.pdb; "
                "accepted cx, cy, cz, r");
  EXPECT_EQ(error("xi", "qj", "file = \"points.csv\"\nwith = \"centres.csv\"\npairs = \"cross\"\n"),
            "centres.csv:1: q: no such column, which the input qj needs: an input ending in i is "
            "of an item of points.csv, in j of centres.csv: received nothing; accepted c (the "
            "nearest), d");
  EXPECT_EQ(
      error("x", "z", "file = \"points.csv\"\n"),
      "points.csv:1: z: no such column, which the input z needs: received nothing; accepted x "
      "(the nearest), y, phi");
  EXPECT_EQ(
      error("qi", "qj", "items = \"uniform_spheres\"\npairs = \"all\"\n"),
      "scene.toml:7: data.items: no column q, which the input qi needs: an input ending in i "
      "or j is of an item of uniform_spheres: received nothing in uniform_spheres; accepted r (the "
      "nearest), cx, cy, cz");
}

TEST_F(DataMistakes, AFileThatCannotBeReadIsAMistakeOfItsKey) {
  EXPECT_EQ(error("x * ci", "x * cj",
                  "file = \"points.csv\"\nwith = \"none.csv\"\npairs = \"arg_min\"\n"),
            "scene.toml:8: data.with: cannot read the file none.csv: received no such file; "
            "accepted a readable file");
  EXPECT_EQ(error("x * ci", "x * cj", arg_min, {}, "[data]\n\nfile = \"none.npy\"\n"),
            "plan.toml:4: data.file: cannot read the file none.npy: received no such file; "
            "accepted a readable file");
  EXPECT_EQ(error("x * ci", "x * cj", arg_min, {"data.with=none.pdb"}),
            "--set: data.with: cannot read the file none.pdb: received no such file; accepted a "
            "readable file");
}

TEST_F(DataMistakes, StandWhereTheWrongKeyIsSet) {
  const std::string item =
      ": received x; accepted a column's name followed by i or j, then "
      "subscripts";
  const std::string message = "data.pairs: with pairs, inputs are columns of item i or item j";
  const std::string rows = "file = \"points.csv\"\n\n";
  EXPECT_EQ(error("x", "y", rows + "pairs = \"all\"\n"), "scene.toml:9: " + message + item);
  EXPECT_EQ(error("x", "y", rows, {}, "[data]\npairs = \"all\"\n"),
            "plan.toml:3: " + message + item);
  EXPECT_EQ(error("x", "y", rows, {"data.pairs=all"}), "--set: " + message + item);
  EXPECT_EQ(error("p[0]", "p[1]", rows, {"data.columns.p=[\"x\"]"}),
            "--set: data.columns.p: no column for p_1: received a list of 1; accepted 2 columns "
            "or more");
  EXPECT_EQ(error("x", "y", rows, {}, "[data]\ncolumns = { z = \"x\" }\n"),
            "plan.toml:3: data.columns.z: no input needs such a column: received z; accepted x "
            "(the nearest), y");
  EXPECT_EQ(error("x", "y", rows, {"data.items=uniform_spheres"}).substr(0, 43),
            "--set: data.items: two sources of data: rec");
}

TEST_F(DataMistakes, UniformNumbersAreDrawnFromRanges) {
  const std::string uniform = "items = \"uniform\"\n", inputs = "[inputs]\nx = { range = ";
  const auto no_range = [](int line, const std::string& input) {
    return "scene.toml:" + std::to_string(line) + ": data.items: the input " + input +
           " has no range to draw from: received \"uniform\"; accepted " + input +
           " = { range = [low, high] } in [inputs], or data from a file";
  };
  EXPECT_EQ(error("x", "y", uniform), no_range(7, "x"));
  EXPECT_EQ(error("x", "y", uniform + inputs + "[0, 1] }\n"), no_range(7, "y"));
  EXPECT_EQ(error("x", "y", uniform + inputs + "\"data\" }\n"), no_range(7, "x"));
  EXPECT_EQ(error("xi", "xj",
                  uniform + "pairs = \"all\"\n[inputs]\nxi = { range = [0, 1] }\n" +
                      "xj = { range = [2, 3] }\n"),
            "scene.toml:7: data.items: s53e11 has no number to draw for the column x: received [2, "
            "1]; accepted a range that contains some of the format's numbers");
}

TEST_F(DataMistakes, UniformNumbersHaveNoKeysOfOtherData) {
  const std::string uniform = "items = \"uniform\"\n";
  EXPECT_EQ(error("x", "y", uniform + "radius_max = 2\n"),
            "scene.toml:8: data.radius_max: not used: numbers are drawn from the inputs' ranges: "
            "received 2; accepted no such key here, or items = \"uniform_spheres\" beside it");
  EXPECT_EQ(error("x", "y", uniform + "columns = { x = \"y\" }\n"),
            "scene.toml:8: data.columns: not used: columns have the inputs' names: received a "
            "table with the key \"x\"; accepted no such key here, or file in place of items");
  EXPECT_EQ(error("xi", "xj", uniform + "pairs = \"cross\"\nwith = \"one.csv\"\n"),
            "scene.toml:9: data.with: not used: both tables are drawn: received \"one.csv\"; "
            "accepted with_count beside items = \"uniform\", or file in place of items");
  EXPECT_EQ(error("x", "y", uniform + "with_count = 3\n"),
            "scene.toml:8: data.with_count: not used: no second table is drawn: received 3; "
            "accepted no such key here, or items = \"uniform\" with pairs = \"cross\" or "
            "\"arg_min\" beside it");
}

TEST_F(DataMistakes, TooFewRowsNameTheirFile) {
  EXPECT_EQ(error("x * ci", "x * cj", arg_min, {"data.with=one.csv"}),
            "--set: data.with: too few rows: received 1 rows in one.csv; accepted 2..2147483648 "
            "rows");
  EXPECT_EQ(error("ci", "cj", "file = \"one.csv\"\npairs = \"all\"\n"),
            "scene.toml:7: data.file: no such number of items can be paired: received 1 items in "
            "one.csv; accepted 2..2147483648 items");
  write("empty.csv", "x,y\n");
  EXPECT_EQ(error("x", "y", "file = \"empty.csv\"\n"),
            "scene.toml:7: data.file: nothing to compare: received 0 rows in empty.csv; accepted "
            "1..2147483648 rows");
}

TEST_F(DataMistakes, KeysThatTheSourceDoesNotUseAreRefused) {
  const std::string file = "file = \"points.csv\"\n", spheres = "items = \"uniform_spheres\"\n";
  for (const char* key : {"count", "side", "radius_max", "seed"}) {
    EXPECT_EQ(
        error("x", "y", file + key + " = 2\n"),
        std::string("scene.toml:8: data.") + key +
            ": not used: the data come from a file: received 2; accepted no such key here, or "
            "items in place of file beside it");
  }
  EXPECT_EQ(
      error("cxi", "cxj", "items = \"sphere_family\"\nfamily = \"tangent\"\nside = 2\n"),
      "scene.toml:9: data.side: not used: a family has its own sizes: received 2; accepted no "
      "such key here, or items = \"uniform_spheres\" beside it");
  EXPECT_EQ(error("x", "y", file + "family = \"tangent\"\n"),
            "scene.toml:8: data.family: only of items = \"sphere_family\": received \"tangent\"; "
            "accepted no family here");
  EXPECT_EQ(error("cxi", "cxj", spheres + "pairs = \"all\"\nwith = \"one.csv\"\n"),
            "scene.toml:9: data.with: a second file needs pairs that use it: received \"one.csv\"; "
            "accepted pairs = \"cross\" or \"arg_min\" beside it");
  EXPECT_EQ(error("cxi", "cxj", spheres + "pairs = \"all\"\nwith_columns = { x = \"y\" }\n"),
            "scene.toml:9: data.with_columns: names columns of no file: received no data.with; "
            "accepted with = \"file.csv\"");
  EXPECT_EQ(error("cxi", "cxj", spheres + "pairs = \"all\"\ncolumns = { q = \"cx\" }\n"),
            "scene.toml:9: data.columns.q: no input needs such a column: received q; accepted cx");
}

TEST_F(DataMistakes, AnArrayWithoutNamesNeedsNumbers) {
  const std::string dictionary =
      "{'descr': '<f8', 'fortran_order': False, 'shape': (0, 3), }                             "
      "                        \n";
  std::string header = "\x93NUMPY\x01";
  header += '\0';
  header += static_cast<char>(dictionary.size());
  header += '\0';
  write("plain.npy", header + dictionary);
  EXPECT_EQ(error("p[0] + r", "p[1]", "file = \"plain.npy\"\n"),
            "scene.toml:7: data.columns: the columns of a plain array have no names, and plain.npy "
            "is one: received no number for p_0, r, p_1; accepted the number of each one's column, "
            "counted from 0 and below 3, for example { p = [0, 2], r = 1 }");
  EXPECT_EQ(error("p[0] + r", "p[1]", "file = \"plain.npy\"\n\ncolumns = { p = [1, 2] }\n"),
            "scene.toml:9: data.columns: the columns of a plain array have no names, and plain.npy "
            "is one: received no number for r; accepted the number of each one's column, counted "
            "from 0 and below 3, for example { p = [1, 2], r = 0 }");
  EXPECT_EQ(error("ai", "bj",
                  "file = \"points.csv\"\ncolumns = { a = \"x\" }\nwith = \"plain.npy\"\n"
                  "pairs = \"cross\"\nwith_columns = { b = \"b\" }\n"),
            "scene.toml:11: data.with_columns.b: the columns of plain.npy have no names: received "
            "\"b\"; accepted a number below 3, the first column being 0");
  EXPECT_EQ(error("x", "y", "file = \"points.csv\"\n", {"data.columns.x=-1"}),
            "--set: data.columns.x: not a column: received -1; accepted the name of a column, its "
            "number counted from 0, or a list of these");
  EXPECT_EQ(
      error("x", "y", "file = \"points.csv\"\n", {"data.columns.x=[0, true]"}),
      "--set: data.columns.x: not a column: received true; accepted the name of a column, its "
      "number counted from 0, or a list of these");
}

TEST_F(DataMistakes, OverridesReachIntoTables) {
  EXPECT_EQ(error("p[0]", "p[1]", "file = \"points.csv\"\ncolumns = { p_1 = \"y\" }\n",
                  {"data.columns.p_0=z"}),
            "points.csv:1: z: no such column, which the input p_0 needs: received nothing; "
            "accepted x (the nearest), y, phi");
}

TEST(ComparisonProgress, CountsUpToAllComparisons) {
  const test::ScratchDirectory directory;
  std::string rows = "p\n";
  for (int row = 0; row < 5000; ++row) rows += std::to_string(row) + "\n";
  std::ofstream(directory.path() / "rows.csv") << rows;
  std::ofstream(directory.path() / "with.csv") << "c\n1\n2\n3\n";
  std::ofstream(directory.path() / "scene.toml")
      << "[comparison]\nname = \"n\"\nf = \"abs(p - ci)\"\ng = \"abs(p - cj)\"\n[reference]\n"
         "format = \"binary32\"\n[data]\nfile = \"rows.csv\"\nwith = \"with.csv\"\n"
         "pairs = \"arg_min\"\n";
  const Result<scene::Scene> scene = scene::load_scene(directory.path() / "scene.toml", {});
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  std::vector<std::uint64_t> told;
  const auto data = workload::load_comparisons(*scene, [&](std::uint64_t done, std::uint64_t all) {
    EXPECT_EQ(all, 10'000U);
    told.push_back(done);
  });
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  EXPECT_EQ(told, (std::vector<std::uint64_t>{4096, 8192, 9096, 10'000}));
}

/// Atoms are read in the reference's format first. E4M3 has no number for a coordinate of 999.
TEST_F(DataMistakes, CoordinatesThatAFormatWithoutInfinitiesLacksAreCounted) {
  write("atoms.pdb",
        "ATOM      1  N   MET A   1      11.000  12.000  13.000  1.00 10.00           N\n"
        "ATOM      2  N   MET A   1     999.000-465.000-448.000  1.00 10.00           N\n");
  write("scene.toml",
        "reference.format = \"binary64\"\n[comparison]\nname = \"n\"\n"
        "f = \"(cxi - cxj)^2 + (cyi - cyj)^2\"\ng = \"czi * czj\"\n"
        "[inputs]\n\"c*\" = { format = \"E4M3\" }\n"
        "[data]\nfile = \"atoms.pdb\"\npairs = \"all\"\n");
  const Result<data::Comparisons> loaded = load("scene.toml", {});
  ASSERT_TRUE(loaded.ok()) << loaded.error().to_string();
  const data::LostNumbers lost = data::lost_numbers_of(*loaded);
  EXPECT_EQ(lost.count, 2U);
  EXPECT_EQ(lost.first, "999 in atoms.pdb, row A 1 MET N, cx, read in E4M3");
}

/// Each number of an input in fixed point is one of its format.
TEST_F(DataMistakes, ANumberThatAnInputsFormatLacks) {
  write("numbers.csv", "x,y\n3,2\n3,16\n");
  const std::string rows = "file = \"numbers.csv\"\n[inputs]\nx = { format = \"uint4\" }\n";
  EXPECT_EQ(error("x", "y", rows + "y = { format = \"uint4\" }\n[reduced]\nformat = \"exact\"\n"),
            "numbers.csv: row of line 3, y: not a number of uint4, the format of the input y: "
            "received 16; accepted multiples of 1 from 0 to 15");
  write("numbers.csv", "x,y\n3,2.125\n3,-2\n");
  EXPECT_EQ(error("x", "y", rows + "y = { format = \"q1.2\" }\n[reduced]\nformat = \"exact\"\n"),
            "numbers.csv: row of line 2, y: not a number of q1.2, the format of the input y: "
            "received 2.125; accepted multiples of 0.25 from -2 to 1.75");
  write("numbers.csv", "x,y\n3,2\n3,nan\n");
  EXPECT_EQ(error("x", "y", rows + "y = { format = \"uint4\" }\n[reduced]\nformat = \"exact\"\n"),
            "numbers.csv: row of line 3, y: not a number of uint4, the format of the input y: "
            "received nan; accepted multiples of 1 from 0 to 15");
}

}  // namespace
}  // namespace mixcmp::test::data_mistakes_test
