// serial_squares: fp_serial_square in ten variants, only for the regression. Slots 0 to 7 are
// {TOWARD_ZERO, GRADUAL, cuts}, the cuts counting fastest: 0 for only the cuts that the unit needs,
// 1 for SOME_CUTS besides. Slots 8 and 9 promise that nothing is special, overflows or underflows.
`default_nettype none

module serial_squares #(
    parameter       EXPONENT_BITS        = 3,
    parameter       PRECISION            = 13,
    parameter       RESULT_EXPONENT_BITS = EXPONENT_BITS,
    parameter       RESULT_PRECISION     = PRECISION,
    parameter [6:0] SOME_CUTS            = 7'h0  // two in front of the steps, five behind
) (
    input wire                               aclk,
    input wire                               start,
    input wire [EXPONENT_BITS+PRECISION-1:0] a
);

  localparam CYCLES = (PRECISION + 5) / 6;
  localparam RESULT = RESULT_EXPONENT_BITS + RESULT_PRECISION;

  // The answers, which the test reads by hierarchical name, as in fp_units.
  wire [63:0] y   [0:9]  /* verilator public_flat_rd */;
  wire        flag[0:9]  /* verilator public_flat_rd */;

  genvar slot;

  generate
    for (slot = 0; slot < 10; slot = slot + 1) begin : built
      localparam [6:0] OUTER = (slot % 2 == 1) ? SOME_CUTS : 7'h0;

      wire [RESULT-1:0] square;

      fp_serial_square #(
          .EXPONENT_BITS       (EXPONENT_BITS),
          .PRECISION           (PRECISION),
          .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
          .RESULT_PRECISION    (RESULT_PRECISION),
          .SPECIAL_OPERANDS    (slot < 8),
          .OVERFLOW            (slot < 8),
          .UNDERFLOW           (slot < 8),
          .GRADUAL             (slot / 2 % 2),
          .TOWARD_ZERO         (slot / 4 % 2),
          .SUM_SELECTS         (slot % 3),
          .CUTS                ({OUTER[6:2], {(CYCLES + 3) {1'b1}}, OUTER[1:0]})
      ) unit (
          .aclk       (aclk),
          .start      (start),
          .a          (a),
          .y          (square),
          .exceptional(flag[slot])
      );

      assign y[slot] = {{(64 - RESULT) {1'b0}}, square};
    end
  endgenerate

endmodule

`default_nettype wire
