#include <fmt/core.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <optional>

#include "model/comparison/expression/parser.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "tests/support/mixed_spheres.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"

/// Generated systems raise no warning in Verilator, Icarus or Yosys, and hold no latch.
namespace mixcmp::test::lint_test {
namespace {

namespace fs = std::filesystem;

struct Variant {
  std::string name;
  design::Design design;
};

void PrintTo(const Variant& variant, std::ostream* stream) {
  *stream << variant.name;
}

design::Design with(design::Design design, const std::function<void(design::Design&)>& change) {
  change(design);
  return design;
}

/// Two certified lanes and a reference for any comparison.
design::Design design_of(const std::string& f, const std::string& g, Arithmetic reduced,
                         FloatFormat reference) {
  Graph graph;
  const NodeId left = parse_expression(graph, f, {}).value();
  graph.compare(left, parse_expression(graph, g, {}).value());
  TypedGraph lane = lane_graph(graph, reference, reduced, LaneInputs::exact);
  const std::vector<bool> any_sign(graph.inputs().size(), false);
  return {.name = "comparison",
          .inputs = graph.inputs(),
          .lanes = {{.lane = relative_lane(std::move(lane), any_sign).value(), .count = 2}},
          .reference = reference_graph(graph, {reference}),
          .references = {{.count = 1}},
          .system = {}};
}

/// Spheres in a lane of any kind of error bound.
design::Design bounded(BoundKind kind, int digits, Arithmetic reduced, std::optional<Range> range) {
  const Graph graph = sphere_graph();
  design::Design design = sphere_design(reduced.format, format("s24e8"), 2, 1);
  const FloatFormat reference = design.reference.input_format;
  design.lanes.front().lane =
      error::certified_lane(lane_graph(graph, reference, reduced, LaneInputs::rounded),
                            {.kind = kind,
                             .bound_digits = digits,
                             .ranges = std::vector<std::optional<Range>>(8, range)})
          .value();
  return design;
}

design::Design with_pairs(design::Design design, int capacity) {
  design.system =
      with_engine(design.system, {.kind = scene::EngineKind::pairwise, .capacity = capacity});
  return design;
}

/// The nearest of some points, for a row that needs not all of its columns to be read twice.
design::Design with_arg_min(int lanes, const std::function<void(design::Design&)>& change) {
  design::Design design = design_of("(x - cxi)^2 + (y - cyi)^2", "(x - cxj)^2 + (y - cyj)^2",
                                    {format("s9e8")}, format("s23e8"));
  design.lanes.front().count = lanes;
  design.system = with_engine(design.system, {.kind = scene::EngineKind::arg_min});
  change(design);
  return design;
}

/// References of binary32 that square by steps, since the device has look-up tables of four inputs.
design::Design folded_by_steps(int references) {
  design::Design design = sphere_design(format("s12e8"), format("s24e8"), 2, references);
  design.references.front().structure = {scene::Multipliers::logic, 16};
  design.system.device = "ice40-hx8k";
  design.system.target_mhz = 95;
  return design;
}

/// Adds lanes in fixed point of two widths, two of each.
void in_fixed_point(design::Design& design) {
  const Graph graph = [] {
    Graph made;
    const NodeId f = parse_expression(made, "(x - cxi)^2 + (y - cyi)^2", {}).value();
    made.compare(f, parse_expression(made, "(x - cxj)^2 + (y - cyj)^2", {}).value());
    return made;
  }();
  for (const int bits : {7, 12}) {
    design.lanes.push_back(
        {.lane = fixed::fixed_lane(graph, design.reference.input_format,
                                   {.format = {.bits = bits},
                                    .ranges = std::vector<std::optional<Range>>(6, Range{-4, 4})})
                     .value(),
         .count = 2});
  }
}

design::Design with_counter_port(design::Design design) {
  design.system.counters = scene::CounterAccess::axi_lite;
  design.system.counter_bits = 48;
  return design;
}

std::vector<Variant> variants_of_systems() {
  const design::Design base = sphere_design(format("s17e8"), format("s24e8"), 8, 1);
  constexpr auto running = BoundKind::running;
  const design::Design odd = sphere_design(format("s8e5"), format("s24e7"), 7, 3);
  return {
      {"tagged_8x1", base},
      {"in_order_8x1", with(base, [](auto& d) { d.system.order = scene::ResultOrder::in_order; })},
      {"refetched_8x1",
       with(base, [](auto& d) { d.system.operands = scene::OperandStore::refetched; })},
      {"no_counters_odd_tag", with(base,
                                   [](auto& d) {
                                     d.system.counter_bits = 0;
                                     d.system.tag_bits = 5;
                                   })},
      {"counter_port_8x1", with_counter_port(base)},
      {"counter_port_padded_7x3", with_counter_port(odd)},
      {"folded_8x1",
       with(base, [](auto& d) { d.references.front().structure.initiation_interval = 16; })},
      {"folded_by_steps", folded_by_steps(1)},
      {"slow_clock", with(base, [](auto& d) { d.system.target_mhz = 10; })},
      {"fast_clock", with(base, [](auto& d) { d.system.target_mhz = 900; })},
      {"padded_7x3", odd},
      {"mixed_7x3", mixed_sphere_design()},
      {"mixed_refetched_in_order_7x3", with(mixed_sphere_design(),
                                            [](auto& d) {
                                              d.system.operands = scene::OperandStore::refetched;
                                              d.system.order = scene::ResultOrder::in_order;
                                            })},
      {"mixed_lanes_only", with(mixed_sphere_design(), [](auto& d) { d.references.clear(); })},
      {"refetched_padded_7x3",
       with(odd, [](auto& d) { d.system.operands = scene::OperandStore::refetched; })},
      {"every_operation",
       design_of("max(abs(a) * b^2, min(-a, 0.3)) / (b - 1)", "sqrt(abs(b)) + a^2",
                 {format("s9e6"), Rounding::toward_zero, Subnormals::gradual}, format("s24e8"))},
      {"magnitude_alone", design_of("abs(a)", "max(b, -c)", {format("s4e2")}, format("s53e11"))},
      {"lane_format_is_reference",
       design_of("sqrt(a) / b", "c", {format("s11e5")}, format("s11e5"))},
      {"running_4_digits", bounded(running, 4, {format("s17e8")}, {})},
      {"running_exponents_alone_in_ranges",
       bounded(running, 1, {format("s17e8"), Rounding::toward_zero}, Range{0, 100})},
      {"running_8_digits_flushing",
       bounded(running, 8, {format("s8e8"), Rounding::nearest_even, Subnormals::flush}, {})},
      {"constant_in_ranges",
       bounded(BoundKind::constant, 0, {format("s17e8"), Rounding::nearest_even, Subnormals::flush},
               Range{0, 100})},
      {"lane_only", sphere_design(format("s12e6"), format("s24e8"), 3, 0)},
      {"single_lane", sphere_design(format("s4e8"), format("s11e8"), 1, 1)},
      {"more_references_than_lanes", sphere_design(format("s4e8"), format("s11e8"), 2, 3)},
  };
}

std::vector<Variant> variants_of_engines() {
  const design::Design base = sphere_design(format("s17e8"), format("s24e8"), 8, 1);
  const design::Design odd = sphere_design(format("s8e5"), format("s24e7"), 7, 3);
  return {
      {"pairwise_counter_port", with_counter_port(with_pairs(base, 9))},
      {"arg_min_counter_port", with_counter_port(with_arg_min(8, [](auto&) {}))},
      {"pairwise_folded_by_steps", with_pairs(folded_by_steps(3), 64)},
      {"pairwise_8x1", with_pairs(base, 1024)},
      {"pairwise_padded_7x3", with_pairs(odd, 300)},
      {"pairwise_lanes_only", with_pairs(sphere_design(format("s12e6"), format("s24e8"), 3, 0), 2)},
      {"pairwise_one_sided",
       with_pairs(design_of("xj * ai", "abs(bi)", {format("s8e8")}, format("s24e8")), 65536)},
      {"pairwise_no_counters",
       with(with_pairs(base, 9), [](auto& d) { d.system.counter_bits = 0; })},
      {"arg_min_3", with_arg_min(2, [](auto&) {})},
      {"arg_min_2", with_arg_min(1, [](auto& d) { d.system.engine.row_tag_bits = 1; })},
      {"arg_min_mixed_6x3", with_arg_min(2,
                                         [](auto& d) {
                                           in_fixed_point(d);
                                           d.references.front().count = 3;
                                         })},
      {"arg_min_fixed", with_arg_min(2,
                                     [](auto& d) {
                                       in_fixed_point(d);
                                       d.lanes.erase(d.lanes.begin());
                                     })},
      {"arg_min_no_counters", with_arg_min(8, [](auto& d) { d.system.counter_bits = 0; })},
  };
}

std::vector<Variant> variants() {
  std::vector<Variant> all = variants_of_systems();
  for (Variant& engine : variants_of_engines()) all.push_back(std::move(engine));
  return all;
}

/// Runs a shell command; whether it succeeded, and its output without the lines in which newer
/// Verilators report on themselves.
std::pair<bool, std::string> run(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::string output, line;
  for (int c = fgetc(pipe); c != EOF; c = fgetc(pipe)) {
    line += static_cast<char>(c);
    if (c != '\n') continue;
    if (!line.starts_with("- ")) output += line;
    line.clear();
  }
  return {pclose(pipe) == 0, output + line};
}

bool is_installed(const std::string& tool) {
  return run("command -v " + tool).first;
}

class Lint : public testing::TestWithParam<Variant> {
protected:
  void SetUp() override {
    directory_ = fs::absolute(generate_to(GetParam().design, "lint_" + GetParam().name));
    const auto system = verilator_tb::load_system(directory_);
    ASSERT_TRUE(system.ok()) << system.error().to_string();
    list_ = system->signature.top + ".f";
    top_ = system->signature.engine ? system->signature.engine->top : system->signature.top;
  }

  /// The command for a tool that the head of the list gives, for `directory_`.
  std::string command_for(const std::string& tool) {
    std::ifstream list(directory_ / list_);
    const std::string begin = "//   " + tool + " ";
    for (std::string line; std::getline(list, line);) {
      if (!line.starts_with(begin)) continue;
      std::string command = line.substr(5);
      for (std::size_t place = 0; (place = command.find("DIR/", place)) != std::string::npos;) {
        command.replace(place, 3, directory_.string());
      }
      const std::size_t folder = command.find(" DIR ");
      if (folder != std::string::npos) command.replace(folder + 1, 3, directory_.string());
      return command;
    }
    ADD_FAILURE() << list_ << " has no command for " << tool;
    return "false";
  }

  /// Runs the tool in another folder than the files'.
  void expect_silent(const std::string& tool, const std::string& command) {
    if (!is_installed(tool)) GTEST_SKIP() << tool << " is not installed";
    const ScratchDirectory elsewhere;
    const auto [succeeded, output] =
        run(fmt::format("cd '{}' && {}", elsewhere.path().string(), command));
    EXPECT_TRUE(succeeded) << output;
    EXPECT_EQ(output, "");
  }

  fs::path directory_;  ///< absolute
  std::string top_;
  std::string list_;  ///< the files
};

TEST_P(Lint, Verilator) {
  expect_silent("verilator", command_for("verilator"));
}

TEST_P(Lint, Icarus) {
  expect_silent("iverilog", command_for("iverilog"));
}

TEST_P(Lint, IcarusTakesTheListInItsOwnFolder) {
  expect_silent("iverilog", fmt::format("cd {} && iverilog -g2001 -Wall -t null -s {} -c {}",
                                        directory_.string(), top_, list_));
}

TEST_P(Lint, Yosys) {
  std::string command = command_for("yosys");
  ASSERT_TRUE(command.ends_with('\'')) << command;
  command.pop_back();
  expect_silent("yosys", command +
                             "; proc; check -assert; "
                             "select -assert-none t:$dlatch t:$_DLATCH_*'");
}

INSTANTIATE_TEST_SUITE_P(Systems, Lint, testing::ValuesIn(variants()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace

}  // namespace mixcmp::test::lint_test
