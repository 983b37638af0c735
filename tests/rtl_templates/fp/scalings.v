// scalings: fp_convert by every power of two that is a normal number of the operand's format, only
// for the regression. The slots are {scale, GRADUAL, TOWARD_ZERO, promised, cut}, the scales
// counting slowest; promised: SPECIAL_OPERANDS, OVERFLOW and UNDERFLOW are 0; cut: with three
// cycles.
`default_nettype none

module scalings #(
    parameter EXPONENT_BITS        = 4,
    parameter PRECISION            = 4,
    parameter RESULT_EXPONENT_BITS = 4,
    parameter RESULT_PRECISION     = 4,
    parameter LARGEST              = (1 << (EXPONENT_BITS - 1)) - 1,
    parameter SLOTS                = 32 * LARGEST
) (
    input wire                               aclk,
    input wire [EXPONENT_BITS+PRECISION-1:0] a
);

  // The answers, which the test reads by hierarchical name, as in fp_units.
  wire [63:0] y   [0:SLOTS-1]  /* verilator public_flat_rd */;
  wire        flag[0:SLOTS-1]  /* verilator public_flat_rd */;

  genvar slot;

  generate
    for (slot = 0; slot < SLOTS; slot = slot + 1) begin : built
      wire [RESULT_EXPONENT_BITS+RESULT_PRECISION-1:0] scaled;

      fp_convert #(
          .EXPONENT_BITS       (EXPONENT_BITS),
          .PRECISION           (PRECISION),
          .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
          .RESULT_PRECISION    (RESULT_PRECISION),
          .SCALE               (slot / 16 - LARGEST + 1),
          .SPECIAL_OPERANDS    (1 - slot / 2 % 2),
          .OVERFLOW            (1 - slot / 2 % 2),
          .UNDERFLOW           (1 - slot / 2 % 2),
          .GRADUAL             (slot / 8 % 2),
          .TOWARD_ZERO         (slot / 4 % 2),
          .CUTS                ((slot % 2 != 0) ? 6'b101010 : 6'b000000)
      ) unit (
          .aclk       (aclk),
          .a          (a),
          .y          (scaled),
          .exceptional(flag[slot])
      );
      assign y[slot] = {{(64 - RESULT_EXPONENT_BITS - RESULT_PRECISION) {1'b0}}, scaled};
    end
  endgenerate

endmodule

`default_nettype wire
