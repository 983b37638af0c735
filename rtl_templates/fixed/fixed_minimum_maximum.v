// fixed_minimum_maximum: the smaller or the larger of a and b, less its DROPPED low bits.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// Operands are in two's complement.
`default_nettype none

module fixed_minimum_maximum #(
  parameter       A_WIDTH = 14,    // bits of a, 1 or more
  parameter       B_WIDTH = 14,    // bits of b, 1 or more
  parameter       MAXIMUM = 0,     // 0: the smaller of a and b; 1: the larger
  parameter       DROPPED = 0,     // low bits of the result that y lacks, 0 or more
  // bits of y, as its range needs; 1 to max(A_WIDTH, B_WIDTH) + 1 - DROPPED
  parameter       WIDTH   = 14,
  parameter [1:0] CUTS    = 2'b00  // a register behind stage k if bit k is 1
) (
  input  wire               aclk,
  input  wire [A_WIDTH-1:0] a,
  input  wire [B_WIDTH-1:0] b,
  output wire [WIDTH-1:0]   y
);

  localparam COMMON = ((A_WIDTH > B_WIDTH) ? A_WIDTH : B_WIDTH) + 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (A_WIDTH < 1) begin : g_refused_a A_WIDTH_is_below_1 refused (); end
    if (B_WIDTH < 1) begin : g_refused_b B_WIDTH_is_below_1 refused (); end
    if (DROPPED < 0) begin : g_refused_dropped
      DROPPED_is_below_0 refused ();
    end else if ((WIDTH < 1) || (WIDTH + DROPPED > COMMON)) begin : g_refused_width
      WIDTH_is_not_1_to_that_of_an_operand refused ();
    end
  endgenerate

  // Stage compare.
  wire [COMMON-1:0] s0_a    = {{(COMMON - A_WIDTH) {a[A_WIDTH-1]}}, a};
  wire [COMMON-1:0] s0_b    = {{(COMMON - B_WIDTH) {b[B_WIDTH-1]}}, b};
  wire              s0_less = $signed(s0_a) < $signed(s0_b);

  wire [WIDTH-1:0] s1_a;
  wire [WIDTH-1:0] s1_b;
  wire             s1_take_a;

  fp_rank #(
    .WIDTH     (2 * WIDTH + 1),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_a[DROPPED+:WIDTH], s0_b[DROPPED+:WIDTH], s0_less ^ (MAXIMUM != 0)}),
    .q   ({s1_a, s1_b, s1_take_a})
  );

  // Stage select.
  fp_rank #(
    .WIDTH     (WIDTH),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   (s1_take_a ? s1_a : s1_b),
    .q   (y)
  );

endmodule

`default_nettype wire
