// fixed_operands: fixed_operand and fixed_grid_operand for some tops and widths, unsigned and
// signed, only for the tests. Slot {top, width, sign} of the answers, the sign counting fastest, has
// the mask of cuts that is the slot's number modulo 4, or modulo 8 on a grid.
`default_nettype none

module fixed_operands #(
    parameter EXPONENT_BITS = 4,
    parameter PRECISION     = 4,
    parameter FIRST_TOP     = -5,
    parameter TOP_STEP      = 1,
    parameter TOPS          = 14,
    parameter FIRST_WIDTH   = 1,
    parameter WIDTH_STEP    = 1,
    parameter WIDTHS        = 9
) (
    input wire                               aclk,
    input wire [EXPONENT_BITS+PRECISION-1:0] x
);

  localparam SLOTS = 2 * TOPS * WIDTHS;

  // The answers, which the test reads by hierarchical name: {out_of_range, y}, y zero-extended.
  wire [63:0] answers[0:SLOTS-1]  /* verilator public_flat_rd */;
  wire [63:0] grid_answers[0:SLOTS-1]  /* verilator public_flat_rd */;

  genvar slot;

  generate
    for (slot = 0; slot < SLOTS; slot = slot + 1) begin : each_slot
      localparam       SIGNED = slot % 2;
      localparam       WIDTH  = FIRST_WIDTH + WIDTH_STEP * ((slot / 2) % WIDTHS);
      localparam       TOP    = FIRST_TOP + TOP_STEP * (slot / 2 / WIDTHS);
      localparam [2:0] CUTS   = slot;

      wire [WIDTH+SIGNED-1:0] y;
      wire                    out_of_range;
      wire [WIDTH+SIGNED-1:0] grid_y;
      wire                    off_grid;

      fixed_operand #(
          .EXPONENT_BITS(EXPONENT_BITS),
          .PRECISION    (PRECISION),
          .TOP          (TOP),
          .WIDTH        (WIDTH),
          .SIGNED       (SIGNED),
          .CUTS         (CUTS[1:0])
      ) operand (
          .aclk        (aclk),
          .x           (x),
          .y           (y),
          .out_of_range(out_of_range)
      );

      fixed_grid_operand #(
          .EXPONENT_BITS(EXPONENT_BITS),
          .PRECISION    (PRECISION),
          .TOP          (TOP),
          .WIDTH        (WIDTH),
          .SIGNED       (SIGNED),
          .CUTS         (CUTS)
      ) grid_operand (
          .aclk        (aclk),
          .x           (x),
          .y           (grid_y),
          .out_of_range(off_grid)
      );

      assign answers[slot]      = {out_of_range, {(63 - WIDTH - SIGNED) {1'b0}}, y};
      assign grid_answers[slot] = {off_grid, {(63 - WIDTH - SIGNED) {1'b0}}, grid_y};
    end
  endgenerate

endmodule

`default_nettype wire
