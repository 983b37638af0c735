// fp_range_check: fails if an operand breaks the promise made for it: its sign, and its leading
// magnitude bits (exponent first) from LEAST to GREATEST.
// Latency: CUTS; initiation interval 1; no reset.
// A zero's sign counts. NaNs and infinities fail if GREATEST is finite.
`default_nettype none

module fp_range_check #(
  parameter       EXPONENT_BITS = 8,    // bits of the operand's exponent, 2 or more
  parameter       PRECISION     = 24,   // digits with the leading one, 2 or more
  parameter       SIGN          = 0,    // promised sign: 0 any, 1 non-negative, 2 non-positive
  parameter       LEADING_BITS  = 0,    // magnitude bits that are compared, at most all; 0: none
  // Least value of the leading bits, at most GREATEST.
  parameter [EXPONENT_BITS+PRECISION-2:0] LEAST    = 0,
  // Greatest value of the leading bits, below 2^LEADING_BITS.
  parameter [EXPONENT_BITS+PRECISION-2:0] GREATEST = 0,
  parameter [0:0] CUTS          = 1'b0  // 1: a register behind the only stage
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] x,
  output wire                               fails
);

  localparam MAGNITUDE = EXPONENT_BITS + PRECISION - 1;
  localparam REST      = MAGNITUDE - LEADING_BITS;

  localparam [MAGNITUDE-1:0] LARGEST = {MAGNITUDE{1'b1}} >> REST;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if ((SIGN < 0) || (SIGN > 2)) begin : g_refused_sign SIGN_is_not_0_to_2 refused (); end
    if (LEADING_BITS < 0) begin : g_refused_leading_bits LEADING_BITS_is_below_0 refused (); end
    if (LEADING_BITS > MAGNITUDE)
      begin : g_refused_magnitude LEADING_BITS_is_above_the_magnitude refused (); end
    if (GREATEST > LARGEST)
      begin : g_refused_greatest GREATEST_is_too_large_for_LEADING_BITS refused (); end
    if (LEAST > GREATEST) begin : g_refused_least LEAST_is_above_GREATEST refused (); end
  endgenerate

  // Stage check: packed magnitudes have the order of integers. A limit that no magnitude breaks has
  // no comparison.
  wire [MAGNITUDE-1:0] s0_leading    = x[MAGNITUDE-1:0] >> REST;
  wire                 s0_wrong_sign = (SIGN == 1) ? x[MAGNITUDE] : (SIGN == 2) && !x[MAGNITUDE];
  wire                 s0_below      = (LEAST != 0) && (s0_leading < LEAST);
  wire                 s0_above      = (GREATEST != LARGEST) && (s0_leading > GREATEST);

  fp_rank #(
    .WIDTH     (1),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   (s0_wrong_sign || ((LEADING_BITS != 0) && (s0_below || s0_above))),
    .q   (fails)
  );

endmodule

`default_nettype wire
