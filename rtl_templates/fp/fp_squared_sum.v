// fp_squared_sum: (a + b)^2, or (a - b)^2 with SUBTRACT. The sum is rounded, then its square: the
// same bits as those of an fp_add and an fp_square behind it, in fewer gates.
// Latency: the population count of CUTS (nineteen bits); initiation interval 1; no reset.
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
  parameter [18:0] CUTS          = 19'b0
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
  localparam NORMALISE = 14;

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
  wire [PRODUCT-1:0] s14_product;

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
    .product(s14_product)
  );

  // Beside the product's first stage: leading zeros of what is squared, and the room to move its
  // square up in. The square's second place has exponent 2 e - BIAS, where e is the sum's: it is
  // 2 HALF_BIAS - 1 lower than twice that, and the square has e - HALF_BIAS steps to exponent 1.
  wire [COUNTED-1:0]      s7_counted = {s7_significand, {(COUNTED - PRECISION) {1'b0}}};
  wire [COUNT_BITS-1:0]   s7_count;
  wire                    s7_empty;
  wire [SUM_EXPONENT-1:0] s7_room    =
      s7_exponent - HALF_BIAS[SUM_EXPONENT-1:0] + {{(SUM_EXPONENT - 1) {1'b0}}, s7_carry};

  fp_leading_zeros #(
    .COUNT_BITS(COUNT_BITS)
  ) s7_leading_zeros (
    .value(s7_counted),
    .count(s7_count),
    .empty(s7_empty)
  );

  wire [SUM_EXPONENT-1:0] s8_room;
  wire [COUNT_BITS-1:0]   s8_count;
  wire [2:0]              s8_flags;

  fp_rank #(
    .WIDTH     (SUM_EXPONENT + COUNT_BITS + 3),
    .REGISTERED(CUTS[SQUARE])
  ) rank_7 (
    .aclk(aclk),
    .d   ({s7_room, s7_count, s7_nan, s7_infinite, s7_empty}),
    .q   ({s8_room, s8_count, s8_flags})
  );

  // Beside its second stage: a square with less room than it has zeros in front is subnormal. It
  // moves up by the room, which may be negative, and whatever its exponent is, its field is 0.
  wire [SUM_EXPONENT-1:0] s8_zeros       = {{(SUM_EXPONENT - COUNT_BITS) {1'b0}}, s8_count};
  wire [SUM_EXPONENT-1:0] s8_spare       = s8_room - s8_zeros;
  wire                    s8_tiny        = (GRADUAL != 0) && s8_spare[SUM_EXPONENT-1];
  wire [SUM_EXPONENT:0]   s8_exponent    = {s8_spare, 1'b1};
  wire [SUM_EXPONENT-1:0] s8_room_steps  = s8_room + MARGIN[SUM_EXPONENT-1:0];
  wire [STEP_BITS-1:0]    s8_tiny_steps  =
      s8_room_steps[STEP_BITS-1:0] & {STEP_BITS{!s8_room_steps[SUM_EXPONENT-1]}};
  wire [STEP_BITS-1:0]    s8_other_steps = s8_zeros[STEP_BITS-1:0] + MARGIN[STEP_BITS-1:0];
  wire [STEP_BITS-1:0]    s8_steps       = s8_tiny ? s8_tiny_steps : s8_other_steps;

  wire [SUM_EXPONENT:0] s14_exponent;
  wire [STEP_BITS-1:0]  s14_steps;
  wire [2:0]            s14_flags;

  fp_ranks #(
    .WIDTH(SUM_EXPONENT + 1 + STEP_BITS + 3),
    .COUNT(NORMALISE - SQUARE - 1),
    .CUTS (CUTS[NORMALISE-1:SQUARE+1])
  ) ranks_8 (
    .aclk(aclk),
    .d   ({s8_exponent, s8_steps, s8_flags}),
    .q   ({s14_exponent, s14_steps, s14_flags})
  );

  // Stage normalise by eights, of steps.
  wire [PLACES-1:0] s14_places;
  wire [EIGHTS-1:0] s14_moved;
  wire              s14_sticky;

  generate
    if (MARGIN > 0) begin : g_margin
      assign s14_places = {{(2 * MARGIN) {1'b0}}, s14_product};
    end else begin : g_no_margin
      assign s14_places = s14_product;
    end
  endgenerate

  fp_shift_left #(
    .WIDTH      (PLACES),
    .KEPT       (EIGHTS),
    .AMOUNT_BITS(STEP_BITS + 1)
  ) s14_normalise (
    .value  (s14_places),
    .amount ({s14_steps[STEP_BITS-1:3], 4'b0000}),
    .shifted(s14_moved),
    .sticky (s14_sticky)
  );

  wire [SUM_EXPONENT:0] s15_exponent;
  wire [2:0]            s15_steps;
  wire [EIGHTS-1:0]     s15_value;
  wire                  s15_sticky;
  wire [2:0]            s15_flags;

  fp_rank #(
    .WIDTH     (SUM_EXPONENT + 1 + 3 + EIGHTS + 4),
    .REGISTERED(CUTS[NORMALISE])
  ) rank_14 (
    .aclk(aclk),
    .d   ({s14_exponent, s14_steps[2:0], s14_moved, s14_sticky, s14_flags}),
    .q   ({s15_exponent, s15_steps, s15_value, s15_sticky, s15_flags})
  );

  // Stage normalise by twos.
  wire [TWOS-1:0] s15_moved;
  wire            s15_lost;

  fp_shift_left #(
    .WIDTH      (EIGHTS),
    .KEPT       (TWOS),
    .AMOUNT_BITS(4)
  ) s15_normalise (
    .value  (s15_value),
    .amount ({s15_steps[2:1], 2'b00}),
    .shifted(s15_moved),
    .sticky (s15_lost)
  );

  wire [SUM_EXPONENT:0] s16_exponent;
  wire                  s16_step;
  wire [TWOS-1:0]       s16_value;
  wire                  s16_sticky;
  wire                  s16_nan;
  wire                  s16_infinite;
  wire                  s16_zero;

  fp_rank #(
    .WIDTH     (SUM_EXPONENT + 1 + 1 + TWOS + 4),
    .REGISTERED(CUTS[NORMALISE+1])
  ) rank_15 (
    .aclk(aclk),
    .d   ({s15_exponent, s15_steps[0], s15_moved, s15_sticky || s15_lost, s15_flags}),
    .q   ({s16_exponent, s16_step, s16_value, s16_sticky, s16_nan, s16_infinite, s16_zero})
  );

  // Stage select: by the last step, and by where the leading one is.
  wire [KEPT-1:0] s16_moved;
  wire            s16_lost;

  fp_shift_left #(
    .WIDTH      (TWOS),
    .KEPT       (KEPT),
    .AMOUNT_BITS(2)
  ) s16_normalise (
    .value  (s16_value),
    .amount ({s16_step, 1'b0}),
    .shifted(s16_moved),
    .sticky (s16_lost)
  );

  wire                  s16_high        = s16_moved[KEPT-1];
  wire [KEPT-2:0]       s16_significand = s16_high ? s16_moved[KEPT-1:1] : s16_moved[KEPT-2:0];
  wire                  s16_beyond      = s16_sticky || s16_lost || (s16_high && s16_moved[0]);
  wire [SUM_EXPONENT:0] s16_selected    =
      s16_exponent + {{SUM_EXPONENT{1'b0}}, s16_high};
  wire                  unused_exceptional;

  // Stages round, pack.
  fp_round #(
    .EXPONENT_WIDTH      (SUM_EXPONENT + 1),
    .RESULT_EXPONENT_BITS(EXPONENT_BITS),
    .RESULT_PRECISION    (PRECISION),
    .GRADUAL             (GRADUAL),
    .DENORMALISE         (0),
    .CUTS                (CUTS[18:16])
  ) s16_round (
    .aclk       (aclk),
    .sign       (1'b0),
    .exponent   (s16_selected),
    .significand(s16_significand),
    .sticky     (s16_beyond),
    .nan        (s16_nan),
    .infinite   (s16_infinite),
    .zero       (s16_zero),
    .suspect    (1'b0),
    .y          (y),
    .exceptional(unused_exceptional)
  );

endmodule

`default_nettype wire
