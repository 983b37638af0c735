// fp_squared_sum: (a + b)^2, or (a - b)^2 with SUBTRACT. The sum is rounded, then its square. The
// result is bit for bit that of an fp_add followed by an fp_square, in fewer gates.
// Latency: the population count of CUTS (23 bits); initiation interval 1; no reset.
// The rounded sum is squared as it leaves the adder: without its sign, and with leading zeros if
// its operands cancel. So only the square is normalised. The same step moves it down if it is
// subnormal.
// Special values as IEEE 754.
`default_nettype none

module fp_squared_sum #(
  parameter        EXPONENT_BITS = 8,     // bits of an operand's exponent, 2 to 30
  parameter        PRECISION     = 24,    // digits with the leading one, 3 or more
  parameter        SUBTRACT      = 0,     // 1: a - b; 0: a + b
  parameter        GRADUAL       = 0,     // 1: subnormals; 0: flushed to zero
  // 1: multipliers, as `*` of FACTOR_A by FACTOR_B bits; 0: logic, if PRECISION is 127 or less.
  parameter        EMBEDDED      = 1,
  // 1: in logic, a stage of its own finds the digits; only if PRECISION is 63 or less.
  parameter        DIGIT_STAGE   = 0,
  // 1: in logic, the highest quarter of the bits is late, as in fp_logic_product; needs CUTS[16].
  parameter        SPLIT         = 0,
  parameter        SUM_SELECTS   = 2,     // bits that may select, 0 to 2; see fp_add
  parameter        FACTOR_A      = 24,    // first factor of `*`, 1 bit or more
  parameter        FACTOR_B      = 17,    // second factor of `*`, 1 bit or more
  parameter [22:0] CUTS          = 23'b0  // a register behind stage k if bit k is 1
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

  // Cuts SQUARE to NORMALISE - 1 belong to the product.
  localparam SQUARE    = 9;
  localparam NORMALISE = 17;

  // The square's leading one is in the first or the second place. Two places and a sticky bit
  // beyond PRECISION decide its rounding.
  localparam PRODUCT = 2 * PRECISION;
  localparam KEPT    = PRECISION + 3;

  // Shifts are counted in steps of two places: each leading zero of the sum gives two of its
  // square, and a subnormal square moves by an even number of places until its exponent is 1.
  // MARGIN steps in front of the product let it move down until no bit of it is kept.
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

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 30))
      begin : g_refused_exponent EXPONENT_BITS_is_not_2_to_30 refused (); end
    if (PRECISION < 3) begin : g_refused_precision PRECISION_is_below_3 refused (); end
    if (FACTOR_A < 1) begin : g_refused_factor_a FACTOR_A_is_below_1 refused (); end
    if (FACTOR_B < 1) begin : g_refused_factor_b FACTOR_B_is_below_1 refused (); end
  endgenerate

  // Stages of the sum.
  wire [SUM_EXPONENT-1:0] s9_exponent;
  wire                    s9_carry;
  wire [PRECISION-1:0]    s9_significand;
  wire                    s9_nan;
  wire                    s9_infinite;

  fp_unnormalised_sum #(
    .EXPONENT_BITS (EXPONENT_BITS),
    .PRECISION     (PRECISION),
    .EXPONENT_WIDTH(SUM_EXPONENT),
    .SUBTRACT      (SUBTRACT),
    .GRADUAL       (GRADUAL),
    .SUM_SELECTS   (SUM_SELECTS),
    .CUTS          (CUTS[SQUARE-1:0])
  ) s0_sum (
    .aclk       (aclk),
    .a          (a),
    .b          (b),
    .exponent   (s9_exponent),
    .carry      (s9_carry),
    .significand(s9_significand),
    .nan        (s9_nan),
    .infinite   (s9_infinite)
  );

  // Stages of the product.
  wire [PRODUCT-1:0] s17_product;

  fp_product #(
    .PRECISION  (PRECISION),
    .SQUARE     (1),
    .EMBEDDED   (EMBEDDED),
    .DIGIT_STAGE(DIGIT_STAGE),
    .SPLIT      (SPLIT),
    .FACTOR_A   (FACTOR_A),
    .FACTOR_B   (FACTOR_B),
    .LEADING_ONE(0),
    .CUTS       (CUTS[NORMALISE-1:SQUARE])
  ) s9_product (
    .aclk   (aclk),
    .a      (s9_significand),
    .b      (s9_significand),
    .product(s17_product)
  );

  // Beside the product's first two stages: the leading zeros of the sum, and the room in which its
  // square may move up, in steps until its exponent is 1. The square's second place has exponent 2
  // e - BIAS, where e is the sum's exponent. That is 2 HALF_BIAS - 1 below 2 e, so the room is e -
  // HALF_BIAS steps.
  wire [COUNTED-1:0]      s9_counted = {s9_significand, {(COUNTED - PRECISION) {1'b0}}};
  wire [COUNT_BITS-1:0]   s10_count;
  wire                    s10_empty;
  wire [SUM_EXPONENT-1:0] s9_room    =
      s9_exponent - HALF_BIAS[SUM_EXPONENT-1:0] + {{(SUM_EXPONENT - 1) {1'b0}}, s9_carry};
  wire [SUM_EXPONENT-1:0] s10_room;
  wire [1:0]              s10_flags;

  fp_leading_zeros #(
    .COUNT_BITS(COUNT_BITS),
    .REGISTERED(CUTS[SQUARE])
  ) s9_leading_zeros (
    .aclk (aclk),
    .value(s9_counted),
    .count(s10_count),
    .empty(s10_empty)
  );

  fp_rank #(
    .WIDTH     (SUM_EXPONENT + 2),
    .REGISTERED(CUTS[SQUARE])
  ) rank_9 (
    .aclk(aclk),
    .d   ({s9_room, s9_nan, s9_infinite}),
    .q   ({s10_room, s10_flags})
  );

  wire [SUM_EXPONENT-1:0] s11_room;
  wire [COUNT_BITS-1:0]   s11_count;
  wire [2:0]              s11_flags;

  fp_rank #(
    .WIDTH     (SUM_EXPONENT + COUNT_BITS + 3),
    .REGISTERED(CUTS[SQUARE+1])
  ) rank_10 (
    .aclk(aclk),
    .d   ({s10_room, s10_count, s10_flags, s10_empty}),
    .q   ({s11_room, s11_count, s11_flags})
  );

  // Beside the product's third stage: a square with fewer steps of room than leading zeros is
  // subnormal. It moves up by the room, which may be negative. Its exponent field is 0 whatever its
  // exponent is.
  wire [SUM_EXPONENT-1:0] s11_zeros       = {{(SUM_EXPONENT - COUNT_BITS) {1'b0}}, s11_count};
  wire [SUM_EXPONENT-1:0] s11_spare       = s11_room - s11_zeros;
  wire                    s11_tiny        = (GRADUAL != 0) && s11_spare[SUM_EXPONENT-1];
  wire [SUM_EXPONENT:0]   s11_exponent    = {s11_spare, 1'b1};
  wire [SUM_EXPONENT-1:0] s11_room_steps  = s11_room + MARGIN[SUM_EXPONENT-1:0];
  wire [STEP_BITS-1:0]    s11_tiny_steps  =
      s11_room_steps[STEP_BITS-1:0] & {STEP_BITS{!s11_room_steps[SUM_EXPONENT-1]}};
  wire [STEP_BITS-1:0]    s11_other_steps = s11_zeros[STEP_BITS-1:0] + MARGIN[STEP_BITS-1:0];
  wire [STEP_BITS-1:0]    s11_steps       = s11_tiny ? s11_tiny_steps : s11_other_steps;

  wire [SUM_EXPONENT:0] s17_exponent;
  wire [STEP_BITS-1:0]  s17_steps;
  wire [2:0]            s17_flags;

  fp_ranks #(
    .WIDTH(SUM_EXPONENT + 1 + STEP_BITS + 3),
    .COUNT(NORMALISE - SQUARE - 2),
    .CUTS (CUTS[NORMALISE-1:SQUARE+2])
  ) ranks_11 (
    .aclk(aclk),
    .d   ({s11_exponent, s11_steps, s11_flags}),
    .q   ({s17_exponent, s17_steps, s17_flags})
  );

  // Stage normalise by eights: eight steps at a time.
  wire [PLACES-1:0] s17_places;
  wire [EIGHTS-1:0] s17_moved;
  wire              s17_sticky;

  generate
    if (MARGIN > 0) begin : g_margin
      assign s17_places = {{(2 * MARGIN) {1'b0}}, s17_product};
    end else begin : g_no_margin
      assign s17_places = s17_product;
    end
  endgenerate

  fp_shift_left #(
    .WIDTH      (PLACES),
    .KEPT       (EIGHTS),
    .AMOUNT_BITS(STEP_BITS - 3),
    .STEP       (16)
  ) s17_normalise (
    .value  (s17_places),
    .amount (s17_steps[STEP_BITS-1:3]),
    .shifted(s17_moved),
    .sticky (s17_sticky)
  );

  wire [SUM_EXPONENT:0] s18_exponent;
  wire [2:0]            s18_steps;
  wire [EIGHTS-1:0]     s18_value;
  wire                  s18_sticky;
  wire [2:0]            s18_flags;

  fp_rank #(
    .WIDTH     (SUM_EXPONENT + 1 + 3 + EIGHTS + 4),
    .REGISTERED(CUTS[NORMALISE])
  ) rank_17 (
    .aclk(aclk),
    .d   ({s17_exponent, s17_steps[2:0], s17_moved, s17_sticky, s17_flags}),
    .q   ({s18_exponent, s18_steps, s18_value, s18_sticky, s18_flags})
  );

  // Stage normalise by twos: two steps at a time.
  wire [TWOS-1:0] s18_moved;
  wire            s18_lost;

  fp_shift_left #(
    .WIDTH      (EIGHTS),
    .KEPT       (TWOS),
    .AMOUNT_BITS(2),
    .STEP       (4)
  ) s18_normalise (
    .value  (s18_value),
    .amount (s18_steps[2:1]),
    .shifted(s18_moved),
    .sticky (s18_lost)
  );

  wire [SUM_EXPONENT:0] s19_exponent;
  wire                  s19_step;
  wire [TWOS-1:0]       s19_value;
  wire                  s19_sticky;
  wire                  s19_nan;
  wire                  s19_infinite;
  wire                  s19_zero;

  fp_rank #(
    .WIDTH     (SUM_EXPONENT + 1 + 1 + TWOS + 4),
    .REGISTERED(CUTS[NORMALISE+1])
  ) rank_18 (
    .aclk(aclk),
    .d   ({s18_exponent, s18_steps[0], s18_moved, s18_sticky || s18_lost, s18_flags}),
    .q   ({s19_exponent, s19_step, s19_value, s19_sticky, s19_nan, s19_infinite, s19_zero})
  );

  // Stages select, round, pack. The square begins in the first or the second of KEPT places, behind
  // the two that the last step skips. fp_round moves it down: by two places unless that step is
  // taken, and by one if the first place has a one.
  wire [KEPT+1:0]       s19_places;
  wire                  s19_high     = s19_step ? s19_places[KEPT-1] : s19_places[KEPT+1];
  wire [SUM_EXPONENT:0] s19_selected = s19_exponent + {{SUM_EXPONENT{1'b0}}, s19_high};
  wire                  unused_exceptional;

  generate
    if (TWOS < KEPT + 2) begin : g_narrow
      assign s19_places = {s19_value, {(KEPT + 2 - TWOS) {1'b0}}};
    end else begin : g_as_wide
      assign s19_places = s19_value;
    end
  endgenerate

  fp_round #(
    .EXPONENT_WIDTH      (SUM_EXPONENT + 1),
    .RESULT_EXPONENT_BITS(EXPONENT_BITS),
    .RESULT_PRECISION    (PRECISION),
    .GRADUAL             (GRADUAL),
    .DENORMALISE         (0),
    .AMOUNT_BITS         (2),
    .SUM_SELECTS         (SUM_SELECTS),
    .CUTS                (CUTS[22:19])
  ) s19_round (
    .aclk       (aclk),
    .sign       (1'b0),
    .exponent   (s19_selected),
    .value      (s19_places),
    .amount     ({!s19_step, s19_high}),
    .sticky     (s19_sticky),
    .nan        (s19_nan),
    .infinite   (s19_infinite),
    .zero       (s19_zero),
    .suspect    (1'b0),
    .y          (y),
    .exceptional(unused_exceptional)
  );

endmodule

`default_nettype wire
