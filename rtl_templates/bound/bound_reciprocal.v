// bound_reciprocal: a power of two at or above 1 / |x|, which has x's exponent negated.
// Latency: CUTS; initiation interval 1; no reset.
// The result is infinite if x is zero, subnormal, infinite or a NaN.
`default_nettype none

module bound_reciprocal #(
  parameter       EXPONENT_BITS   = 8,    // bits of the exponent, 2 or more
  parameter       PRECISION       = 24,   // digits with the leading one, 2 or more
  parameter       BOUND_PRECISION = 4,    // digits of a bound, 1 to PRECISION
  parameter [0:0] CUTS            = 1'b0  // 1: a register behind the stage
) (
  input  wire                                     aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0]       x,
  output wire [EXPONENT_BITS+BOUND_PRECISION-2:0] y
);

  localparam SIGN     = EXPONENT_BITS + PRECISION - 1;
  localparam EXPONENT = PRECISION - 1;
  localparam BOUND    = EXPONENT_BITS + BOUND_PRECISION - 1;

  localparam [BOUND-1:0] FRACTION = {BOUND{1'b1}} >> EXPONENT_BITS;
  localparam [BOUND-1:0] SMALLEST = FRACTION + 1'b1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if (BOUND_PRECISION < 1)
      begin : g_refused_bound_precision BOUND_PRECISION_is_below_1 refused (); end
    if (BOUND_PRECISION > PRECISION)
      begin : g_refused_more_digits BOUND_PRECISION_is_above_PRECISION refused (); end
  endgenerate

  // Stage negate: the result's exponent is 2 BIAS less the exponent. As 2 BIAS is all ones less
  // one, that is the complement less one. At both ends it is the complement itself: infinite for
  // exponent 0, and the smallest bound for the largest exponent.
  wire                     unused_sign     = x[SIGN];
  wire [EXPONENT-1:0]      unused_fraction = x[EXPONENT-1:0];
  wire [EXPONENT_BITS-1:0] s0_exponent     = x[SIGN-1:EXPONENT];
  wire                     s0_zero         = !(|s0_exponent);
  wire                     s0_largest      = (&s0_exponent[EXPONENT_BITS-1:1]) && !s0_exponent[0];
  wire                     s0_between      = !s0_zero && !s0_largest;
  wire [BOUND-1:0]         s0_complement   = ~(x[SIGN-1:SIGN-BOUND] | FRACTION);

  fp_rank #(
    .WIDTH     (BOUND),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   (s0_complement - (SMALLEST & {BOUND{s0_between}})),
    .q   (y)
  );

endmodule

`default_nettype wire
