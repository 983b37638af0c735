// fp_compare: the order of a and b: 0 less, 1 equal, 2 greater, 3 unordered.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// Special values as IEEE 754: -0 equals +0, a NaN is unordered.
`default_nettype none

module fp_compare #(
  parameter       EXPONENT_BITS = 8,     // bits of an operand's exponent, 2 or more
  parameter       PRECISION     = 24,    // digits with the leading one, 2 or more
  parameter       GRADUAL       = 0,     // 1: subnormals; 0: flushed to zero
  parameter [1:0] CUTS          = 2'b00  // a register behind stage k if bit k is 1
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] a,
  input  wire [EXPONENT_BITS+PRECISION-1:0] b,
  output wire [1:0]                         verdict
);

  localparam SIGN     = EXPONENT_BITS + PRECISION - 1;
  localparam EXPONENT = PRECISION - 1;
  localparam HALF     = SIGN / 2;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
  endgenerate

  // Stage compare: packed magnitudes have the order of integers. Fields of many bits are reduced to
  // one bit each. Stage "decide" combines these reductions.
  wire s0_a_fraction  = |a[EXPONENT-1:0];
  wire s0_b_fraction  = |b[EXPONENT-1:0];
  wire s0_a_field     = |a[SIGN-1:EXPONENT];
  wire s0_b_field     = |b[SIGN-1:EXPONENT];
  wire s0_a_all_ones  = &a[SIGN-1:EXPONENT];
  wire s0_b_all_ones  = &b[SIGN-1:EXPONENT];
  wire s0_not_below   = a[SIGN-1:0] >= b[SIGN-1:0];  // a carry out, which needs no gate behind it
  wire s0_same_upper  = a[SIGN-1:HALF] == b[SIGN-1:HALF];
  wire s0_same_lower  = a[HALF-1:0] == b[HALF-1:0];

  wire s1_a_sign;
  wire s1_b_sign;
  wire s1_a_fraction;
  wire s1_b_fraction;
  wire s1_a_field;
  wire s1_b_field;
  wire s1_a_all_ones;
  wire s1_b_all_ones;
  wire s1_not_below;
  wire s1_same_upper;
  wire s1_same_lower;

  fp_rank #(
    .WIDTH     (11),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({a[SIGN], b[SIGN], s0_a_fraction, s0_b_fraction, s0_a_field, s0_b_field,
           s0_a_all_ones, s0_b_all_ones, s0_not_below, s0_same_upper, s0_same_lower}),
    .q   ({s1_a_sign, s1_b_sign, s1_a_fraction, s1_b_fraction, s1_a_field, s1_b_field,
           s1_a_all_ones, s1_b_all_ones, s1_not_below, s1_same_upper, s1_same_lower})
  );

  // Stage decide: unlike signs give the order; the order of two negative numbers is that of their
  // magnitudes, reversed.
  wire s1_fraction  = (GRADUAL != 0) && (s1_a_fraction || s1_b_fraction);
  wire s1_both_zero = !s1_a_field && !s1_b_field && !s1_fraction;
  wire s1_unordered = (s1_a_all_ones && s1_a_fraction) || (s1_b_all_ones && s1_b_fraction);
  wire s1_like      = s1_a_sign == s1_b_sign;
  wire s1_same      = s1_same_upper && s1_same_lower;
  wire s1_equal     = s1_both_zero || (s1_like && s1_same);
  wire s1_less      = s1_like ? (!s1_not_below ^ s1_a_sign) : s1_a_sign;

  fp_rank #(
    .WIDTH     (2),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ({s1_unordered || !(s1_equal || s1_less), s1_unordered || s1_equal}),
    .q   (verdict)
  );

endmodule

`default_nettype wire
