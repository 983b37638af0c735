// embedded_multiplier: a * b, by a multiplier cell of iCE40 UltraPlus with the cell's registers.
// Yosys can find such cells itself (synth_ice40 -dsp), but it also moves adders into the cell that
// are too wide for it, and fails.
// Latency: the population count of CUTS (three bits); initiation interval 1; no reset.
// Multipliers with factors of more than 16 bits become logic.
`default_nettype none

module embedded_multiplier #(
  parameter       A_WIDTH  = 16,  // bits of a, 1 or more
  parameter       B_WIDTH  = 16,  // bits of b, 1 or more
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
    if ((A_WIDTH <= 16) && (B_WIDTH <= 16)) begin : g_cell
      // Each factor gets one bit more, which is not read, so that no repetition is empty.
      wire [16:0] a_extended  = {{(17 - A_WIDTH) {a_negative}}, a};
      wire [16:0] b_extended  = {{(17 - B_WIDTH) {b_negative}}, b};
      wire [31:0] whole;
      wire        unused_bits = ^{a_extended[16], b_extended[16], whole};

      SB_MAC16 #(
        .A_SIGNED                (SIGNED_A != 0),
        .B_SIGNED                (SIGNED_B != 0),
        .A_REG                   (CUTS[0]),
        .B_REG                   (CUTS[0]),
        .TOP_8x8_MULT_REG        (CUTS[2:1] == 2'b11),
        .BOT_8x8_MULT_REG        (CUTS[2:1] == 2'b11),
        .PIPELINE_16x16_MULT_REG1(CUTS[2:1] == 2'b11),
        .PIPELINE_16x16_MULT_REG2(CUTS[2:1] != 2'b00),
        .TOPOUTPUT_SELECT        (2'b11),
        .BOTOUTPUT_SELECT        (2'b11)
      ) multiplier (
        .CLK(aclk), .CE(1'b1),
        .A(a_extended[15:0]), .B(b_extended[15:0]), .C(16'd0), .D(16'd0),
        .O(whole), .CO(), .ACCUMCO(), .SIGNEXTOUT(),
        .IRSTTOP(1'b0), .IRSTBOT(1'b0), .ORSTTOP(1'b0), .ORSTBOT(1'b0),
        .AHOLD(1'b0), .BHOLD(1'b0), .CHOLD(1'b0), .DHOLD(1'b0),
        .OHOLDTOP(1'b0), .OHOLDBOT(1'b0), .OLOADTOP(1'b0), .OLOADBOT(1'b0),
        .ADDSUBTOP(1'b0), .ADDSUBBOT(1'b0), .CI(1'b0), .ACCUMCI(1'b0), .SIGNEXTIN(1'b0)
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
