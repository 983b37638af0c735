// fp_square_root: the square root of a, rounded once to the result format; one bit a stage.
// Latency: the population count of CUTS (RESULT_PRECISION + 7 bits); initiation interval 1; no
// reset.
// Special values as IEEE 754: the root of -0 is -0, that of any other negative number is NaN.
// rtl_templates/fp/README.md states the promises in full.
`default_nettype none

module fp_square_root #(
  parameter EXPONENT_BITS        = 8,              // bits of the operand's exponent, 2 to 30
  parameter PRECISION            = 24,             // digits with the leading one, 2 or more
  parameter RESULT_EXPONENT_BITS = EXPONENT_BITS,  // bits of the result's exponent, 2 to 30
  parameter RESULT_PRECISION     = PRECISION,      // digits of the result, 2 or more
  parameter SPECIAL_OPERANDS     = 1,              // 0 promises no NaN and no infinity
  parameter OVERFLOW             = 1,              // 0 promises that no result overflows
  parameter UNDERFLOW            = 1,              // 0 promises no tiny operand or result
  parameter GRADUAL              = 0,              // 1: subnormals; 0: flushed to zero
  parameter TOWARD_ZERO          = 0,              // 1: rounds toward zero; 0: nearest even
  parameter [RESULT_PRECISION+6:0] CUTS = 0        // a register behind stage k if bit k is 1
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

  // The root has its bits up to the guard bit, the radicand two bits for each.
  localparam ROOT     = RESULT_PRECISION + 1;
  localparam RADICAND = 2 * ROOT;
  localparam FLAGS    = 5;
  localparam EXPONENT_WIDTH =
      larger(larger(EXPONENT_BITS, RESULT_EXPONENT_BITS),
             bits_for(larger(PRECISION, RESULT_PRECISION + 2))) + 2;

  localparam integer BIAS        = (1 << (EXPONENT_BITS - 1)) - 1;
  localparam integer RESULT_BIAS = (1 << (RESULT_EXPONENT_BITS - 1)) - 1;
  // Half the exponent of the smallest subnormal is a normal one, unless the result's range is
  // short.
  localparam DENORMALISE = (SUBNORMALS != 0) && (BIAS + PRECISION > 2 * RESULT_BIAS);

  // Without subnormals, a root is tiny only if the result's exponent is shorter than the operand's.
  localparam TINY_RESULTS =
      (UNDERFLOW != 0) && (SUBNORMALS || (RESULT_EXPONENT_BITS < EXPONENT_BITS));

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

  // Stages count, normalise: the significand gets a leading one.
  wire                      s2_sign;
  wire [EXPONENT_WIDTH-1:0] s2_a_exponent;
  wire [PRECISION-1:0]      s2_a_significand;
  wire                      s2_zero;
  wire                      s2_infinite;
  wire                      s2_a_nan;
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
    .nan        (s2_a_nan),
    .flushed    (s2_flushed)
  );

  // Stages digit 1 to ROOT - 1: an odd exponent gives its last bit to the significand, so the
  // radicand lies in [1, 4) and digit 0 of the root is 1. The bias is odd, so an even biased
  // exponent is an odd exponent. The other bits are found one by one, without restoring: let Q be
  // the root's bits so far. After a 1, subtract 4Q + 1 from the remainder; after a 0, add 4Q + 3.
  // The sign of the new remainder is the next bit.
  wire                      s2_odd      = !s2_a_exponent[0];
  wire [EXPONENT_WIDTH-1:0] s2_doubled  = s2_a_exponent - BIAS[EXPONENT_WIDTH-1:0];
  wire [EXPONENT_WIDTH-1:0] s2_exponent =
      {s2_doubled[EXPONENT_WIDTH-1], s2_doubled[EXPONENT_WIDTH-1:1]}
      + RESULT_BIAS[EXPONENT_WIDTH-1:0];
  wire [PRECISION:0]        s2_even     = {1'b0, s2_a_significand} << s2_odd;
  wire [RADICAND-1:0]       s2_radicand;
  wire                      s2_sticky;

  fp_fit #(
    .FROM(PRECISION + 1),
    .TO  (RADICAND)
  ) s2_fit (
    .value (s2_even),
    .fitted(s2_radicand),
    .sticky(s2_sticky)
  );

  wire s2_nan     = s2_a_nan || (s2_sign && !s2_zero);
  wire s2_suspect = s2_nan || s2_infinite || s2_flushed;

  genvar k;
  generate
    for (k = 1; k < ROOT; k = k + 1) begin : g_digit
      // The remainder is at most twice the root of k + 1 bits, with a sign.
      localparam REMAINDER = k + 3;

      wire [REMAINDER-3:0]      above;     // the remainder so far
      wire [k-1:0]              root;
      wire [RADICAND-2*k-1:0]   radicand;  // bits not yet used; each stage takes two
      wire                      sticky;
      wire [EXPONENT_WIDTH-1:0] exponent;
      wire [FLAGS-1:0]          flags;

      if (k == 1) begin : g_first
        assign above    = s2_radicand[RADICAND-1:RADICAND-2] - 2'd1;
        assign root     = 1'b1;
        assign radicand = s2_radicand[RADICAND-3:0];
        assign sticky   = s2_sticky;
        assign exponent = s2_exponent;
        assign flags    = {s2_sign, s2_nan, s2_infinite, s2_zero, s2_suspect};
      end else begin : g_later
        assign above    = g_digit[k-1].next_remainder;
        assign root     = g_digit[k-1].next_root;
        assign radicand = g_digit[k-1].g_more.next_radicand;
        assign sticky   = g_digit[k-1].next_sticky;
        assign exponent = g_digit[k-1].next_exponent;
        assign flags    = g_digit[k-1].next_flags;
      end

      wire [REMAINDER-1:0] remainder =
          {above, radicand[RADICAND-2*k-1:RADICAND-2*k-2]}
          + {root[0], root ^ {k{root[0]}}, 2'b11};

      wire [REMAINDER-2:0]      next_remainder;  // its sign is the root's next bit
      wire [k:0]                next_root;
      wire                      next_sticky;
      wire [EXPONENT_WIDTH-1:0] next_exponent;
      wire [FLAGS-1:0]          next_flags;

      fp_rank #(
        .WIDTH     (REMAINDER - 1 + k + 1 + 1 + EXPONENT_WIDTH + FLAGS),
        .REGISTERED(CUTS[1+k])
      ) rank (
        .aclk(aclk),
        .d   ({remainder[REMAINDER-2:0], root, !remainder[REMAINDER-1],
               sticky, exponent, flags}),
        .q   ({next_remainder, next_root, next_sticky, next_exponent, next_flags})
      );

      if (k + 1 < ROOT) begin : g_more
        wire [RADICAND-2*k-3:0] next_radicand;

        fp_rank #(
          .WIDTH     (RADICAND - 2 * k - 2),
          .REGISTERED(CUTS[1+k])
        ) rank_radicand (
          .aclk(aclk),
          .d   (radicand[RADICAND-2*k-3:0]),
          .q   (next_radicand)
        );
      end
    end
  endgenerate

  // Stage select: the root is exact iff the remainder is zero or, after a 0, -(2Q + 1). Two numbers
  // add up to zero iff there is a carry into each place where their digits differ and none where
  // they agree.
  localparam LAST = ROOT + 1;

  wire [LAST-1:0] last_remainder = g_digit[ROOT-1].next_remainder;
  wire [ROOT-1:0] last_root      = g_digit[ROOT-1].next_root;
  wire [LAST-1:0] last_restore   = {last_root, 1'b1} & {LAST{!last_root[0]}};
  wire [LAST-1:0] last_carry     = (last_remainder | last_restore) << 1;
  wire            last_remains   = |(last_remainder ^ last_restore ^ last_carry);
  wire            last_sticky    = last_remains || g_digit[ROOT-1].next_sticky;

  wire [EXPONENT_WIDTH-1:0] round_exponent;
  wire [ROOT-1:0]           round_root;
  wire                      round_sticky;
  wire                      round_sign;
  wire                      round_nan;
  wire                      round_infinite;
  wire                      round_zero;
  wire                      round_suspect;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + ROOT + 1 + FLAGS),
    .REGISTERED(CUTS[ROOT+1])
  ) last_rank (
    .aclk(aclk),
    .d   ({g_digit[ROOT-1].next_exponent, last_root, last_sticky, g_digit[ROOT-1].next_flags}),
    .q   ({round_exponent, round_root, round_sticky,
           round_sign, round_nan, round_infinite, round_zero, round_suspect})
  );

  // Stages denormalise, round, pack.
  fp_round #(
    .EXPONENT_WIDTH      (EXPONENT_WIDTH),
    .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
    .RESULT_PRECISION    (RESULT_PRECISION),
    .OVERFLOW            (OVERFLOW),
    .UNDERFLOW           (TINY_RESULTS),
    .GRADUAL             (SUBNORMALS),
    .DENORMALISE         (DENORMALISE),
    .TOWARD_ZERO         (TOWARD_ZERO),
    .CUTS                (CUTS[ROOT+5:ROOT+2])
  ) round (
    .aclk       (aclk),
    .sign       (round_sign),
    .exponent   (round_exponent),
    .value      ({round_root, 1'b0}),
    .amount     (2'b00),
    .sticky     (round_sticky),
    .nan        (round_nan),
    .infinite   (round_infinite),
    .zero       (round_zero),
    .suspect    (round_suspect),
    .y          (y),
    .exceptional(exceptional)
  );

endmodule

`default_nettype wire
