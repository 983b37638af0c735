// fp_divide: a / b, rounded once to the result format; one quotient bit a stage.
// Latency: the population count of CUTS (RESULT_PRECISION + 9 bits); initiation interval 1; no
// reset.
// Special values as IEEE 754: x / 0 is infinite, 0 / 0 and infinity / infinity are NaN.
// rtl_templates/fp/README.md states the promises in full.
`default_nettype none

module fp_divide #(
  parameter EXPONENT_BITS        = 8,              // bits of an operand's exponent, 2 to 30
  parameter PRECISION            = 24,             // digits with the leading one, 2 or more
  parameter RESULT_EXPONENT_BITS = EXPONENT_BITS,  // bits of the result's exponent, 2 to 30
  parameter RESULT_PRECISION     = PRECISION,      // digits of the result, 2 or more
  parameter SPECIAL_OPERANDS     = 1,              // 0 promises no NaN and no infinity
  parameter OVERFLOW             = 1,              // 0 promises no overflow, no zero divisor
  parameter UNDERFLOW            = 1,              // 0 promises no tiny operand or result
  parameter GRADUAL              = 0,              // 1: subnormals; 0: flushed to zero
  parameter TOWARD_ZERO          = 0,              // 1: rounds toward zero; 0: nearest even
  parameter SUM_SELECTS          = 2,              // bits that may select, 0 to 2; see fp_add
  parameter [RESULT_PRECISION+8:0] CUTS = 0        // a register behind stage k if bit k is 1
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

  // The quotient lies in (1/2, 2). DIGITS: its bits up to the guard bit, and one more if it is
  // below 1.
  localparam DIGITS    = RESULT_PRECISION + 2;
  localparam REMAINDER = PRECISION + 1;
  localparam FLAGS     = 5;
  localparam EXPONENT_WIDTH =
      larger(larger(EXPONENT_BITS, RESULT_EXPONENT_BITS),
             bits_for(larger(2 * PRECISION, RESULT_PRECISION + 2))) + 2;
  localparam AMOUNT_BITS = bits_for(RESULT_PRECISION + 3);

  // For a quotient below 1.
  localparam integer REBIAS = (1 << (RESULT_EXPONENT_BITS - 1)) - 2;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 30))
      begin : g_refused_exponent EXPONENT_BITS_is_not_2_to_30 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if ((RESULT_EXPONENT_BITS < 2) || (RESULT_EXPONENT_BITS > 30))
      begin : g_refused_result_exponent RESULT_EXPONENT_BITS_is_not_2_to_30 refused (); end
    if (RESULT_PRECISION < 2)
      begin : g_refused_result_precision RESULT_PRECISION_is_below_2 refused (); end
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
  wire                      s2_b_is_zero;
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
    .zero       (s2_b_is_zero),
    .infinite   (s2_b_infinite),
    .nan        (s2_b_nan),
    .flushed    (s2_b_flushed)
  );

  // Stages digit 0 to DIGITS - 1: one bit each, by non-restoring division. If the last bit was 0
  // the remainder is negative, and the divisor is added instead of subtracted. The sign of the new
  // remainder is the next bit. It is stored only there, since the remainder stays within +-divisor.
  wire [EXPONENT_WIDTH-1:0] s2_exponent = s2_a_exponent - s2_b_exponent;
  wire                      s2_b_zero   = (OVERFLOW != 0) && s2_b_is_zero;
  wire                      s2_sign     = s2_a_sign ^ s2_b_sign;
  wire                      s2_nan      = s2_a_nan || s2_b_nan || (s2_a_infinite && s2_b_infinite)
                                          || (s2_a_zero && s2_b_zero);
  wire                      s2_infinite = s2_a_infinite || s2_b_zero;
  wire                      s2_zero     = s2_a_zero || s2_b_infinite;
  wire                      s2_suspect  = s2_nan || s2_infinite || s2_b_infinite
                                          || s2_a_flushed || s2_b_flushed;

  genvar k;
  generate
    for (k = 0; k < DIGITS; k = k + 1) begin : g_digit
      // The known part of the result's place: its exponent, in the last stage fp_subnormal_shift's
      // outputs.
      localparam LAST  = k == DIGITS - 1;
      localparam PLACE = LAST ? EXPONENT_WIDTH + 1 + AMOUNT_BITS : EXPONENT_WIDTH;

      wire [REMAINDER-1:0]      doubled;
      wire [PRECISION-1:0]      divisor;
      wire                      subtract;
      wire [EXPONENT_WIDTH-1:0] exponent;
      wire [PLACE-1:0]          place;
      wire [FLAGS-1:0]          flags;
      wire [REMAINDER-1:0]      remainder;
      wire [k:0]                quotient;

      if (k == 0) begin : g_first
        assign doubled  = {1'b0, s2_a_significand};
        assign divisor  = s2_b_significand;
        assign quotient = !remainder[REMAINDER-1];
        assign subtract = 1'b1;
        assign exponent = s2_exponent + REBIAS[EXPONENT_WIDTH-1:0];
        assign flags    = {s2_sign, s2_nan, s2_infinite, s2_zero, s2_suspect};
      end else begin : g_later
        assign doubled  = {g_digit[k-1].next_remainder, 1'b0};
        assign divisor  = g_digit[k-1].next_divisor;
        assign quotient = {g_digit[k-1].next_quotient, !remainder[REMAINDER-1]};
        assign subtract = g_digit[k-1].next_quotient[0];
        assign exponent = g_digit[k-1].next_place;
        assign flags    = g_digit[k-1].next_flags;
      end

      if (LAST) begin : g_tiny
        fp_subnormal_shift #(
          .EXPONENT_WIDTH(EXPONENT_WIDTH),
          .AMOUNT_BITS   (AMOUNT_BITS),
          .GRADUAL       (SUBNORMALS)
        ) subnormal_shift (
          .exponent(exponent),
          .limited (place[PLACE-1:AMOUNT_BITS+1]),
          .tiny    (place[AMOUNT_BITS]),
          .amount  (place[AMOUNT_BITS-1:0])
        );
      end else begin : g_not_yet
        assign place = exponent;
      end

      wire [REMAINDER-1:0] addend = {1'b0, divisor} ^ {REMAINDER{subtract}};
      wire                 unused_place;

      assign {remainder, unused_place} = {doubled, 1'b1} + {addend, subtract};

      wire [REMAINDER-2:0]      next_remainder;
      wire [PRECISION-1:0]      next_divisor;
      wire [k:0]                next_quotient;
      wire [PLACE-1:0]          next_place;
      wire [FLAGS-1:0]          next_flags;

      fp_rank #(
        .WIDTH     (REMAINDER - 1 + PRECISION + k + 1 + PLACE + FLAGS),
        .REGISTERED(CUTS[2+k])
      ) rank (
        .aclk(aclk),
        .d   ({remainder[REMAINDER-2:0], divisor, quotient, place, flags}),
        .q   ({next_remainder, next_divisor, next_quotient, next_place, next_flags})
      );
    end
  endgenerate

  // Stage denormalise: the quotient is exact iff the remainder is zero or, after a 0, minus the
  // divisor. Two numbers add up to zero iff there is a carry into each place where their digits
  // differ and none where they agree.
  wire [PRECISION-1:0]      last_remainder = g_digit[DIGITS-1].next_remainder;
  wire [DIGITS-1:0]         last_quotient  = g_digit[DIGITS-1].next_quotient;
  wire [PRECISION-1:0]      last_restore   =
      g_digit[DIGITS-1].next_divisor & {PRECISION{!last_quotient[0]}};
  wire [PRECISION-1:0]      last_carry     = (last_remainder | last_restore) << 1;
  wire                      last_sticky    = |(last_remainder ^ last_restore ^ last_carry);
  wire [EXPONENT_WIDTH-1:0] last_exponent;
  wire                      last_tiny;
  wire [AMOUNT_BITS-1:0]    last_amount;
  wire                      last_sign;
  wire                      last_nan;
  wire                      last_infinite;
  wire                      last_zero;
  wire                      last_suspect;

  assign {last_exponent, last_tiny, last_amount} = g_digit[DIGITS-1].next_place;
  assign {last_sign, last_nan, last_infinite, last_zero, last_suspect} =
      g_digit[DIGITS-1].next_flags;

  // Stages select, round, pack follow.
  fp_select_round #(
    .WIDTH               (DIGITS),
    .EXPONENT_WIDTH      (EXPONENT_WIDTH),
    .AMOUNT_BITS         (AMOUNT_BITS),
    .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
    .RESULT_PRECISION    (RESULT_PRECISION),
    .OVERFLOW            (OVERFLOW),
    .UNDERFLOW           (UNDERFLOW),
    .GRADUAL             (SUBNORMALS),
    .TOWARD_ZERO         (TOWARD_ZERO),
    .SUM_SELECTS         (SUM_SELECTS),
    .CUTS                (CUTS[DIGITS+6:DIGITS+2])
  ) last_select_round (
    .aclk       (aclk),
    .sign       (last_sign),
    .exponent   (last_exponent),
    .tiny       (last_tiny),
    .amount     (last_amount),
    .value      (last_quotient),
    .sticky     (last_sticky),
    .nan        (last_nan),
    .infinite   (last_infinite),
    .zero       (last_zero),
    .suspect    (last_suspect),
    .y          (y),
    .exceptional(exceptional)
  );

endmodule

`default_nettype wire
