// fixed_range_check: whether a is below LEAST or above GREATEST, all in two's complement.
// Latency: the population count of CUTS (one bit); initiation interval 1; no reset.
`default_nettype none

module fixed_range_check #(
  parameter               A_WIDTH  = 14,   // bits of a, 2 or more
  // the least value in range, at most GREATEST
  parameter [A_WIDTH-1:0] LEAST    = {1'b1, {(A_WIDTH - 1) {1'b0}}},
  // the greatest value in range
  parameter [A_WIDTH-1:0] GREATEST = {1'b0, {(A_WIDTH - 1) {1'b1}}},
  parameter [0:0]         CUTS     = 1'b0  // 1: a register behind the stage
) (
  input  wire               aclk,
  input  wire [A_WIDTH-1:0] a,
  output wire               out_of_range
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (A_WIDTH < 2) begin : g_refused_a A_WIDTH_is_below_2 refused (); end
    if ($signed(LEAST) > $signed(GREATEST))
      begin : g_refused_limits LEAST_is_above_GREATEST refused (); end
  endgenerate

  // Stage compare.
  wire s0_below = $signed(a) < $signed(LEAST);
  wire s0_above = $signed(a) > $signed(GREATEST);

  fp_rank #(
    .WIDTH     (1),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   (s0_below || s0_above),
    .q   (out_of_range)
  );

endmodule

`default_nettype wire
