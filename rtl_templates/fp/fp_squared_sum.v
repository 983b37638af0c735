// fp_squared_sum: (a + b)^2, or (a - b)^2 with SUBTRACT. The sum is rounded, then its square: the
// same bits as those of an fp_add and an fp_square behind it, in fewer gates.
// Latency: the population count of CUTS (twenty bits); initiation interval 1; no reset.
// The rounded sum is squared as it leaves the adder, with leading zeros where its operands cancel,
// and without its sign. So only the square is normalised, and in the same step it moves down if it
// is subnormal.
// EMBEDDED, DIGIT_STAGE, FACTOR_A, FACTOR_B: as in fp_square. Special values as IEEE 754.
`default_nettype none

module fp_squared_sum #(
  parameter        EXPONENT_BITS = 8,
  parameter        PRECISION     = 24,
  parameter        SUBTRACT      = 0,
  parameter        GRADUAL       = 0,
  parameter        EMBEDDED      = 1,
  parameter        DIGIT_STAGE   = 0,
  parameter        FACTOR_A      = 24,
  parameter        FACTOR_B      = 17,
  parameter [19:0] CUTS          = 20'b0
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] a,
  input  wire [EXPONENT_BITS+PRECISION-1:0] b,
  output wire [EXPONENT_BITS+PRECISION-1:0] y
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

  // Cuts SQUARE to NORMALISE - 1 are the product's.
  localparam SQUARE    = 7;
  localparam NORMALISE = 15;

  // The square's leading one is in the first or the second place; two places and a sticky bit
  // beyond PRECISION decide how it is rounded.
  localparam PRODUCT = 2 * PRECISION;
  localparam KEPT    = PRECISION + 3;

  // Shifts are counted in steps of two places: a leading zero of the sum makes two of its square,
  // and a subnormal square is an even number of places from where its exponent is 1. MARGIN steps
  // in front of the product let it move down until nothing of it is kept.
  localparam MARGIN     = (GRADUAL != 0) ? (KEPT + 1) / 2 : 0;
  localparam PLACES     = 2 * MARGIN + PRODUCT;
  localparam COUNT_BITS = bits_for(PRECISION);
  localparam COUNTED    = 1 << COUNT_BITS;
  localparam STEP_BITS  = larger(bits_for(MARGIN + PRECISION - 1), 4);
  localparam EIGHTS     = (PLACES < KEPT + 14) ? PLACES : KEPT + 14;
  localparam TWOS       = (PLACES < KEPT + 2) ? PLACES : KEPT + 2;

  // The exponent of the sum is signed, since leading zeros count down from it.
  localparam         SUM_EXPONENT = larger(EXPONENT_BITS, bits_for(KEPT)) + 2;
  localparam integer HALF_BIAS    = 1 << (EXPONENT_BITS - 2);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 30)) begin : g_refused_exponent
      EXPONENT_BITS_is_not_2_to_30 refused ();
    end
    if (PRECISION < 3) begin : g_refused_precision
      PRECISION_is_below_3 refused ();
    end
    if (FACTOR_A < 1) begin : g_refused_factor_a
      FACTOR_A_is_below_1 refused ();
    end
    if (FACTOR_B < 1) begin : g_refused_factor_b
      FACTOR_B_is_below_1 refused ();
    end
  endgenerate

  // Stages of the sum.
  wire [SUM_EXPONENT-1:0] s7_exponent;
  wire                    s7_carry;
  wire [PRECISION-1:0]    s7_significand;
  wire                    s7_nan;
  wire                    s7_infinite;

  fp_unnormalised_sum #(
    .EXPONENT_BITS (EXPONENT_BITS),
    .PRECISION     (PRECISION),
    .EXPONENT_WIDTH(SUM_EXPONENT),
    .SUBTRACT      (SUBTRACT),
    .GRADUAL       (GRADUAL),
    .CUTS          (CUTS[SQUARE-1:0])
  ) s0_sum (
    .aclk       (aclk),
    .a          (a),
    .b          (b),
    .exponent   (s7_exponent),
    .carry      (s7_carry),
    .significand(s7_significand),
    .nan        (s7_nan),
    .infinite   (s7_infinite)
  );

  // Stages of the product.
  wire [PRODUCT-1:0] s15_product;

  fp_product #(
    .PRECISION  (PRECISION),
    .SQUARE     (1),
    .EMBEDDED   (EMBEDDED),
    .DIGIT_STAGE(DIGIT_STAGE),
    .FACTOR_A   (FACTOR_A),
    .FACTOR_B   (FACTOR_B),
    .LEADING_ONE(0),
    .CUTS       (CUTS[NORMALISE-1:SQUARE])
  ) s7_product (
    .aclk   (aclk),
    .a      (s7_significand),
    .b      (s7_significand),
    .product(s15_product)
  );

  // Beside the product's first two stages: leading zeros of what is squared, and the room to move
  // its square up in. The square's second place has exponent 2 e - BIAS, where e is the sum's: it is
  // 2 HALF_BIAS - 1 lower than twice that, and the square has e - HALF_BIAS steps to exponent 1.
  wire [COUNTED-1:0]      s7_counted = {s7_significand, {(COUNTED - PRECISION) {1'b0}}};
  wire [COUNT_BITS-1:0]   s8_count;
  wire                    s8_empty;
  wire [SUM_EXPONENT-1:0] s7_room    =
      s7_exponent - HALF_BIAS[SUM_EXPONENT-1:0] + {{(SUM_EXPONENT - 1) {1'b0}}, s7_carry};
  wire [SUM_EXPONENT-1:0] s8_room;
  wire [1:0]              s8_flags;

  fp_leading_zeros #(
    .COUNT_BITS(COUNT_BITS),
    .REGISTERED(CUTS[SQUARE])
  ) s7_leading_zeros (
    .aclk (aclk),
    .value(s7_counted),
    .count(s8_count),
    .empty(s8_empty)
  );

  fp_rank #(
    .WIDTH     (SUM_EXPONENT + 2),
    .REGISTERED(CUTS[SQUARE])
  ) rank_7 (
    .aclk(aclk),
    .d   ({s7_room, s7_nan, s7_infinite}),
    .q   ({s8_room, s8_flags})
  );

  wire [SUM_EXPONENT-1:0] s9_room;
  wire [COUNT_BITS-1:0]   s9_count;
  wire [2:0]              s9_flags;

  fp_rank #(
    .WIDTH     (SUM_EXPONENT + COUNT_BITS + 3),
    .REGISTERED(CUTS[SQUARE+1])
  ) rank_8 (
    .aclk(aclk),
    .d   ({s8_room, s8_count, s8_flags, s8_empty}),
    .q   ({s9_room, s9_count, s9_flags})
  );

  // Beside its third stage: a square with less room than it has zeros in front is subnormal. It
  // moves up by the room, which may be negative, and whatever its exponent is, its field is 0.
  wire [SUM_EXPONENT-1:0] s9_zeros       = {{(SUM_EXPONENT - COUNT_BITS) {1'b0}}, s9_count};
  wire [SUM_EXPONENT-1:0] s9_spare       = s9_room - s9_zeros;
  wire                    s9_tiny        = (GRADUAL != 0) && s9_spare[SUM_EXPONENT-1];
  wire [SUM_EXPONENT:0]   s9_exponent    = {s9_spare, 1'b1};
  wire [SUM_EXPONENT-1:0] s9_room_steps  = s9_room + MARGIN[SUM_EXPONENT-1:0];
  wire [STEP_BITS-1:0]    s9_tiny_steps  =
      s9_room_steps[STEP_BITS-1:0] & {STEP_BITS{!s9_room_steps[SUM_EXPONENT-1]}};
  wire [STEP_BITS-1:0]    s9_other_steps = s9_zeros[STEP_BITS-1:0] + MARGIN[STEP_BITS-1:0];
  wire [STEP_BITS-1:0]    s9_steps       = s9_tiny ? s9_tiny_steps : s9_other_steps;

  wire [SUM_EXPONENT:0] s15_exponent;
  wire [STEP_BITS-1:0]  s15_steps;
  wire [2:0]            s15_flags;

  fp_ranks #(
    .WIDTH(SUM_EXPONENT + 1 + STEP_BITS + 3),
    .COUNT(NORMALISE - SQUARE - 2),
    .CUTS (CUTS[NORMALISE-1:SQUARE+2])
  ) ranks_9 (
    .aclk(aclk),
    .d   ({s9_exponent, s9_steps, s9_flags}),
    .q   ({s15_exponent, s15_steps, s15_flags})
  );

  // Stage normalise by eights, of steps.
  wire [PLACES-1:0] s15_places;
  wire [EIGHTS-1:0] s15_moved;
  wire              s15_sticky;

  generate
    if (MARGIN > 0) begin : g_margin
      assign s15_places = {{(2 * MARGIN) {1'b0}}, s15_product};
    end else begin : g_no_margin
      assign s15_places = s15_product;
    end
  endgenerate

  fp_shift_left #(
    .WIDTH      (PLACES),
    .KEPT       (EIGHTS),
    .AMOUNT_BITS(STEP_BITS + 1)
  ) s15_normalise (
    .value  (s15_places),
    .amount ({s15_steps[STEP_BITS-1:3], 4'b0000}),
    .shifted(s15_moved),
    .sticky (s15_sticky)
  );

  wire [SUM_EXPONENT:0] s16_exponent;
  wire [2:0]            s16_steps;
  wire [EIGHTS-1:0]     s16_value;
  wire                  s16_sticky;
  wire [2:0]            s16_flags;

  fp_rank #(
    .WIDTH     (SUM_EXPONENT + 1 + 3 + EIGHTS + 4),
    .REGISTERED(CUTS[NORMALISE])
  ) rank_15 (
    .aclk(aclk),
    .d   ({s15_exponent, s15_steps[2:0], s15_moved, s15_sticky, s15_flags}),
    .q   ({s16_exponent, s16_steps, s16_value, s16_sticky, s16_flags})
  );

  // Stage normalise by twos.
  wire [TWOS-1:0] s16_moved;
  wire            s16_lost;

  fp_shift_left #(
    .WIDTH      (EIGHTS),
    .KEPT       (TWOS),
    .AMOUNT_BITS(4)
  ) s16_normalise (
    .value  (s16_value),
    .amount ({s16_steps[2:1], 2'b00}),
    .shifted(s16_moved),
    .sticky (s16_lost)
  );

  wire [SUM_EXPONENT:0] s17_exponent;
  wire                  s17_step;
  wire [TWOS-1:0]       s17_value;
  wire                  s17_sticky;
  wire                  s17_nan;
  wire                  s17_infinite;
  wire                  s17_zero;

  fp_rank #(
    .WIDTH     (SUM_EXPONENT + 1 + 1 + TWOS + 4),
    .REGISTERED(CUTS[NORMALISE+1])
  ) rank_16 (
    .aclk(aclk),
    .d   ({s16_exponent, s16_steps[0], s16_moved, s16_sticky || s16_lost, s16_flags}),
    .q   ({s17_exponent, s17_step, s17_value, s17_sticky, s17_nan, s17_infinite, s17_zero})
  );

  // Stage select: by the last step, and by where the leading one is.
  wire [KEPT-1:0] s17_moved;
  wire            s17_lost;

  fp_shift_left #(
    .WIDTH      (TWOS),
    .KEPT       (KEPT),
    .AMOUNT_BITS(2)
  ) s17_normalise (
    .value  (s17_value),
    .amount ({s17_step, 1'b0}),
    .shifted(s17_moved),
    .sticky (s17_lost)
  );

  wire                  s17_high        = s17_moved[KEPT-1];
  wire [KEPT-2:0]       s17_significand = s17_high ? s17_moved[KEPT-1:1] : s17_moved[KEPT-2:0];
  wire                  s17_beyond      = s17_sticky || s17_lost || (s17_high && s17_moved[0]);
  wire [SUM_EXPONENT:0] s17_selected    =
      s17_exponent + {{SUM_EXPONENT{1'b0}}, s17_high};
  wire                  unused_exceptional;

  // Stages round, pack.
  fp_round #(
    .EXPONENT_WIDTH      (SUM_EXPONENT + 1),
    .RESULT_EXPONENT_BITS(EXPONENT_BITS),
    .RESULT_PRECISION    (PRECISION),
    .GRADUAL             (GRADUAL),
    .DENORMALISE         (0),
    .CUTS                (CUTS[19:17])
  ) s17_round (
    .aclk       (aclk),
    .sign       (1'b0),
    .exponent   (s17_selected),
    .significand(s17_significand),
    .sticky     (s17_beyond),
    .nan        (s17_nan),
    .infinite   (s17_infinite),
    .zero       (s17_zero),
    .suspect    (1'b0),
    .y          (y),
    .exceptional(unused_exceptional)
  );

endmodule

`default_nettype wire
