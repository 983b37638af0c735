#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <tuple>

#include "model/base/common/counter_random.hpp"
#include "model/base/number/exact.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"

/// One place in one module of a generated system is broken, and either judge finds it, in either
/// simulator. (Results that are lost, doubled or get a wrong tag: tests/verilator_tb/verify_test.)
namespace mixcmp::test::broken_system_test {
namespace {

namespace fs = std::filesystem;

constexpr int lane_precision = 4;
constexpr int reference_precision = 6;

struct Fault {
  const char* name;
  const char* file;
  std::string from;
  std::string to;
};

std::ostream& operator<<(std::ostream& out, const Fault& fault) {
  return out << fault.name;
}

/// A tie of two neighbours is rounded up, not to the even one, only in results of this precision.
Fault ties_rounded_up(const char* name, int precision) {
  return {name, "mixcmp_fp_round.v", "(s0_odd || s0_tail)",
          "(s0_odd || s0_tail || (RESULT_PRECISION == " + std::to_string(precision) + "))"};
}

const Fault faults[] = {
    ties_rounded_up("RoundingOfLanes", lane_precision),
    ties_rounded_up("RoundingOfReferences", reference_precision),
    {"AnswersToTheOtherLane", "mixcmp_stream_crossbar.v", "answer_lane == name",
     "answer_lane != name"},
    {"ResultsOfTheOtherLane", "sphere_s4e8_2x1.v", "m_axis_tdata[lane *",
     "m_axis_tdata[(1 - lane) *"},
};

design::Design two_lanes() {
  return sphere_design(format("s4e8"), format("s6e8"), 2, 1);
}

/// Spheres of whole numbers below 64: their squares need up to 12 digits, so ties in rounding
/// abound.
data::Comparisons spheres_of_whole_numbers(const design::Design& design) {
  data::Table table{design.reference.input_format, {"cx", "cy", "cz", "r"}, {}, {}};
  for (std::uint64_t k = 0; k < 4 * 60; ++k) {
    const std::uint64_t number = counter_random(5, k) % 64;
    table.values.push_back(from_rational(table.format, number));
  }
  return data::Comparisons::all_pairs(table, design.inputs).value();
}

void break_file(const fs::path& path, const Fault& fault) {
  std::ifstream in(path);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t place = text.find(fault.from);
  ASSERT_NE(place, std::string::npos) << path;
  std::ofstream(path) << text.replace(place, fault.from.size(), fault.to);
}

fs::path broken_rtl(const design::Design& design, const Fault& fault) {
  const fs::path rtl = generate_to(design, std::string("broken_") + fault.name);
  break_file(rtl / fault.file, fault);
  return rtl;
}

struct Judged {
  std::uint64_t mismatches = 0;
  std::uint64_t by_emulator = 0;
  nlohmann::ordered_json by_anyone;  ///< must be the same whoever judges
};

Judged judged(const design::Design& design, const fs::path& rtl,
              const verilator_tb::VerifyOptions& options) {
  const auto report = verilator_tb::verify(design, spheres_of_whole_numbers(design),
                                           verilator_tb::load_system(rtl).value(), options)
                          .value();
  EXPECT_FALSE(report.passed()) << to_text(report);
  EXPECT_EQ(report.emulator_errors, 0u) << to_text(report);
  Judged judged = {report.mismatch_count, report.judged_by_emulator, to_json(report)};
  for (const char* key : {"judged_by_emulator", "build_seconds", "run_seconds"}) {
    judged.by_anyone.erase(key);
  }
  return judged;
}

class BrokenSystem : public testing::TestWithParam<std::tuple<verilator_tb::SimulatorKind, Fault>> {
};

TEST_P(BrokenSystem, IsFoundByEachJudge) {
  const auto& [simulator, fault] = GetParam();
  const design::Design design = two_lanes();
  const fs::path rtl = broken_rtl(design, fault);
  verilator_tb::VerifyOptions options = {.simulator = simulator,
                                         .work_dir = test_work_dir("builds")};
  options.judge = verilator_tb::JudgeKind::emulator;
  const Judged emulator = judged(design, rtl, options);
  options.judge = verilator_tb::JudgeKind::golden_model;
  const Judged golden_model = judged(design, rtl, options);
  EXPECT_GT(emulator.mismatches, 0u);
  EXPECT_GT(emulator.by_emulator, 0u);
  EXPECT_EQ(golden_model.by_emulator, 0u);
  EXPECT_EQ(emulator.by_anyone, golden_model.by_anyone);
}

INSTANTIATE_TEST_SUITE_P(In, BrokenSystem,
                         testing::Combine(testing::Values(verilator_tb::SimulatorKind::verilator,
                                                          verilator_tb::SimulatorKind::icarus),
                                          testing::ValuesIn(faults)),
                         [](const auto& test) {
                           const bool icarus =
                               std::get<0>(test.param) == verilator_tb::SimulatorKind::icarus;
                           return std::string(icarus ? "Icarus" : "Verilator") +
                                  std::get<1>(test.param).name;
                         });

}  // namespace
}  // namespace mixcmp::test::broken_system_test
