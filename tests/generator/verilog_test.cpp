#include "generator/emit/verilog.hpp"

#include <gtest/gtest.h>

namespace mixcmp::test::verilog_test {
namespace {

using namespace rtl;

TEST(Verilog, PrintsAStructuralModule) {
  Module module;
  module.name = "pair";
  module.header = {"pair: two of something.", "", "No reset."};
  module.ports = {{Direction::input, 1, "aclk"},
                  {Direction::input, 1, "go", true},
                  {Direction::output, 16, "y"}};
  auto loop = std::make_shared<ForGenerate>();
  *loop = {"k", 0, 2, "halves", {Instance{"half", "one", {}, {{"a", indexed("x", "k", 8)}}}}};
  module.items = {Comment{"A fact."},
                  Wire{16, "x", concatenation({slice("p", 7, 0), literal(8, 0xa5)})},
                  Assignment{bit("q", 3), any_of({net("r"), inverted(bit("s", 0))})},
                  Instance{"unit",
                           "u",
                           {{"WIDTH", 16}, {"CUTS", Literal{5, 0b10010}}},
                           {{"aclk", net("aclk")}, {"d", literal(12, 0xabc)}}},
                  std::shared_ptr<const ForGenerate>(loop)};
  EXPECT_EQ(emit::to_verilog(module), R"(// pair: two of something.
//
// No reset.

`default_nettype none

module pair (
  input  wire        aclk,
  input  wire [0:0]  go,
  output wire [15:0] y
);

  // A fact.
  wire [15:0] x = {p[7:0], 8'b10100101};
  assign q[3] = r | ~s[0];

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

endmodule

`default_nettype wire
)");
}

TEST(Verilog, AnyOfNothingIsZeroAndOfOneIsItself) {
  Module module = {"m", {}, {{Direction::input, 1, "a"}}, {}};
  module.items = {Wire{1, "x", any_of({})}, Wire{1, "y", any_of({net("a")})}};
  const std::string text = emit::to_verilog(module);
  EXPECT_NE(text.find("wire x = 1'b0;"), std::string::npos);
  EXPECT_NE(text.find("wire y = a;"), std::string::npos);
}

TEST(Verilog, LongConcatenationsAreBrokenBetweenParts) {
  const std::string part(40, 'a');
  Module module = {"m", {}, {}, {}};
  module.items = {Wire{1, "x", nullptr},
                  Assignment{net("x"), concatenation({net(part), net(part), net("b"), net(part)})}};
  EXPECT_NE(emit::to_verilog(module).find("  assign x =\n      {" + part + ", " + part +
                                          ", b,\n       " + part + "};\n"),
            std::string::npos)
      << emit::to_verilog(module);
}

TEST(Verilog, PhasesStandOnOneLineOrOnOneEach) {
  Module module;
  module.name = "phases";
  module.items = {
      PhaseFlag{"few", {Literal{4, 3}, Literal{4, 11}}},
      PhaseFlag{"squarer_start",
                {Literal{4, 0}, Literal{4, 3}, Literal{4, 6}, Literal{4, 9}, Literal{4, 12}}}};
  const std::string text = emit::to_verilog(module);
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
  Module module = {"m", {}, {}, {}};
  module.items = {Wire{1, "x", any_of({net(longest), net("b"), net(longest)})}};
  EXPECT_NE(emit::to_verilog(module).find("  wire x =\n      " + longest + "\n      | b\n      | " +
                                          longest + ";\n"),
            std::string::npos);
}

}  // namespace
}  // namespace mixcmp::test::verilog_test
