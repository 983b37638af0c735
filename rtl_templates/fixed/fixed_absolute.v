// fixed_absolute: the absolute value of a, less its DROPPED low bits.
// Latency: the population count of CUTS (one bit); initiation interval 1; no reset.
// The operand is in two's complement.
`default_nettype none

module fixed_absolute #(
  parameter       A_WIDTH = 14,   // bits of a, 1 or more
  parameter       DROPPED = 0,    // low bits of the absolute value that y lacks, 0 or more
  parameter       WIDTH   = 14,   // bits of y, as its range needs; 1 to A_WIDTH - DROPPED
  parameter [0:0] CUTS    = 1'b0  // 1: a register behind the stage
) (
  input  wire               aclk,
  input  wire [A_WIDTH-1:0] a,
  output wire [WIDTH-1:0]   y
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (A_WIDTH < 1) begin : g_refused_a A_WIDTH_is_below_1 refused (); end
    if (DROPPED < 0) begin : g_refused_dropped
      DROPPED_is_below_0 refused ();
    end else if ((WIDTH < 1) || (WIDTH + DROPPED > A_WIDTH)) begin : g_refused_width
      WIDTH_is_not_1_to_that_of_the_operand refused ();
    end
  endgenerate

  // Stage negate: -a is ~a + 1.
  wire               s0_negative  = a[A_WIDTH-1];
  wire [A_WIDTH-1:0] s0_one       = {{(A_WIDTH - 1) {1'b0}}, s0_negative};
  wire [A_WIDTH-1:0] s0_magnitude = (a ^ {A_WIDTH{s0_negative}}) + s0_one;
  wire               unused_bits  = ^s0_magnitude;

  fp_rank #(
    .WIDTH     (WIDTH),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   (s0_magnitude[DROPPED+:WIDTH]),
    .q   (y)
  );

endmodule

`default_nettype wire
