// fp_add: a + b, or a - b with SUBTRACT, rounded once to the result format.
// Latency: the population count of CUTS (nine bits); initiation interval 1; no reset.
// Special values as IEEE 754: infinity - infinity is NaN, x - x is +0.
// SPECIAL_OPERANDS, OVERFLOW, UNDERFLOW: 0 promises that there are none; docs/rtl.md.
// CANCELLATION = 0 promises that what is added never has unlike signs, zeros aside.
`default_nettype none

module fp_add #(
  parameter       EXPONENT_BITS        = 8,
  parameter       PRECISION            = 24,
  parameter       RESULT_EXPONENT_BITS = EXPONENT_BITS,
  parameter       RESULT_PRECISION     = PRECISION,
  parameter       SUBTRACT             = 0,
  parameter       SPECIAL_OPERANDS     = 1,
  parameter       OVERFLOW             = 1,
  parameter       UNDERFLOW            = 1,
  parameter       CANCELLATION         = 1,
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

  // Of like signs, a sum has its leading one where the larger operand has, or one place above. If
  // the result's exponent is as wide as the operands', a subnormal sum is represented as such, so
  // no leading one has to be found.
  localparam GROWING =
      (CANCELLATION == 0) && (!SUBNORMALS || (RESULT_EXPONENT_BITS == EXPONENT_BITS));

  // The smaller operand is aligned on the larger one's leading bit and as many fraction bits as
  // make both a cancellation and the bit beyond the result's guard bit exact.
  localparam ALIGNED = larger(PRECISION, RESULT_PRECISION + 1) + 1;
  // Only one bit can cancel unless the exponents differ by less than two, and then nothing is
  // below the larger operand's last bit but one bit: zeros are counted over carry, P and that one.
  localparam CANCELLING = PRECISION + 2;
  localparam SUM        = ALIGNED + 2;
  localparam KEPT       = RESULT_PRECISION + 2;

  localparam AMOUNT_BITS    = bits_for(ALIGNED);
  localparam DISTANCE_WIDTH = larger(EXPONENT_BITS, AMOUNT_BITS) + 1;
  localparam COUNT_BITS     = GROWING ? 1 : bits_for(CANCELLING);
  localparam EXPONENT_WIDTH =
      larger(larger(EXPONENT_BITS, RESULT_EXPONENT_BITS), bits_for(SUM)) + 2;
  localparam PACKED = EXPONENT_BITS + PRECISION;

  localparam integer REBIAS = (1 << (RESULT_EXPONENT_BITS - 1)) - (1 << (EXPONENT_BITS - 1));
  // With a result exponent no narrower than the operands', not normalising below exponent 1 is
  // all that a subnormal sum asks for.
  localparam DENORMALISE = (SUBNORMALS != 0) && (RESULT_EXPONENT_BITS < EXPONENT_BITS);

  // What was not flushed does not add up to less unless it cancels.
  localparam TINY_RESULTS =
      (UNDERFLOW != 0) && (SUBNORMALS || !(GROWING && (RESULT_EXPONENT_BITS >= EXPONENT_BITS)));

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 30)) begin : g_refused_exponent
      EXPONENT_BITS_is_not_2_to_30 refused ();
    end
    if (PRECISION < 2) begin : g_refused_precision
      PRECISION_is_below_2 refused ();
    end
    if ((RESULT_EXPONENT_BITS < 2) || (RESULT_EXPONENT_BITS > 30)) begin : g_refused_result_exponent
      RESULT_EXPONENT_BITS_is_not_2_to_30 refused ();
    end
    if (RESULT_PRECISION < 2) begin : g_refused_result_precision
      RESULT_PRECISION_is_below_2 refused ();
    end
  endgenerate

  // Stage compare: packed magnitudes order as integers; both exponent differences are at hand
  // when the order is known.
  wire                     s0_a_sign;
  wire [EXPONENT_BITS-1:0] s0_a_exponent;
  wire [PRECISION-1:0]     s0_a_significand;
  wire                     s0_a_zero;
  wire                     s0_a_infinite;
  wire                     s0_a_nan;
  wire                     s0_a_flushed;

  fp_unpack #(
    .EXPONENT_BITS   (EXPONENT_BITS),
    .PRECISION       (PRECISION),
    .SPECIAL_OPERANDS(SPECIAL_OPERANDS),
    .UNDERFLOW       (UNDERFLOW),
    .GRADUAL         (SUBNORMALS)
  ) s0_unpack_a (
    .a          (a),
    .sign       (s0_a_sign),
    .exponent   (s0_a_exponent),
    .significand(s0_a_significand),
    .zero       (s0_a_zero),
    .infinite   (s0_a_infinite),
    .nan        (s0_a_nan),
    .flushed    (s0_a_flushed)
  );

  wire                     s0_b_packed_sign;
  wire [EXPONENT_BITS-1:0] s0_b_exponent;
  wire [PRECISION-1:0]     s0_b_significand;
  wire                     s0_b_zero;
  wire                     s0_b_infinite;
  wire                     s0_b_nan;
  wire                     s0_b_flushed;

  fp_unpack #(
    .EXPONENT_BITS   (EXPONENT_BITS),
    .PRECISION       (PRECISION),
    .SPECIAL_OPERANDS(SPECIAL_OPERANDS),
    .UNDERFLOW       (UNDERFLOW),
    .GRADUAL         (SUBNORMALS)
  ) s0_unpack_b (
    .a          (b),
    .sign       (s0_b_packed_sign),
    .exponent   (s0_b_exponent),
    .significand(s0_b_significand),
    .zero       (s0_b_zero),
    .infinite   (s0_b_infinite),
    .nan        (s0_b_nan),
    .flushed    (s0_b_flushed)
  );

  wire                     s0_b_sign    = s0_b_packed_sign ^ (SUBTRACT != 0);
  wire                     s0_cancel    = s0_a_sign ^ s0_b_sign;
  wire                     s0_swap      = a[PACKED-2:0] < b[PACKED-2:0];
  wire [EXPONENT_BITS-1:0] s0_a_above_b = s0_a_exponent - s0_b_exponent;
  wire [EXPONENT_BITS-1:0] s0_b_above_a = s0_b_exponent - s0_a_exponent;

  wire s0_infinite = s0_a_infinite || s0_b_infinite;
  wire s0_nan      = s0_a_nan || s0_b_nan || (s0_a_infinite && s0_b_infinite && s0_cancel);
  wire s0_suspect  = s0_infinite || s0_nan || s0_a_flushed || s0_b_flushed;
  wire s0_zero     = (GROWING || !SUBNORMALS) && s0_a_zero && s0_b_zero;

  wire [EXPONENT_BITS-1:0] s1_a_exponent;
  wire [PRECISION-1:0]     s1_a_significand;
  wire [EXPONENT_BITS-1:0] s1_b_exponent;
  wire [PRECISION-1:0]     s1_b_significand;
  wire [EXPONENT_BITS-1:0] s1_a_above_b;
  wire [EXPONENT_BITS-1:0] s1_b_above_a;
  wire                     s1_swap;
  wire                     s1_a_zero;
  wire                     s1_b_zero;
  wire                     s1_a_sign;
  wire                     s1_b_sign;
  wire [3:0]               s1_flags;

  fp_rank #(
    .WIDTH     (2 * (EXPONENT_BITS + PRECISION)),
    .REGISTERED(CUTS[0])
  ) rank_0_operands (
    .aclk(aclk),
    .d   ({s0_a_exponent, s0_a_significand, s0_b_exponent, s0_b_significand}),
    .q   ({s1_a_exponent, s1_a_significand, s1_b_exponent, s1_b_significand})
  );

  fp_rank #(
    .WIDTH     (2 * EXPONENT_BITS + 9),
    .REGISTERED(CUTS[0])
  ) rank_0_order (
    .aclk(aclk),
    .d   ({s0_a_above_b, s0_b_above_a, s0_swap, s0_a_zero, s0_b_zero, s0_a_sign, s0_b_sign,
           s0_nan, s0_infinite, s0_zero, s0_suspect}),
    .q   ({s1_a_above_b, s1_b_above_a, s1_swap, s1_a_zero, s1_b_zero, s1_a_sign, s1_b_sign,
           s1_flags})
  );

  // Stage swap: the larger magnitude gives the sign; a zero as the smaller one adds nothing.
  wire [EXPONENT_BITS-1:0] s1_exponent   = s1_swap ? s1_b_exponent : s1_a_exponent;
  wire [PRECISION-1:0]     s1_large      = s1_swap ? s1_b_significand : s1_a_significand;
  wire [PRECISION-1:0]     s1_other      = s1_swap ? s1_a_significand : s1_b_significand;
  wire                     s1_other_zero = s1_swap ? s1_a_zero : s1_b_zero;
  wire [PRECISION-1:0]     s1_small      = s1_other & {PRECISION{!s1_other_zero}};
  wire [EXPONENT_BITS-1:0] s1_distance   = s1_swap ? s1_b_above_a : s1_a_above_b;
  wire                     s1_sign       = s1_swap ? s1_b_sign : s1_a_sign;
  wire                     s1_cancel     = s1_a_sign ^ s1_b_sign;

  wire [EXPONENT_BITS-1:0] s2_exponent;
  wire [PRECISION-1:0]     s2_large;
  wire [PRECISION-1:0]     s2_small;
  wire [EXPONENT_BITS-1:0] s2_distance;
  wire                     s2_sign;
  wire                     s2_cancel;
  wire [3:0]               s2_flags;

  fp_rank #(
    .WIDTH     (2 * (EXPONENT_BITS + PRECISION) + 6),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ({s1_exponent, s1_large, s1_small, s1_distance, s1_sign, s1_cancel, s1_flags}),
    .q   ({s2_exponent, s2_large, s2_small, s2_distance, s2_sign, s2_cancel, s2_flags})
  );

  // Stage align: beyond its width the smaller operand is no more than a sticky bit.
  wire [DISTANCE_WIDTH-1:0] s2_wide_distance = {
    {(DISTANCE_WIDTH - EXPONENT_BITS) {1'b0}}, s2_distance
  };
  wire                   s2_far    = |s2_wide_distance[DISTANCE_WIDTH-1:AMOUNT_BITS];
  wire [AMOUNT_BITS-1:0] s2_amount = s2_wide_distance[AMOUNT_BITS-1:0] | {AMOUNT_BITS{s2_far}};
  wire [ALIGNED-1:0]     s2_aligned;
  wire                   s2_sticky;

  fp_shift_right #(
    .WIDTH      (ALIGNED),
    .AMOUNT_BITS(AMOUNT_BITS)
  ) s2_align (
    .value  ({s2_small, {(ALIGNED - PRECISION) {1'b0}}}),
    .amount (s2_amount),
    .shifted(s2_aligned),
    .sticky (s2_sticky)
  );

  wire [EXPONENT_BITS-1:0] s3_exponent;
  wire [PRECISION-1:0]     s3_large;
  wire [ALIGNED:0]         s3_small;
  wire                     s3_sign;
  wire                     s3_cancel;
  wire [3:0]               s3_flags;

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + PRECISION + ALIGNED + 7),
    .REGISTERED(CUTS[2])
  ) rank_2 (
    .aclk(aclk),
    .d   ({s2_exponent, s2_large, s2_aligned, s2_sticky, s2_sign, s2_cancel, s2_flags}),
    .q   ({s3_exponent, s3_large, s3_small, s3_sign, s3_cancel, s3_flags})
  );

  // Stage sum: minus x is not x plus one; the one enters as a carry out of an extra last place.
  wire           s3_subtract = (CANCELLATION != 0) && s3_cancel;
  wire [SUM-1:0] s3_addend   = {1'b0, s3_small} ^ {SUM{s3_subtract}};
  wire [SUM-1:0] s3_sum;
  wire           s3_unused_place;

  assign {s3_sum, s3_unused_place} =
      {1'b0, s3_large, {(SUM - 1 - PRECISION) {1'b0}}, 1'b1} + {s3_addend, s3_subtract};

  wire [EXPONENT_BITS-1:0] s4_exponent;
  wire [SUM-1:0]           s4_sum;
  wire                     s4_sign;
  wire                     s4_cancel;
  wire                     s4_nan;
  wire                     s4_infinite;
  wire                     s4_operands_zero;
  wire                     s4_suspect;

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + SUM + 6),
    .REGISTERED(CUTS[3])
  ) rank_3 (
    .aclk(aclk),
    .d   ({s3_exponent, s3_sum, s3_sign, s3_cancel, s3_flags}),
    .q   ({s4_exponent, s4_sum, s4_sign, s4_cancel,
           s4_nan, s4_infinite, s4_operands_zero, s4_suspect})
  );

  // Stage count: leading zeros of the sum, and the room above exponent 1 to move it up in.
  wire [COUNT_BITS-1:0] s4_count;
  wire                  s4_empty;

  generate
    if (GROWING) begin : g_growing
      assign s4_count = !s4_sum[SUM-1];
      assign s4_empty = 1'b0;
    end else begin : g_cancelling
      localparam COUNTED = 1 << COUNT_BITS;

      wire [COUNTED-1:0] s4_counted = {
        s4_sum[SUM-1:SUM-CANCELLING], {(COUNTED - CANCELLING) {1'b0}}
      };

      fp_leading_zeros #(
        .COUNT_BITS(COUNT_BITS)
      ) s4_leading_zeros (
        .value(s4_counted),
        .count(s4_count),
        .empty(s4_empty)
      );
    end
  endgenerate

  wire [EXPONENT_WIDTH-1:0] s4_room =
      {{(EXPONENT_WIDTH - EXPONENT_BITS) {1'b0}}, s4_exponent} + REBIAS[EXPONENT_WIDTH-1:0];
  wire                      s4_zero = s4_empty || s4_operands_zero;

  wire [EXPONENT_WIDTH-1:0] s5_room;
  wire [COUNT_BITS-1:0]     s5_count;
  wire [SUM-1:0]            s5_sum;
  wire [4:0]                s5_flags;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + COUNT_BITS + SUM + 5),
    .REGISTERED(CUTS[4])
  ) rank_4 (
    .aclk(aclk),
    .d   ({s4_room, s4_count, s4_sum, s4_sign && !(s4_zero && s4_cancel),
           s4_nan, s4_infinite, s4_zero, s4_suspect}),
    .q   ({s5_room, s5_count, s5_sum, s5_flags})
  );

  // Stage normalise: the sum's first bit is the carry, one above the larger operand's exponent.
  wire [COUNT_BITS-1:0]     s5_amount;
  wire [KEPT-1:0]           s5_significand;
  wire                      s5_sticky;
  wire [EXPONENT_WIDTH-1:0] s5_exponent =
      s5_room + {{(EXPONENT_WIDTH - 1) {1'b0}}, 1'b1}
      - {{(EXPONENT_WIDTH - COUNT_BITS) {1'b0}}, s5_amount};

  generate
    if (SUBNORMALS != 0) begin : g_gradual
      wire s5_no_room = s5_room[EXPONENT_WIDTH-1];
      wire s5_little_room =
          s5_room[EXPONENT_WIDTH-2:0] < {{(EXPONENT_WIDTH - 1 - COUNT_BITS) {1'b0}}, s5_count};
      wire [COUNT_BITS-1:0] s5_possible =
          s5_little_room ? s5_room[COUNT_BITS-1:0] : s5_count;

      assign s5_amount = s5_possible & {COUNT_BITS{!s5_no_room}};
    end else begin : g_flush
      assign s5_amount = s5_count;
    end
  endgenerate

  fp_shift_left #(
    .WIDTH      (SUM),
    .KEPT       (KEPT),
    .AMOUNT_BITS(COUNT_BITS)
  ) s5_normalise (
    .value  (s5_sum),
    .amount (s5_amount),
    .shifted(s5_significand),
    .sticky (s5_sticky)
  );

  wire [EXPONENT_WIDTH-1:0] s6_exponent;
  wire [KEPT-1:0]           s6_significand;
  wire                      s6_sticky;
  wire                      s6_sign;
  wire                      s6_nan;
  wire                      s6_infinite;
  wire                      s6_zero;
  wire                      s6_suspect;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + KEPT + 6),
    .REGISTERED(CUTS[5])
  ) rank_5 (
    .aclk(aclk),
    .d   ({s5_exponent, s5_significand, s5_sticky, s5_flags}),
    .q   ({s6_exponent, s6_significand, s6_sticky,
           s6_sign, s6_nan, s6_infinite, s6_zero, s6_suspect})
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
    .CUTS                (CUTS[8:6])
  ) s6_round (
    .aclk       (aclk),
    .sign       (s6_sign),
    .exponent   (s6_exponent),
    .significand(s6_significand),
    .sticky     (s6_sticky),
    .nan        (s6_nan),
    .infinite   (s6_infinite),
    .zero       (s6_zero),
    .suspect    (s6_suspect),
    .y          (y),
    .exceptional(exceptional)
  );

endmodule

`default_nettype wire
