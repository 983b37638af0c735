// fp_select_round: rounds and packs a result whose leading one is in the first or second place.
// Five cuts, initiation interval 1, no reset. Special values and promises as in fp_round.
// `exponent`, `tiny` and `amount` are outputs of fp_subnormal_shift for the exponent of the second
// place. The shift of a subnormal result and the selection of the leading one of any other result
// share their gates.
`default_nettype none

module fp_select_round #(
  parameter       WIDTH                = 48,   // bits of `value`, 2 or more
  parameter       EXPONENT_WIDTH       = 10,   // bits of `exponent`, above RESULT_EXPONENT_BITS + 1
  parameter       AMOUNT_BITS          = 5,    // bits of `amount`, enough for RESULT_PRECISION + 3
  parameter       RESULT_EXPONENT_BITS = 8,    // bits of the result's exponent, 2 or more
  parameter       RESULT_PRECISION     = 24,   // digits of the result, 2 or more
  parameter       OVERFLOW             = 1,    // 0 promises that no result overflows
  parameter       UNDERFLOW            = 1,    // 0 promises that no result is tiny
  parameter       GRADUAL              = 0,    // 1: subnormals, only with UNDERFLOW; 0: flushed
  parameter       TOWARD_ZERO          = 0,    // 1: rounds toward zero; 0: nearest even
  parameter       SUM_SELECTS          = 2,    // bits that may select, 0 to 2; see fp_add
  parameter [4:0] CUTS                 = 5'b0  // a register behind stage k if bit k is 1
) (
  input  wire                                             aclk,
  input  wire                                             sign,
  input  wire [EXPONENT_WIDTH-1:0]                        exponent,
  input  wire                                             tiny,
  input  wire [AMOUNT_BITS-1:0]                           amount,
  input  wire [WIDTH-1:0]                                 value,
  input  wire                                             sticky,
  input  wire                                             nan,
  input  wire                                             infinite,
  input  wire                                             zero,
  input  wire                                             suspect,
  output wire [RESULT_EXPONENT_BITS+RESULT_PRECISION-1:0] y,
  output wire                                             exceptional
);

  // MOVED: the first place, and the bits that are kept if the leading one is in the second place.
  localparam MOVED = RESULT_PRECISION + 3;
  localparam FLAGS = 5;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 2) begin : g_refused_width WIDTH_is_below_2 refused (); end
    if (RESULT_EXPONENT_BITS < 2)
      begin : g_refused_result_exponent RESULT_EXPONENT_BITS_is_below_2 refused (); end
    if (RESULT_PRECISION < 2)
      begin : g_refused_result_precision RESULT_PRECISION_is_below_2 refused (); end
    if (EXPONENT_WIDTH <= RESULT_EXPONENT_BITS + 1) begin : g_refused_exponent_width
      EXPONENT_WIDTH_is_too_small_for_RESULT_EXPONENT_BITS refused ();
    end
    if ((MOVED >> AMOUNT_BITS) != 0)
      begin : g_refused_amount_bits AMOUNT_BITS_is_too_small_for_RESULT_PRECISION refused (); end
    if ((GRADUAL != 0) && (UNDERFLOW == 0))
      begin : g_refused_gradual GRADUAL_without_UNDERFLOW refused (); end
  endgenerate

  // Stage denormalise: moves by the part of `amount` that is a multiple of four.
  wire [MOVED-1:0] s0_value;
  wire             s0_below;

  fp_fit #(
    .FROM(WIDTH),
    .TO  (MOVED)
  ) s0_fit (
    .value (value),
    .fitted(s0_value),
    .sticky(s0_below)
  );

  wire [MOVED-1:0]       s0_moved;
  wire [AMOUNT_BITS-1:0] s0_lost;

  fp_shift_right #(
    .WIDTH      (MOVED),
    .AMOUNT_BITS(AMOUNT_BITS)
  ) s0_shift (
    .value  (s0_value),
    .amount ({amount[AMOUNT_BITS-1:2], 2'b00}),
    .shifted(s0_moved),
    .lost   (s0_lost)
  );

  wire [EXPONENT_WIDTH-1:0] s1_exponent;
  wire [MOVED-1:0]          s1_value;
  wire                      s1_sticky;
  wire                      s1_tiny;
  wire [1:0]                s1_rest;
  wire                      s1_sign;
  wire                      s1_nan;
  wire                      s1_infinite;
  wire                      s1_zero;
  wire                      s1_suspect;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + MOVED + 4 + FLAGS),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({exponent, s0_moved, sticky || s0_below || (|s0_lost), tiny, amount[1:0],
           sign, nan, infinite, zero, suspect}),
    .q   ({s1_exponent, s1_value, s1_sticky, s1_tiny, s1_rest,
           s1_sign, s1_nan, s1_infinite, s1_zero, s1_suspect})
  );

  // Stage select: how far the value still has to move down. If the first place has a one, that is
  // one place more, and the exponent is one higher, unless the result is tiny and has moved
  // already. A tiny result without a leading one is subnormal, whatever its exponent is.
  wire                      s1_high     = s1_value[MOVED-1];
  wire [1:0]                s1_amount   = {s1_rest[1], s1_rest[0] || (s1_high && !s1_tiny)};
  wire [EXPONENT_WIDTH-1:0] s1_selected =
      s1_exponent + {{(EXPONENT_WIDTH - 1) {1'b0}}, s1_high};

  // Stages round, pack. fp_round moves the value; its first cut is behind the decision to round up.
  fp_round #(
    .EXPONENT_WIDTH      (EXPONENT_WIDTH),
    .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
    .RESULT_PRECISION    (RESULT_PRECISION),
    .OVERFLOW            (OVERFLOW),
    .UNDERFLOW           (UNDERFLOW),
    .GRADUAL             (GRADUAL),
    .DENORMALISE         (0),
    .TOWARD_ZERO         (TOWARD_ZERO),
    .AMOUNT_BITS         (2),
    .SUM_SELECTS         (SUM_SELECTS),
    .CUTS                (CUTS[4:1])
  ) s1_round (
    .aclk       (aclk),
    .sign       (s1_sign),
    .exponent   (s1_selected),
    .value      ({2'b00, s1_value}),
    .amount     (s1_amount),
    .sticky     (s1_sticky),
    .nan        (s1_nan),
    .infinite   (s1_infinite),
    .zero       (s1_zero),
    .suspect    (s1_suspect),
    .y          (y),
    .exceptional(exceptional)
  );

endmodule

`default_nettype wire
