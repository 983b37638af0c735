// fixed_roots: fixed_square_root at small widths and shifts, only for the tests.
// fixed_roots_test.cpp describes the slots in the same words.
`default_nettype none

module fixed_roots #(
    parameter WIDTHS = 9,
    parameter SHIFTS = 9
) (
    input wire       aclk,
    input wire [8:0] a
);

  localparam SLOTS = WIDTHS * SHIFTS * 4;

  function integer larger(input integer first, input integer second);
    larger = (first > second) ? first : second;
  endfunction

  // The answers, which the test reads by hierarchical name.
  wire [63:0] roots[0:SLOTS-1]  /* verilator public_flat_rd */;

  genvar slot;

  // Slot {a's width, shift from -4 on, variant}: a shift that would drop all of a drops all but one
  // bit. Variants 2 and 3 have a root of one bit more than it needs; each has other cuts.
  generate
    for (slot = 0; slot < SLOTS; slot = slot + 1) begin : g_roots
      localparam        A     = 1 + slot / (4 * SHIFTS);
      localparam        SHIFT = larger(slot / 4 % SHIFTS - 4, 1 - A);
      localparam        WIDTH = (A + SHIFT + 1) / 2 + slot / 2 % 2;
      localparam [31:0] CUTS  = slot * 7 + slot / 8;

      wire [WIDTH-1:0] y;

      assign roots[slot] = {{(64 - WIDTH) {1'b0}}, y};

      fixed_square_root #(
          .A_WIDTH(A),
          .SHIFT  (SHIFT),
          .WIDTH  (WIDTH),
          .CUTS   (CUTS[WIDTH-1:0])
      ) unit (
          .aclk(aclk),
          .a   (a[A-1:0]),
          .y   (y)
      );
    end
  endgenerate

endmodule

`default_nettype wire
