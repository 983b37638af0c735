// bound_binade: the largest power of two that is at most |x|, from x's exponent; 0 if x is zero.
// Latency: CUTS; initiation interval 1; no reset.
// The result is the smallest bound if x is subnormal, and infinite if x is an infinity or a NaN.
`default_nettype none

module bound_binade #(
  parameter       EXPONENT_BITS   = 8,    // bits of the exponent, 2 or more
  parameter       PRECISION       = 24,   // digits with the leading one, 2 or more
  parameter       BOUND_PRECISION = 4,    // digits of a bound, 1 to PRECISION
  parameter       GRADUAL         = 0,    // 1: x may be subnormal; 0: only with `exceptional`
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

  // Stage binade: only the exponent field counts.
  wire             unused_sign  = x[SIGN];
  wire [BOUND-1:0] s0_leading   = x[SIGN-1:SIGN-BOUND];
  wire             s0_subnormal = (GRADUAL != 0) && !(|x[SIGN-1:EXPONENT]) && (|x[EXPONENT-1:0]);

  fp_rank #(
    .WIDTH     (BOUND),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ((s0_leading & ~FRACTION) | (SMALLEST & {BOUND{s0_subnormal}})),
    .q   (y)
  );

endmodule

`default_nettype wire
