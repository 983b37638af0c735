// fixed_common_cut: the WIDTH bits of a above its `drop` low bits; `drop` is 0 to MOST.
// Latency: the population count of CUTS (one bit); initiation interval 1; no reset.
// a is in two's complement.
`default_nettype none

module fixed_common_cut #(
  parameter       A_WIDTH   = 18,   // bits of a, 1 or more
  parameter       MOST      = 3,    // the largest drop, 1 or more
  parameter       DROP_BITS = 2,    // bits of the drop, 1 or more; 2^DROP_BITS > MOST
  parameter       WIDTH     = 14,   // bits of y, 1 to A_WIDTH
  parameter [0:0] CUTS      = 1'b0  // 1: a register behind the stage
) (
  input  wire                 aclk,
  input  wire [A_WIDTH-1:0]   a,
  input  wire [DROP_BITS-1:0] drop,
  output wire [WIDTH-1:0]     y
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (A_WIDTH < 1) begin : g_refused_a
      A_WIDTH_is_below_1 refused ();
    end else if ((WIDTH < 1) || (WIDTH > A_WIDTH)) begin : g_refused_width
      WIDTH_is_not_1_to_A_WIDTH refused ();
    end
    if (MOST < 1) begin : g_refused_most
      MOST_is_below_1 refused ();
    end else if ((DROP_BITS < 1) || ((MOST >> DROP_BITS) != 0)) begin : g_refused_drop
      DROP_BITS_do_not_hold_MOST refused ();
    end
  endgenerate

  // Stage shift. `drop` never exceeds MOST.
  wire [A_WIDTH+MOST-1:0] s0_extended = {{MOST{a[A_WIDTH-1]}}, a};
  wire [A_WIDTH+MOST-1:0] s0_shifted  = s0_extended >> drop;
  wire                    unused_bits = ^s0_shifted;

  fp_rank #(
    .WIDTH     (WIDTH),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   (s0_shifted[WIDTH-1:0]),
    .q   (y)
  );

endmodule

`default_nettype wire
