// block_units: the units of block floating point at small widths, only for the tests.
// Slot k of `maxima` has block_exponent for k + 1 operands; slot {width, sign} of `integers`, the
// sign counting fastest, has fixed_alignment. The masks of cuts are the slots' numbers.
`default_nettype none

module block_units #(
    parameter COUNTS = 9,
    parameter WIDTHS = 6
) (
    input wire                aclk,
    input wire [3*COUNTS-1:0] exponents,
    input wire [6:0]          x,  // s4e3
    input wire [2:0]          largest
);

  // The answers, which the test reads by hierarchical name: {not_finite, largest}; y,
  // zero-extended.
  wire [63:0] maxima[0:COUNTS-1]  /* verilator public_flat_rd */;
  wire [63:0] integers[0:2*WIDTHS-1]  /* verilator public_flat_rd */;

  genvar slot;

  generate
    for (slot = 0; slot < COUNTS; slot = slot + 1) begin : g_maxima
      localparam LEVELS = (slot < 2) ? 1 : (slot < 4) ? 2 : (slot < 8) ? 3 : 4;
      localparam [LEVELS-1:0] CUTS = slot;

      wire [2:0] maximum;
      wire       not_finite;

      block_exponent #(
          .COUNT        (slot + 1),
          .LEVELS       (LEVELS),
          .EXPONENT_BITS(3),
          .CUTS         (CUTS)
      ) unit (
          .aclk      (aclk),
          .exponents (exponents[3*(slot+1)-1:0]),
          .largest   (maximum),
          .not_finite(not_finite)
      );

      assign maxima[slot] = {60'd0, not_finite, maximum};
    end

    for (slot = 0; slot < 2 * WIDTHS; slot = slot + 1) begin : g_integers
      localparam       WIDTH  = 1 + slot / 2;
      localparam       SIGNED = slot % 2;
      localparam [1:0] CUTS   = slot / 2;

      wire [WIDTH+SIGNED-1:0] y;

      fixed_alignment #(
          .EXPONENT_BITS(3),
          .PRECISION    (4),
          .WIDTH        (WIDTH),
          .SIGNED       (SIGNED),
          .CUTS         (CUTS)
      ) unit (
          .aclk   (aclk),
          .x      (x),
          .largest(largest),
          .y      (y)
      );

      assign integers[slot] = {{(64 - WIDTH - SIGNED) {1'b0}}, y};
    end
  endgenerate

endmodule

`default_nettype wire
