#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "generator/software/source.hpp"
#include "model/base/number/verdict.hpp"
#include "model/comparison/data/operand_source.hpp"
#include "model/comparison/data/sphere_family.hpp"
#include "model/judge/emulator/emulator.hpp"
#include "model/judge/workload/compare_by_reference.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "tests/generator/software_program.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/unproven_tie.hpp"

/// Software against the golden model and against the real numbers, comparison by comparison.
namespace mixcmp::test::software_test {
namespace {

constexpr std::string_view letters_of_verdicts = "<=>u";

char letter(Verdict verdict) {
  return letters_of_verdicts[static_cast<std::size_t>(verdict)];
}

struct Seen {
  std::uint64_t comparisons = 0, decided = 0;
};

/// Kernels in double give the golden model's verdicts; filters give the true verdict or none; long
/// runs count the verdicts of single comparisons. Returns one count of decisions for each filter.
std::vector<Seen> expect_right(CompiledSoftware& software, const data::Comparisons& data,
                               const std::string& what) {
  const auto doubles = reference_graph(software.scene().graph, {software::software_format()});
  const std::vector<software::KernelOutput> kernels = software.verdicts(data);
  EXPECT_EQ(kernels.size(), software.filters().filters.size() + 1);
  std::vector<Seen> seen(kernels.size() - 1);
  std::vector<Bits> operands(data.input_count());
  for (std::size_t k = 0; k < data.size(); ++k) {
    data.fetch(k, operands);
    EXPECT_EQ(kernels[0].letters[k], letter(golden::evaluate_reference(doubles, operands)))
        << what << ", comparison " << k;
    const char truth =
        letter(golden::true_verdict(software.scene().graph, software::software_format(), operands)
                   .value());
    for (std::size_t filter = 1; filter < kernels.size(); ++filter) {
      const char decided = kernels[filter].letters[k];
      ++seen[filter - 1].comparisons;
      if (decided == '?') continue;
      ++seen[filter - 1].decided;
      EXPECT_EQ(decided, truth) << what << ", comparison " << k << ", " << kernels[filter].name;
    }
  }
  const auto count = [&](char c) {
    return static_cast<std::uint64_t>(
        std::count(kernels[0].letters.begin(), kernels[0].letters.end(), c));
  };
  for (const software::KernelOutput& kernel : kernels) {
    EXPECT_EQ(kernel.verdicts,
              (software::VerdictCounts{count('<'), count('='), count('>'), count('u')}))
        << what << ", " << kernel.name;
  }
  return seen;
}

using Random = std::mt19937_64;

/// Rows of encodings: special ones, random ones of any scale, and neighbours of one another.
data::Table extreme_rows(const std::vector<std::string>& inputs, std::size_t count,
                         Random& random) {
  const FloatFormat format = software::software_format();
  const std::vector<Bits> special = special_encodings(format);
  data::Table table{.format = format, .columns = inputs};
  for (std::size_t row = 0; row < count; ++row) {
    const Bits near = random_encoding(format, random);
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const std::uint64_t choice = random() % 4;
      table.values.push_back(choice == 0   ? special[random() % special.size()]
                             : choice == 1 ? random_encoding(format, random)
                                           : random_encoding_near(format, near, random));
    }
  }
  return table;
}

Bits encoded(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

/// Numbers between 1/2 and 8 that differ by anything from a quarter to a last place of a double.
data::Table close_rows(const std::vector<std::string>& inputs, std::size_t count, Random& random,
                       bool any_sign) {
  data::Table table{.format = software::software_format(), .columns = inputs};
  std::uniform_real_distribution<double> around(0.5, 6);
  for (std::size_t row = 0; row < count; ++row) {
    const double base = around(random);
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const double step = std::ldexp(around(random), -static_cast<int>(random() % 52) - 5);
      const double value = base + (random() % 2 != 0 ? step : -step);
      table.values.push_back(encoded(any_sign && random() % 2 != 0 ? -value : value));
    }
  }
  return table;
}

/// Numbers of few digits between the ends of floats and slightly below, each of its own scale or
/// all of one scale. They and the values computed from them underflow or overflow.
data::Table wide_rows(const std::vector<std::string>& inputs, std::size_t count, Random& random) {
  constexpr int least = -154, scales = 274;
  data::Table table{.format = software::software_format(), .columns = inputs};
  const auto scale = [&] { return least + static_cast<int>(random() % scales); };
  for (std::size_t row = 0; row < count; ++row) {
    const int common = random() % 2 != 0 ? scale() : least + static_cast<int>(random() % 12);
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const auto digits = static_cast<double>(random() % 64);
      table.values.push_back(encoded(std::ldexp(digits, row % 2 != 0 ? common : scale())));
    }
  }
  return table;
}

/// Spheres whose squared distances are some last places of the smallest floats.
data::Table tiny_spheres(const std::vector<std::string>& inputs, std::size_t count,
                         Random& random) {
  data::Table table{.format = software::software_format(), .columns = inputs};
  for (std::size_t k = 0; k < count * inputs.size(); ++k) {
    table.values.push_back(encoded(std::ldexp(static_cast<double>(random() % 256), -80)));
  }
  return table;
}

const SoftwareScene sphere_scene = {.f = "(cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2",
                                    .g = "(ri + rj)^2"};

TEST(Software, FiltersNeverDecideSphereFamiliesWrongly) {
  SoftwareScene text = sphere_scene;
  text.inputs = "\"c*\" = { range = [-128, 128] }\n\"r*\" = { range = [0, 64] }\n";
  CompiledSoftware software(text);
  ASSERT_EQ(software.filters().filters.size(), 2u);
  for (const std::string& name : data::sphere_family_names()) {
    if (name.starts_with("near_tie_") && name != "near_tie_24" && name != "near_tie_23") continue;
    auto rows = data::sphere_family({.name = name, .count = 300}, software::software_format());
    ASSERT_TRUE(rows.ok()) << rows.error().to_string();
    const auto seen = expect_right(software, software.comparisons(*rows), name);
    if (name != "uniform") continue;
    for (const Seen& filter : seen) EXPECT_GE(filter.decided, filter.comparisons * 99 / 100);
  }
}

TEST(Software, RunningBoundsSurviveNearTiesAndUnderflow) {
  CompiledSoftware software(sphere_scene);
  ASSERT_EQ(software.filters().filters.size(), 1u);
  EXPECT_EQ(software.filters().filters[0].kind, BoundKind::running);
  auto rows =
      data::sphere_family({.name = "near_tie_24", .count = 4000}, software::software_format());
  const auto seen = expect_right(software, software.comparisons(*rows), "near_tie_24");
  EXPECT_LT(seen[0].decided, seen[0].comparisons);
  Random random(11);
  const auto tiny = tiny_spheres(software.scene().graph.inputs(), 2000, random);
  expect_right(software, software.comparisons(tiny), "tiny");
}

struct Case {
  const char* name;
  SoftwareScene scene;
};

class Expressions : public testing::TestWithParam<Case> {};

TEST_P(Expressions, AreComputedAsTheGoldenModelDoesAndNeverDecidedWrongly) {
  CompiledSoftware software(GetParam().scene);
  const std::vector<std::string>& inputs = software.scene().graph.inputs();
  Random random(7);
  expect_right(software, software.comparisons(extreme_rows(inputs, 3000, random)), "extreme");
  const auto seen = expect_right(
      software, software.comparisons(close_rows(inputs, 3000, random, false)), "close");
  for (const Seen& filter : seen) EXPECT_GT(filter.decided, filter.comparisons / 20);
  expect_right(software, software.comparisons(close_rows(inputs, 1000, random, true)), "signed");
  expect_right(software, software.comparisons(wide_rows(inputs, 2000, random)), "wide");
}

INSTANTIATE_TEST_SUITE_P(
    Software, Expressions,
    testing::Values(
        Case{"products", {"a * b", "c * d", "\"*\" = { range = [0.25, 16] }\n"}},
        Case{"quotients", {"(a - b) / (c + d)", "a / c - 0.1", "\"*\" = { range = [0.25, 16] }\n"}},
        Case{"divisors", {"a / (b - c)", "d * 0x1p24"}},
        Case{"large_divisors", {"a / (b * c)", "d"}},
        Case{"tiny_operands", {"a * 0x1p60 + b * 0x1p60", "c * 0x1p60"}},
        Case{"roots", {"sqrt(a * b - c * d)", "sqrt(abs(c)) + 0.7 * a"}},
        Case{"selections",
             {"min(1 / a, b)", "max(c, d) - abs(c)", "\"*\" = { range = [-32, 32] }\n"}},
        Case{"signed_zeros", {"1 / min(a, b)", "1 / max(b, a)"}},
        Case{"names", {"float + EOF", "columns * i + j^3", "\"*\" = { range = [-8, 8] }\n"}}),
    [](const auto& test) { return test.param.name; });

std::uint64_t at(const std::vector<std::uint64_t>& counts, Decision decision) {
  return counts[static_cast<std::size_t>(decision)];
}

/// All pairs through the emulator, which shares nothing with the program.
software::VerdictCounts emulated(const scene::Scene& scene, const data::Comparisons& data) {
  const emulator::Emulator reference(reference_graph(scene.graph, {software::software_format()}));
  const data::OperandSource source(data);
  data::OperandBlock block(data.input_count(), 1 << 14);
  std::vector<Decision> decisions(block.capacity());
  std::vector<std::uint64_t> counts(5);
  for (std::uint64_t first = 0; first < data.size(); first += block.size()) {
    source.fetch(first, std::min<std::uint64_t>(block.capacity(), data.size() - first), block);
    reference.decide(block.columns(), block.size(), decisions);
    for (std::size_t k = 0; k < block.size(); ++k) ++counts[static_cast<std::size_t>(decisions[k])];
  }
  return {at(counts, Decision::less), at(counts, Decision::equal), at(counts, Decision::greater),
          at(counts, Decision::unordered)};
}

data::Table items_on_a_grid(std::size_t count, Random& random) {
  data::Table items{.format = software::software_format(), .columns = {"x", "r"}};
  for (std::size_t k = 0; k < count; ++k) {
    items.values.push_back(encoded(static_cast<double>(random() % 64)));
    items.values.push_back(k % 100 == 3 ? software::software_format().quiet_nan()
                                        : encoded(static_cast<double>(random() % 8) / 4));
  }
  return items;
}

TEST(Software, EveryPairIsCountedOnceAtTheEdgesOfRuns) {
  ScratchDirectory work;
  CompiledSoftware software({"(xi - xj)^2", "(ri + rj)^2",
                             "\"x*\" = { range = [0, 64] }\n\"r*\" = { range = [0, 2] }\n"});
  Random random(3);
  std::optional<software::SoftwareProgram> program;
  for (const std::size_t items : {2u, 3u, 1024u, 1025u, 4097u}) {
    const auto data = software.comparisons(items_on_a_grid(items, random), true);
    if (!program) {
      program =
          software::SoftwareProgram::compile(software.scene(), data, software.filters(),
                                             {.work = work.path(), .rounds = 1, .seconds = 0.001})
              .value();
    }
    const software::VerdictCounts expected = emulated(software.scene(), data);
    const std::vector<software::KernelOutput> kernels = program->measure(data, 3).value();
    for (const software::KernelOutput& kernel : kernels) {
      EXPECT_EQ(kernel.verdicts, expected) << kernel.name << ", " << items << " items";
      ASSERT_EQ(kernel.rates.size(), 2u);
      EXPECT_GT(kernel.rates[1].best_per_s, 0);
    }
  }
}

TEST(Software, EveryRowMeetsEveryOtherAtTheEdgesOfRuns) {
  ScratchDirectory work;
  CompiledSoftware software({"(xi - xj)^2", "(ri + rj)^2",
                             "\"x*\" = { range = [0, 64] }\n\"r*\" = { range = [0, 2] }\n"});
  Random random(3);
  std::optional<software::SoftwareProgram> program;
  const std::vector<std::pair<std::size_t, std::size_t>> sizes = {
      {1, 1}, {3, 1025}, {4097, 2}, {1024, 1024}};
  for (const auto& [first, second] : sizes) {
    const auto data =
        data::Comparisons::cross(items_on_a_grid(first, random), items_on_a_grid(second, random),
                                 software.scene().graph.inputs())
            .value();
    if (!program) {
      program =
          software::SoftwareProgram::compile(software.scene(), data, software.filters(),
                                             {.work = work.path(), .rounds = 1, .seconds = 0.001})
              .value();
    }
    const software::VerdictCounts expected = emulated(software.scene(), data);
    const std::vector<software::KernelOutput> kernels = program->measure(data, 3).value();
    for (const software::KernelOutput& kernel : kernels) {
      EXPECT_EQ(kernel.verdicts, expected) << kernel.name << ", " << first << " by " << second;
    }
  }
}

TEST(Software, ABaselineOfTwoTablesIsChecked) {
  ScratchDirectory work;
  CompiledSoftware software({"(x - xi)^2 + ri", "(x - xj)^2 + rj",
                             "\"x*\" = { range = [0, 64] }\n\"r*\" = { range = [0, 2] }\n"});
  Random random(4);
  const auto& graph = software.scene().graph;
  const auto compare =
      workload::compare_by_reference(reference_graph(graph, {software::software_format()}));
  const auto data = data::Comparisons::arg_min(items_on_a_grid(300, random),
                                               items_on_a_grid(5, random), graph.inputs(), compare)
                        .value();
  const auto baseline = software::software_baseline(
      software.scene(), data,
      {.work = work.path(), .threads = 2, .rounds = 1, .seconds = 0.002, .sample = 500});
  ASSERT_TRUE(baseline.ok()) << baseline.error().to_string();
  EXPECT_TRUE(baseline->passed());
  EXPECT_EQ(baseline->comparisons, 1200u);
  EXPECT_EQ(baseline->exact().verdicts, emulated(software.scene(), data));
}

TEST(Software, ABaselineIsCheckedMeasuredAndReported) {
  ScratchDirectory work;
  CompiledSoftware software({"a * b", "c", "\"*\" = { range = [0.25, 16] }\n"});
  Random random(5);
  const auto data = software.comparisons(close_rows({"a", "b", "c"}, 5000, random, false));
  const auto baseline = software::software_baseline(
      software.scene(), data,
      {.work = work.path(), .threads = 2, .rounds = 2, .seconds = 0.002, .sample = 500});
  ASSERT_TRUE(baseline.ok()) << baseline.error().to_string();
  EXPECT_TRUE(baseline->passed());
  ASSERT_EQ(baseline->kernels.size(), 4u);
  EXPECT_FALSE(baseline->exact().filter);
  EXPECT_EQ(baseline->exact().all_cores.threads, 2u);
  EXPECT_EQ(baseline->check.comparisons, 500u);
  EXPECT_EQ(baseline->comparisons, 5000u);
  for (const software::BaselineKernel& kernel : baseline->kernels) {
    EXPECT_LE(kernel.one_core.median_per_s, kernel.one_core.best_per_s);
    EXPECT_NE(software::to_text(*baseline).find(kernel_name(kernel)), std::string::npos);
  }
}

TEST(Software, NobodyIsWrongWhereTheTruthIsUndetermined) {
  ScratchDirectory work;
  const auto [f, g] = unproven_tie();
  CompiledSoftware software({f, g, "\"*\" = { range = [0.25, 16] }\n"});
  Random random(6);
  const auto data = software.comparisons(close_rows({"a", "b"}, 50, random, false));
  const auto baseline = software::software_baseline(
      software.scene(), data,
      {.work = work.path(), .threads = 1, .rounds = 1, .seconds = 0.002, .sample = 50});
  ASSERT_TRUE(baseline.ok()) << baseline.error().to_string();
  EXPECT_TRUE(baseline->passed());
  EXPECT_EQ(baseline->check.undetermined, 50u);
  EXPECT_EQ(baseline->check.not_true, 0u);
  EXPECT_NE(software::to_text(*baseline).find("50 not held against the truth"), std::string::npos);
}

TEST(Software, AFilterThatCountsOtherwiseFailsTheBaseline) {
  software::Baseline baseline;
  baseline.kernels.resize(2);
  EXPECT_TRUE(baseline.passed());
  baseline.kernels[1].verdicts.less = 1;
  EXPECT_FALSE(baseline.passed());
  baseline.kernels[1].verdicts.less = 0;
  baseline.check.decided_wrongly = 1;
  EXPECT_FALSE(baseline.passed());
}

TEST(Software, TheSameSceneGivesTheSameBytes) {
  const CompiledSoftware one(sphere_scene), other(sphere_scene);
  auto rows = data::sphere_family({.name = "uniform", .count = 2}, software::software_format());
  const auto data = one.comparisons(*rows);
  EXPECT_EQ(software::software_source(one.scene(), data, one.filters()),
            software::software_source(other.scene(), data, other.filters()));
}

TEST(Software, SeveralPartsAreDecidedTogether) {
  Random random(21);
  for (const char* combine : {"all", "any"}) {
    CompiledSoftware software({.f = R"x("max(a, b)", "(a - b)^2")x",
                               .g = R"x("min(c, d)", "c * d")x",
                               .inputs = "\"*\" = { range = [0, 8] }\n",
                               .combine = combine});
    ASSERT_EQ(software.filters().filters.size(), 2u);
    const auto& inputs = software.scene().graph.inputs();
    for (const data::Table& table :
         {extreme_rows(inputs, 2000, random), close_rows(inputs, 2000, random, false),
          close_rows(inputs, 2000, random, true), wide_rows(inputs, 2000, random)}) {
      expect_right(software, software.comparisons(table), combine);
    }
    const std::vector<Seen> seen = expect_right(
        software, software.comparisons(close_rows(inputs, 4000, random, false)), combine);
    for (const Seen& filter : seen) EXPECT_GT(filter.decided, filter.comparisons / 4);
  }
}

TEST(Software, WhyAFilterIsMissingIsTold) {
  const CompiledSoftware software({"a - b * c", "c"});
  ASSERT_EQ(software.filters().filters.size(), 1u);
  ASSERT_EQ(software.filters().missing.size(), 2u);
  EXPECT_NE(software.filters().missing[1].reason.find("a - b * c"), std::string::npos);
}

TEST(Software, FactorsOfBoundsRoundUp) {
  EXPECT_EQ(software::float_at_least(1), 1.0f);
  EXPECT_EQ(software::float_at_least(1 + mpq_class(1, mpz_class(1) << 40)), 1.0f + 0x1p-23f);
  EXPECT_EQ(software::float_at_least(mpq_class(1, mpz_class(1) << 140)), 0x1p-126f);
  EXPECT_EQ(software::float_at_least(0), 0.0f);
  EXPECT_TRUE(std::isinf(software::float_at_least(mpq_class(mpz_class(1) << 128))));
}

}  // namespace
}  // namespace mixcmp::test::software_test
