// squared_sums: fp_squared_sum in eight variants, only for the regression. The slots are {SUBTRACT,
// GRADUAL, cuts}, the cuts counting fastest: 0 none, 1 SOME_CUTS. Slots whose first and last bit
// are alike have a product of multipliers, the others a product of logic. If a product of logic has
// GRADUAL, a stage of its own finds its digits. Slots with an even number of ones have SUM_SELECTS
// = 2; among the others slot 7 has 1 and the rest 0.
`default_nettype none

module squared_sums #(
    parameter        EXPONENT_BITS = 4,
    parameter        PRECISION     = 4,
    parameter [22:0] SOME_CUTS     = 23'h0
) (
    input wire                               aclk,
    input wire [EXPONENT_BITS+PRECISION-1:0] a,
    input wire [EXPONENT_BITS+PRECISION-1:0] b
);

  localparam PACKED = EXPONENT_BITS + PRECISION;

  // The answers, which the test reads by hierarchical name, as in fp_units.
  wire [63:0] y[0:7]  /* verilator public_flat_rd */;

  genvar slot;

  generate
    for (slot = 0; slot < 8; slot = slot + 1) begin : built
      wire [PACKED-1:0] square;

      fp_squared_sum #(
          .EXPONENT_BITS(EXPONENT_BITS),
          .PRECISION    (PRECISION),
          .SUBTRACT     (slot / 4),
          .GRADUAL      (slot / 2 % 2),
          .EMBEDDED     (slot / 4 == slot % 2),
          .DIGIT_STAGE  (slot / 2 % 2),
          .SPLIT        (slot == 1 && SOME_CUTS[16]),
          .SUM_SELECTS  ((slot == 7) ? 1 : ((slot / 4 + slot / 2 + slot) % 2 == 0) ? 2 : 0),
          .CUTS         ((slot % 2 == 1) ? SOME_CUTS : 23'h0)
      ) unit (
          .aclk(aclk),
          .a   (a),
          .b   (b),
          .y   (square)
      );

      assign y[slot] = {{(64 - PACKED) {1'b0}}, square};
    end
  endgenerate

endmodule

`default_nettype wire
