// bound_at_most: 1 if bound <= |x|.
// Latency: CUTS; initiation interval 1; no reset.
// The result is undefined for a NaN, which must raise `exceptional` of the decision.
`default_nettype none

module bound_at_most #(
  parameter       EXPONENT_BITS   = 8,    // bits of the exponent, 2 or more
  parameter       PRECISION       = 24,   // digits with the leading one, 2 or more
  parameter       BOUND_PRECISION = 4,    // digits of a bound, 1 to PRECISION
  parameter [0:0] CUTS            = 1'b0  // 1: a register behind the stage
) (
  input  wire                                     aclk,
  input  wire [EXPONENT_BITS+BOUND_PRECISION-2:0] bound,
  input  wire [EXPONENT_BITS+PRECISION-1:0]       x,
  output wire                                     holds
);

  localparam SIGN  = EXPONENT_BITS + PRECISION - 1;
  localparam BOUND = EXPONENT_BITS + BOUND_PRECISION - 1;
  localparam REST  = PRECISION - BOUND_PRECISION + 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if (BOUND_PRECISION < 1)
      begin : g_refused_bound_precision BOUND_PRECISION_is_below_1 refused (); end
    if (BOUND_PRECISION > PRECISION)
      begin : g_refused_more_digits BOUND_PRECISION_is_above_PRECISION refused (); end
  endgenerate

  // Stage compare: where x has digits below the bound's, the bound has zeros, so only the leading
  // digits of x count.
  wire             unused_sign = x[SIGN];
  wire [BOUND-1:0] s0_leading;
  wire [REST-1:0]  s0_unused_rest;

  assign {s0_leading, s0_unused_rest} = {x[SIGN-1:0], 1'b0};

  fp_rank #(
    .WIDTH     (1),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   (bound <= s0_leading),
    .q   (holds)
  );

endmodule

`default_nettype wire
