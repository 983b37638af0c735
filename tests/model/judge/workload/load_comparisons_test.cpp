#include "model/judge/workload/load_comparisons.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "model/base/number/double.hpp"
#include "model/base/number/verdict.hpp"
#include "model/comparison/data/input_sources.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::load_comparisons_test {
namespace {

class TwoTables : public testing::Test {
protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_.path() / name, std::ios::binary) << text;
  }

  Result<data::Comparisons> load(const std::string& f, const std::string& g,
                                 const std::string& data,
                                 const std::string& format = "binary64") const {
    write("scene.toml", "[comparison]\nname = \"n\"\nf = \"" + f + "\"\ng = \"" + g +
                            "\"\n[reference]\nformat = \"" + format + "\"\n[data]\n" + data);
    const Result<scene::Scene> scene = scene::load_scene(directory_.path() / "scene.toml", {});
    if (!scene.ok()) return scene.error();
    return workload::load_comparisons(*scene);
  }

  std::string error(const std::string& f, const std::string& g, const std::string& data) const {
    const Result<data::Comparisons> loaded = load(f, g, data);
    EXPECT_FALSE(loaded.ok());
    if (loaded.ok()) return {};
    const std::string text = loaded.error().to_string();
    const std::string path = directory_.path().string() + "/";
    return text.starts_with(path) ? text.substr(path.size()) : text;
  }

private:
  test::ScratchDirectory directory_;
};

std::vector<double> operands(const data::Comparisons& data, std::uint64_t index) {
  std::vector<Bits> bits(data.input_count());
  data.fetch(index, bits);
  std::vector<double> values;
  for (const Bits one : bits) values.push_back(to_double(data.format(), one));
  return values;
}

/// A column that two inputs read has numbers that both allow; the tables differ.
TEST_F(TwoTables, MayBothBeDrawn) {
  const auto cross = load("xi + yi", "xj + yj",
                          "items = \"uniform\"\ncount = 3\nwith_count = 5\nseed = 9\n"
                          "pairs = \"cross\"\n[inputs]\nxi = { range = [0, 10], grid = 1 }\n"
                          "xj = { range = [5, 20], grid = 4 }\n\"y*\" = { range = [0, 1] }\n");
  ASSERT_TRUE(cross.ok()) << cross.error().to_string();
  ASSERT_EQ(cross->size(), 15u);
  EXPECT_NE(operands(*cross, 0)[1], operands(*cross, 0)[3]);
  for (std::uint64_t k = 0; k < 15; ++k) {
    const std::vector<double> row = operands(*cross, k);
    EXPECT_EQ(row[0], std::floor(row[0]));
    EXPECT_LE(row[0], 10);
    EXPECT_EQ(std::fmod(row[2], 4), 0);
    EXPECT_GE(row[2], 8);
    EXPECT_LE(row[2], 20);
  }
  const std::string pairs = "items = \"uniform\"\ncount = 50\npairs = \"all\"\n[inputs]\n";
  for (const char* ranges :
       {"xi = { range = [0, 10], grid = 1 }\nxj = { range = [5, 20], grid = 4 }\n",
        "xi = { range = [5, 20], grid = 4 }\nxj = { range = [0, 10], grid = 1 }\n"}) {
    const auto all = load("xi", "xj", pairs + ranges);
    ASSERT_TRUE(all.ok()) << all.error().to_string();
    ASSERT_EQ(all->size(), 50u * 49 / 2);
    for (std::uint64_t k = 0; k < all->size(); ++k) EXPECT_EQ(operands(*all, k)[0], 8);
  }
}

TEST_F(TwoTables, ColumnsHaveTheScenesNames) {
  write("points.csv", "name,width,height,size\na,1,2,3\nb,4,5,6\n");
  write("centres.csv", "x,y\n7,8\n");
  const auto cross = load("pi[0] + pi[1] * cj[1]", "ri",
                          "file = \"points.csv\"\nwith = \"centres.csv\"\npairs = \"cross\"\n"
                          "columns = { p = [\"height\", \"width\"], r = \"size\" }\n"
                          "with_columns = { c = [\"x\", \"y\"] }\n");
  ASSERT_TRUE(cross.ok()) << cross.error().to_string();
  ASSERT_EQ(cross->size(), 2U);
  EXPECT_EQ(operands(*cross, 1), (std::vector<double>{5, 4, 8, 6}));
  const auto rows = load("p[1]", "r",
                         "file = \"points.csv\"\ncolumns = { \"p[1]\" = \"size\", "
                         "r = \"width\" }\n");
  ASSERT_TRUE(rows.ok()) << rows.error().to_string();
  EXPECT_EQ(operands(*rows, 0), (std::vector<double>{3, 1}));
  const auto generated = load("pi[0]", "pj[1]",
                              "items = \"uniform_spheres\"\ncount = 3\npairs = \"all\"\n"
                              "columns = { p = [\"cx\", \"r\"] }\n");
  ASSERT_TRUE(generated.ok()) << generated.error().to_string();
}

TEST_F(TwoTables, EveryInputTellsItsColumn) {
  write("points.csv", "name,width,height,size\na,1,2,3\nb,4,5,6\n");
  write("centres.csv", "x,y\n7,8\n9,10\n");
  const auto told = [](const Result<data::Comparisons>& data,
                       const std::vector<std::string>& inputs) {
    EXPECT_TRUE(data.ok()) << (data.ok() ? "" : data.error().to_string());
    std::vector<std::string> lines;
    for (const data::InputSource& input : data::input_sources(*data, inputs)) {
      lines.push_back(input.input + " <- " + input.shown());
    }
    return lines;
  };
  const auto arg_min = load("p[0] * ci[0]", "p[0] * cj[0] + p[1]",
                            "file = \"points.csv\"\nwith = \"centres.csv\"\npairs = \"arg_min\"\n"
                            "columns = { p = [3, \"width\"] }\nwith_columns = { c = [1] }\n");
  EXPECT_EQ(told(arg_min, {"p_0", "ci_0", "cj_0", "p_1"}),
            (std::vector<std::string>{"p_0 <- column 3 \"size\" of points.csv, row",
                                      "ci_0 <- column 1 \"y\" of centres.csv, candidate i",
                                      "cj_0 <- column 1 \"y\" of centres.csv, candidate j",
                                      "p_1 <- column 1 \"width\" of points.csv, row"}));
  EXPECT_EQ(operands(*arg_min, 0), (std::vector<double>{3, 8, 10, 1}));
  const auto spheres =
      load("ri", "cyj", "items = \"uniform_spheres\"\ncount = 3\npairs = \"all\"\n");
  EXPECT_EQ(told(spheres, {"ri", "cyj"}),
            (std::vector<std::string>{"ri <- column 3 \"r\" of uniform_spheres, item i",
                                      "cyj <- column 1 \"cy\" of uniform_spheres, item j"}));
  const auto family = load("a", "b",
                           "items = \"sphere_family\"\nfamily = \"tangent\"\ncount = 2\n"
                           "columns = { a = \"rj\", b = 0 }\n");
  EXPECT_EQ(told(family, {"a", "b"}),
            (std::vector<std::string>{"a <- column 7 \"rj\" of sphere_family",
                                      "b <- column 0 \"cxi\" of sphere_family"}));
}

TEST_F(TwoTables, MistakesNameFileLineAndKey) {
  write("points.csv", "width,height\n1,2\n");
  write("centres.csv", "x,y\n7,8\n");
  const std::string both = "file = \"points.csv\"\nwith = \"centres.csv\"\n";
  EXPECT_EQ(error("ai", "aj", "file = \"points.csv\"\npairs = \"cross\"\n"),
            "scene.toml:7: data.with: required: received nothing; accepted a second file, for "
            "pairs = \"cross\"");
  EXPECT_EQ(error("a", "b", both),
            "scene.toml:9: data.with: a second file needs pairs that use it: received "
            "\"centres.csv\"; accepted pairs = \"cross\" or \"arg_min\" beside it");
  EXPECT_EQ(
      error("wi", "xj", both + "pairs = \"cross\"\ncolumns = { w = \"with\" }\n"),
      "points.csv:1: with: no such column, which the input wi needs: an input ending in i is of "
      "an item of points.csv, in j of centres.csv: received nothing; accepted width (the "
      "nearest), height");
  EXPECT_EQ(error("wi", "xj", both + "pairs = \"cross\"\ncolumns = { w = 3.5 }\n"),
            "scene.toml:11: data.columns.w: not a column: received 3.5; accepted the name of a "
            "column, its number counted from 0, or a list of these");
  EXPECT_EQ(error("widthi", "xj", both + "pairs = \"cross\"\nwith_columns = { w = \"x\" }\n"),
            "scene.toml:11: data.with_columns.w: no input needs such a column: received w; "
            "accepted x (the nearest)");
  EXPECT_EQ(error("pi[1]", "xj", both + "pairs = \"cross\"\ncolumns = { p = [\"width\"] }\n"),
            "scene.toml:11: data.columns.p: no column for p_1: received a list of 1; accepted 2 "
            "columns or more");
}

/// A file whose numbers lie on a small grid, so that costs tie. Some are NaN or infinite.
std::string random_csv(int rows, const std::string& header, int columns, bool special,
                       std::mt19937& random) {
  std::string text = header + "\n";
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto kind = special ? random() % 24 : 23;
      text += kind == 0   ? "nan"
              : kind == 1 ? "inf"
                          : fmt::format("{}", 0.1 + 0.125 * static_cast<double>(random() % 4));
      text += column + 1 < columns ? "," : "\n";
    }
  }
  return text;
}

std::vector<std::vector<double>> numbers_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  for (std::size_t line = csv.find('\n') + 1; line < csv.size(); line = csv.find('\n', line) + 1) {
    std::vector<double>& row = rows.emplace_back();
    std::size_t place = line;
    for (; csv[place] != '\n'; place += csv[place] == ',' ? 1 : 0) {
      char* end = nullptr;
      row.push_back(std::strtod(csv.data() + place, &end));
      place = static_cast<std::size_t>(end - csv.data());
    }
  }
  return rows;
}

double cost(const std::vector<double>& point, const std::vector<double>& centre) {
  const double x = point[0] - centre[0], y = point[1] - centre[1];
  return centre[2] * (x * x + y * y);
}

/// The first candidate of least cost. A cost that has no order neither beats another nor is beaten.
std::size_t least(const std::vector<double>& point, const std::vector<std::vector<double>>& all) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < all.size(); ++k) {
    if (cost(point, all[best]) > cost(point, all[k])) best = k;
  }
  return best;
}

const std::string arg_min_data =
    "file = \"points.csv\"\nwith = \"centres.csv\"\npairs = \"arg_min\"\n";

TEST_F(TwoTables, ArgMinIsThatOfBruteForceTiesAndNaNsIncluded) {
  std::mt19937 random(3);
  for (int round = 0; round < 40; ++round) {
    const int points = 1 + static_cast<int>(random() % 60), centres = 2 + round % 9;
    const std::string rows = random_csv(points, "p_0,p_1", 2, round % 2 == 0, random);
    const std::string candidates = random_csv(centres, "c_0,c_1,w", 3, round % 2 == 0, random);
    write("points.csv", rows);
    write("centres.csv", candidates);
    const auto data = load("wi * sum(k in 0..1, (p[k] - ci[k])^2)",
                           "wj * sum(k in 0..1, (p[k] - cj[k])^2)", arg_min_data);
    ASSERT_TRUE(data.ok()) << data.error().to_string();
    ASSERT_EQ(data->size(), static_cast<std::uint64_t>(points * (centres - 1)));
    const auto all = numbers_of(candidates);
    const auto point = numbers_of(rows);
    for (std::uint64_t row = 0; row < point.size(); ++row) {
      ASSERT_EQ(data->arg_min(row), least(point[row], all)) << "round " << round << " row " << row;
    }
  }
}

/// The comparisons, decided one after the other, choose the candidate of arg_min.
TEST_F(TwoTables, ArgMinFollowsFromTheVerdictsInAnyFormat) {
  std::mt19937 random(5);
  write("points.csv", random_csv(30, "p_0,p_1", 2, true, random));
  write("centres.csv", random_csv(7, "c_0,c_1,w", 3, true, random));
  for (const std::string format : {"binary128", "binary32", "s11e5", "s53e8"}) {
    const std::string f = "wi * sum(k in 0..1, (p[k] - ci[k])^2)";
    const std::string g = "wj * sum(k in 0..1, (p[k] - cj[k])^2)";
    const auto data = load(f, g, arg_min_data, format);
    ASSERT_TRUE(data.ok()) << data.error().to_string();
    Graph graph;
    const NodeId left = *parse_expression(graph, f, {});
    graph.compare(left, *parse_expression(graph, g, {}));
    const TypedGraph reference = reference_graph(graph, {FloatFormat::parse(format).value()});
    std::vector<Bits> bits(data->input_count());
    std::uint64_t index = 0;
    for (std::uint64_t row = 0; row < 30; ++row) {
      std::uint64_t best = 0;
      for (std::uint64_t j = 1; j < 7; ++j, ++index) {
        ASSERT_EQ(data->items(index), (data::Items{.row = row, .first = best, .second = j}))
            << format;
        data->fetch(index, bits);
        const auto verdict = golden::evaluate_reference(reference, bits);
        if (verdict == Verdict::greater) best = j;
      }
      EXPECT_EQ(data->arg_min(row), best) << format;
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::load_comparisons_test
