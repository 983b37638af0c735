// bound_magnitude: an upper bound of |x|: its leading digits, rounded up.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// y is infinite if rounding leaves the format. It is undefined for a NaN, which must raise
// `exceptional` of the decision.
`default_nettype none

module bound_magnitude #(
  parameter       EXPONENT_BITS   = 8,     // bits of the exponent, 2 or more
  parameter       PRECISION       = 24,    // digits with the leading one, 2 or more
  parameter       BOUND_PRECISION = 4,     // digits of a bound, 1 to PRECISION
  parameter       GRADUAL         = 0,     // 1: x may be subnormal; 0: only with `exceptional`
  parameter [1:0] CUTS            = 2'b00  // a register behind stage k if bit k is 1
) (
  input  wire                                     aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0]       x,
  output wire [EXPONENT_BITS+BOUND_PRECISION-2:0] y
);

  localparam SIGN     = EXPONENT_BITS + PRECISION - 1;
  localparam EXPONENT = PRECISION - 1;
  localparam BOUND    = EXPONENT_BITS + BOUND_PRECISION - 1;
  localparam REST     = PRECISION - BOUND_PRECISION + 1;

  localparam [BOUND-1:0] FRACTION = {BOUND{1'b1}} >> EXPONENT_BITS;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if (BOUND_PRECISION < 1)
      begin : g_refused_bound_precision BOUND_PRECISION_is_below_1 refused (); end
    if (BOUND_PRECISION > PRECISION)
      begin : g_refused_more_digits BOUND_PRECISION_is_above_PRECISION refused (); end
  endgenerate

  // Stage reduce: with an extra place below the last one, s0_rest has a bit even if BOUND_PRECISION
  // = PRECISION. A subnormal number rounds up to the smallest bound, as if its leading digits were
  // ones.
  wire             unused_sign  = x[SIGN];
  wire [BOUND-1:0] s0_leading;
  wire [REST-1:0]  s0_rest;
  wire             s0_subnormal = (GRADUAL != 0) && !(|x[SIGN-1:EXPONENT]) && (|x[EXPONENT-1:0]);

  assign {s0_leading, s0_rest} = {x[SIGN-1:0], 1'b0};

  wire [BOUND-1:0] s1_leading;
  wire             s1_round_up;

  fp_rank #(
    .WIDTH     (BOUND + 1),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_leading | (FRACTION & {BOUND{s0_subnormal}}), s0_subnormal || (|s0_rest)}),
    .q   ({s1_leading, s1_round_up})
  );

  // Stage round: a carry out of the fraction gives the next power of two, or infinity above the
  // largest one.
  fp_rank #(
    .WIDTH     (BOUND),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   (s1_leading + {{(BOUND - 1) {1'b0}}, s1_round_up}),
    .q   (y)
  );

endmodule

`default_nettype wire
