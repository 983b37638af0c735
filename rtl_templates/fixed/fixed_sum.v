// fixed_sum: the sum or the difference of a and b 2^SHIFT_B, less its DROPPED low bits.
// Latency: the population count of CUTS (one bit); initiation interval 1; no reset.
// Operands are in two's complement.
`default_nettype none

module fixed_sum #(
  parameter       A_WIDTH  = 14,   // bits of a, 1 or more
  parameter       B_WIDTH  = 14,   // bits of b, 1 or more
  parameter       SHIFT_B  = 0,    // places by which b is shifted up, 0 or more
  parameter       SUBTRACT = 0,    // 0: the sum; 1: the difference
  parameter       DROPPED  = 0,    // low bits of the sum that y lacks, 0 or more
  // bits of y, as its range needs; 1 to max(A_WIDTH, B_WIDTH + SHIFT_B) + 1 - DROPPED
  parameter       WIDTH    = 15,
  parameter [0:0] CUTS     = 1'b0  // 1: a register behind the stage
) (
  input  wire               aclk,
  input  wire [A_WIDTH-1:0] a,
  input  wire [B_WIDTH-1:0] b,
  output wire [WIDTH-1:0]   y
);

  localparam SUM = ((A_WIDTH > B_WIDTH + SHIFT_B) ? A_WIDTH : B_WIDTH + SHIFT_B) + 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (A_WIDTH < 1) begin : g_refused_a A_WIDTH_is_below_1 refused (); end
    if (B_WIDTH < 1) begin : g_refused_b B_WIDTH_is_below_1 refused (); end
    if (SHIFT_B < 0) begin : g_refused_shift SHIFT_B_is_below_0 refused (); end
    if (DROPPED < 0) begin : g_refused_dropped
      DROPPED_is_below_0 refused ();
    end else if ((WIDTH < 1) || (WIDTH + DROPPED > SUM)) begin : g_refused_width
      WIDTH_is_not_1_to_that_of_the_sum refused ();
    end
  endgenerate

  // Stage add. The bits of a below those of b are bits of the sum. One more bit stands below them,
  // since Verilog has no empty range if there are none.
  localparam HIGH = SUM - SHIFT_B;

  wire [SUM:0]    s0_a        = {{(SUM - A_WIDTH) {a[A_WIDTH-1]}}, a, 1'b0};
  wire [HIGH-1:0] s0_b        = {{(HIGH - B_WIDTH) {b[B_WIDTH-1]}}, b};
  wire [HIGH-1:0] s0_high     =
      (SUBTRACT != 0) ? s0_a[SUM:SHIFT_B+1] - s0_b : s0_a[SUM:SHIFT_B+1] + s0_b;
  wire [SUM:0]    s0_sum      = {s0_high, s0_a[SHIFT_B:0]};
  wire            unused_bits = ^s0_sum;

  fp_rank #(
    .WIDTH     (WIDTH),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   (s0_sum[DROPPED+1+:WIDTH]),
    .q   (y)
  );

endmodule

`default_nettype wire
