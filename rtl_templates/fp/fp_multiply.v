// fp_multiply: a * b, rounded once to the result format.
// Latency: the population count of CUTS (fifteen bits); initiation interval 1; no reset.
// Special values as IEEE 754: infinity * 0 is NaN.
// rtl_templates/fp/README.md states the promises in full.
`default_nettype none

module fp_multiply #(
  parameter        EXPONENT_BITS        = 8,              // bits of an operand's exponent, 2 to 30
  parameter        PRECISION            = 24,             // digits with the leading one, 2 or more
  parameter        RESULT_EXPONENT_BITS = EXPONENT_BITS,  // bits of the result's exponent, 2 to 30
  parameter        RESULT_PRECISION     = PRECISION,      // digits of the result, 2 or more
  parameter        SPECIAL_OPERANDS     = 1,              // 0 promises no NaN and no infinity
  parameter        OVERFLOW             = 1,              // 0 promises that no result overflows
  parameter        UNDERFLOW            = 1,              // 0 promises no tiny operand or result
  parameter        GRADUAL              = 0,              // 1: subnormals; 0: flushed to zero
  parameter        TOWARD_ZERO          = 0,              // 1: rounds toward zero; 0: nearest even
  parameter        SUM_SELECTS          = 2,              // bits that select, 0 to 2; see fp_add
  // 1: multipliers, as `*` of FACTOR_A by FACTOR_B bits; 0: logic, if PRECISION is 127 or less.
  parameter        EMBEDDED             = 1,
  // 1: in logic, a stage of its own finds the digits; only if PRECISION is 63 or less.
  parameter        DIGIT_STAGE          = 0,
  parameter        FACTOR_A             = 24,             // first factor of `*`, 1 bit or more
  parameter        FACTOR_B             = 17,             // second factor of `*`, 1 bit or more
  parameter [14:0] CUTS                 = 15'b0           // a register behind stage k if bit k is 1
) (
  input  wire                                             aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0]               a,
  input  wire [EXPONENT_BITS+PRECISION-1:0]               b,
  output wire [RESULT_EXPONENT_BITS+RESULT_PRECISION-1:0] y,
  output wire                                             exceptional
);

  function integer bits_for(input integer value);
    integer rest;
    begin
      bits_for = 0;
      for (rest = value; rest > 0; rest = rest >> 1) bits_for = bits_for + 1;
    end
  endfunction

  function integer larger(input integer first, input integer second);
    larger = (first > second) ? first : second;
  endfunction

  // Without underflow there are no subnormals, so GRADUAL has no effect.
  localparam SUBNORMALS = (GRADUAL != 0) && (UNDERFLOW != 0);

  // Cuts 2 to ROUND - 1 belong to the product.
  localparam ROUND   = 10;
  localparam PRODUCT = 2 * PRECISION;
  localparam EXPONENT_WIDTH =
      larger(larger(EXPONENT_BITS, RESULT_EXPONENT_BITS),
             bits_for(larger(PRODUCT, RESULT_PRECISION + 2))) + 2;
  localparam AMOUNT_BITS = bits_for(RESULT_PRECISION + 3);

  localparam integer BIAS        = (1 << (EXPONENT_BITS - 1)) - 1;
  localparam integer RESULT_BIAS = (1 << (RESULT_EXPONENT_BITS - 1)) - 1;
  // REBIAS is one too small and therefore ends in zeros. The carry into the sum of the exponents
  // adds the one.
  localparam integer REBIAS      = RESULT_BIAS - 2 * BIAS - 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 30))
      begin : g_refused_exponent EXPONENT_BITS_is_not_2_to_30 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if ((RESULT_EXPONENT_BITS < 2) || (RESULT_EXPONENT_BITS > 30))
      begin : g_refused_result_exponent RESULT_EXPONENT_BITS_is_not_2_to_30 refused (); end
    if (RESULT_PRECISION < 2)
      begin : g_refused_result_precision RESULT_PRECISION_is_below_2 refused (); end
    if (FACTOR_A < 1) begin : g_refused_factor_a FACTOR_A_is_below_1 refused (); end
    if (FACTOR_B < 1) begin : g_refused_factor_b FACTOR_B_is_below_1 refused (); end
  endgenerate

  // Stages count, normalise: both significands get a leading one.
  wire                      s2_a_sign;
  wire [EXPONENT_WIDTH-1:0] s2_a_exponent;
  wire [PRECISION-1:0]      s2_a_significand;
  wire                      s2_a_zero;
  wire                      s2_a_infinite;
  wire                      s2_a_nan;
  wire                      s2_a_flushed;

  fp_operand #(
    .EXPONENT_BITS   (EXPONENT_BITS),
    .PRECISION       (PRECISION),
    .EXPONENT_WIDTH  (EXPONENT_WIDTH),
    .SPECIAL_OPERANDS(SPECIAL_OPERANDS),
    .UNDERFLOW       (UNDERFLOW),
    .GRADUAL         (SUBNORMALS),
    .CUTS            (CUTS[1:0])
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

  wire                      s2_b_sign;
  wire [EXPONENT_WIDTH-1:0] s2_b_exponent;
  wire [PRECISION-1:0]      s2_b_significand;
  wire                      s2_b_zero;
  wire                      s2_b_infinite;
  wire                      s2_b_nan;
  wire                      s2_b_flushed;

  fp_operand #(
    .EXPONENT_BITS   (EXPONENT_BITS),
    .PRECISION       (PRECISION),
    .EXPONENT_WIDTH  (EXPONENT_WIDTH),
    .SPECIAL_OPERANDS(SPECIAL_OPERANDS),
    .UNDERFLOW       (UNDERFLOW),
    .GRADUAL         (SUBNORMALS),
    .CUTS            (CUTS[1:0])
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

  // Stages factors, multiply: the product of two significands in [1, 2) lies in [1, 4).
  wire [EXPONENT_WIDTH-1:0] s2_exponent;
  wire                      s2_unused_place;
  wire                      s2_sign     = s2_a_sign ^ s2_b_sign;
  wire                      s2_infinite = s2_a_infinite || s2_b_infinite;
  wire                      s2_zero     = s2_a_zero || s2_b_zero;
  wire                      s2_nan      = s2_a_nan || s2_b_nan || (s2_infinite && s2_zero);
  wire                      s2_suspect  = s2_nan || s2_infinite || s2_a_flushed || s2_b_flushed;

  assign {s2_exponent, s2_unused_place} = {s2_a_exponent, 1'b1} + {s2_b_exponent, 1'b1};

  wire [PRODUCT-1:0] last_product;

  fp_product #(
    .PRECISION  (PRECISION),
    .SQUARE     (0),
    .EMBEDDED   (EMBEDDED),
    .DIGIT_STAGE(DIGIT_STAGE),
    .FACTOR_A   (FACTOR_A),
    .FACTOR_B   (FACTOR_B),
    .CUTS       (CUTS[ROUND-1:2])
  ) s2_product (
    .aclk   (aclk),
    .a      (s2_a_significand),
    .b      (s2_b_significand),
    .product(last_product)
  );

  wire [EXPONENT_WIDTH-1:0] s4_sum;
  wire [4:0]                s4_flags;

  fp_ranks #(
    .WIDTH(EXPONENT_WIDTH + 5),
    .COUNT(2),
    .CUTS (CUTS[3:2])
  ) ranks_2 (
    .aclk(aclk),
    .d   ({s2_exponent, s2_sign, s2_nan, s2_infinite, s2_zero, s2_suspect}),
    .q   ({s4_sum, s4_flags})
  );

  // The other stages of the product.
  wire [EXPONENT_WIDTH-1:0] s4_exponent = s4_sum + REBIAS[EXPONENT_WIDTH-1:0];
  wire [EXPONENT_WIDTH-1:0] s5_exponent;
  wire [4:0]                s5_flags;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + 5),
    .REGISTERED(CUTS[4])
  ) rank_4 (
    .aclk(aclk),
    .d   ({s4_exponent, s4_flags}),
    .q   ({s5_exponent, s5_flags})
  );

  wire [EXPONENT_WIDTH-1:0] s5_limited;
  wire                      s5_tiny;
  wire [AMOUNT_BITS-1:0]    s5_amount;

  fp_subnormal_shift #(
    .EXPONENT_WIDTH(EXPONENT_WIDTH),
    .AMOUNT_BITS   (AMOUNT_BITS),
    .GRADUAL       (SUBNORMALS)
  ) s5_subnormal_shift (
    .exponent(s5_exponent),
    .limited (s5_limited),
    .tiny    (s5_tiny),
    .amount  (s5_amount)
  );

  wire [EXPONENT_WIDTH-1:0] last_exponent;
  wire                      last_tiny;
  wire [AMOUNT_BITS-1:0]    last_amount;
  wire                      last_sign;
  wire                      last_nan;
  wire                      last_infinite;
  wire                      last_zero;
  wire                      last_suspect;

  fp_ranks #(
    .WIDTH(EXPONENT_WIDTH + AMOUNT_BITS + 6),
    .COUNT(ROUND - 5),
    .CUTS (CUTS[ROUND-1:5])
  ) ranks_5 (
    .aclk(aclk),
    .d   ({s5_limited, s5_tiny, s5_amount, s5_flags}),
    .q   ({last_exponent, last_tiny, last_amount,
           last_sign, last_nan, last_infinite, last_zero, last_suspect})
  );

  // Stages denormalise, select, round, pack.
  fp_select_round #(
    .WIDTH               (PRODUCT),
    .EXPONENT_WIDTH      (EXPONENT_WIDTH),
    .AMOUNT_BITS         (AMOUNT_BITS),
    .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
    .RESULT_PRECISION    (RESULT_PRECISION),
    .OVERFLOW            (OVERFLOW),
    .UNDERFLOW           (UNDERFLOW),
    .GRADUAL             (SUBNORMALS),
    .TOWARD_ZERO         (TOWARD_ZERO),
    .SUM_SELECTS         (SUM_SELECTS),
    .CUTS                (CUTS[ROUND+4:ROUND])
  ) select_round (
    .aclk       (aclk),
    .sign       (last_sign),
    .exponent   (last_exponent),
    .tiny       (last_tiny),
    .amount     (last_amount),
    .value      (last_product),
    .sticky     (1'b0),
    .nan        (last_nan),
    .infinite   (last_infinite),
    .zero       (last_zero),
    .suspect    (last_suspect),
    .y          (y),
    .exceptional(exceptional)
  );

endmodule

`default_nettype wire
