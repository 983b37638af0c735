#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <filesystem>

#include "model/base/common/output_file.hpp"
#include "model/base/common/process.hpp"
#include "model/base/number/exact.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/simulated_system.hpp"

/// Systems whose operands arrive in narrower formats than the reference's, at least one of them in
/// floating point: on every operand of small formats, subnormal and special ones included, they
/// decide as the golden model does, which takes operands in the reference format.
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

Graph graph_arriving_in(const std::vector<OperandFormat>& formats) {
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
  const std::vector<OperandFormat> formats = {OperandFormat::parse(c.format_of_a).value(),
                                              OperandFormat::parse(c.format_of_b).value()};
  const Graph graph = graph_arriving_in(formats);
  return {.name = "float_operands",
          .inputs = graph.inputs(),
          .lanes = {{.lane = lane_of(c, graph, formats)}},
          .reference = reference_graph(graph, c.reference),
          .references = {{.structure = {.initiation_interval = c.interval}, .count = 1}},
          .system = {},
          .operand_formats = formats};
}

/// A word as the reference's encoding has it.
Bits encoded(FloatFormat encoding, const OperandFormat& format, Bits word) {
  const FixedFormat* const fixed = format.fixed();
  if (fixed == nullptr) return converted(encoding, *format.floating(), word);
  const Bits beyond = Bits{1} << fixed->magnitude_bits();
  mpz_class units = to_integer(word);
  if (word >= beyond) units -= to_integer(beyond) * 2;
  return from_rational(encoding, units * fixed->unit());
}

/// Every word of the wider format beside words of the other one; a row more than a multiple of the
/// other's count each time, so that every one of them meets many.
data::Table every_word(const Case& c) {
  const OperandFormat a = OperandFormat::parse(c.format_of_a).value();
  const OperandFormat b = OperandFormat::parse(c.format_of_b).value();
  const FloatFormat encoding = c.reference.format;
  data::Table table{.format = encoding, .columns = {"a", "b"}, .values = {}, .labels = {}};
  const Bits words_of_a = Bits{1} << a.width(), words_of_b = Bits{1} << b.width();
  const Bits rows = std::max(Bits{1} << 14, std::max(words_of_a, words_of_b));
  for (Bits row = 0; row < rows; ++row) {
    table.values.push_back(encoded(encoding, a, row % words_of_a));
    table.values.push_back(encoded(encoding, b, (row * 37 + row / words_of_a) % words_of_b));
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
        Case{"integers", Kind::fixed, "int8", "E5M2"},
        Case{"single_bits", Kind::fixed, "uint1", "s4e4"},
        Case{"integers_of_all_digits", Kind::fixed, "int9", "s4e4", {format_of(8, 5)}},
        Case{"fractions", Kind::fixed, "uq2.6", "E4M3", flushing(format_of(11, 5))},
        Case{"fractions_folded",
             Kind::fixed,
             "s4e4",
             "q3.5",
             {format_of(24, 8)},
             format_of(9, 8),
             6},
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

/// A word of 8 bits, and the number with which the reference compares it.
struct Compared {
  int word;
  float number;
};

/// A bench that holds each pair at the reference for longer than its latency and prints its
/// verdict.
std::string bench_of_words(const std::string& module, const std::vector<Compared>& pairs) {
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
  for (const auto& [word, number] : pairs) {
    bench += fmt::format("    a = {}; b = 32'h{:08x}; #80 $display(\"%0d\", verdict);\n", word,
                         std::bit_cast<std::uint32_t>(number));
  }
  return bench + "    $finish(0);\n  end\nendmodule\n";
}

/// The number of a word, by the tables of OFP8: E4M3 has a NaN of all ones and no infinity, E5M2
/// has those of IEEE 754.
float number_of(const std::string& format, int word) {
  const bool is_e4m3 = format == "E4M3";
  const int fraction_bits = is_e4m3 ? 3 : 2, bias = is_e4m3 ? 7 : 15;
  const int largest = is_e4m3 ? 15 : 31;
  const int field = word >> fraction_bits & largest, ones = (1 << fraction_bits) - 1;
  const int fraction = word & ones;
  const int significand = field == 0 ? fraction : fraction + ones + 1;
  float magnitude =
      std::ldexp(static_cast<float>(significand), std::max(field, 1) - bias - fraction_bits);
  if (is_e4m3 && field == largest && fraction == ones) magnitude = NAN;
  if (!is_e4m3 && field == largest) magnitude = fraction == 0 ? INFINITY : NAN;
  return word < 128 ? magnitude : -magnitude;
}

/// Also the words that no data make, such as a NaN with a sign. Each is compared with its number
/// and with the neighbours of that in s24e8.
TEST(FloatOperandWords, EachOfEveryByteIsItsNumberInTheReference) {
  if (!is_in_path("iverilog")) GTEST_SKIP() << "Icarus is not installed";
  for (const char* name : {"E4M3", "E5M2"}) {
    const FloatFormat byte = format_named(name), encoding = format_of(24, 8);
    Graph graph = graph_of("a", "b");
    graph.arrives_in(0, OperandFormat(byte));
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
    std::vector<Compared> pairs;
    std::string expected;
    for (int word = 0; word < 256; ++word) {
      const float number = number_of(name, word);
      for (const float other :
           {std::nextafter(number, -INFINITY), number, std::nextafter(number, INFINITY)}) {
        pairs.push_back({word, other});
        expected += std::isnan(number) ? "3\n"
                    : number < other   ? "0\n"
                    : number == other  ? "1\n"
                                       : "2\n";
      }
    }
    const std::string reference = reference_file(folder).stem().string();
    ASSERT_TRUE(write_file(folder / "tb.v", bench_of_words(reference, pairs)).ok());
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
    graph.arrives_in(k, OperandFormat(arriving[static_cast<std::size_t>(k)]));
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
