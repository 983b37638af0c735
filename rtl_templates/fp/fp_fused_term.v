// fp_fused_term: one term of a fused sum, exactly: a * b, a * a or a.
// Nine cuts, initiation interval 1, no reset. The exponent and the flags leave behind the first two
// cuts, `product` behind all nine. The term's magnitude is product * 2^(exponent - OFFSET - 2
// BIAS): the product has two bits in front of its point, and BIAS is the format's.
// A zero has exponent 0 and an arbitrary product. The exponents of other finite terms are above
// OFFSET - 2 * PRECISION.
`default_nettype none

module fp_fused_term #(
  parameter       EXPONENT_BITS  = 8,    // bits of an operand's exponent, 2 to 28
  parameter       PRECISION      = 24,   // digits with the leading one, 2 or more
  parameter       EXPONENT_WIDTH = 10,   // bits of `exponent`, enough for 4 BIAS + 2 + OFFSET
  parameter       OFFSET         = 80,   // added to the exponent, 2 * PRECISION or more
  parameter       SQUARE         = 0,    // 1: the term is a * a; b is not read
  parameter       PLAIN          = 0,    // 1: the term is a; b is not read; not with SQUARE
  parameter       NEGATED        = 0,    // 1: the term is subtracted
  parameter       GRADUAL        = 0,    // 1: subnormals; 0: flushed to zero
  parameter       VANISHING      = 0,    // 1: squares of subnormals are zeros; only with GRADUAL
  // 1: multipliers, as `*` of FACTOR_A by FACTOR_B bits; 0: logic, if PRECISION is 127 or less.
  parameter       EMBEDDED       = 1,
  parameter       FACTOR_A       = 24,   // first factor of `*`, 1 bit or more
  parameter       FACTOR_B       = 17,   // second factor of `*`, 1 bit or more
  parameter [8:0] CUTS           = 9'b0  // a register behind stage k if bit k is 1
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] a,
  input  wire [EXPONENT_BITS+PRECISION-1:0] b,
  output wire [EXPONENT_WIDTH-1:0]          exponent,
  output wire                               sign,
  output wire                               zero,
  output wire                               infinite,
  output wire                               nan,
  output wire                               flushed,
  output wire [2*PRECISION-1:0]             product
);

  // The name differs from that of the units' own function, since Verilator 5.006 warns if one hides
  // the other.
  function integer length_of(input integer value);
    integer rest;
    begin
      length_of = 0;
      for (rest = value; rest > 0; rest = rest >> 1) length_of = length_of + 1;
    end
  endfunction

  localparam integer BIAS   = (1 << (EXPONENT_BITS - 1)) - 1;
  localparam integer LIFTED = OFFSET + BIAS;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 28))
      begin : g_refused_exponent EXPONENT_BITS_is_not_2_to_28 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if (OFFSET < 2 * PRECISION)
      begin : g_refused_offset OFFSET_is_too_small_for_PRECISION refused (); end
    if (EXPONENT_WIDTH < length_of(4 * BIAS + 2 + OFFSET)) begin : g_refused_exponent_width
      EXPONENT_WIDTH_is_too_small_for_OFFSET_and_EXPONENT_BITS refused ();
    end
    if ((SQUARE != 0) && (PLAIN != 0)) begin : g_refused_kind SQUARE_and_PLAIN refused (); end
    if ((VANISHING != 0) && (GRADUAL == 0))
      begin : g_refused_vanishing VANISHING_without_GRADUAL refused (); end
    if (FACTOR_A < 1) begin : g_refused_factor_a FACTOR_A_is_below_1 refused (); end
    if (FACTOR_B < 1) begin : g_refused_factor_b FACTOR_B_is_below_1 refused (); end
  endgenerate

  generate
    if (PLAIN != 0) begin : g_plain
      wire                     s0_sign;
      wire [EXPONENT_BITS-1:0] s0_exponent;
      wire [PRECISION-1:0]     s0_significand;
      wire                     s0_zero;
      wire                     s0_infinite;
      wire                     s0_nan;
      wire                     s0_flushed;
      wire [EXPONENT_BITS-1:0] s2_exponent;
      wire [PRECISION-1:0]     s2_significand;
      wire [PRECISION-1:0]     last_significand;
      wire                     unused_b = ^b;

      fp_unpack #(
        .EXPONENT_BITS(EXPONENT_BITS),
        .PRECISION    (PRECISION),
        .GRADUAL      (GRADUAL)
      ) s0_unpack (
        .a          (a),
        .sign       (s0_sign),
        .exponent   (s0_exponent),
        .significand(s0_significand),
        .zero       (s0_zero),
        .infinite   (s0_infinite),
        .nan        (s0_nan),
        .flushed    (s0_flushed)
      );

      fp_ranks #(
        .WIDTH(EXPONENT_BITS + PRECISION + 5),
        .COUNT(2),
        .CUTS (CUTS[1:0])
      ) ranks_0 (
        .aclk(aclk),
        .d   ({s0_exponent, s0_significand, s0_sign ^ (NEGATED != 0), s0_zero, s0_infinite, s0_nan,
               s0_flushed}),
        .q   ({s2_exponent, s2_significand, sign, zero, infinite, nan, flushed})
      );

      fp_ranks #(
        .WIDTH(PRECISION),
        .COUNT(7),
        .CUTS (CUTS[8:2])
      ) ranks_2 (
        .aclk(aclk),
        .d   (s2_significand),
        .q   (last_significand)
      );

      // The other factor is one, whose biased exponent is the bias.
      wire [EXPONENT_WIDTH-1:0] s2_lifted =
          {{(EXPONENT_WIDTH - EXPONENT_BITS) {1'b0}}, s2_exponent} + LIFTED[EXPONENT_WIDTH-1:0];

      assign exponent = s2_lifted & {EXPONENT_WIDTH{!zero}};
      assign product  = {1'b0, last_significand, {(PRECISION - 1) {1'b0}}};
    end else begin : g_product
      localparam NORMALISED = (GRADUAL != 0) && !((SQUARE != 0) && (VANISHING != 0));

      wire                      s2_a_sign;
      wire [EXPONENT_WIDTH-1:0] s2_a_exponent;
      wire [PRECISION-1:0]      s2_a_significand;
      wire                      s2_a_zero;
      wire                      s2_a_infinite;
      wire                      s2_a_nan;
      wire                      s2_a_flushed;
      wire [EXPONENT_WIDTH-1:0] s2_exponent;
      wire [PRECISION-1:0]      s2_b_significand;

      fp_operand #(
        .EXPONENT_BITS (EXPONENT_BITS),
        .PRECISION     (PRECISION),
        .EXPONENT_WIDTH(EXPONENT_WIDTH),
        .UNDERFLOW     (NORMALISED || (GRADUAL == 0)),
        .GRADUAL       (NORMALISED),
        .CUTS          (CUTS[1:0])
      ) s0_operand_a (
        .aclk       (aclk),
        .a          (a),
        .sign       (s2_a_sign),
        .exponent   (s2_a_exponent),
        .significand(s2_a_significand),
        .zero       (s2_a_zero),
        .infinite   (s2_a_infinite),
        .nan        (s2_a_nan),
        .flushed    (s2_a_flushed)
      );

      if (SQUARE != 0) begin : g_square
        wire unused_b = ^{b, s2_a_sign};

        assign s2_exponent      = s2_a_exponent << 1;
        assign s2_b_significand = s2_a_significand;
        assign sign             = (NEGATED != 0);
        assign zero             = s2_a_zero;
        assign infinite         = s2_a_infinite;
        assign nan              = s2_a_nan;
        assign flushed          = s2_a_flushed;
      end else begin : g_two_factors
        wire                      s2_b_sign;
        wire [EXPONENT_WIDTH-1:0] s2_b_exponent;
        wire                      s2_b_zero;
        wire                      s2_b_infinite;
        wire                      s2_b_nan;
        wire                      s2_b_flushed;

        fp_operand #(
          .EXPONENT_BITS (EXPONENT_BITS),
          .PRECISION     (PRECISION),
          .EXPONENT_WIDTH(EXPONENT_WIDTH),
          .GRADUAL       (GRADUAL),
          .CUTS          (CUTS[1:0])
        ) s0_operand_b (
          .aclk       (aclk),
          .a          (b),
          .sign       (s2_b_sign),
          .exponent   (s2_b_exponent),
          .significand(s2_b_significand),
          .zero       (s2_b_zero),
          .infinite   (s2_b_infinite),
          .nan        (s2_b_nan),
          .flushed    (s2_b_flushed)
        );

        assign s2_exponent = s2_a_exponent + s2_b_exponent;
        assign sign        = s2_a_sign ^ s2_b_sign ^ (NEGATED != 0);
        assign zero        = s2_a_zero || s2_b_zero;
        assign infinite    = s2_a_infinite || s2_b_infinite;
        assign nan         = s2_a_nan || s2_b_nan || (s2_a_infinite && s2_b_zero)
                             || (s2_a_zero && s2_b_infinite);
        assign flushed     = s2_a_flushed || s2_b_flushed;
      end

      assign exponent = (s2_exponent + OFFSET[EXPONENT_WIDTH-1:0]) & {EXPONENT_WIDTH{!zero}};

      fp_product #(
        .PRECISION(PRECISION),
        .SQUARE   (SQUARE),
        .EMBEDDED (EMBEDDED),
        .FACTOR_A (FACTOR_A),
        .FACTOR_B (FACTOR_B),
        .CUTS     ({CUTS[8:2], 1'b0})
      ) s2_product (
        .aclk   (aclk),
        .a      (s2_a_significand),
        .b      (s2_b_significand),
        .product(product)
      );
    end
  endgenerate

endmodule

`default_nettype wire
