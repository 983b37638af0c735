#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "model/base/common/output_file.hpp"
#include "model/base/common/process.hpp"
#include "model/base/number/exact.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/simulated_system.hpp"

/// Systems whose operands arrive in floating-point formats that are narrower than the reference's:
/// on every operand of small formats, subnormal and special ones included, they decide as the
/// golden model does, which takes operands in the reference format.
namespace mixcmp::test::float_operands_system_test {
namespace {

enum class Kind { floating, exact_inputs, fixed, block };

struct Case {
  const char* name;
  Kind lane;
  const char* format_of_a;
  const char* format_of_b;
  Arithmetic reference = {format_of(24, 8)};
  FloatFormat reduced = format_of(9, 8);
  int interval = 1;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

constexpr const char* f = "(a - b)^2 + abs(a) * a";
constexpr const char* g = "max(a * b, 2 * b^2)";

FloatFormat format_named(const char* name) {
  return *OperandFormat::parse(name)->floating();
}

Graph graph_arriving_in(const std::vector<FloatFormat>& formats) {
  Graph graph = graph_of(f, g);
  for (std::size_t k = 0; k < formats.size(); ++k) {
    graph.arrives_in(static_cast<int>(k), formats[k]);
  }
  return graph;
}

design::Lane lane_of(const Case& c, const Graph& graph, const std::vector<OperandFormat>& formats) {
  const std::vector<std::optional<Range>> ranges(2, Range{-100, 100});
  if (c.lane == Kind::fixed || c.lane == Kind::block) {
    return fixed::fixed_lane(graph, c.reference.format,
                             {.format = {.bits = 12, .is_block = c.lane == Kind::block},
                              .bound = {},
                              .ranges = ranges,
                              .operand_formats = formats})
        .value();
  }
  const LaneInputs inputs = c.lane == Kind::floating ? LaneInputs::rounded : LaneInputs::exact;
  const TypedGraph lane = lane_graph(
      graph, c.reference.format, {c.reduced, Rounding::nearest_even, Subnormals::flush}, inputs);
  return error::certified_lane(lane, {.ranges = std::vector<std::optional<Range>>(2)}).value();
}

design::Design design_of(const Case& c) {
  const std::vector<FloatFormat> arriving = {format_named(c.format_of_a),
                                             format_named(c.format_of_b)};
  const std::vector<OperandFormat> formats = {OperandFormat(arriving[0]),
                                              OperandFormat(arriving[1])};
  const Graph graph = graph_arriving_in(arriving);
  return {.name = "float_operands",
          .inputs = graph.inputs(),
          .lanes = {{.lane = lane_of(c, graph, formats)}},
          .reference = reference_graph(graph, c.reference),
          .references = {{.structure = {.initiation_interval = c.interval}, .count = 1}},
          .system = {},
          .operand_formats = formats};
}

/// Every word of the wider format beside words of the other one; a row more than a multiple of the
/// other's count each time, so that every one of them meets many.
data::Table every_word(const Case& c) {
  const FloatFormat a = format_named(c.format_of_a), b = format_named(c.format_of_b);
  const FloatFormat encoding = c.reference.format;
  data::Table table{.format = encoding, .columns = {"a", "b"}, .values = {}, .labels = {}};
  const Bits words_of_a = Bits{1} << a.width(), words_of_b = Bits{1} << b.width();
  const Bits rows = std::max(Bits{1} << 14, std::max(words_of_a, words_of_b));
  for (Bits row = 0; row < rows; ++row) {
    table.values.push_back(converted(encoding, a, row % words_of_a));
    table.values.push_back(converted(encoding, b, (row * 37 + row / words_of_a) % words_of_b));
  }
  return table;
}

class FloatOperands : public testing::TestWithParam<Case> {};

TEST_P(FloatOperands, EveryWordIsDecidedAsTheGoldenModelSays) {
  const design::Design design = design_of(GetParam());
  const Graph graph = graph_of(f, g);
  const data::Table table = every_word(GetParam());
  const std::uint64_t comparisons = table.rows();
  const auto data = data::Comparisons::rows(table, design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report =
      simulate(design, *data, {.truth = verilator_tb::TruthCheck{.graph = &graph}});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, comparisons);
  EXPECT_GT(report.recomputations, 0u);
  EXPECT_LT(report.recomputations, comparisons);
  EXPECT_EQ(report.truth->wrong_by_lane, 0u) << to_text(report);
}

constexpr Arithmetic flushing(FloatFormat format) {
  return {format, Rounding::nearest_even, Subnormals::flush};
}

INSTANTIATE_TEST_SUITE_P(
    Systems, FloatOperands,
    testing::Values(
        Case{"bytes", Kind::floating, "s4e4", "E5M2"},
        Case{"bfloat16_and_a_byte", Kind::floating, "bfloat16", "E5M2"},
        Case{"flushed", Kind::exact_inputs, "bfloat16", "s4e4", flushing(format_of(24, 8)),
             format_of(6, 8)},
        Case{"subnormal_in_the_reference",
             Kind::exact_inputs,
             "s6e4",
             "s5e3",
             {format_of(12, 4)},
             format_of(7, 4)},
        Case{"in_fixed_point", Kind::fixed, "binary16", "s4e4"},
        Case{"in_blocks", Kind::block, "s4e4", "E5M2"},
        Case{"without_infinities", Kind::floating, "E4M3", "E5M2"},
        Case{"without_infinities_exact", Kind::exact_inputs, "bfloat16", "E4M3",
             flushing(format_of(24, 8)), format_of(6, 8)},
        Case{"without_infinities_in_five_exponent_bits",
             Kind::floating,
             "E4M3",
             "E4M3",
             {format_of(11, 5)},
             format_of(6, 5)},
        Case{"without_infinities_in_fixed_point", Kind::fixed, "E4M3", "E4M3"},
        Case{"without_infinities_in_blocks", Kind::block, "E4M3", "bfloat16"},
        Case{"without_infinities_folded",
             Kind::floating,
             "E4M3",
             "s4e4",
             {format_of(24, 8)},
             format_of(9, 8),
             6},
        Case{"without_infinities_fused",
             Kind::floating,
             "E4M3",
             "E4M3",
             {format_of(24, 8), Rounding::nearest_even, Subnormals::gradual, Sums::fused}},
        Case{"folded", Kind::floating, "s4e4", "bfloat16", {format_of(24, 8)}, format_of(9, 8), 6},
        Case{"fused",
             Kind::floating,
             "E5M2",
             "s4e4",
             {format_of(24, 8), Rounding::nearest_even, Subnormals::gradual, Sums::fused}}),
    [](const auto& instance) { return std::string(instance.param.name); });

/// The file of the reference datapath among a system's Verilog.
std::filesystem::path reference_file(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().stem().string();
    const bool is_datapath = name.find("_words_reference_") != std::string::npos;
    if (is_datapath && !name.ends_with("_channel")) return entry.path();
  }
  return {};
}

/// A bench that holds each word of 8 bits at the reference for longer than its latency and prints
/// its verdict on the word and the number at which `numbers` has it.
std::string bench_of_words(const std::string& module, const std::vector<std::string>& numbers) {
  std::string bench = fmt::format(R"(`timescale 1ns / 1ns
module tb;
  reg aclk = 0;
  reg [7:0] a = 0;
  reg [31:0] b = 0;
  wire [1:0] verdict;
  {} dut (.aclk(aclk), .a(a), .b(b), .verdict(verdict));
  always #1 aclk = !aclk;
  initial begin
)",
                                  module);
  for (std::size_t word = 0; word < numbers.size(); ++word) {
    bench += fmt::format("    a = {}; b = 32'h{}; #80 $display(\"%0d\", verdict);\n", word,
                         numbers[word]);
  }
  return bench + "    $finish;\n  end\nendmodule\n";
}

/// Also the words that no data make, such as a NaN with a sign.
TEST(FloatOperandWords, EachOfEveryByteIsItsNumberInTheReference) {
  if (!is_in_path("iverilog")) GTEST_SKIP() << "Icarus is not installed";
  for (const char* name : {"E4M3", "E5M2"}) {
    const FloatFormat byte = format_named(name), encoding = format_of(24, 8);
    Graph graph = graph_of("a", "b");
    graph.arrives_in(0, byte);
    const Case c{"words", Kind::floating, name, "s24e8"};
    const std::vector<OperandFormat> formats = {OperandFormat(byte), OperandFormat(encoding)};
    const design::Design design{.name = "words",
                                .inputs = graph.inputs(),
                                .lanes = {{.lane = lane_of(c, graph, formats)}},
                                .reference = reference_graph(graph, c.reference),
                                .references = {{.count = 1}},
                                .system = {},
                                .operand_formats = formats};
    const auto folder = generate_to(design, fmt::format("words_{}_{}", name, getpid()));
    std::vector<std::string> numbers;
    std::string expected;
    for (Bits word = 0; word < 256; ++word) {
      numbers.push_back(to_hex(converted(encoding, byte, word), 32));
      expected += byte.is_nan(word) ? "3\n" : "1\n";
    }
    const std::string reference = reference_file(folder).stem().string();
    ASSERT_TRUE(write_file(folder / "tb.v", bench_of_words(reference, numbers)).ok());
    const auto path = [&](const char* file) { return (folder / file).string(); };
    const auto built = capture({"iverilog", "-g2001", "-y", folder.string(), "-s", "tb", "-o",
                                path("tb.vvp"), path("tb.v")});
    ASSERT_TRUE(built.ok() && built->succeeded()) << built->errors;
    const auto run = capture({"vvp", "-n", path("tb.vvp")}, {.seconds = 60});
    ASSERT_TRUE(run.ok() && run->succeeded());
    EXPECT_EQ(run->output, expected) << name;
    std::filesystem::remove_all(folder);
  }
}

/// An engine stores words of 8 and 16 bits.
class FloatOperandsInAnEngine : public testing::TestWithParam<std::tuple<Kind, const char*>> {};

TEST_P(FloatOperandsInAnEngine, EveryPairOfItemsIsDecidedAsTheGoldenModelSays) {
  Graph graph = graph_of("(xi - xj)^2 + (yi - yj)^2", "12");
  const auto [kind, name] = GetParam();
  const FloatFormat byte = format_named(name), brain = format_named("bfloat16");
  const std::vector<FloatFormat> arriving = {byte, byte, brain, brain};
  std::vector<OperandFormat> formats;
  for (int k = 0; k < 4; ++k) {
    graph.arrives_in(k, arriving[static_cast<std::size_t>(k)]);
    formats.emplace_back(arriving[static_cast<std::size_t>(k)]);
  }
  const FloatFormat reference = format_of(24, 8);
  const std::vector<std::optional<Range>> ranges(4, Range{-8, 8});
  const design::Lane lane =
      kind == Kind::floating
          ? design::Lane(error::certified_lane(lane_graph(graph, reference,
                                                          {format_of(6, 8), Rounding::nearest_even,
                                                           Subnormals::flush},
                                                          LaneInputs::rounded),
                                               {.ranges = ranges})
                             .value())
          : design::Lane(fixed::fixed_lane(graph, reference,
                                           {.format = {.bits = 7},
                                            .bound = {},
                                            .ranges = ranges,
                                            .operand_formats = formats})
                             .value());
  design::Design design{.name = "float_items",
                        .inputs = graph.inputs(),
                        .lanes = {{.lane = lane, .count = 2}},
                        .reference = reference_graph(graph, {reference}),
                        .references = {{.count = 1}},
                        .system = {},
                        .operand_formats = formats};
  design.system = with_engine(design.system, {.kind = scene::EngineKind::pairwise, .capacity = 64});
  data::Table items{.format = reference, .columns = {"x", "y"}, .values = {}, .labels = {}};
  for (Bits k = 0; k < 64; ++k) {
    items.values.push_back(converted(reference, byte, (k * 83) % 256));
    items.values.push_back(from_rational(reference, mpq_class(static_cast<int>(k) - 32, 8)));
  }
  const auto data = data::Comparisons::all_pairs(items, design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report =
      simulate(design, *data, {.simulator = verilator_tb::SimulatorKind::icarus});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, 64u * 63 / 2);
  EXPECT_GT(report.verdicts[0], 0u);
  EXPECT_GT(report.recomputations, 0u);
}

INSTANTIATE_TEST_SUITE_P(Lanes, FloatOperandsInAnEngine,
                         testing::Combine(testing::Values(Kind::floating, Kind::fixed),
                                          testing::Values("s4e4", "E4M3")));

}  // namespace
}  // namespace mixcmp::test::float_operands_system_test
