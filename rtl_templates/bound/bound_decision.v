// bound_decision: decides the sign of a difference: less (0) or greater (2). It decides iff the
// difference's magnitude is more than GUARD_ULP above the bound of its error, and no operation
// behind the difference or the bound was exceptional.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// A verdict is valid where `decided` is 1. `exceptional` must be 1 if the difference is a NaN.
// No finite difference exceeds an infinite bound.
`default_nettype none

module bound_decision #(
  parameter EXPONENT_BITS   = 8,     // bits of the exponent, 2 or more
  parameter PRECISION       = 24,    // digits with the leading one, 2 or more
  parameter BOUND_PRECISION = 4,     // digits of a bound, 1 to PRECISION
  // margin above the bound, in steps of the difference's encoding; 0: none
  parameter [EXPONENT_BITS+PRECISION-1:0] GUARD_ULP = 0,
  parameter [1:0] CUTS      = 2'b00  // a register behind stage k if bit k is 1
) (
  input  wire                                     aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0]       difference,
  input  wire [EXPONENT_BITS+BOUND_PRECISION-2:0] bound,
  input  wire                                     exceptional,
  output wire [1:0]                               verdict,
  output wire                                     decided
);

  localparam SIGN  = EXPONENT_BITS + PRECISION - 1;
  localparam BOUND = EXPONENT_BITS + BOUND_PRECISION - 1;

  // REST masks the places below the bound's digits. GUARD_LOW is the guard's part in these places.
  localparam [SIGN:0] REST       = ~({(SIGN + 1) {1'b1}} << (PRECISION - BOUND_PRECISION));
  localparam [SIGN:0] GUARD_LOW  = GUARD_ULP & REST;
  localparam [SIGN:0] GUARD_HIGH = GUARD_ULP >> (PRECISION - BOUND_PRECISION);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if (BOUND_PRECISION < 1)
      begin : g_refused_bound_precision BOUND_PRECISION_is_below_1 refused (); end
    if (BOUND_PRECISION > PRECISION)
      begin : g_refused_more_digits BOUND_PRECISION_is_above_PRECISION refused (); end
  endgenerate

  // Stage limit: the bound has zeros in the places that it lacks, so a guard that fits into them
  // needs no adder.
  wire [BOUND-1:0] s0_leading = difference[SIGN-1:SIGN-BOUND];
  wire             s0_beyond  = (difference & REST) > GUARD_LOW;
  wire [BOUND+1:0] s0_limit   = {2'b00, bound} + {1'b0, GUARD_HIGH[BOUND:0]};

  wire [BOUND-1:0] s1_leading;
  wire [BOUND+1:0] s1_limit;
  wire             s1_beyond;
  wire             s1_less;
  wire             s1_exceptional;

  fp_rank #(
    .WIDTH     (2 * BOUND + 5),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_leading, s0_limit, s0_beyond, difference[SIGN], exceptional}),
    .q   ({s1_leading, s1_limit, s1_beyond, s1_less, s1_exceptional})
  );

  // Stage compare: leading + ~limit carries if leading > limit. s1_beyond enters as the carry out
  // of an extra last place; with it, the sum carries even if leading = limit.
  wire             s1_exceeds;
  wire [BOUND+2:0] s1_unused_places;

  assign {s1_exceeds, s1_unused_places} =
      {3'b000, s1_leading, 1'b1} + {1'b0, ~s1_limit, s1_beyond};

  fp_rank #(
    .WIDTH     (3),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ({!s1_less, 1'b0, s1_exceeds && !s1_exceptional}),
    .q   ({verdict, decided})
  );

endmodule

`default_nettype wire
