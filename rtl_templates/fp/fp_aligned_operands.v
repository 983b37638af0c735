// fp_aligned_operands: orders the operands of a + b, or of a - b with SUBTRACT, by size and aligns
// them. The smaller one is moved down by the difference of their exponents.
// Four cuts, initiation interval 1, no reset.
`default_nettype none

module fp_aligned_operands #(
  parameter       EXPONENT_BITS    = 8,       // bits of an operand's exponent, 2 or more
  parameter       PRECISION        = 24,      // digits with the leading one, 2 or more
  parameter       ALIGNED          = 26,      // places of the smaller operand, PRECISION or more
  parameter       SUBTRACT         = 0,       // 1: a - b; 0: a + b
  parameter       SPECIAL_OPERANDS = 1,       // 0 promises no NaN and no infinity
  parameter       UNDERFLOW        = 1,       // 0 promises that no operand is subnormal
  parameter       GRADUAL          = 0,       // 1: subnormals, only with UNDERFLOW; 0: flushed
  // 1: `larger` has the larger magnitude, and `sign` is its sign. 0: `larger` has the larger
  // exponent, and `sign` is the sign of an operand that is not zero, which is the sum's if signs
  // are alike.
  parameter       ORDERED          = 1,
  parameter       COMPLEMENTED     = 0,       // 1: `larger` is complemented if the signs are unlike
  // 1: `larger` is selected behind the last cut instead of in stage swap. That needs more
  // registers. It needs no gates if the sum follows at once and look-up tables have six inputs.
  parameter       SELECTED_LAST    = 0,
  // 1: the smaller operand's step by one place is left to the sum behind this unit
  // (fp_selected_sum).
  parameter       MOVED_LAST       = 0,
  parameter [3:0] CUTS             = 4'b0000  // a register behind stage k if bit k is 1
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] a,
  input  wire [EXPONENT_BITS+PRECISION-1:0] b,
  output wire [EXPONENT_BITS-1:0]           exponent,  // biased, of `larger`
  output wire [PRECISION-1:0]               larger,    // arbitrary if both are zero
  output wire                               moves,     // 1: the smaller operand is `moved`
  output wire [ALIGNED:0]                   smaller,   // if `moves` is 0; its last bit is sticky
  output wire [ALIGNED:0]                   moved,
  output wire                               sign,
  output wire                               cancel,    // the signs are unlike
  output wire                               nan,
  output wire                               infinite,
  output wire                               zero,      // both operands are zero
  output wire                               suspect    // an operand is exceptional
);

  // The name differs from that of the units' own function, since Verilator 5.006 warns if one hides
  // the other.
  function integer width_of(input integer value);
    integer rest;
    begin
      width_of = 0;
      for (rest = value; rest > 0; rest = rest >> 1) width_of = width_of + 1;
    end
  endfunction

  localparam AMOUNT_BITS    = width_of(ALIGNED);
  localparam DISTANCE_WIDTH = (EXPONENT_BITS > AMOUNT_BITS) ? EXPONENT_BITS + 1 : AMOUNT_BITS + 1;
  localparam FLAGS          = 4;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if (ALIGNED < PRECISION) begin : g_refused_aligned ALIGNED_is_below_PRECISION refused (); end
    if ((GRADUAL != 0) && (UNDERFLOW == 0))
      begin : g_refused_gradual GRADUAL_without_UNDERFLOW refused (); end
  endgenerate

  // Stage compare: packed magnitudes have the order of integers. Both exponent differences are
  // computed while the order is found.
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
    .GRADUAL         (GRADUAL)
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
    .GRADUAL         (GRADUAL)
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

  wire                     s0_b_sign = s0_b_packed_sign ^ (SUBTRACT != 0);
  wire                     s0_swap;
  wire [EXPONENT_BITS-1:0] s0_a_above_b;
  wire [EXPONENT_BITS-1:0] s0_b_above_a;

  // A subnormal number has exponent 1 although its field is 0. So the distance of a normal number
  // from it is one less than the difference of the fields. Which numbers are subnormal is known
  // late, so it only feeds the borrow of an extra last place.
  wire [EXPONENT_BITS-1:0] s0_a_field  = a[EXPONENT_BITS+PRECISION-2:PRECISION-1];
  wire [EXPONENT_BITS-1:0] s0_b_field  = b[EXPONENT_BITS+PRECISION-2:PRECISION-1];
  wire                     s0_a_normal = s0_a_significand[PRECISION-1];
  wire                     s0_b_normal = s0_b_significand[PRECISION-1];
  wire                     s0_a_below;
  wire                     s0_unused_a_place;
  wire                     s0_unused_b_place;

  assign {s0_a_below, s0_a_above_b, s0_unused_a_place} =
      {1'b0, s0_a_field, 1'b0} - {1'b0, s0_b_field, s0_a_normal && !s0_b_normal};
  assign {s0_b_above_a, s0_unused_b_place} =
      {s0_b_field, 1'b0} - {s0_a_field, s0_b_normal && !s0_a_normal};

  // The order is the borrow out, so there is no gate between carry chain and register.
  generate
    if (ORDERED != 0) begin : g_by_magnitude
      wire unused_below = s0_a_below;

      assign s0_swap = a[EXPONENT_BITS+PRECISION-2:0] < b[EXPONENT_BITS+PRECISION-2:0];
    end else begin : g_by_exponent
      assign s0_swap = s0_a_below;
    end
  endgenerate

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
  wire                     s1_a_infinite;
  wire                     s1_b_infinite;
  wire                     s1_a_nan;
  wire                     s1_b_nan;
  wire                     s1_flushed;

  fp_rank #(
    .WIDTH     (2 * (EXPONENT_BITS + PRECISION)),
    .REGISTERED(CUTS[0])
  ) rank_0_operands (
    .aclk(aclk),
    .d   ({s0_a_exponent, s0_a_significand, s0_b_exponent, s0_b_significand}),
    .q   ({s1_a_exponent, s1_a_significand, s1_b_exponent, s1_b_significand})
  );

  fp_rank #(
    .WIDTH     (2 * EXPONENT_BITS + 10),
    .REGISTERED(CUTS[0])
  ) rank_0_order (
    .aclk(aclk),
    .d   ({s0_a_above_b, s0_b_above_a, s0_swap, s0_a_zero, s0_b_zero, s0_a_sign, s0_b_sign,
           s0_a_infinite, s0_b_infinite, s0_a_nan, s0_b_nan, s0_a_flushed || s0_b_flushed}),
    .q   ({s1_a_above_b, s1_b_above_a, s1_swap, s1_a_zero, s1_b_zero, s1_a_sign, s1_b_sign,
           s1_a_infinite, s1_b_infinite, s1_a_nan, s1_b_nan, s1_flushed})
  );

  // Stage swap: a zero as the smaller operand adds nothing. If the distance exceeds its width, the
  // smaller operand is no more than a sticky bit.
  wire [EXPONENT_BITS-1:0] s1_exponent   = s1_swap ? s1_b_exponent : s1_a_exponent;
  wire [PRECISION-1:0]     s1_other      = s1_swap ? s1_a_significand : s1_b_significand;
  wire                     s1_other_zero = s1_swap ? s1_a_zero : s1_b_zero;
  wire [PRECISION-1:0]     s1_small      = s1_other & {PRECISION{!s1_other_zero}};
  wire [EXPONENT_BITS-1:0] s1_distance   = s1_swap ? s1_b_above_a : s1_a_above_b;
  wire                     s1_b_signs    = (ORDERED != 0) ? s1_swap : s1_a_zero;
  wire                     s1_sign       = s1_b_signs ? s1_b_sign : s1_a_sign;
  wire                     s1_cancel     = s1_a_sign ^ s1_b_sign;
  wire                     s1_infinite   = s1_a_infinite || s1_b_infinite;
  wire                     s1_nan        =
      s1_a_nan || s1_b_nan || (s1_a_infinite && s1_b_infinite && s1_cancel);
  wire                     s1_zero       = s1_a_zero && s1_b_zero;
  wire                     s1_suspect    = s1_infinite || s1_nan || s1_flushed;

  wire [DISTANCE_WIDTH-1:0] s1_wide_distance = {
    {(DISTANCE_WIDTH - EXPONENT_BITS) {1'b0}}, s1_distance
  };
  wire                     s1_far        = |s1_wide_distance[DISTANCE_WIDTH-1:AMOUNT_BITS];

  wire [EXPONENT_BITS-1:0] s2_exponent;
  wire [PRECISION-1:0]     s2_small;
  wire [AMOUNT_BITS-1:0]   s2_distance;
  wire                     s2_far;
  wire                     s2_sign;
  wire                     s2_cancel;
  wire [FLAGS-1:0]         s2_flags;

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + PRECISION + AMOUNT_BITS + 3 + FLAGS),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ({s1_exponent, s1_small, s1_wide_distance[AMOUNT_BITS-1:0], s1_far, s1_sign, s1_cancel,
           s1_nan, s1_infinite, s1_zero, s1_suspect}),
    .q   ({s2_exponent, s2_small, s2_distance, s2_far, s2_sign, s2_cancel, s2_flags})
  );

  // Stage align by fours.
  wire [AMOUNT_BITS-1:0] s2_amount = s2_distance | {AMOUNT_BITS{s2_far}};
  wire [ALIGNED-1:0]     s2_widened;
  wire [ALIGNED-1:0]     s2_moved;
  wire [AMOUNT_BITS-1:0] s2_lost;

  generate
    if (ALIGNED > PRECISION) begin : g_widened
      assign s2_widened = {s2_small, {(ALIGNED - PRECISION) {1'b0}}};
    end else begin : g_as_wide
      assign s2_widened = s2_small;
    end
  endgenerate

  fp_shift_right #(
    .WIDTH      (ALIGNED),
    .AMOUNT_BITS(AMOUNT_BITS)
  ) s2_align (
    .value  (s2_widened),
    .amount ({s2_amount[AMOUNT_BITS-1:2], 2'b00}),
    .shifted(s2_moved),
    .lost   (s2_lost)
  );

  // The step by four is the last of this stage. The bits that it loses have a register of their
  // own, so there is no gate behind the step.
  wire [AMOUNT_BITS+2:0] s2_all_lost     = {3'b000, s2_lost};
  wire                   s2_lost_before  = |s2_all_lost[AMOUNT_BITS+2:3];
  wire                   s2_lost_by_four = |s2_all_lost[2:0];

  wire [EXPONENT_BITS-1:0] s3_exponent;
  wire [ALIGNED-1:0]       s3_moved;
  wire [1:0]               s3_lost_before;
  wire [1:0]               s3_rest;
  wire                     s3_sign;
  wire                     s3_cancel;
  wire [FLAGS-1:0]         s3_flags;

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + ALIGNED + 6 + FLAGS),
    .REGISTERED(CUTS[2])
  ) rank_2 (
    .aclk(aclk),
    .d   ({s2_exponent, s2_moved, s2_lost_before, s2_lost_by_four, s2_amount[1:0], s2_sign,
           s2_cancel, s2_flags}),
    .q   ({s3_exponent, s3_moved, s3_lost_before, s3_rest, s3_sign, s3_cancel, s3_flags})
  );

  // Stage align: moves by the remaining places. Bits that the last place moves out are already
  // lost.
  wire               s3_moves  = (MOVED_LAST != 0) && s3_rest[0];
  wire [ALIGNED-1:0] s3_aligned;
  wire [1:0]         s3_lost;
  wire               s3_sticky =
      (|s3_lost_before) || (|s3_lost) || (s3_moves && s3_aligned[0]);

  fp_shift_right #(
    .WIDTH      (ALIGNED),
    .AMOUNT_BITS(2)
  ) s3_align (
    .value  (s3_moved),
    .amount ({s3_rest[1], s3_rest[0] && !s3_moves}),
    .shifted(s3_aligned),
    .lost   (s3_lost)
  );

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + ALIGNED + 4 + FLAGS),
    .REGISTERED(CUTS[3])
  ) rank_3 (
    .aclk(aclk),
    .d   ({s3_exponent, s3_moves, s3_aligned, s3_sticky, s3_sign, s3_cancel, s3_flags}),
    .q   ({exponent, moves, smaller, sign, cancel, nan, infinite, zero, suspect})
  );

  assign moved = {1'b0, smaller[ALIGNED:2], smaller[0]};

  // The larger operand, from stage swap on.
  generate
    if (SELECTED_LAST != 0) begin : g_selected_last
      wire                 last_swap;
      wire [PRECISION-1:0] last_a_significand;
      wire [PRECISION-1:0] last_b_significand;
      wire                 last_complement = (COMPLEMENTED != 0) && cancel;

      fp_ranks #(
        .WIDTH(2 * PRECISION + 1),
        .COUNT(3),
        .CUTS (CUTS[3:1])
      ) ranks_1 (
        .aclk(aclk),
        .d   ({s1_swap, s1_a_significand, s1_b_significand}),
        .q   ({last_swap, last_a_significand, last_b_significand})
      );

      assign larger =
          (last_swap ? last_b_significand : last_a_significand) ^ {PRECISION{last_complement}};
    end else begin : g_selected_first
      wire [PRECISION-1:0] s1_larger     = s1_swap ? s1_b_significand : s1_a_significand;
      wire                 s1_complement = (COMPLEMENTED != 0) && s1_cancel;

      fp_ranks #(
        .WIDTH(PRECISION),
        .COUNT(3),
        .CUTS (CUTS[3:1])
      ) ranks_1 (
        .aclk(aclk),
        .d   (s1_larger ^ {PRECISION{s1_complement}}),
        .q   (larger)
      );
    end
  endgenerate

endmodule

`default_nettype wire
