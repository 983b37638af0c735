#include "generator/hardware/emit/verilog.hpp"

#include <gtest/gtest.h>

namespace mixcmp::test::verilog_test {
namespace {

using namespace rtl;

/// The text of a module whose instances, of modules "half" and "unit", have these ports.
std::string printed(Module module) {
  const OutsidePorts outside = [](const Instance& instance) -> Result<std::vector<Port>> {
    if (instance.module == "half") return std::vector<Port>{{Direction::input, 8, "a"}};
    return std::vector<Port>{{Direction::input, 1, "aclk"}, {Direction::input, 12, "d"}};
  };
  return emit::to_verilog(CheckedModules({std::move(module)}, outside)).front();
}

/// A module with one of each item.
Module structural_module() {
  Module module;
  module.name = "pair";
  module.ports = {{Direction::input, 1, "aclk"},   {Direction::input, 1, "go", true},
                  {Direction::input, 8, "p"},      {Direction::input, 1, "r"},
                  {Direction::output, 16, "y"},    {Direction::output, 2, "q"},
                  {Direction::output, 1, "parity"}};
  auto loop = std::make_shared<ForGenerate>();
  *loop = {"k", 0, 2, "halves", {Instance{"half", "one", {}, {{"a", indexed("x", "k", 8)}}}}};
  module.items = {Comment{"A fact."},
                  Wire{16, "x", concatenation({slice("p", 7, 0), literal(8, 0xa5)})},
                  Assignment{bit("q", 1), any_of({net("r"), inverted(bit("go", 0))})},
                  Instance{"unit",
                           "u",
                           {{"WIDTH", 16}, {"CUTS", Literal{5, 0b10010}}},
                           {{"aclk", net("aclk")}, {"d", literal(12, 0xabc)}}},
                  std::shared_ptr<const ForGenerate>(loop),
                  Assignment{bit("q", 0), literal(1, 0)},
                  Assignment{net("y"), net("x")},
                  Assignment{net("parity"), all_bits(net("x"))}};
  return module;
}

TEST(Verilog, PrintsAStructuralModule) {
  EXPECT_EQ(printed(structural_module()), R"(
`default_nettype none

module pair (
  input  wire        aclk,
  input  wire [0:0]  go,
  input  wire [7:0]  p,
  input  wire        r,
  output wire [15:0] y,
  output wire [1:0]  q,
  output wire        parity
);

  // A fact.
  wire [15:0] x = {p[7:0], 8'b10100101};
  assign q[1] = r | ~go[0];

  unit #(
    .WIDTH(16),
    .CUTS (5'b10010)
  ) u (
    .aclk(aclk),
    .d   (12'habc)
  );

  genvar k;
  generate
    for (k = 0; k < 2; k = k + 1) begin : g_halves
      half one (
        .a(x[k * 8 +: 8])
      );
    end
  endgenerate

  assign q[0] = 1'b0;
  assign y = x;
  assign parity = &x;

endmodule

`default_nettype wire
)");
}

TEST(Verilog, HeadsAreComments) {
  EXPECT_EQ(emit::to_comment({"pair: two of something.", "", "No reset."}),
            "// pair: two of something.\n//\n// No reset.\n");
}

TEST(Verilog, AnyOfNothingIsZeroAndOfOneIsItself) {
  Module module = {"m", {{Direction::input, 1, "a"}}, {}};
  module.items = {Wire{1, "unused_x", any_of({})}, Wire{1, "unused_y", any_of({net("a")})}};
  const std::string text = printed(module);
  EXPECT_NE(text.find("wire unused_x = 1'b0;"), std::string::npos);
  EXPECT_NE(text.find("wire unused_y = a;"), std::string::npos);
}

TEST(Verilog, LongConcatenationsAreBrokenBetweenParts) {
  const std::string part(40, 'a');
  Module module = {
      "m",
      {{Direction::input, 1, part}, {Direction::input, 1, "b"}, {Direction::output, 4, "x"}},
      {}};
  module.items = {Assignment{net("x"), concatenation({net(part), net(part), net("b"), net(part)})}};
  EXPECT_NE(printed(module).find("  assign x =\n      {" + part + ", " + part + ", b,\n       " +
                                 part + "};\n"),
            std::string::npos)
      << printed(module);
}

TEST(Verilog, WordsOfATableAreHexadecimalFromTheLastAddressOn) {
  Words narrow{.width = 5, .words = {}}, wide{.width = 30, .words = {}};
  for (Bits k = 0; k < 16; ++k) {
    narrow.words.push_back(k + 16);
    wide.words.push_back(k << 26);
  }
  Module module = {"m", {{Direction::input, 1, "aclk"}, {Direction::input, 12, "d"}}, {}};
  module.items = {Instance{"unit",
                           "u",
                           {{"WORDS", narrow}, {"OTHERS", wide}},
                           {{"aclk", net("aclk")}, {"d", net("d")}}}};
  const std::string text = printed(module);
  EXPECT_NE(text.find(R"(
    .WORDS ({
      5'h1f, 5'h1e, 5'h1d, 5'h1c, 5'h1b, 5'h1a, 5'h19, 5'h18, 5'h17, 5'h16, 5'h15, 5'h14, 5'h13,
      5'h12, 5'h11, 5'h10}),
    .OTHERS({
      30'h3c000000, 30'h38000000, 30'h34000000, 30'h30000000, 30'h2c000000, 30'h28000000,
      30'h24000000, 30'h20000000, 30'h1c000000, 30'h18000000, 30'h14000000, 30'h10000000,
      30'h0c000000, 30'h08000000, 30'h04000000, 30'h00000000})
)"),
            std::string::npos)
      << text;
}

TEST(Verilog, PhasesStandOnOneLineOrOnOneEach) {
  Module module = {"phases", {{Direction::input, 4, "phase"}, {Direction::output, 2, "y"}}, {}};
  module.items = {
      PhaseFlag{"few", {Literal{4, 3}, Literal{4, 11}}},
      PhaseFlag{"squarer_start",
                {Literal{4, 0}, Literal{4, 3}, Literal{4, 6}, Literal{4, 9}, Literal{4, 12}}},
      Assignment{net("y"), concatenation({net("few"), net("squarer_start")})}};
  const std::string text = printed(module);
  EXPECT_NE(text.find("  wire few = (phase == 4'd3) || (phase == 4'd11);\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("  wire squarer_start =\n"
                      "      (phase == 4'd0)\n"
                      "      || (phase == 4'd3)\n"),
            std::string::npos)
      << text;
}

TEST(Verilog, LongAlternativesTakeALineEach) {
  const std::string longest(60, 'a');
  Module module = {"m", {{Direction::input, 1, longest}, {Direction::input, 1, "b"}}, {}};
  module.items = {Wire{1, "unused_x", any_of({net(longest), net("b"), net(longest)})}};
  EXPECT_NE(printed(module).find("  wire unused_x =\n      " + longest + "\n      | b\n      | " +
                                 longest + ";\n"),
            std::string::npos);
}

}  // namespace
}  // namespace mixcmp::test::verilog_test
