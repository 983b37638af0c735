// fp_multiply: a * b, rounded once to the result format.
// Latency: the population count of CUTS (nine bits); initiation interval 1; no reset.
// Special values as IEEE 754: infinity * 0 is NaN.
// SPECIAL_OPERANDS, OVERFLOW, UNDERFLOW: 0 promises that there are none; docs/architecture.md.
`default_nettype none

module fp_multiply #(
    parameter       EXPONENT_BITS        = 8,
    parameter       PRECISION            = 24,
    parameter       RESULT_EXPONENT_BITS = EXPONENT_BITS,
    parameter       RESULT_PRECISION     = PRECISION,
    parameter       SPECIAL_OPERANDS     = 1,
    parameter       OVERFLOW             = 1,
    parameter       UNDERFLOW            = 1,
    parameter       GRADUAL              = 0,
    parameter       TOWARD_ZERO          = 0,
    parameter [8:0] CUTS                 = 9'b0
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

  // Without underflow there are no subnormals to be gradual about.
  localparam SUBNORMALS = (GRADUAL != 0) && (UNDERFLOW != 0);

  localparam PRODUCT = 2 * PRECISION;
  localparam EXPONENT_WIDTH =
      larger(larger(EXPONENT_BITS, RESULT_EXPONENT_BITS),
             bits_for(larger(PRODUCT, RESULT_PRECISION + 2))) + 2;

  localparam integer BIAS        = (1 << (EXPONENT_BITS - 1)) - 1;
  localparam integer RESULT_BIAS = (1 << (RESULT_EXPONENT_BITS - 1)) - 1;
  // One less, which leaves zeros at its end: the one is the carry into the sum of the exponents.
  localparam integer REBIAS      = RESULT_BIAS - 2 * BIAS - 1;

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

  // Stage multiply: the product of two significands in [1, 2) lies in [1, 4).
  wire [PRODUCT-1:0]        s2_product  = s2_a_significand * s2_b_significand;
  wire [EXPONENT_WIDTH-1:0] s2_exponent;
  wire                      s2_unused_place;
  wire                      s2_sign     = s2_a_sign ^ s2_b_sign;
  wire                      s2_infinite = s2_a_infinite || s2_b_infinite;
  wire                      s2_zero     = s2_a_zero || s2_b_zero;
  wire                      s2_nan      = s2_a_nan || s2_b_nan || (s2_infinite && s2_zero);
  wire                      s2_suspect  = s2_nan || s2_infinite || s2_a_flushed || s2_b_flushed;

  assign {s2_exponent, s2_unused_place} = {s2_a_exponent, 1'b1} + {s2_b_exponent, 1'b1};

  wire [PRODUCT-1:0]        s3_product;
  wire [EXPONENT_WIDTH-1:0] s3_sum;
  wire [4:0]                s3_flags;

  fp_rank #(
      .WIDTH     (PRODUCT + EXPONENT_WIDTH + 5),
      .REGISTERED(CUTS[2])
  ) rank_2 (
      .aclk(aclk),
      .d   ({s2_product, s2_exponent, s2_sign, s2_nan, s2_infinite, s2_zero, s2_suspect}),
      .q   ({s3_product, s3_sum, s3_flags})
  );

  // Stages accumulate 1 and 2: nothing but ranks that synthesis moves into the product, where
  // embedded multipliers and the adders behind them have registers of their own.
  wire [EXPONENT_WIDTH-1:0] s3_exponent = s3_sum + REBIAS[EXPONENT_WIDTH-1:0];

  wire [PRODUCT-1:0]        s4_product;
  wire [EXPONENT_WIDTH-1:0] s4_exponent;
  wire [4:0]                s4_flags;

  fp_rank #(
      .WIDTH     (PRODUCT + EXPONENT_WIDTH + 5),
      .REGISTERED(CUTS[3])
  ) rank_3 (
      .aclk(aclk),
      .d   ({s3_product, s3_exponent, s3_flags}),
      .q   ({s4_product, s4_exponent, s4_flags})
  );

  wire [PRODUCT-1:0]        s5_product;
  wire [EXPONENT_WIDTH-1:0] s5_exponent;
  wire                      s5_sign;
  wire                      s5_nan;
  wire                      s5_infinite;
  wire                      s5_zero;
  wire                      s5_suspect;

  fp_rank #(
      .WIDTH     (PRODUCT + EXPONENT_WIDTH + 5),
      .REGISTERED(CUTS[4])
  ) rank_4 (
      .aclk(aclk),
      .d   ({s4_product, s4_exponent, s4_flags}),
      .q   ({s5_product, s5_exponent, s5_sign, s5_nan, s5_infinite, s5_zero, s5_suspect})
  );

  // Stages select, denormalise, round, pack.
  fp_select_round #(
      .WIDTH               (PRODUCT),
      .EXPONENT_WIDTH      (EXPONENT_WIDTH),
      .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
      .RESULT_PRECISION    (RESULT_PRECISION),
      .OVERFLOW            (OVERFLOW),
      .UNDERFLOW           (UNDERFLOW),
      .GRADUAL             (SUBNORMALS),
      .TOWARD_ZERO         (TOWARD_ZERO),
      .CUTS                (CUTS[8:5])
  ) s5_select_round (
      .aclk       (aclk),
      .sign       (s5_sign),
      .exponent   (s5_exponent),
      .value      (s5_product),
      .sticky     (1'b0),
      .nan        (s5_nan),
      .infinite   (s5_infinite),
      .zero       (s5_zero),
      .suspect    (s5_suspect),
      .y          (y),
      .exceptional(exceptional)
  );

endmodule

`default_nettype wire
