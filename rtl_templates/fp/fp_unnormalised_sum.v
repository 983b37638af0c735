// fp_unnormalised_sum: the magnitude of a + b, or of a - b with SUBTRACT, rounded to nearest, ties
// to even. It has leading zeros where its operands cancel.
// Nine cuts, initiation interval 1, no reset. The magnitude is significand * 2^(exponent + carry),
// where `exponent` is that of the leading place, biased and signed. A significand with leading
// zeros was not rounded: it is exact.
// Overflow of the sum is not detected. If both operands are zero, the significand is arbitrary and
// the exponent is 0.
`default_nettype none

module fp_unnormalised_sum #(
  parameter       EXPONENT_BITS  = 8,    // bits of an operand's exponent, 2 or more
  parameter       PRECISION      = 24,   // digits with the leading one, 3 or more
  parameter       EXPONENT_WIDTH = 10,   // bits of `exponent`, EXPONENT_BITS + 2 or more
  parameter       SUBTRACT       = 0,    // 1: a - b; 0: a + b
  parameter       GRADUAL        = 0,    // 1: subnormals; 0: operands are flushed, the sum is not
  parameter       SUM_SELECTS    = 2,    // bits that may select, 0 to 2; see fp_add
  parameter [8:0] CUTS           = 9'b0  // a register behind stage k if bit k is 1
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] a,
  input  wire [EXPONENT_BITS+PRECISION-1:0] b,
  output wire [EXPONENT_WIDTH-1:0]          exponent,
  output wire                               carry,
  output wire [PRECISION-1:0]               significand,
  output wire                               nan,
  output wire                               infinite
);

  // The smaller operand has two places more than the larger one, and a sticky bit. The sum has one
  // place in front, for its carry.
  localparam ALIGNED = PRECISION + 2;
  localparam SUM     = ALIGNED + 2;

  // 1: two bits may select, so the choice of the larger operand and the place where the significand
  // begins take effect in the sums. 0: the smaller operand's step by one place takes effect there.
  localparam SELECTS_LATE = (SUM_SELECTS == 2);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 3) begin : g_refused_precision PRECISION_is_below_3 refused (); end
    if ((SUM_SELECTS < 0) || (SUM_SELECTS > 2))
      begin : g_refused_sum_selects SUM_SELECTS_is_not_0_to_2 refused (); end
    if (EXPONENT_WIDTH < EXPONENT_BITS + 2)
      begin : g_refused_exponent_width EXPONENT_WIDTH_is_too_small_for_EXPONENT_BITS refused (); end
  endgenerate

  // Stages compare, swap, align by fours, align: `large` is the operand with the larger exponent.
  wire [EXPONENT_BITS-1:0] s4_exponent;
  wire [PRECISION-1:0]     s4_large;
  wire                     s4_moves;
  wire [ALIGNED:0]         s4_small;
  wire [ALIGNED:0]         s4_moved;
  wire                     s4_unused_sign;
  wire                     s4_cancel;
  wire                     s4_nan;
  wire                     s4_infinite;
  wire                     s4_unused_zero;
  wire                     s4_unused_suspect;

  fp_aligned_operands #(
    .EXPONENT_BITS(EXPONENT_BITS),
    .PRECISION    (PRECISION),
    .ALIGNED      (ALIGNED),
    .SUBTRACT     (SUBTRACT),
    .GRADUAL      (GRADUAL),
    .ORDERED      (0),
    .COMPLEMENTED (1),
    .SELECTED_LAST(SELECTS_LATE),
    .MOVED_LAST   (!SELECTS_LATE),
    .CUTS         (CUTS[3:0])
  ) s0_aligned_operands (
    .aclk    (aclk),
    .a       (a),
    .b       (b),
    .exponent(s4_exponent),
    .larger  (s4_large),
    .moves   (s4_moves),
    .smaller (s4_small),
    .moved   (s4_moved),
    .sign    (s4_unused_sign),
    .cancel  (s4_cancel),
    .nan     (s4_nan),
    .infinite(s4_infinite),
    .zero    (s4_unused_zero),
    .suspect (s4_unused_suspect)
  );

  // Stages sum, sum upper half: with unlike signs, small + (-1 - large) is -1 - (large - small).
  wire [SUM-1:0]           s4_large_places = {s4_cancel, s4_large, {3{s4_cancel}}};
  wire [EXPONENT_BITS-1:0] s5_exponent;
  wire [SUM-1:0]           s5_sum;
  wire                     s5_cancel;
  wire [1:0]               s5_flags;

  generate
    if (!SELECTS_LATE) begin : g_moved_last
      fp_selected_sum #(
        .WIDTH(SUM),
        .CUTS (CUTS[4])
      ) s4_sum (
        .aclk  (aclk),
        .a     (s4_large_places),
        .select(s4_moves),
        .b     ({1'b0, s4_small}),
        .c     ({1'b0, s4_moved}),
        .carry (1'b0),
        .sum   (s5_sum)
      );
    end else begin : g_selected_last
      wire unused_moves = ^{s4_moves, s4_moved};

      fp_halved_sum #(
        .WIDTH(SUM),
        .GATED(1),
        .CUTS (CUTS[4])
      ) s4_sum (
        .aclk (aclk),
        .a    ({1'b0, s4_small}),
        .b    (s4_large_places),
        .carry(1'b0),
        .sum  (s5_sum)
      );
    end
  endgenerate

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + 3),
    .REGISTERED(CUTS[4])
  ) rank_4 (
    .aclk(aclk),
    .d   ({s4_exponent, s4_cancel, s4_nan, s4_infinite}),
    .q   ({s5_exponent, s5_cancel, s5_flags})
  );

  wire [EXPONENT_BITS-1:0] s6_exponent;
  wire [SUM-1:0]           s6_sum;
  wire                     s6_cancel;
  wire [1:0]               s6_flags;

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + SUM + 3),
    .REGISTERED(CUTS[5])
  ) rank_5 (
    .aclk(aclk),
    .d   ({s5_exponent, s5_sum, s5_cancel, s5_flags}),
    .q   ({s6_exponent, s6_sum, s6_cancel, s6_flags})
  );

  // Stage select: the significand begins with a carry, with the larger operand's leading one, or
  // one place below. If the leading one is still lower, the sum has no further bits and the
  // significand begins one place below as well. If `small` was in fact larger, the exponents are
  // equal, and the sum lacks the 1 that rounding up adds.
  wire [SUM-1:0] s6_bits     = s6_sum ^ {SUM{s6_cancel}};
  wire           s6_swapped  = s6_cancel && !s6_sum[SUM-1];
  wire           s6_inverted = s6_cancel && s6_sum[SUM-1];
  wire           s6_carry    = !s6_cancel && s6_sum[SUM-1];
  wire           s6_below    = s6_inverted && !s6_bits[SUM-2];
  wire           s6_shifts   = s6_carry || s6_below;
  wire           s6_up       =
      s6_swapped
      || (s6_carry && s6_bits[3] && (s6_bits[4] || (|s6_bits[2:0])))
      || (s6_below && s6_bits[1] && (s6_bits[2] || s6_bits[0]))
      || (!s6_carry && !s6_below && s6_bits[2] && (s6_bits[3] || (|s6_bits[1:0])));
  wire [EXPONENT_WIDTH-1:0] s6_moved_exponent =
      {{(EXPONENT_WIDTH - EXPONENT_BITS) {1'b0}}, s6_exponent}
      + {{(EXPONENT_WIDTH - 1) {s6_below}}, s6_shifts};

  wire [EXPONENT_WIDTH-1:0] s7_exponent;
  wire [PRECISION-1:0]      s7_selected;
  wire                      s7_up;
  wire [1:0]                s7_flags;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + 3),
    .REGISTERED(CUTS[6])
  ) rank_6 (
    .aclk(aclk),
    .d   ({s6_moved_exponent, s6_up, s6_flags}),
    .q   ({s7_exponent, s7_up, s7_flags})
  );

  // A bit of the significand is one of two neighbouring bits of the sum, or its complement.
  function [PRECISION-1:0] selected(input [PRECISION+1:0] sum, input shifts, input inverted);
    reg [PRECISION-1:0] shifted;
    begin
      shifted  = inverted ? ~sum[PRECISION-1:0] : sum[PRECISION+1:2];
      selected = shifts ? shifted : (sum[PRECISION:1] ^ {PRECISION{inverted}});
    end
  endfunction

  generate
    if (!SELECTS_LATE) begin : g_in_front
      fp_rank #(
        .WIDTH     (PRECISION),
        .REGISTERED(CUTS[6])
      ) rank_6_selected (
        .aclk(aclk),
        .d   (selected(s6_sum[SUM-1:2], s6_shifts, s6_inverted)),
        .q   (s7_selected)
      );
    end else begin : g_behind
      wire [PRECISION+1:0] s7_sum;
      wire                 s7_shifts;
      wire                 s7_inverted;

      fp_rank #(
        .WIDTH     (PRECISION + 4),
        .REGISTERED(CUTS[6])
      ) rank_6_sum (
        .aclk(aclk),
        .d   ({s6_sum[SUM-1:2], s6_shifts, s6_inverted}),
        .q   ({s7_sum, s7_shifts, s7_inverted})
      );

      assign s7_selected = selected(s7_sum, s7_shifts, s7_inverted);
    end
  endgenerate

  // Stages round sum, round upper half: a carry out leaves zeros, and the first of them becomes a
  // one.
  wire [EXPONENT_WIDTH-1:0] s8_exponent;
  wire                      s8_carry;
  wire [PRECISION-1:0]      s8_rounded;
  wire [1:0]                s8_flags;

  fp_halved_sum #(
    .WIDTH(PRECISION + 1),
    .GATED(SELECTS_LATE),
    .CUTS (CUTS[7])
  ) s7_round (
    .aclk (aclk),
    .a    ({{PRECISION{1'b0}}, s7_up}),
    .b    ({1'b0, s7_selected}),
    .carry(1'b0),
    .sum  ({s8_carry, s8_rounded})
  );

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + 2),
    .REGISTERED(CUTS[7])
  ) rank_7 (
    .aclk(aclk),
    .d   ({s7_exponent, s7_flags}),
    .q   ({s8_exponent, s8_flags})
  );

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + 1 + PRECISION + 2),
    .REGISTERED(CUTS[8])
  ) rank_8 (
    .aclk(aclk),
    .d   ({s8_exponent, s8_carry, s8_rounded[PRECISION-1] || s8_carry, s8_rounded[PRECISION-2:0],
           s8_flags}),
    .q   ({exponent, carry, significand, nan, infinite})
  );

endmodule

`default_nettype wire
