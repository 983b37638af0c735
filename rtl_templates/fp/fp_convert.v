// fp_convert: a * 2^SCALE in another format or the same, rounded once.
// Latency: the population count of CUTS (six bits); initiation interval 1; no reset.
// Special values as IEEE 754, except that every NaN becomes the one positive quiet NaN.
// rtl_templates/fp/README.md states the promises in full.
`default_nettype none

module fp_convert #(
  parameter       EXPONENT_BITS        = 8,              // bits of the operand's exponent, 2 to 29
  parameter       PRECISION            = 53,             // digits with the leading one, 2 or more
  parameter       RESULT_EXPONENT_BITS = EXPONENT_BITS,  // bits of the result's exponent, 2 to 29
  parameter       RESULT_PRECISION     = PRECISION,      // digits of the result, 2 or more
  parameter       SCALE                = 0,              // power of two, |SCALE| < 2^EXPONENT_BITS
  parameter       SPECIAL_OPERANDS     = 1,              // 0 promises no NaN and no infinity
  parameter       OVERFLOW             = 1,              // 0 promises that no result overflows
  parameter       UNDERFLOW            = 1,              // 0 promises no tiny operand or result
  parameter       GRADUAL              = 0,              // 1: subnormals; 0: flushed to zero
  parameter       TOWARD_ZERO          = 0,              // 1: rounds toward zero; 0: nearest even
  parameter [5:0] CUTS                 = 6'b0            // a register behind stage k if bit k is 1
) (
  input  wire                                             aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0]               a,
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

  localparam KEPT = RESULT_PRECISION + 2;
  // One bit for the sign, one for the sum with the bias, and a third if the scale adds as much.
  localparam EXPONENT_WIDTH =
      larger(larger(EXPONENT_BITS, RESULT_EXPONENT_BITS), bits_for(larger(PRECISION, KEPT))) +
      ((SCALE == 0) ? 2 : 3);

  localparam integer SIGNED_SCALE = SCALE;  // signed: some tools pass a negative SCALE as unsigned
  localparam integer SCALE_LIMIT  = 1 << EXPONENT_BITS;
  localparam integer REBIAS       =
      (1 << (RESULT_EXPONENT_BITS - 1)) - (1 << (EXPONENT_BITS - 1)) + SCALE;
  // If this is 0, even the smallest subnormal operand is a normal number of the result format.
  localparam DENORMALISE = (SUBNORMALS != 0) && (REBIAS < PRECISION - 1);

  // Without subnormals and with REBIAS >= 0, operands that were not flushed become normal numbers.
  localparam TINY_RESULTS = (UNDERFLOW != 0) && (SUBNORMALS || (REBIAS < 0));

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 29))
      begin : g_refused_exponent EXPONENT_BITS_is_not_2_to_29 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if ((RESULT_EXPONENT_BITS < 2) || (RESULT_EXPONENT_BITS > 29))
      begin : g_refused_result_exponent RESULT_EXPONENT_BITS_is_not_2_to_29 refused (); end
    if (RESULT_PRECISION < 2)
      begin : g_refused_result_precision RESULT_PRECISION_is_below_2 refused (); end
    if ((SIGNED_SCALE >= SCALE_LIMIT) || (SIGNED_SCALE <= -SCALE_LIMIT))
      begin : g_refused_scale SCALE_is_too_large_for_EXPONENT_BITS refused (); end
  endgenerate

  // Stages count, normalise: the significand gets a leading one.
  wire                      s2_sign;
  wire [EXPONENT_WIDTH-1:0] s2_a_exponent;
  wire [PRECISION-1:0]      s2_a_significand;
  wire                      s2_zero;
  wire                      s2_infinite;
  wire                      s2_nan;
  wire                      s2_flushed;

  fp_operand #(
    .EXPONENT_BITS   (EXPONENT_BITS),
    .PRECISION       (PRECISION),
    .EXPONENT_WIDTH  (EXPONENT_WIDTH),
    .SPECIAL_OPERANDS(SPECIAL_OPERANDS),
    .UNDERFLOW       (UNDERFLOW),
    .GRADUAL         (SUBNORMALS),
    .CUTS            (CUTS[1:0])
  ) s0_operand (
    .aclk       (aclk),
    .a          (a),
    .sign       (s2_sign),
    .exponent   (s2_a_exponent),
    .significand(s2_a_significand),
    .zero       (s2_zero),
    .infinite   (s2_infinite),
    .nan        (s2_nan),
    .flushed    (s2_flushed)
  );

  // Stages denormalise, round, pack.
  wire [EXPONENT_WIDTH-1:0] s2_exponent = s2_a_exponent + REBIAS[EXPONENT_WIDTH-1:0];
  wire [KEPT-1:0]           s2_significand;
  wire                      s2_sticky;
  wire                      s2_suspect = s2_nan || s2_infinite || s2_flushed;

  fp_fit #(
    .FROM(PRECISION),
    .TO  (KEPT)
  ) s2_fit (
    .value (s2_a_significand),
    .fitted(s2_significand),
    .sticky(s2_sticky)
  );

  fp_round #(
    .EXPONENT_WIDTH      (EXPONENT_WIDTH),
    .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
    .RESULT_PRECISION    (RESULT_PRECISION),
    .OVERFLOW            (OVERFLOW),
    .UNDERFLOW           (TINY_RESULTS),
    .GRADUAL             (SUBNORMALS),
    .DENORMALISE         (DENORMALISE),
    .TOWARD_ZERO         (TOWARD_ZERO),
    .CUTS                (CUTS[5:2])
  ) s2_round (
    .aclk       (aclk),
    .sign       (s2_sign),
    .exponent   (s2_exponent),
    .value      (s2_significand),
    .amount     (2'b00),
    .sticky     (s2_sticky),
    .nan        (s2_nan),
    .infinite   (s2_infinite),
    .zero       (s2_zero),
    .suspect    (s2_suspect),
    .y          (y),
    .exceptional(exceptional)
  );

endmodule

`default_nettype wire
