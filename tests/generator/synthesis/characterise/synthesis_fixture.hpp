#pragma once

#include <gtest/gtest.h>

#include "generator/synthesis/characterise/router.hpp"
#include "generator/synthesis/characterise/synthesis.hpp"
#include "generator/synthesis/characterise/tools.hpp"
#include "tests/support/scratch_directory.hpp"

/// Small modules whose mapping is known, and runs of the real tools on them.
namespace mixcmp::test {

/// Two 16-bit registers in, their sum in a third: 48 flip-flops, 16 LUTs on a carry chain.
inline constexpr const char* adder = R"(
module dut (input wire aclk, input wire [15:0] a, input wire [15:0] b, output reg [15:0] y);
  reg [15:0] a_q, b_q;
  always @(posedge aclk) begin
    a_q <= a;
    b_q <= b;
    y <= a_q + b_q;
  end
endmodule
)";

/// Three adders: their operands came in 8, 24 and 40 cycles ago.
inline constexpr const char* delayed_adders = R"(
module delayed_adder #(parameter LENGTH = 8) (
  input wire aclk, input wire [15:0] a, input wire [15:0] b, output reg [15:0] y);
  reg [32*LENGTH-1:0] rank_q;
  always @(posedge aclk) begin
    rank_q <= {rank_q, a, b};
    y <= rank_q[32*LENGTH-1-:16] + rank_q[32*LENGTH-17-:16];
  end
endmodule
module dut (input wire aclk, input wire [15:0] a, input wire [15:0] b, output wire [47:0] y);
  delayed_adder #(.LENGTH(8)) one (.aclk(aclk), .a(a), .b(b), .y(y[15:0]));
  delayed_adder #(.LENGTH(24)) large (.aclk(aclk), .a(a), .b(b), .y(y[31:16]));
  delayed_adder #(.LENGTH(40)) two (.aclk(aclk), .a(a), .b(b), .y(y[47:32]));
endmodule
)";

/// 24 x 24 bits, registered on all sides.
inline constexpr const char* ice40_multiplier = R"(
module dut (input wire aclk, input wire [15:0] a, input wire [15:0] b, output wire [31:0] y);
  SB_MAC16 #(.TOPOUTPUT_SELECT(2'b11), .BOTOUTPUT_SELECT(2'b11), .PIPELINE_16x16_MULT_REG2(1'b1))
    multiplier (.CLK(aclk), .CE(1'b1), .A(a), .B(b), .O(y));
endmodule
)";

inline constexpr const char* multiplier = R"(
module dut (input wire aclk, input wire [23:0] a, input wire [23:0] b, output reg [47:0] y);
  reg [23:0] a_q, b_q;
  always @(posedge aclk) begin
    a_q <= a;
    b_q <= b;
    y <= a_q * b_q;
  end
endmodule
)";

/// Eight bits delayed by twelve cycles: eight shift registers of one LUT each on Xilinx.
inline constexpr const char* delay = R"(
module dut (input wire aclk, input wire [7:0] a, output wire [7:0] y);
  reg [95:0] line;
  always @(posedge aclk) line <= {line[87:0], a};
  assign y = line[95:88];
endmodule
)";

/// Eight registers with one reset, active low: one inverter on Xilinx.
inline constexpr const char* resets = R"(
module dut (input wire aclk, input wire aresetn, input wire [7:0] a, output reg [7:0] y);
  always @(posedge aclk) y <= aresetn ? a : 8'd0;
endmodule
)";

/// 1024 words of 18 bits, read and written once a cycle.
inline constexpr const char* memory = R"(
module dut (input wire aclk, input wire write, input wire [9:0] to, input wire [9:0] from,
            input wire [17:0] a, output reg [17:0] y);
  reg [17:0] words [0:1023];
  always @(posedge aclk) begin
    if (write) words[to] <= a;
    y <= words[from];
  end
endmodule
)";

/// 32 words of 16 bits in LUTs: read in the same cycle.
inline constexpr const char* small_memory = R"(
module dut (input wire aclk, input wire write, input wire [4:0] to, input wire [4:0] from,
            input wire [15:0] a, output reg [15:0] y);
  reg [15:0] words [0:31];
  always @(posedge aclk) begin
    if (write) words[to] <= a;
    y <= words[from] ^ {16{write}};
  end
endmodule
)";

/// All of the above in one.
inline constexpr const char* everything = R"(
module dut (input wire aclk, input wire write, input wire [9:0] to, input wire [9:0] from,
            input wire [23:0] a, input wire [23:0] b, output reg [15:0] sum,
            output reg [47:0] product, output wire [7:0] late, output reg [17:0] word,
            output reg [15:0] small_word);
  reg [15:0] a_q, b_q;
  reg [23:0] x_q, y_q;
  reg [95:0] line;
  reg [17:0] words [0:1023];
  reg [15:0] small_words [0:31];
  always @(posedge aclk) begin
    a_q <= a[15:0];
    b_q <= b[15:0];
    sum <= a_q + b_q;
    x_q <= a;
    y_q <= b;
    product <= x_q * y_q;
    line <= {line[87:0], a[7:0]};
    if (write) words[to] <= {a[17:0]};
    word <= words[from];
    if (write) small_words[to[4:0]] <= b[15:0];
    small_word <= small_words[from[4:0]] ^ {16{write}};
  end
  assign late = line[95:88];
endmodule
)";

/// Nothing but registers, 300 bits wide.
inline constexpr const char* wide_register = R"(
module dut (input wire aclk, input wire [299:0] a, output reg [299:0] y);
  always @(posedge aclk) y <= a;
endmodule
)";

class Synthesis : public testing::Test {
protected:
  static devices::Device device(const std::string& name) {
    return devices::find_device(name).value();
  }

  static const characterise::Router& router(std::string_view name) {
    return *characterise::router_of(device(std::string(name)));
  }

  Result<characterise::SynthesisResult> run(const char* text, const devices::Device& device,
                                            const characterise::SynthesisOptions& options) {
    return characterise::synthesise({.sources = {{"dut.v", text}}, .top = "dut"}, device, options,
                                    directory_.path());
  }

  devices::Area area(const char* text, const std::string& name) {
    const auto result = run(text, device(name), {.effort = characterise::TimingEffort::area_only});
    EXPECT_TRUE(result.ok()) << result.error().to_string();
    return result.ok() ? result->area : devices::Area{};
  }

  ScratchDirectory directory_;
};

#define SKIP_WITHOUT_YOSYS()                                   \
  if (!characterise::yosys_version(device("ice40-hx8k")).ok()) \
  GTEST_SKIP() << "yosys is not installed"
#define SKIP_WITHOUT_ROUTER(name)                                               \
  if (const auto tool = characterise::router_version(router(name)); !tool.ok()) \
  GTEST_SKIP() << "no router for " << name << ": " << tool.error().to_string()

}  // namespace mixcmp::test
