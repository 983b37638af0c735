// fp_add: a + b, or a - b with SUBTRACT, rounded once to the result format.
// Latency: the population count of CUTS (fourteen bits); initiation interval 1; no reset.
// Special values as IEEE 754: infinity - infinity is NaN, x - x is +0.
// rtl_templates/fp/README.md states the promises in full.
`default_nettype none

module fp_add #(
  parameter        EXPONENT_BITS        = 8,              // bits of an operand's exponent, 2 to 30
  parameter        PRECISION            = 24,             // digits with the leading one, 2 or more
  parameter        RESULT_EXPONENT_BITS = EXPONENT_BITS,  // bits of the result's exponent, 2 to 30
  parameter        RESULT_PRECISION     = PRECISION,      // digits of the result, 2 or more
  parameter        SUBTRACT             = 0,              // 1: a - b; 0: a + b
  parameter        SPECIAL_OPERANDS     = 1,              // 0 promises no NaN and no infinity
  parameter        OVERFLOW             = 1,              // 0 promises that no result overflows
  parameter        UNDERFLOW            = 1,              // 0 promises no tiny operand or result
  parameter        CANCELLATION         = 1,              // 0 promises like signs, except of zeros
  parameter        GRADUAL              = 0,              // 1: subnormals; 0: flushed to zero
  parameter        TOWARD_ZERO          = 0,              // 1: rounds toward zero; 0: nearest even
  // How many bits may select an operand inside the look-up tables of a carry chain: 2 for tables of
  // six inputs, 1 for carry cells of four inputs that can select (ECP5), otherwise 0.
  parameter        SUM_SELECTS          = 2,
  parameter [13:0] CUTS                 = 14'b0           // a register behind stage k if bit k is 1
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

  // If the signs are alike, the sum has its leading one in the larger operand's leading place or
  // one place above. If the result's exponent is also as wide as the operands', a subnormal sum
  // needs no other form, so no leading one has to be found.
  localparam GROWING =
      (CANCELLATION == 0) && (!SUBNORMALS || (RESULT_EXPONENT_BITS == EXPONENT_BITS));

  // The smaller operand is aligned on the larger one's leading bit and as many fraction bits as
  // make both a cancellation and the bit beyond the result's guard bit exact.
  localparam ALIGNED = larger(PRECISION, RESULT_PRECISION + 1) + 1;
  // More than one bit can cancel only if the exponents differ by less than two. The sum then has at
  // most one bit below the larger operand's last one. So zeros are counted in the carry, the
  // PRECISION bits and that bit.
  localparam CANCELLING = PRECISION + 2;
  localparam SUM        = ALIGNED + 2;
  localparam KEPT       = RESULT_PRECISION + 2;
  // MOVED has room for a shift of up to three places, which stage normalise or fp_round makes.
  localparam MOVED      = (SUM < KEPT + 3) ? SUM : KEPT + 3;

  localparam COUNT_BITS     = GROWING ? 3 : bits_for(CANCELLING);
  localparam EXPONENT_WIDTH =
      larger(larger(EXPONENT_BITS, RESULT_EXPONENT_BITS), bits_for(SUM)) + 2;

  localparam integer REBIAS = (1 << (RESULT_EXPONENT_BITS - 1)) - (1 << (EXPONENT_BITS - 1));
  // If the result's exponent is no narrower than the operands', a subnormal sum is right as soon as
  // it is not normalised below exponent 1.
  localparam DENORMALISE = (SUBNORMALS != 0) && (RESULT_EXPONENT_BITS < EXPONENT_BITS);

  // Operands that were not flushed have a tiny sum only if they cancel or the result's range is
  // less.
  localparam TINY_RESULTS =
      (UNDERFLOW != 0) && (SUBNORMALS || !(GROWING && (RESULT_EXPONENT_BITS >= EXPONENT_BITS)));

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

  // Stages compare, swap, align by fours, align. If nothing is subtracted, the exponents decide
  // which significand is aligned on the other.
  wire [EXPONENT_BITS-1:0] s4_exponent;
  wire [PRECISION-1:0]     s4_large;
  wire                     s4_unused_moves;
  wire [ALIGNED:0]         s4_small;
  wire [ALIGNED:0]         s4_unused_moved;
  wire                     s4_sign;
  wire                     s4_cancel;
  wire                     s4_nan;
  wire                     s4_infinite;
  wire                     s4_operands_zero;
  wire                     s4_suspect;

  fp_aligned_operands #(
    .EXPONENT_BITS   (EXPONENT_BITS),
    .PRECISION       (PRECISION),
    .ALIGNED         (ALIGNED),
    .SUBTRACT        (SUBTRACT),
    .SPECIAL_OPERANDS(SPECIAL_OPERANDS),
    .UNDERFLOW       (UNDERFLOW),
    .GRADUAL         (SUBNORMALS),
    .ORDERED         (CANCELLATION),
    .CUTS            (CUTS[3:0])
  ) s0_aligned_operands (
    .aclk    (aclk),
    .a       (a),
    .b       (b),
    .exponent(s4_exponent),
    .larger  (s4_large),
    .moves   (s4_unused_moves),
    .smaller (s4_small),
    .moved   (s4_unused_moved),
    .sign    (s4_sign),
    .cancel  (s4_cancel),
    .nan     (s4_nan),
    .infinite(s4_infinite),
    .zero    (s4_operands_zero),
    .suspect (s4_suspect)
  );

  // Stages sum, sum upper half: -x is ~x + 1.
  wire                     s4_subtract = (CANCELLATION != 0) && s4_cancel;
  wire [EXPONENT_BITS-1:0] s5_exponent;
  wire [SUM-1:0]           s5_sum;
  wire [5:0]               s5_flags;

  fp_halved_sum #(
    .WIDTH(SUM),
    .CUTS (CUTS[4])
  ) s4_sum (
    .aclk (aclk),
    .a    ({1'b0, s4_large, {(SUM - 1 - PRECISION) {1'b0}}}),
    .b    ({1'b0, s4_small} ^ {SUM{s4_subtract}}),
    .carry(s4_subtract),
    .sum  (s5_sum)
  );

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + 6),
    .REGISTERED(CUTS[4])
  ) rank_4 (
    .aclk(aclk),
    .d   ({s4_exponent, s4_sign, s4_cancel, s4_nan, s4_infinite, s4_operands_zero, s4_suspect}),
    .q   ({s5_exponent, s5_flags})
  );

  wire [EXPONENT_BITS-1:0] s6_exponent;
  wire [SUM-1:0]           s6_sum;
  wire                     s6_sign;
  wire                     s6_cancel;
  wire                     s6_nan;
  wire                     s6_infinite;
  wire                     s6_operands_zero;
  wire                     s6_suspect;

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + SUM + 6),
    .REGISTERED(CUTS[5])
  ) rank_5 (
    .aclk(aclk),
    .d   ({s5_exponent, s5_sum, s5_flags}),
    .q   ({s6_exponent, s6_sum, s6_sign, s6_cancel,
           s6_nan, s6_infinite, s6_operands_zero, s6_suspect})
  );

  // Stage count: the sum's leading zeros, and by how many places it may move up until exponent 1.
  wire [COUNT_BITS-1:0] s6_count;
  wire                  s6_empty;

  generate
    if (GROWING) begin : g_growing
      assign s6_count = {{(COUNT_BITS - 1) {1'b0}}, !s6_sum[SUM-1]};
      assign s6_empty = 1'b0;
    end else begin : g_cancelling
      localparam COUNTED = 1 << COUNT_BITS;

      wire [COUNTED-1:0] s6_counted = {
        s6_sum[SUM-1:SUM-CANCELLING], {(COUNTED - CANCELLING) {1'b0}}
      };

      fp_leading_zeros #(
        .COUNT_BITS(COUNT_BITS)
      ) s6_leading_zeros (
        .aclk (aclk),
        .value(s6_counted),
        .count(s6_count),
        .empty(s6_empty)
      );
    end
  endgenerate

  wire [EXPONENT_WIDTH-1:0] s6_room =
      {{(EXPONENT_WIDTH - EXPONENT_BITS) {1'b0}}, s6_exponent} + REBIAS[EXPONENT_WIDTH-1:0];
  // If a gradual sum may cancel, its count already finds the sum of two zeros empty.
  wire                      s6_zero =
      s6_empty || (s6_operands_zero && (GROWING || !SUBNORMALS));

  wire [EXPONENT_WIDTH-1:0] s7_room;
  wire [COUNT_BITS-1:0]     s7_count;
  wire [SUM-1:0]            s7_sum;
  wire [4:0]                s7_flags;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + COUNT_BITS + SUM + 5),
    .REGISTERED(CUTS[6])
  ) rank_6 (
    .aclk(aclk),
    .d   ({s6_room, s6_count, s6_sum, s6_sign && !(s6_zero && s6_cancel),
           s6_nan, s6_infinite, s6_zero, s6_suspect}),
    .q   ({s7_room, s7_count, s7_sum, s7_flags})
  );

  // Stage limit: a subnormal sum moves up until its exponent is 1 and no further. A sum that cannot
  // cancel moves up by at most one place, which is always allowed: operands' exponents are 1 or
  // more.
  wire [COUNT_BITS-1:0] s7_amount;

  generate
    if ((SUBNORMALS != 0) && !GROWING) begin : g_gradual
      wire s7_no_room = s7_room[EXPONENT_WIDTH-1];
      wire s7_little_room =
          s7_room[EXPONENT_WIDTH-2:0] < {{(EXPONENT_WIDTH - 1 - COUNT_BITS) {1'b0}}, s7_count};
      wire [COUNT_BITS-1:0] s7_possible =
          s7_little_room ? s7_room[COUNT_BITS-1:0] : s7_count;

      assign s7_amount = s7_possible & {COUNT_BITS{!s7_no_room}};
    end else begin : g_unlimited
      assign s7_amount = s7_count;
    end
  endgenerate

  wire [EXPONENT_WIDTH-1:0] s8_room;
  wire [COUNT_BITS-1:0]     s8_amount;
  wire [SUM-1:0]            s8_sum;
  wire [4:0]                s8_flags;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + COUNT_BITS + SUM + 5),
    .REGISTERED(CUTS[7])
  ) rank_7 (
    .aclk(aclk),
    .d   ({s7_room, s7_amount, s7_sum, s7_flags}),
    .q   ({s8_room, s8_amount, s8_sum, s8_flags})
  );

  // Stage normalise by fours: the sum's first bit is the carry, one place above the larger
  // operand's leading one.
  wire [EXPONENT_WIDTH-1:0] s8_exponent;
  wire [MOVED-1:0]          s8_moved;
  wire                      s8_sticky;

  generate
    if (GROWING) begin : g_moves_by_one
      assign s8_exponent = s8_room + {{(EXPONENT_WIDTH - 1) {1'b0}}, !s8_amount[0]};
    end else begin : g_moves_by_amount
      assign s8_exponent =
          s8_room + {{(EXPONENT_WIDTH - 1) {1'b0}}, 1'b1}
          - {{(EXPONENT_WIDTH - COUNT_BITS) {1'b0}}, s8_amount};
    end
  endgenerate

  fp_shift_left #(
    .WIDTH      (SUM),
    .KEPT       (MOVED),
    .AMOUNT_BITS(COUNT_BITS - 2),
    .STEP       (4)
  ) s8_normalise (
    .value  (s8_sum),
    .amount (s8_amount[COUNT_BITS-1:2]),
    .shifted(s8_moved),
    .sticky (s8_sticky)
  );

  wire [EXPONENT_WIDTH-1:0] s9_exponent;
  wire [MOVED-1:0]          s9_moved;
  wire                      s9_sticky;
  wire [1:0]                s9_rest;
  wire [4:0]                s9_flags;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + MOVED + 8),
    .REGISTERED(CUTS[8])
  ) rank_8 (
    .aclk(aclk),
    .d   ({s8_exponent, s8_moved, s8_sticky, s8_amount[1:0], s8_flags}),
    .q   ({s9_exponent, s9_moved, s9_sticky, s9_rest, s9_flags})
  );

  // Stage normalise: moves by the remaining places, unless fp_round does that.
  localparam TO_ROUND = (DENORMALISE != 0) ? KEPT : KEPT + 3;

  wire [TO_ROUND-1:0] s9_value;
  wire [1:0]          s9_amount;
  wire                s9_lost;

  generate
    if (DENORMALISE != 0) begin : g_normalised
      assign s9_amount = 2'b00;

      fp_shift_left #(
        .WIDTH      (MOVED),
        .KEPT       (KEPT),
        .AMOUNT_BITS(2)
      ) s9_normalise (
        .value  (s9_moved),
        .amount (s9_rest),
        .shifted(s9_value),
        .sticky (s9_lost)
      );
    end else begin : g_left_to_rounding
      // fp_round moves down and keeps the low places: up by s9_rest is down by 3 - s9_rest.
      assign s9_amount = ~s9_rest;
      assign s9_lost   = 1'b0;

      if (MOVED < TO_ROUND) begin : g_narrow
        assign s9_value = {s9_moved, {(TO_ROUND - MOVED) {1'b0}}};
      end else begin : g_as_wide
        assign s9_value = s9_moved;
      end
    end
  endgenerate

  wire [EXPONENT_WIDTH-1:0] s10_exponent;
  wire [TO_ROUND-1:0]       s10_value;
  wire [1:0]                s10_amount;
  wire                      s10_sticky;
  wire                      s10_sign;
  wire                      s10_nan;
  wire                      s10_infinite;
  wire                      s10_zero;
  wire                      s10_suspect;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + TO_ROUND + 8),
    .REGISTERED(CUTS[9])
  ) rank_9 (
    .aclk(aclk),
    .d   ({s9_exponent, s9_value, s9_amount, s9_sticky || s9_lost, s9_flags}),
    .q   ({s10_exponent, s10_value, s10_amount, s10_sticky,
           s10_sign, s10_nan, s10_infinite, s10_zero, s10_suspect})
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
    .AMOUNT_BITS         ((DENORMALISE != 0) ? 0 : 2),
    .SUM_SELECTS         (SUM_SELECTS),
    .CUTS                (CUTS[13:10])
  ) s10_round (
    .aclk       (aclk),
    .sign       (s10_sign),
    .exponent   (s10_exponent),
    .value      (s10_value),
    .amount     (s10_amount),
    .sticky     (s10_sticky),
    .nan        (s10_nan),
    .infinite   (s10_infinite),
    .zero       (s10_zero),
    .suspect    (s10_suspect),
    .y          (y),
    .exceptional(exceptional)
  );

endmodule

`default_nettype wire
