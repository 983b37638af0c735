// fp_round: rounds an exact result, given by its leading bits and a sticky bit, and packs it.
// Four cuts, initiation interval 1, no reset. Special values: `nan`, `infinite` and `zero` say that
// the result is one, whatever `exponent` and `value` are. The first of them that is 1 wins.
// The promises of OVERFLOW and UNDERFLOW are about all other results.
// The value moves down by `amount`, and its low bits are rounded. Up to SUM_SELECTS bits of
// `amount` take effect in the look-up tables of the rounding's carry chain.
`default_nettype none

module fp_round #(
  // Bits of `exponent`: more than RESULT_EXPONENT_BITS + 1, and with DENORMALISE more than
  // RESULT_PRECISION + 2 has in binary.
  parameter       EXPONENT_WIDTH       = 10,
  parameter       RESULT_EXPONENT_BITS = 8,       // bits of the result's exponent, 2 or more
  parameter       RESULT_PRECISION     = 24,      // digits of the result, 2 or more
  parameter       OVERFLOW             = 1,       // 0 promises that no result overflows
  parameter       UNDERFLOW            = 1,       // 0 promises that no result is tiny
  parameter       GRADUAL              = 0,       // 1: subnormals, only with UNDERFLOW; 0: flushed
  // 1: with GRADUAL, exponents below 1 occur, and then the significand is normalised. 0: such
  // exponents do not occur, but a significand of exponent 1 may have leading zeros.
  parameter       DENORMALISE          = GRADUAL,
  parameter       TOWARD_ZERO          = 0,       // 1: rounds toward zero; 0: nearest even
  // Bits of `amount` that are read, 0 to 2; 0 with DENORMALISE.
  parameter       AMOUNT_BITS          = 0,
  parameter       SUM_SELECTS          = 2,       // bits that may select, 0 to 2; see fp_add
  parameter [3:0] CUTS                 = 4'b0000  // a register behind stage k if bit k is 1
) (
  input  wire                                             aclk,
  input  wire                                             sign,
  input  wire [EXPONENT_WIDTH-1:0]                        exponent,  // biased and signed
  // The significand. Once it has moved down, its low RESULT_PRECISION + 2 bits are rounded.
  input  wire [RESULT_PRECISION+(1<<AMOUNT_BITS):0]       value,
  input  wire [1:0]                                       amount,    // the low AMOUNT_BITS are read
  input  wire                                             sticky,
  input  wire                                             nan,
  input  wire                                             infinite,
  input  wire                                             zero,
  input  wire                                             suspect,   // an operand was exceptional
  output wire [RESULT_EXPONENT_BITS+RESULT_PRECISION-1:0] y,
  output wire                                             exceptional
);

  // The name differs from that of the units' own function, since Verilator 5.006 warns if one hides
  // the other.
  function integer width_of(input integer number);
    integer rest;
    begin
      width_of = 0;
      for (rest = number; rest > 0; rest = rest >> 1) width_of = width_of + 1;
    end
  endfunction

  localparam FRACTION_BITS = RESULT_PRECISION - 1;
  localparam WIDTH         = RESULT_PRECISION + 2;
  localparam FLAGS         = 5;
  localparam ROUNDED_WIDTH = EXPONENT_WIDTH + FRACTION_BITS;

  localparam VANISHING     = (UNDERFLOW != 0) && (GRADUAL == 0);
  // If nothing behind the rounding has to replace its result, a special result is inserted in front
  // of the rounding, where it shares the adder's gates.
  localparam SPECIAL_FIRST = (OVERFLOW == 0) && !VANISHING;

  // LATE_BITS: the bits of `amount` that take effect in the sum. There are none if special results
  // use the tables' inputs. HELD: how many bits of the value the sum then selects from.
  localparam LATE_LIMIT = (SUM_SELECTS < AMOUNT_BITS) ? SUM_SELECTS : AMOUNT_BITS;
  localparam LATE_BITS = SPECIAL_FIRST ? 0 : LATE_LIMIT;
  localparam PLACES    = RESULT_PRECISION + 1 + (1 << AMOUNT_BITS);
  localparam HELD      = FRACTION_BITS - 1 + (1 << LATE_BITS);

  localparam [1:0] AMOUNT_MASK = (1 << AMOUNT_BITS) - 1;
  localparam [1:0] LATE_MASK   = (1 << LATE_BITS) - 1;

  localparam [FRACTION_BITS-1:0] NO_FRACTION = 0;
  localparam [FRACTION_BITS-1:0] QUIET       = ~(~NO_FRACTION >> 1);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (RESULT_EXPONENT_BITS < 2)
      begin : g_refused_result_exponent RESULT_EXPONENT_BITS_is_below_2 refused (); end
    if (RESULT_PRECISION < 2)
      begin : g_refused_result_precision RESULT_PRECISION_is_below_2 refused (); end
    if (EXPONENT_WIDTH <= RESULT_EXPONENT_BITS + 1) begin : g_refused_exponent_width
      EXPONENT_WIDTH_is_too_small_for_RESULT_EXPONENT_BITS refused ();
    end
    if ((DENORMALISE != 0) && (EXPONENT_WIDTH <= width_of(WIDTH))) begin : g_refused_precision_width
      EXPONENT_WIDTH_is_too_small_for_RESULT_PRECISION refused ();
    end
    if ((GRADUAL != 0) && (UNDERFLOW == 0))
      begin : g_refused_gradual GRADUAL_without_UNDERFLOW refused (); end
    if ((DENORMALISE != 0) && (GRADUAL == 0))
      begin : g_refused_denormalise DENORMALISE_without_GRADUAL refused (); end
    if ((AMOUNT_BITS < 0) || (AMOUNT_BITS > 2))
      begin : g_refused_amount_bits AMOUNT_BITS_is_not_0_to_2 refused (); end
    if ((SUM_SELECTS < 0) || (SUM_SELECTS > 2))
      begin : g_refused_sum_selects SUM_SELECTS_is_not_0_to_2 refused (); end
    if ((DENORMALISE != 0) && (AMOUNT_BITS != 0))
      begin : g_refused_two_moves AMOUNT_BITS_with_DENORMALISE refused (); end
  endgenerate

  // Stage denormalise: below exponent 1 the significand moves down instead of the exponent.
  // Otherwise the value moves by those bits of `amount` that do not take effect in the sum. A copy
  // moves by all bits: it tells whether to round up and whether the result is subnormal.
  wire [WIDTH-1:0] s0_significand;
  wire [HELD-1:0]  s0_held;
  wire [1:0]       s0_amount = amount & LATE_MASK;
  wire             s0_sticky;

  generate
    if (DENORMALISE != 0) begin : g_denormalise
      localparam DOWN_BITS = width_of(WIDTH);

      wire [EXPONENT_WIDTH-1:0] unused_limited;
      wire                      unused_tiny;
      wire [DOWN_BITS-1:0]      down;
      wire [DOWN_BITS-1:0]      lost;

      fp_subnormal_shift #(
        .EXPONENT_WIDTH(EXPONENT_WIDTH),
        .AMOUNT_BITS   (DOWN_BITS)
      ) subnormal_shift (
        .exponent(exponent),
        .limited (unused_limited),
        .tiny    (unused_tiny),
        .amount  (down)
      );

      fp_shift_right #(
        .WIDTH      (WIDTH),
        .AMOUNT_BITS(DOWN_BITS)
      ) shift (
        .value  (value),
        .amount (down),
        .shifted(s0_significand),
        .lost   (lost)
      );

      assign s0_held   = s0_significand[WIDTH-2:2];
      assign s0_sticky = sticky || (|lost);
    end else begin : g_normal
      wire [PLACES-1:0] s0_early;
      wire [PLACES-1:0] s0_moved;
      wire [1:0]        lost_early;
      wire [1:0]        lost;
      wire              unused_places = ^s0_early ^ (^s0_moved);

      fp_shift_right #(
        .WIDTH      (PLACES),
        .AMOUNT_BITS(2)
      ) shift_early (
        .value  (value),
        .amount (amount & AMOUNT_MASK & ~LATE_MASK),
        .shifted(s0_early),
        .lost   (lost_early)
      );

      fp_shift_right #(
        .WIDTH      (PLACES),
        .AMOUNT_BITS(2)
      ) shift (
        .value  (s0_early),
        .amount (s0_amount),
        .shifted(s0_moved),
        .lost   (lost)
      );

      assign s0_significand = s0_moved[WIDTH-1:0];
      assign s0_held        = s0_early[HELD+1:2];
      assign s0_sticky      = sticky || (|lost_early) || (|lost);
    end
  endgenerate

  // Stage denormalise also decides whether to round up, so the rounding is no more than a carry
  // chain. A significand without a leading one is subnormal: its exponent field is 0.
  wire                      s0_leading = s0_significand[WIDTH-1];
  wire                      s0_odd     = s0_significand[2];
  wire                      s0_guard   = s0_significand[1];
  wire                      s0_beyond  = s0_significand[0];
  wire                      s0_tail    = s0_beyond || s0_sticky;
  wire [EXPONENT_WIDTH-1:0] s0_field   =
      exponent & {EXPONENT_WIDTH{s0_leading || (GRADUAL == 0)}};
  wire                      s0_inexact_subnormal = !s0_leading && (s0_guard || s0_tail);

  wire s0_all_ones  = SPECIAL_FIRST && (nan || infinite);
  wire s0_all_zeros = SPECIAL_FIRST && zero;
  wire s0_finite    = !(s0_all_ones || s0_all_zeros);

  wire [EXPONENT_WIDTH-1:0] s0_known_field    =
      (s0_field & {EXPONENT_WIDTH{!s0_all_zeros}}) | {EXPONENT_WIDTH{s0_all_ones}};
  wire [HELD-1:0]           s0_known;
  wire                      s0_up             =
      (TOWARD_ZERO == 0) && s0_finite && s0_guard && (s0_odd || s0_tail);

  generate
    if (SPECIAL_FIRST) begin : g_special_first
      assign s0_known = (s0_held & {HELD{s0_finite}}) | (QUIET & {HELD{nan}});
    end else begin : g_special_last
      assign s0_known = s0_held;
    end
  endgenerate

  wire [EXPONENT_WIDTH-1:0] s1_field;
  wire [HELD-1:0]           s1_held;
  wire [1:0]                s1_amount;
  wire                      s1_up;
  wire                      s1_inexact_subnormal;
  wire                      s1_beyond;
  wire [FLAGS-1:0]          s1_flags;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + HELD + 5 + FLAGS),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_known_field, s0_known, s0_amount, s0_up, s0_inexact_subnormal, s0_beyond,
           sign, nan, infinite, zero, suspect}),
    .q   ({s1_field, s1_held, s1_amount, s1_up, s1_inexact_subnormal, s1_beyond, s1_flags})
  );

  // Stages round, round upper half: exponent and fraction are one number, so a carry out of the
  // fraction increments the exponent.
  wire [ROUNDED_WIDTH-1:0] s2_rounded;
  wire                     s2_inexact_subnormal;
  wire                     s2_beyond;
  wire [FLAGS-1:0]         s2_flags;

  generate
    if (LATE_BITS == 0) begin : g_selected
      wire unused_amount = ^s1_amount;

      fp_halved_sum #(
        .WIDTH(ROUNDED_WIDTH),
        .CUTS (CUTS[1])
      ) s1_round (
        .aclk (aclk),
        .a    ({s1_field, s1_held}),
        .b    ({{(ROUNDED_WIDTH - 1) {1'b0}}, s1_up}),
        .carry(1'b0),
        .sum  (s2_rounded)
      );
    end else begin : g_selecting
      wire [HELD-1:0]          s1_by_twos      = s1_amount[1] ? s1_held >> 2 : s1_held;
      wire [FRACTION_BITS-1:0] s1_unmoved      = s1_by_twos[FRACTION_BITS-1:0];
      wire [FRACTION_BITS-1:0] s1_moved_by_one = s1_by_twos[FRACTION_BITS:1];
      wire                     unused_by_twos  = ^s1_by_twos;

      fp_selected_sum #(
        .WIDTH(ROUNDED_WIDTH),
        .CUTS (CUTS[1])
      ) s1_round (
        .aclk  (aclk),
        .a     ({{(ROUNDED_WIDTH - 1) {1'b0}}, s1_up}),
        .select(s1_amount[0]),
        .b     ({s1_field, s1_unmoved}),
        .c     ({s1_field, s1_moved_by_one}),
        .carry (1'b0),
        .sum   (s2_rounded)
      );
    end
  endgenerate

  fp_rank #(
    .WIDTH     (2 + FLAGS),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ({s1_inexact_subnormal, s1_beyond, s1_flags}),
    .q   ({s2_inexact_subnormal, s2_beyond, s2_flags})
  );

  wire [EXPONENT_WIDTH-1:0] s3_field;
  wire [FRACTION_BITS-1:0]  s3_fraction;
  wire                      s3_inexact_subnormal;
  wire                      s3_beyond;
  wire                      s3_sign;
  wire                      s3_nan;
  wire                      s3_infinite;
  wire                      s3_zero;
  wire                      s3_suspect;

  fp_rank #(
    .WIDTH     (ROUNDED_WIDTH + 2 + FLAGS),
    .REGISTERED(CUTS[2])
  ) rank_2 (
    .aclk(aclk),
    .d   ({s2_rounded, s2_inexact_subnormal, s2_beyond, s2_flags}),
    .q   ({s3_field, s3_fraction, s3_inexact_subnormal, s3_beyond,
           s3_sign, s3_nan, s3_infinite, s3_zero, s3_suspect})
  );

  // Stage pack: an all-ones field is too large, and so is a larger one. With GRADUAL no field is
  // too small. Suppose a subnormal was rounded up to the smallest normal number. With an unbounded
  // exponent it would also have been rounded up to that number iff the bit beyond the guard bit was
  // 1.
  wire s3_finite    = !(s3_nan || s3_infinite || s3_zero);
  wire s3_negative  = s3_field[EXPONENT_WIDTH-1];
  wire s3_too_large = (OVERFLOW != 0) && !(VANISHING && s3_negative)
                      && ((|s3_field[EXPONENT_WIDTH-2:RESULT_EXPONENT_BITS])
                          || (&s3_field[RESULT_EXPONENT_BITS-1:0]));
  wire s3_too_small = VANISHING && (s3_negative || !(|s3_field));
  wire s3_overflow  = s3_finite && s3_too_large;
  wire s3_vanished  = s3_finite && s3_too_small;
  wire s3_imprecise = s3_finite && (GRADUAL != 0) && s3_inexact_subnormal
                      && !(s3_field[0] && s3_beyond);

  wire s3_overflow_to_largest = s3_overflow && (TOWARD_ZERO != 0);
  wire s3_all_ones            = (!SPECIAL_FIRST && (s3_nan || s3_infinite)) || s3_overflow;
  wire s3_all_zeros           = (!SPECIAL_FIRST && s3_zero) || s3_vanished;
  // This condition is few gates deep, since it may become the reset of the result's register.
  wire s3_replaces            = !SPECIAL_FIRST && (!s3_finite || s3_too_large || s3_too_small);

  wire [RESULT_EXPONENT_BITS-1:0] s3_y_field =
      ((s3_field[RESULT_EXPONENT_BITS-1:0] & {RESULT_EXPONENT_BITS{!s3_all_zeros}})
       | {RESULT_EXPONENT_BITS{s3_all_ones}})
      & {{(RESULT_EXPONENT_BITS - 1) {1'b1}}, !s3_overflow_to_largest};
  // A choice between this bit and a constant becomes a reset of the register that follows. The
  // first fraction bit, which a NaN sets, has its own choice: synthesis finds a reset only if all
  // bits have the same constant.
  wire                     s3_y_quiet    =
      s3_replaces ? (s3_overflow_to_largest || s3_nan) : s3_fraction[FRACTION_BITS-1];
  wire [FRACTION_BITS-1:0] s3_y_fraction;

  generate
    if (FRACTION_BITS > 1) begin : g_fraction
      assign s3_y_fraction = {
        s3_y_quiet,
        s3_replaces ? {(FRACTION_BITS - 1) {s3_overflow_to_largest}}
                    : s3_fraction[FRACTION_BITS-2:0]
      };
    end else begin : g_one_bit
      assign s3_y_fraction = s3_y_quiet;
    end
  endgenerate

  fp_rank #(
    .WIDTH     (RESULT_EXPONENT_BITS + RESULT_PRECISION + 1),
    .REGISTERED(CUTS[3])
  ) rank_3 (
    .aclk(aclk),
    .d   ({s3_sign && !s3_nan, s3_y_field, s3_y_fraction,
           s3_suspect || s3_overflow || s3_vanished || s3_imprecise}),
    .q   ({y, exceptional})
  );

endmodule

`default_nettype wire
