// embedded_multiplier: a * b, by a multiplier cell of ECP5 with the cell's registers, which Yosys
// does not use by itself.
// Latency: the population count of CUTS (three bits); initiation interval 1; no reset.
// Multipliers with a factor of more than 18 bits, or without a register, are left to synthesis.
`default_nettype none

module embedded_multiplier #(
  parameter       A_WIDTH  = 18,  // bits of a, 1 or more
  parameter       B_WIDTH  = 18,  // bits of b, 1 or more
  parameter       SIGNED_A = 0,   // 1: a is in two's complement; 0: a is unsigned
  parameter       SIGNED_B = 0,   // 1: b is in two's complement; 0: b is unsigned
  // Registers: bit 0 of the factors, bits 1 and 2 of the product.
  parameter [2:0] CUTS     = 3'b000
) (
  input  wire                       aclk,
  input  wire [A_WIDTH-1:0]         a,
  input  wire [B_WIDTH-1:0]         b,
  output wire [A_WIDTH+B_WIDTH-1:0] product
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (A_WIDTH < 1) begin : g_refused_a A_WIDTH_is_below_1 refused (); end
    if (B_WIDTH < 1) begin : g_refused_b B_WIDTH_is_below_1 refused (); end
  endgenerate

  wire a_negative = (SIGNED_A != 0) && a[A_WIDTH-1];
  wire b_negative = (SIGNED_B != 0) && b[B_WIDTH-1];

  generate
    if ((CUTS != 0) && (A_WIDTH <= 18) && (B_WIDTH <= 18)) begin : g_cell
      wire [17:0] a_extended;
      wire [17:0] b_extended;
      wire [35:0] whole;
      wire        unused_bits = ^whole;

      if (A_WIDTH < 18) begin : g_short_a
        assign a_extended = {{(18 - A_WIDTH) {a_negative}}, a};
      end else begin : g_whole_a
        assign a_extended = a;
      end
      if (B_WIDTH < 18) begin : g_short_b
        assign b_extended = {{(18 - B_WIDTH) {b_negative}}, b};
      end else begin : g_whole_b
        assign b_extended = b;
      end

      MULT18X18D #(
        .REG_INPUTA_CLK  (CUTS[0] ? "CLK0" : "NONE"),
        .REG_INPUTB_CLK  (CUTS[0] ? "CLK0" : "NONE"),
        .REG_PIPELINE_CLK((CUTS[2:1] == 2'b11) ? "CLK0" : "NONE"),
        .REG_OUTPUT_CLK  ((CUTS[2:1] != 2'b00) ? "CLK0" : "NONE")
      ) multiplier (
        .CLK0(aclk), .CE0(1'b1), .RST0(1'b0),
        .SIGNEDA(SIGNED_A != 0), .SIGNEDB(SIGNED_B != 0), .SOURCEA(1'b0), .SOURCEB(1'b0),
        .A0(a_extended[0]), .A1(a_extended[1]), .A2(a_extended[2]), .A3(a_extended[3]),
        .A4(a_extended[4]), .A5(a_extended[5]), .A6(a_extended[6]), .A7(a_extended[7]),
        .A8(a_extended[8]), .A9(a_extended[9]), .A10(a_extended[10]), .A11(a_extended[11]),
        .A12(a_extended[12]), .A13(a_extended[13]), .A14(a_extended[14]), .A15(a_extended[15]),
        .A16(a_extended[16]), .A17(a_extended[17]),
        .B0(b_extended[0]), .B1(b_extended[1]), .B2(b_extended[2]), .B3(b_extended[3]),
        .B4(b_extended[4]), .B5(b_extended[5]), .B6(b_extended[6]), .B7(b_extended[7]),
        .B8(b_extended[8]), .B9(b_extended[9]), .B10(b_extended[10]), .B11(b_extended[11]),
        .B12(b_extended[12]), .B13(b_extended[13]), .B14(b_extended[14]), .B15(b_extended[15]),
        .B16(b_extended[16]), .B17(b_extended[17]),
        .C0(1'b0), .C1(1'b0), .C2(1'b0), .C3(1'b0), .C4(1'b0), .C5(1'b0),
        .C6(1'b0), .C7(1'b0), .C8(1'b0), .C9(1'b0), .C10(1'b0), .C11(1'b0),
        .C12(1'b0), .C13(1'b0), .C14(1'b0), .C15(1'b0), .C16(1'b0), .C17(1'b0),
        .P0(whole[0]), .P1(whole[1]), .P2(whole[2]), .P3(whole[3]),
        .P4(whole[4]), .P5(whole[5]), .P6(whole[6]), .P7(whole[7]),
        .P8(whole[8]), .P9(whole[9]), .P10(whole[10]), .P11(whole[11]),
        .P12(whole[12]), .P13(whole[13]), .P14(whole[14]), .P15(whole[15]),
        .P16(whole[16]), .P17(whole[17]), .P18(whole[18]), .P19(whole[19]),
        .P20(whole[20]), .P21(whole[21]), .P22(whole[22]), .P23(whole[23]),
        .P24(whole[24]), .P25(whole[25]), .P26(whole[26]), .P27(whole[27]),
        .P28(whole[28]), .P29(whole[29]), .P30(whole[30]), .P31(whole[31]),
        .P32(whole[32]), .P33(whole[33]), .P34(whole[34]), .P35(whole[35])
      );

      assign product = whole[A_WIDTH+B_WIDTH-1:0];
    end else begin : g_inferred
      wire [A_WIDTH:0]           a_extended;
      wire [B_WIDTH:0]           b_extended;
      wire [A_WIDTH+B_WIDTH-1:0] whole = $signed(a_extended) * $signed(b_extended);

      fp_rank #(
        .WIDTH     (A_WIDTH + B_WIDTH + 2),
        .REGISTERED(CUTS[0])
      ) factors (
        .aclk(aclk),
        .d   ({a_negative, a, b_negative, b}),
        .q   ({a_extended, b_extended})
      );

      fp_ranks #(
        .WIDTH(A_WIDTH + B_WIDTH),
        .COUNT(2),
        .CUTS (CUTS[2:1])
      ) ranks (
        .aclk(aclk),
        .d   (whole),
        .q   (product)
      );
    end
  endgenerate

endmodule

`default_nettype wire
