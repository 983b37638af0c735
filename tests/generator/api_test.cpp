#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "generator/faces/api/mixcmp.hpp"
#include "generator/faces/api/operands.hpp"
#include "model/base/number/double.hpp"
#include "model/base/number/exact.hpp"
#include "tests/support/program.hpp"

/// The public library: its results are those that the program prints and writes.
namespace mixcmp::test::api_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* spheres = R"(
[comparison]
name = "spheres"
f = "(cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2"
g = "(ri + rj)^2"
[inputs]
"c*" = { range = [0, 100] }
"r*" = { range = [0, 100] }
[reference]
format = "s53e8"
[reduced]
format = "s8e8"
[system]
lanes = 2
references = 1
)";
constexpr const char* sphere_data = R"(
[data]
items = "uniform_spheres"
count = 40
radius_max = 25
pairs = "all"
)";

class Api : public ProgramTest {
protected:
  Api() { write("scene.toml", std::string(spheres) + sphere_data); }

  api::Scene scene(const std::vector<std::string>& settings = {}) {
    return api::Scene::from_file(path("scene.toml"), settings);
  }

  /// Expects `run` to throw an Error with this field whose text contains `words`.
  template <class Run>
  static void expect_error(Run run, const std::string& field, const std::string& words) {
    try {
      run();
      ADD_FAILURE() << "no error; expected " << field;
    } catch (const api::Error& error) {
      EXPECT_EQ(error.details().field, field);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
};

/// "relative 8 17 0", a line for each count of `mixcmp profile --json`.
std::string counts_of(const nlohmann::json& report) {
  std::ostringstream text;
  for (const auto& scheme : report.at("recomputation_rates").at(0).at("schemes")) {
    for (const auto& counts : scheme.at("precisions")) {
      text << scheme.at("scheme").get<std::string>() << " " << counts.at("precision") << " "
           << counts.at("undecided") << " " << counts.at("wrong") << "\n";
    }
  }
  return text.str();
}

/// The nearest number of a format by exact rational arithmetic.
double nearest_exactly(FloatFormat format, double value) {
  const Bits bits = from_rational(format, mpq_class(std::fabs(value)));
  return std::copysign(to_double(format, bits), value);
}

TEST(ApiOperands, EveryMidpointAndNeighbourRoundsAsExactArithmeticDoes) {
  for (const char* name : {"s2e2", "s3e4", "s5e3", "s8e8", "E4M3"}) {
    const FloatFormat format = *OperandFormat::parse(name)->floating();
    for (Bits bits = 0; bits <= format.largest_finite(false); ++bits) {
      const double low = to_double(format, bits), high = to_double(format, bits + 1);
      const double step = low - to_double(format, bits - (bits > 0 ? 1 : 0));
      const double middle = std::isfinite(high) ? low + (high - low) / 2 : low + step / 2;
      for (const double value : {low, middle, std::nextafter(middle, 0.0),
                                 std::nextafter(middle, std::numeric_limits<double>::max())}) {
        const double expected = nearest_exactly(format, value);
        const auto operand = api::nearest_operand(format, -value);
        if (!std::isfinite(expected)) {
          EXPECT_FALSE(operand.has_value()) << name << " " << value;
          continue;
        }
        ASSERT_TRUE(operand.has_value()) << name << " " << value;
        EXPECT_EQ(operand->value, -expected) << name << " " << value;
        EXPECT_EQ(operand->bits, from_double(format, -expected)) << name << " " << value;
      }
    }
  }
}

TEST(ApiOperands, AFormatWithoutInfinitiesTakesNone) {
  const FloatFormat e4m3 = *OperandFormat::parse("E4M3")->floating();
  for (const double value : {465.0, 500.0, -512.0, 1e300, double{INFINITY}, -double{INFINITY}}) {
    EXPECT_FALSE(api::nearest_operand(e4m3, value).has_value()) << value;
  }
  EXPECT_EQ(api::nearest_operand(e4m3, -464)->value, -448);
  EXPECT_EQ(api::nearest_operand(e4m3, NAN)->bits, e4m3.quiet_nan());
}

TEST(ApiOperands, DoublesRoundIntoWideFormatsAsExactArithmeticDoes) {
  std::mt19937_64 random(1);
  for (const char* name : {"s53e8", "s24e11", "s53e11", "s60e8", "s113e15", "s20e15"}) {
    const FloatFormat format = FloatFormat::parse(name).value();
    for (int k = 0; k < 2000; ++k) {
      const int span = k % 2 == 0 ? 300 : 2040;
      const double value = std::ldexp(static_cast<double>(random() >> 11) * 0x1p-53,
                                      static_cast<int>(random() % span) - span / 2);
      const auto operand = api::nearest_operand(format, value);
      const Bits expected = from_rational(format, mpq_class(value));
      ASSERT_EQ(operand.has_value(), !format.is_infinite(expected)) << name << " " << value;
      if (!operand) continue;
      EXPECT_EQ(operand->bits, expected) << name << " " << value;
    }
    for (const double value : {0.0, -0.0, double{INFINITY}, -double{INFINITY}}) {
      EXPECT_EQ(api::nearest_operand(format, value)->bits, from_double(format, value)) << name;
    }
    EXPECT_EQ(api::nearest_operand(format, NAN)->bits, format.quiet_nan()) << name;
  }
}

TEST_F(Api, ItsFilesAreThoseOfTheProgram) {
  ASSERT_EQ(mixcmp("generate scene.toml --set system.lanes=3 --no-prove -o program").exit_code, 0);
  const api::System system(scene({"system.lanes=3"}));
  system.write(path("library"));
  const Outcome difference =
      shell("diff -r '" + path("program").string() + "' '" + path("library").string() + "'");
  EXPECT_EQ(difference.exit_code, 0) << difference.output;
  EXPECT_FALSE(system.files().empty());
  EXPECT_EQ(system.lane_count(), 3);
  EXPECT_EQ(system.reference_count(), 1);
  EXPECT_TRUE(system.certified());
}

TEST_F(Api, EmulatorAndGoldenModelAgreeAndAreNeverWrong) {
  for (const char* format : {"s8e8", "s17e8", "q9"}) {
    const api::Scene given = scene({std::string("reduced.format=") + format});
    const std::vector<double> rows = given.operands(0, given.comparison_count());
    const api::System system(given);
    const auto answers = system.emulate(rows);
    EXPECT_EQ(answers, system.evaluate(rows)) << format;
    const auto truth = given.true_verdicts(rows);
    ASSERT_EQ(answers.size(), truth.size());
    std::size_t decided = 0;
    for (std::size_t k = 0; k < truth.size(); ++k) {
      EXPECT_FALSE(answers[k].is_undecided());
      if (answers[k].is_recomputed()) continue;
      ++decided;
      EXPECT_EQ(answers[k].verdict(), truth[k]) << format << " " << k;
    }
    EXPECT_GT(decided, truth.size() / 2) << format;
  }
}

TEST_F(Api, WithoutReferencesAComparisonStaysUndecided) {
  const api::System system(
      api::Scene::from_text(spheres, {"system.references=0", "reduced.format=s8e8"}));
  const std::vector<double> tie = {0, 3, 0, 4, 0, 0, 2, 3};  // f = g = 25
  ASSERT_EQ(system.emulate(tie).size(), 1U);
  EXPECT_TRUE(system.emulate(tie)[0].is_undecided());
  const api::System recomputes(api::Scene::from_text(spheres));
  EXPECT_EQ(recomputes.emulate(tie)[0], api::Answer(api::Answer::recomputed_bit | 1));
}

TEST_F(Api, RowsReplaceTheData) {
  const api::Scene given = scene();
  const std::vector<double> rows = given.operands(3, 5);
  const api::Scene replaced = given.with_operands(rows);
  EXPECT_EQ(replaced.comparison_count(), 5U);
  EXPECT_EQ(replaced.operands(0, 5), rows);
  EXPECT_EQ(given.comparison_count(), 780U);
  EXPECT_EQ(replaced.inputs().size(), 8U);
}

TEST_F(Api, TheProfileHasTheCountsOfTheProgram) {
  const api::Profile counted = profile(scene(), {.first_precision = 8, .last_precision = 10});
  const auto printed =
      nlohmann::json::parse(mixcmp("profile scene.toml --first 8 --last 10 --json").output);
  EXPECT_EQ(counted.comparisons, 780U);
  std::ostringstream text;
  for (const api::Scheme& scheme : counted.schemes) {
    for (const api::Counts& counts : scheme.counts) {
      text << scheme.name << " " << counts.precision << " " << counts.undecided << " "
           << counts.wrong << "\n";
    }
  }
  EXPECT_NE(text.str().find("relative 8 "), std::string::npos) << text.str();
  EXPECT_EQ(text.str(), counts_of(printed));
}

TEST_F(Api, TheSimulationHasTheReportOfTheProgram) {
  const auto without_times = [](const std::string& text) {
    auto report = nlohmann::json::parse(text);
    for (const char* time : {"build_seconds", "run_seconds"}) report.erase(time);
    return report;
  };
  std::vector<std::string> lines;
  const api::Verification run =
      verify(scene({"reduced.format=s5e8"}),
             {.simulator = api::Simulator::icarus,
              .traffic = api::Traffic::stressed,
              .truth = api::Truth::all,
              .sample = 60,
              .seed = 3,
              .work = path("work"),
              .progress = [&](const std::string& line) { lines.push_back(line); }});
  EXPECT_TRUE(run.passed) << run.text;
  EXPECT_EQ(run.comparisons, 60U);
  EXPECT_GT(run.recomputations, 0U);
  EXPECT_EQ(run.mismatches + run.violations + run.undecided, 0U);
  EXPECT_TRUE(run.not_done.empty()) << run.not_done.front();
  ASSERT_FALSE(lines.empty());
  EXPECT_NE(lines.back().find("60 of 60 comparisons"), std::string::npos) << lines.back();
  const Outcome printed = mixcmp(
      "verify scene.toml --format s5e8 --simulator icarus --traffic stressed --truth all "
      "--sample 60 --seed 3 --work work --json 2>/dev/null");
  EXPECT_EQ(without_times(run.json), without_times(printed.output));
}

TEST_F(Api, SimulationsThatCannotBeMadeAreMistakes) {
  const api::VerifyOptions icarus{.simulator = api::Simulator::icarus, .work = path("work")};
  const auto with = [&](auto change) {
    api::VerifyOptions options = icarus;
    change(options);
    return [options, this] { verify(scene(), options); };
  };
  expect_error([&] { verify(api::Scene::from_text(spheres), icarus); }, "data",
               "[data] with items or file, or with_operands");
  expect_error(with([](auto& options) { options.only = 780; }), "only", "an index below 780");
  expect_error(with([](auto& options) { options.first = 0; }), "first", "at least 1");
  expect_error(with([](auto& options) { options.first = options.sample = 1; }),
               "first, sample, only", "received 2");
  expect_error(with([](auto& options) { options.resets = -1; }), "resets", "0..1000000");
  expect_error(with([](auto& options) { options.jobs = 1025; }), "jobs", "0..1024");
  expect_error(with([](auto& options) { options.work = "a\"b"; }), "work", "a path without these");
  EXPECT_FALSE(fs::exists(path("work"))) << "a mistake is found before anything is written";
}

TEST_F(Api, ASimulationOfTheCallersRowsNamesNoCommand) {
  const api::Scene given = scene().with_operands(scene().operands(0, 20));
  const api::Verification run =
      verify(given, {.simulator = api::Simulator::icarus, .work = path("work")});
  EXPECT_TRUE(run.passed) << run.text;
  EXPECT_EQ(run.comparisons, 20U);
  EXPECT_EQ(run.text.find("mixcmp verify"), std::string::npos) << run.text;
}

/// Areas that are made up; a lane of 12 digits is dearer than one of 8.
constexpr const char* table =
    "# device: virtex6-lx760\n# scene: spheres\n# command: made up\n# target_mhz: 250\n"
    "kind,name,format,inputs,bound,multipliers,initiation_interval,ports,latency_cycles,luts,"
    "registers,dsps,memories,carries,shift_luts,mhz,low_mhz,high_mhz,seeds,clock_source,timing_"
    "seeds,hash,tools\n"
    "lane,,s8e8,exact,relative,embedded,0,0,20,2000,2000,4,0,0,0,,,,,,0,00,made up\n"
    "lane,,s12e8,exact,relative,embedded,0,0,20,2500,2500,4,0,0,0,,,,,,0,00,made up\n"
    "reference,,s53e8,,,embedded,1,0,30,8000,8000,40,0,0,0,,,,,,0,00,made up\n"
    "fifo,,,,,,0,64,0,300,300,0,0,0,0,,,,,,0,00,made up\n"
    "crossbar,,,,,,0,1,0,10,10,0,0,0,0,,,,,,0,00,made up\n"
    "crossbar,,,,,,0,256,0,2000,2000,0,0,0,0,,,,,,0,00,made up\n";

TEST_F(Api, ThePlanIsThatOfTheProgram) {
  fs::create_directories(path("characterisation"));
  write("characterisation/scene-virtex6-lx760.csv", table);
  const api::Plan found = plan(scene(), {.last_precision = 14});
  ASSERT_TRUE(found.best.has_value()) << found.text;
  const Outcome printed =
      mixcmp("optimise scene.toml --table characterisation --last 14 -o program.toml 2>/dev/null");
  EXPECT_EQ(printed.output, found.text + "plan: program.toml\n");
  EXPECT_EQ(found.points.size(), 2U);
  EXPECT_GT(found.best->throughput_per_s, found.baseline_per_s);
  EXPECT_GT(found.best->lanes, found.best->references);
  ASSERT_FALSE(found.notes.empty());
  EXPECT_NE(found.notes[0].find("other RTL"), std::string::npos) << found.notes[0];
  write("plan.toml", found.toml);
  const api::System system(api::Scene::from_file(path("plan.toml")));
  EXPECT_EQ(system.lane_count(), found.best->lanes);
  EXPECT_EQ(system.reference_count(), found.best->references);
  EXPECT_EQ(found.toml.find(path("").string()), std::string::npos) << "an absolute path";
}

TEST_F(Api, OutputsNameACommandOnlyWhereOneMakesThemAgain) {
  const auto text_of = [](const api::Scene& scene) {
    const api::System system(scene);  // outlives the loop over its files
    std::string text;
    for (const api::File& file : system.files()) text += file.text;
    return text;
  };
  EXPECT_NE(text_of(scene()).find("mixcmp generate scene.toml\n"), std::string::npos);
  const std::string from_text = text_of(api::Scene::from_text(spheres));
  EXPECT_NE(from_text.find("the library of mixcmp, of a scene from a text\n"), std::string::npos);
  EXPECT_EQ(from_text.find("mixcmp generate"), std::string::npos) << from_text;
  write("table.csv", table);
  const api::Scene given = scene().with_operands(scene().operands(0, 100));
  const std::string plan_text = plan(given, {.table = path("table.csv")}).toml;
  EXPECT_NE(plan_text.find("the library of mixcmp, on 100 comparisons that its caller gave"),
            std::string::npos)
      << plan_text;
  EXPECT_EQ(plan_text.find("mixcmp optimise"), std::string::npos) << plan_text;
  expect_error([&] { plan(api::Scene::from_text(std::string(spheres) + sphere_data)); }, "table",
               "a scene from a text has no table");
}

TEST_F(Api, NumbersBeyondTheirLimitsAreMistakes) {
  fs::create_directories(path("characterisation"));
  write("characterisation/scene-virtex6-lx760.csv", table);
  for (const double mhz : {0.0, -1.0, std::nan(""), double{INFINITY}, 1e-4, 2e6}) {
    expect_error([&] { plan(scene(), {.lane_mhz = mhz}); }, "lane_mhz", "0.001..1000000");
    expect_error([&] { plan(scene(), {.reference_mhz = mhz}); }, "reference_mhz", "0.001..1000000");
  }
  expect_error([&] { plan(scene(), {.first_precision = 3}); }, "first_precision", "4..52");
  expect_error([&] { plan(scene(), {.last_precision = 53}); }, "last_precision", "4..52");
  expect_error([&] { plan(scene(), {.first_precision = 9, .last_precision = 8}); },
               "first_precision", "received 9; accepted at most 8");
  expect_error([&] { profile(scene(), {.first_precision = 3}); }, "first precision, last precision",
               "L = 3..");
  expect_error([&] { profile(scene(), {.error_samples = ~std::uint64_t{0}}); }, "error_samples",
               "0..");
  expect_error([&] { profile(scene(), {.threads = 1025}); }, "threads", "0..1024");
}

TEST_F(Api, MistakesNameTheirPlace) {
  write("wrong.toml",
        "[comparison]\nname = \"a\"\nf = \"x\"\ng = \"y\"\n[reference]\n"
        "format = \"s53e8\"\n[reduced]\nformat = \"s99e8\"\n");
  try {
    api::Scene::from_file(path("wrong.toml"));
    ADD_FAILURE();
  } catch (const api::Error& error) {
    EXPECT_EQ(error.details().line, 8);
    EXPECT_EQ(error.details().field, "reduced.format");
    EXPECT_EQ(error.details().received, "\"s99e8\"");
    EXPECT_TRUE(
        mixcmp("check wrong.toml")
            .output.ends_with(std::string(error.what()).substr(path("").string().size()) + "\n"));
  }
  expect_error([&] { api::Scene::from_text(spheres, {"system.lans=2"}); }, "system.lans", "--set");
  expect_error([&] { scene().with_operands(std::vector<double>(9)); }, "operands", "9 numbers");
  expect_error([&] { scene().with_operands(std::vector<double>(8, 1e200)); },
               "operands, row 0, cxi", "s53e8");
  expect_error([&] { scene().with_operands({}); }, "operands", "nothing to compare");
  expect_error([&] { scene().operands(775, 6); }, "operands", "780");
  expect_error([&] { profile(api::Scene::from_text(spheres)); }, "data", "needs data");
  expect_error([&] { api::System(scene()).emulate({}, 1); }, "group", "0 to 0");
  expect_error([&] { api::System(scene()).write(""); }, "folder", "accepted the path of a folder");
  expect_error([&] { plan(scene()); }, "table", "mixcmp characterise");
  expect_error([&] { api::System(api::Scene::from_text(spheres, {"reduced.format=auto"})); },
               "reduced.format", "--set: ");
  expect_error([&] { api::Scene::from_text(std::string(spheres) + "[data]\nitems = \"none\"\n"); },
               "data.items", "(text):17: ");
}

TEST_F(Api, DataThatDoubleDoesNotHoldAreNotHandedOutRounded) {
  write("wide.csv", "cxi,cxj,cyi,cyj,czi,czj,ri,rj\n0,3,0,4,0,0,2,3\n0,3,0,4,0,0,2,0.1\n");
  const std::string text = std::string(spheres) + "[data]\nfile = \"wide.csv\"\n";
  const api::Scene wide = api::Scene::from_text(text, {"reference.format=binary128"}, path(""));
  EXPECT_EQ(wide.operands(0, 1).back(), 3);
  expect_error([&] { wide.operands(1, 1); }, "operands, row 0, rj", "a number of s113e15");
}

TEST_F(Api, ATextFindsItsDataInTheFolder) {
  write("pairs.csv", "cxi,cxj,cyi,cyj,czi,czj,ri,rj\n0,3,0,4,0,0,2,3\n");
  const std::string text = std::string(spheres) + "[data]\nfile = \"pairs.csv\"\n";
  EXPECT_EQ(api::Scene::from_text(text, {}, path("")).comparison_count(), 1U);
  expect_error([&] { api::Scene::from_text(text, {}, path("elsewhere")); }, "data.file",
               "pairs.csv");
}

}  // namespace
}  // namespace mixcmp::test::api_test
