// fixed_constant_decision: decides the sign of a difference by constants: greater (2) if it is at
// least GREATER_FROM, less (0) if it is at most LESS_TO.
// Latency: the population count of CUTS (one bit); initiation interval 1; no reset.
// A difference out of range is undecided. The difference and the constants are in two's complement.
// A verdict is valid where `decided` is 1; in a reference (EXACT = 2) everywhere.
`default_nettype none

module fixed_constant_decision #(
  parameter           WIDTH        = 30,   // bits of the difference, 1 or more
  parameter [WIDTH:0] GREATER_FROM = 1,    // the least difference that is greater
  // the greatest difference that is less, below GREATER_FROM
  parameter [WIDTH:0] LESS_TO      = {(WIDTH + 1) {1'b1}},
  // differences in between: 0: undecided; 1: equal (1); 2: equal, of a reference, which says
  // unordered (3) where a difference is out of range
  parameter           EXACT        = 0,
  parameter [0:0]     CUTS         = 1'b0  // 1: a register behind the stage
) (
  input  wire             aclk,
  input  wire [WIDTH-1:0] difference,
  input  wire             out_of_range,
  output wire [1:0]       verdict,
  output wire             decided
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if ($signed(LESS_TO) >= $signed(GREATER_FROM))
      begin : g_refused_constants LESS_TO_is_not_below_GREATER_FROM refused (); end
  endgenerate

  // Stage compare.
  wire [WIDTH:0] s0_difference = {difference[WIDTH-1], difference};
  wire           s0_greater    = $signed(s0_difference) >= $signed(GREATER_FROM);
  wire           s0_less       = $signed(s0_difference) <= $signed(LESS_TO);
  wire           s0_equal      = (EXACT != 0) && !s0_greater && !s0_less;
  wire           s0_unordered  = (EXACT == 2) && out_of_range;

  fp_rank #(
    .WIDTH     (3),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_greater || s0_unordered, s0_equal || s0_unordered,
           (s0_greater || s0_less || s0_equal) && !out_of_range}),
    .q   ({verdict, decided})
  );

endmodule

`default_nettype wire
