// fixed_overflow: whether a does not fit WIDTH bits, both in two's complement.
// Latency: the population count of CUTS (one bit); initiation interval 1; no reset.
`default_nettype none

module fixed_overflow #(
  parameter       A_WIDTH = 14,   // bits of a, 2 or more
  parameter       WIDTH   = 10,   // bits that a should fit, 1 to A_WIDTH - 1
  parameter [0:0] CUTS    = 1'b0  // 1: a register behind the stage
) (
  input  wire               aclk,
  input  wire [A_WIDTH-1:0] a,
  output wire               overflow
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((WIDTH < 1) || (WIDTH >= A_WIDTH))
      begin : g_refused_width WIDTH_is_not_1_to_below_A_WIDTH refused (); end
  endgenerate

  // Stage compare: if a fits, its bits from the narrower sign on are all alike.
  wire [A_WIDTH-WIDTH:0] s0_signs = a[A_WIDTH-1:WIDTH-1];

  fp_rank #(
    .WIDTH     (1),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   (!(&s0_signs) && (|s0_signs)),
    .q   (overflow)
  );

  generate
    if (WIDTH > 1) begin : g_low
      wire unused_low = ^a[WIDTH-2:0];
    end
  endgenerate

endmodule

`default_nettype wire
