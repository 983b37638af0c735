// common_cuts: the units of common cuts at small widths, only for the tests.
// Slot k has COUNT = 1 + k / MOSTS integers of WIDTH + MOST bits and a sign, where MOST = 1 + k %
// MOSTS. `drops` is the number of bits that they drop, and `cut` the first integer without these
// bits. `narrow_cut` is the same for the lowest WIDTH + 1 bits of the first, an integer that is
// narrower than the others. The masks of cuts are the slots' numbers.
`default_nettype none

module common_cuts #(
    parameter COUNTS = 3,
    parameter MOSTS  = 5,
    parameter WIDTH  = 2
) (
    input wire                             aclk,
    input wire [COUNTS*(WIDTH+MOSTS+1)-1:0] integers  // in two's complement
);

  // The answers, which the test reads by hierarchical name, zero-extended.
  wire [63:0] drops[0:COUNTS*MOSTS-1]  /* verilator public_flat_rd */;
  wire [63:0] cut[0:COUNTS*MOSTS-1]  /* verilator public_flat_rd */;
  wire [63:0] narrow_cut[0:COUNTS*MOSTS-1]  /* verilator public_flat_rd */;

  genvar slot, k;

  generate
    for (slot = 0; slot < COUNTS * MOSTS; slot = slot + 1) begin : g_slot
      localparam       COUNT     = 1 + slot / MOSTS;
      localparam       MOST      = 1 + slot % MOSTS;
      localparam       DROP_BITS = (MOST < 2) ? 1 : (MOST < 4) ? 2 : 3;
      localparam [1:0] CUTS      = slot;
      localparam [0:0] CUT       = slot / 4;

      wire [COUNT*(MOST+1)-1:0] excess;
      wire [DROP_BITS-1:0]      drop;
      wire [WIDTH:0]            y;
      wire [WIDTH:0]            narrow_y;

      for (k = 0; k < COUNT; k = k + 1) begin : g_excess
        assign excess[k*(MOST+1)+:MOST+1] = integers[k*(WIDTH+MOSTS+1)+WIDTH+:MOST+1];
      end

      fixed_common_drop #(
          .COUNT    (COUNT),
          .MOST     (MOST),
          .DROP_BITS(DROP_BITS),
          .CUTS     (CUTS)
      ) count (
          .aclk  (aclk),
          .excess(excess),
          .drop  (drop)
      );

      // The first integer waits here for the number of bits, which comes in a later cycle.
      reg [WIDTH+MOST:0] first[0:1];
      wire [WIDTH+MOST:0] waited =
          (CUTS == 3) ? first[1] : (CUTS == 0) ? integers[WIDTH+MOST:0] : first[0];

      always @(posedge aclk) begin
        first[0] <= integers[WIDTH+MOST:0];
        first[1] <= first[0];
      end

      fixed_common_cut #(
          .A_WIDTH  (WIDTH + MOST + 1),
          .MOST     (MOST),
          .DROP_BITS(DROP_BITS),
          .WIDTH    (WIDTH + 1),
          .CUTS     (CUT)
      ) unit (
          .aclk(aclk),
          .a   (waited),
          .drop(drop),
          .y   (y)
      );

      fixed_common_cut #(
          .A_WIDTH  (WIDTH + 1),
          .MOST     (MOST),
          .DROP_BITS(DROP_BITS),
          .WIDTH    (WIDTH + 1),
          .CUTS     (CUT)
      ) narrow_unit (
          .aclk(aclk),
          .a   (waited[WIDTH:0]),
          .drop(drop),
          .y   (narrow_y)
      );

      assign drops[slot]      = {{(64 - DROP_BITS) {1'b0}}, drop};
      assign cut[slot]        = {{(63 - WIDTH) {1'b0}}, y};
      assign narrow_cut[slot] = {{(63 - WIDTH) {1'b0}}, narrow_y};
    end
  endgenerate

endmodule

`default_nettype wire
