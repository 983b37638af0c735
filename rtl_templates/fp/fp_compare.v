// fp_compare: the order of a and b: 0 less, 1 equal, 2 greater, 3 unordered.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// Special values as IEEE 754: -0 equals +0, a NaN is unordered.
`default_nettype none

module fp_compare #(
  parameter       EXPONENT_BITS = 8,
  parameter       PRECISION     = 24,
  parameter       GRADUAL       = 0,
  parameter [1:0] CUTS          = 2'b00
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] a,
  input  wire [EXPONENT_BITS+PRECISION-1:0] b,
  output wire [1:0]                         verdict
);

  localparam SIGN     = EXPONENT_BITS + PRECISION - 1;
  localparam EXPONENT = PRECISION - 1;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent
      EXPONENT_BITS_is_below_2 refused ();
    end
    if (PRECISION < 2) begin : g_refused_precision
      PRECISION_is_below_2 refused ();
    end
  endgenerate

  // Stage compare: packed magnitudes order as integers.
  wire s0_a_fraction  = |a[EXPONENT-1:0];
  wire s0_b_fraction  = |b[EXPONENT-1:0];
  wire s0_a_zero      = !(|a[SIGN-1:EXPONENT]) && !((GRADUAL != 0) && s0_a_fraction);
  wire s0_b_zero      = !(|b[SIGN-1:EXPONENT]) && !((GRADUAL != 0) && s0_b_fraction);
  wire s0_a_nan       = (&a[SIGN-1:EXPONENT]) && s0_a_fraction;
  wire s0_b_nan       = (&b[SIGN-1:EXPONENT]) && s0_b_fraction;
  wire s0_both_zero   = s0_a_zero && s0_b_zero;
  wire s0_unordered   = s0_a_nan || s0_b_nan;
  wire s0_below       = a[SIGN-1:0] < b[SIGN-1:0];
  wire s0_same        = a[SIGN-1:0] == b[SIGN-1:0];

  wire s1_a_sign;
  wire s1_b_sign;
  wire s1_both_zero;
  wire s1_unordered;
  wire s1_below;
  wire s1_same;

  fp_rank #(
    .WIDTH     (6),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({a[SIGN], b[SIGN], s0_both_zero, s0_unordered, s0_below, s0_same}),
    .q   ({s1_a_sign, s1_b_sign, s1_both_zero, s1_unordered, s1_below, s1_same})
  );

  // Stage decide: unlike signs decide alone, negative numbers order against their magnitudes.
  wire s1_like  = s1_a_sign == s1_b_sign;
  wire s1_equal = s1_both_zero || (s1_like && s1_same);
  wire s1_less  = s1_like ? (s1_below ^ s1_a_sign) : s1_a_sign;

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
