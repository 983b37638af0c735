// fp_interval_decision: decides the sign of a difference that lies between minimum and maximum:
// greater (2) iff the minimum is above zero, less (0) iff the maximum is below it.
// Latency: CUTS; initiation interval 1; no reset.
// A verdict is valid where `decided` is 1. A NaN in either bound never decides.
`default_nettype none

module fp_interval_decision #(
  parameter       EXPONENT_BITS = 8,    // bits of a bound's exponent, 2 or more
  parameter       PRECISION     = 24,   // digits with the leading one, 2 or more
  parameter [0:0] CUTS          = 1'b0  // 1: a register behind the only stage
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] minimum,
  input  wire [EXPONENT_BITS+PRECISION-1:0] maximum,
  output wire [1:0]                         verdict,
  output wire                               decided
);

  localparam SIGN     = EXPONENT_BITS + PRECISION - 1;
  localparam EXPONENT = PRECISION - 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
  endgenerate

  // Stage decide: a bound is beyond zero if its sign says so and it is not a zero.
  wire s0_minimum_nan = (&minimum[SIGN-1:EXPONENT]) && (|minimum[EXPONENT-1:0]);
  wire s0_maximum_nan = (&maximum[SIGN-1:EXPONENT]) && (|maximum[EXPONENT-1:0]);
  wire s0_unordered   = s0_minimum_nan || s0_maximum_nan;
  wire s0_greater     = !minimum[SIGN] && (|minimum[SIGN-1:0]);
  wire s0_less        = maximum[SIGN] && (|maximum[SIGN-1:0]);

  fp_rank #(
    .WIDTH     (3),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_greater, 1'b0, (s0_greater || s0_less) && !s0_unordered}),
    .q   ({verdict, decided})
  );

endmodule

`default_nettype wire
