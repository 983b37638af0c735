// fp_fused_comparison: the order of a sum of TERMS products and zero: 0 less, 1 equal, 2 greater,
// 3 unordered. The sum is not rounded.
// Latency: the population count of CUTS (25 bits); initiation interval 1; no reset.
// Terms are those of fp_cut_sum.
// Each term is cut toward zero at PRECISION + GUARD bits below the largest exponent. The cut terms
// are added exactly; docs/error_bounds.md says when their sum has the sign of the uncut sum.
// A NaN, infinities of unlike signs and infinity * 0 are unordered.
`default_nettype none

module fp_fused_comparison #(
  parameter             EXPONENT_BITS = 8,     // bits of an operand's exponent, 2 to 28
  parameter             PRECISION     = 24,    // digits with the leading one, 2 or more
  parameter             TERMS         = 3,     // number of terms, 2 to 63
  parameter [TERMS-1:0] SQUARES       = 0,     // bit k: term k is a_k * a_k
  parameter [TERMS-1:0] PLAIN         = 0,     // bit k: term k is a_k
  parameter [TERMS-1:0] SUMS          = 0,     // bit k: term k is (a_k + b_k)^2
  parameter [TERMS-1:0] DIFFERENCES   = 0,     // bit k: term k is (a_k - b_k)^2
  parameter [TERMS-1:0] NEGATED       = 0,     // bit k: term k is subtracted
  parameter             GRADUAL       = 0,     // 1: subnormals; 0: flushed to zero
  // 1: multipliers, as `*` of FACTOR_A by FACTOR_B bits; 0: logic, if PRECISION is 127 or less.
  parameter             EMBEDDED      = 1,
  parameter             SUM_SELECTS   = 2,     // bits that may select, 0 to 2; see fp_add
  parameter             FACTOR_A      = 24,    // first factor of `*`, 1 bit or more
  parameter             FACTOR_B      = 17,    // second factor of `*`, 1 bit or more
  parameter [24:0]      CUTS          = 25'b0  // a register behind stage k if bit k is 1
) (
  input  wire                                       aclk,
  input  wire [TERMS*(EXPONENT_BITS+PRECISION)-1:0] a,  // term 0 in the lowest bits
  input  wire [TERMS*(EXPONENT_BITS+PRECISION)-1:0] b,
  output wire [1:0]                                 verdict
);

  function integer bits_for(input integer value);
    integer rest;
    begin
      bits_for = 0;
      for (rest = value; rest > 0; rest = rest >> 1) bits_for = bits_for + 1;
    end
  endfunction

  localparam GROWTH = bits_for(TERMS - 1);  // bits of a sum of TERMS above those of one term

  // Sizes as in fp_fused_sum.
  localparam         GUARD          = GROWTH + 5;
  localparam         WINDOW         = PRECISION + GUARD + 2;
  localparam         ADDEND         = WINDOW + GROWTH + 1;
  localparam integer BIAS           = (1 << (EXPONENT_BITS - 1)) - 1;
  localparam integer OFFSET         = 2 * (PRECISION + (WINDOW + 1) / 2);
  localparam         EXPONENT_WIDTH = bits_for(4 * BIAS + 2 + OFFSET);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 28))
      begin : g_refused_exponent EXPONENT_BITS_is_not_2_to_28 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if ((TERMS < 2) || (TERMS > 63)) begin : g_refused_terms TERMS_are_not_2_to_63 refused (); end
  endgenerate

  // Stages of the terms and of their sum.
  wire [ADDEND-1:0]         s24_sum;
  wire [EXPONENT_WIDTH-1:0] s24_unused_largest;
  wire                      s24_nan;
  wire                      s24_infinite;
  wire                      s24_all_zero;
  wire                      s24_unused_suspect;
  wire                      s24_unused_zero_sign;
  wire                      s24_infinite_sign;
  wire                      s24_first_sign;

  fp_cut_sum #(
    .EXPONENT_BITS (EXPONENT_BITS),
    .PRECISION     (PRECISION),
    .TERMS         (TERMS),
    .SQUARES       (SQUARES),
    .PLAIN         (PLAIN),
    .SUMS          (SUMS),
    .DIFFERENCES   (DIFFERENCES),
    .NEGATED       (NEGATED),
    .CANCELLATION  (1),
    .GRADUAL       (GRADUAL),
    .EMBEDDED      (EMBEDDED),
    .SUM_SELECTS   (SUM_SELECTS),
    .FACTOR_A      (FACTOR_A),
    .FACTOR_B      (FACTOR_B),
    .WINDOW        (WINDOW),
    .ADDEND        (ADDEND),
    .EXPONENT_WIDTH(EXPONENT_WIDTH),
    .OFFSET        (OFFSET),
    .CUTS          (CUTS[23:0])
  ) s0_cut_sum (
    .aclk      (aclk),
    .a         (a),
    .b         (b),
    .sum       (s24_sum),
    .largest   (s24_unused_largest),
    .nan       (s24_nan),
    .infinite  (s24_infinite),
    .zero      (s24_all_zero),
    .suspect   (s24_unused_suspect),
    .zero_sign (s24_unused_zero_sign),
    .known_sign(s24_infinite_sign),
    .first_sign(s24_first_sign)
  );

  // Stage decide: a negative sum has the sign opposite to that of term 0. If all terms are zero,
  // the window is arbitrary.
  wire s24_equal = !s24_infinite && (s24_all_zero || !(|s24_sum));
  wire s24_sign  = s24_infinite ? s24_infinite_sign : (s24_sum[ADDEND-1] ^ s24_first_sign);

  fp_rank #(
    .WIDTH     (2),
    .REGISTERED(CUTS[24])
  ) rank_24 (
    .aclk(aclk),
    .d   ({s24_nan || !(s24_equal || s24_sign), s24_nan || s24_equal}),
    .q   (verdict)
  );

endmodule

`default_nettype wire
