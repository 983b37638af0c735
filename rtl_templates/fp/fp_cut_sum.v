// fp_cut_sum: the sum of TERMS products, each cut below a common place; no rounding.
// Latency: the population count of CUTS (24 bits); initiation interval 1; no reset.
// Term k is a_k * b_k, unless bit k of SQUARES, PLAIN, SUMS or DIFFERENCES is 1. At most one of
// these bits is 1. The sum or the difference inside a square is rounded to nearest, ties to even;
// it needs a PRECISION of 3 or more.
// Each term is cut toward zero, WINDOW - 2 bits below the largest exponent. A term's exponent is
// the sum of its factors' exponents. With GRADUAL the largest is at least that of the smallest
// normal number.
// With CANCELLATION terms with the sign of term 0 are added and the others subtracted: `sum` is in
// two's complement, and it is negative if its sign is opposite to that of term 0.
`default_nettype none

module fp_cut_sum #(
  parameter             EXPONENT_BITS  = 8,     // bits of an operand's exponent, 2 to 28
  parameter             PRECISION      = 24,    // digits with the leading one, 2 or more
  parameter             TERMS          = 3,     // number of terms, 2 to 63
  parameter [TERMS-1:0] SQUARES        = 0,     // bit k: term k is a_k * a_k
  parameter [TERMS-1:0] PLAIN          = 0,     // bit k: term k is a_k
  parameter [TERMS-1:0] SUMS           = 0,     // bit k: term k is (a_k + b_k)^2
  parameter [TERMS-1:0] DIFFERENCES    = 0,     // bit k: term k is (a_k - b_k)^2
  parameter [TERMS-1:0] NEGATED        = 0,     // bit k: term k is subtracted
  parameter             CANCELLATION   = 1,     // 0 promises like signs, except of zeros
  parameter             GRADUAL        = 0,     // 1: subnormals; 0: flushed to zero
  // 1: multipliers, as `*` of FACTOR_A by FACTOR_B bits; 0: logic, if PRECISION is 127 or less.
  parameter             EMBEDDED       = 1,
  parameter             SUM_SELECTS    = 2,     // bits that may select, 0 to 2; see fp_add
  parameter             FACTOR_A       = 24,    // first factor of `*`, 1 bit or more
  parameter             FACTOR_B       = 17,    // second factor of `*`, 1 bit or more
  // Bits of a cut term, two of them in front of its point; PRECISION or more.
  parameter             WINDOW         = 33,
  parameter             ADDEND         = 36,    // bits of `sum`, WINDOW or more
  parameter             EXPONENT_WIDTH = 10,    // bits of `largest`, enough for 4 BIAS + 2 + OFFSET
  // Added to the exponents; even, 2 * PRECISION + WINDOW or more.
  parameter             OFFSET         = 82,
  parameter [23:0]      CUTS           = 24'b0  // a register behind stage k if bit k is 1
) (
  input  wire                                       aclk,
  input  wire [TERMS*(EXPONENT_BITS+PRECISION)-1:0] a,  // term 0 in the lowest bits
  input  wire [TERMS*(EXPONENT_BITS+PRECISION)-1:0] b,
  output wire [ADDEND-1:0]                          sum,
  output wire [EXPONENT_WIDTH-1:0]                  largest,     // exponent + OFFSET + 2 BIAS
  output wire                                       nan,
  output wire                                       infinite,
  output wire                                       zero,        // all terms are zero
  output wire                                       suspect,     // an operand is exceptional
  output wire                                       zero_sign,   // the sign if the sum is zero
  // The sign of the sum if the sum is infinite or CANCELLATION is 0.
  output wire                                       known_sign,
  output wire                                       first_sign   // the sign of term 0
);

  function integer width_of(input integer value);
    integer rest;
    begin
      width_of = 0;
      for (rest = value; rest > 0; rest = rest >> 1) width_of = width_of + 1;
    end
  endfunction

  localparam PACKED  = EXPONENT_BITS + PRECISION;
  localparam PRODUCT = 2 * PRECISION;
  localparam LEVELS  = 6;   // levels of the trees: enough for 63 terms and one more exponent

  localparam integer BIAS     = (1 << (EXPONENT_BITS - 1)) - 1;
  localparam integer SMALLEST = OFFSET + BIAS + 1;  // the exponent of 1 * 2^(1 - BIAS)

  // With this cut, a subnormal number's square counts as zero: it is below 2^(2 - 2 BIAS), and no
  // cut is lower than 2^(3 - BIAS - WINDOW).
  localparam VANISHING = (GRADUAL != 0) && (BIAS > WINDOW - 2);

  // A product moves up from below the window, whose size WINDOW is at most MARGIN. It moves by the
  // number of its leading zeros, less the distance of its exponent from the largest. Steps of
  // 2^LOW_BITS places and more come first. Distances between exponents of squares are even.
  localparam MARGIN_BITS  = width_of(WINDOW - 1);
  localparam MARGIN       = 1 << MARGIN_BITS;
  localparam PLACES       = MARGIN + PRODUCT;
  localparam AMOUNT_BITS  = width_of(PLACES - 1);
  localparam LOW_BITS     = 3;
  localparam HIGH_KEPT    = WINDOW + (1 << LOW_BITS) - 1;
  localparam MOVED        = (HIGH_KEPT < PLACES) ? HIGH_KEPT : PLACES;
  localparam EVEN         = &(SQUARES | SUMS | DIFFERENCES);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 28))
      begin : g_refused_exponent EXPONENT_BITS_is_not_2_to_28 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if ((TERMS < 2) || (TERMS > 63)) begin : g_refused_terms TERMS_are_not_2_to_63 refused (); end
    if (((SQUARES & PLAIN) | (SUMS & DIFFERENCES)
         | ((SQUARES | PLAIN) & (SUMS | DIFFERENCES))) != 0)
      begin : g_refused_kinds SQUARES_PLAIN_SUMS_and_DIFFERENCES_overlap refused (); end
    if (WINDOW < PRECISION) begin : g_refused_window WINDOW_is_below_PRECISION refused (); end
    if (ADDEND < WINDOW) begin : g_refused_addend ADDEND_is_below_WINDOW refused (); end
    if ((OFFSET < PRODUCT + WINDOW) || ((OFFSET % 2) != 0))
      begin : g_refused_offset OFFSET_is_odd_or_too_small_for_PRECISION_and_WINDOW refused (); end
    if (EXPONENT_WIDTH < width_of(4 * BIAS + 2 + OFFSET)) begin : g_refused_exponent_width
      EXPONENT_WIDTH_is_too_small_for_OFFSET_and_EXPONENT_BITS refused ();
    end
    if (FACTOR_A < 1) begin : g_refused_factor_a FACTOR_A_is_below_1 refused (); end
    if (FACTOR_B < 1) begin : g_refused_factor_b FACTOR_B_is_below_1 refused (); end
  endgenerate

  // For each term: the stages of a sum that is squared, stages count and normalise, and the stages
  // of the product.
  wire [TERMS*EXPONENT_WIDTH-1:0] s9_exponents;
  wire [TERMS*EXPONENT_WIDTH-1:0] s9_places;
  wire [TERMS-1:0]                s9_signs;
  wire [TERMS-1:0]                s9_zeros;
  wire [TERMS-1:0]                s9_infinities;
  wire [TERMS-1:0]                s9_nans;
  wire [TERMS-1:0]                s9_flushed;
  wire [TERMS*PRODUCT-1:0]        s16_products;

  genvar k;
  generate
    for (k = 0; k < TERMS; k = k + 1) begin : g_terms
      if (SUMS[k] || DIFFERENCES[k]) begin : g_squared_sum
        fp_fused_squared_sum #(
          .EXPONENT_BITS (EXPONENT_BITS),
          .PRECISION     (PRECISION),
          .EXPONENT_WIDTH(EXPONENT_WIDTH),
          .OFFSET        (OFFSET),
          .SUBTRACT      (DIFFERENCES[k]),
          .GRADUAL       (GRADUAL),
          .EMBEDDED      (EMBEDDED),
          .SUM_SELECTS   (SUM_SELECTS),
          .FACTOR_A      (FACTOR_A),
          .FACTOR_B      (FACTOR_B),
          .CUTS          (CUTS[15:0])
        ) s0_term (
          .aclk    (aclk),
          .a       (a[k*PACKED+:PACKED]),
          .b       (b[k*PACKED+:PACKED]),
          .exponent(s9_exponents[k*EXPONENT_WIDTH+:EXPONENT_WIDTH]),
          .place   (s9_places[k*EXPONENT_WIDTH+:EXPONENT_WIDTH]),
          .zero    (s9_zeros[k]),
          .infinite(s9_infinities[k]),
          .nan     (s9_nans[k]),
          .product (s16_products[k*PRODUCT+:PRODUCT])
        );

        assign s9_signs[k]   = NEGATED[k];
        assign s9_flushed[k] = 1'b0;
      end else begin : g_product
        wire [PACKED-1:0] s7_a;
        wire [PACKED-1:0] s7_b;

        fp_ranks #(
          .WIDTH(2 * PACKED),
          .COUNT(7),
          .CUTS (CUTS[6:0])
        ) ranks_0 (
          .aclk(aclk),
          .d   ({a[k*PACKED+:PACKED], b[k*PACKED+:PACKED]}),
          .q   ({s7_a, s7_b})
        );

        fp_fused_term #(
          .EXPONENT_BITS (EXPONENT_BITS),
          .PRECISION     (PRECISION),
          .EXPONENT_WIDTH(EXPONENT_WIDTH),
          .OFFSET        (OFFSET),
          .SQUARE        (SQUARES[k]),
          .PLAIN         (PLAIN[k]),
          .NEGATED       (NEGATED[k]),
          .GRADUAL       (GRADUAL),
          .VANISHING     (VANISHING),
          .EMBEDDED      (EMBEDDED),
          .FACTOR_A      (FACTOR_A),
          .FACTOR_B      (FACTOR_B),
          .CUTS          (CUTS[15:7])
        ) s7_term (
          .aclk    (aclk),
          .a       (s7_a),
          .b       (s7_b),
          .exponent(s9_exponents[k*EXPONENT_WIDTH+:EXPONENT_WIDTH]),
          .sign    (s9_signs[k]),
          .zero    (s9_zeros[k]),
          .infinite(s9_infinities[k]),
          .nan     (s9_nans[k]),
          .flushed (s9_flushed[k]),
          .product (s16_products[k*PRODUCT+:PRODUCT])
        );

        assign s9_places[k*EXPONENT_WIDTH+:EXPONENT_WIDTH] =
            s9_exponents[k*EXPONENT_WIDTH+:EXPONENT_WIDTH];
      end
    end
  endgenerate

  // Beside the product: special values, the sign of a zero, and the sign of an infinity or of a sum
  // that cannot cancel.
  wire s9_infinite   = |s9_infinities;
  wire s9_unlike     = (|(s9_infinities & s9_signs)) && (|(s9_infinities & ~s9_signs));
  wire s9_nan        = (|s9_nans) || s9_unlike;
  wire s9_zero       = &s9_zeros;
  wire s9_suspect    = s9_nan || s9_infinite || (|s9_flushed);
  wire s9_zero_sign  = &s9_signs;
  wire s9_known_sign = s9_infinite ? (|(s9_infinities & s9_signs)) : (&(s9_signs | s9_zeros));

  wire [TERMS-1:0] s9_negatives = (s9_signs ^ {TERMS{s9_signs[0]}}) & {TERMS{CANCELLATION != 0}};

  wire [6:0]       s18_flags;
  wire [TERMS-1:0] s18_negatives;

  fp_ranks #(
    .WIDTH(TERMS + 7),
    .COUNT(9),
    .CUTS (CUTS[17:9])
  ) ranks_9 (
    .aclk(aclk),
    .d   ({s9_nan, s9_infinite, s9_zero, s9_suspect, s9_zero_sign, s9_known_sign, s9_signs[0],
           s9_negatives}),
    .q   ({s18_flags, s18_negatives})
  );

  // Beside the product: a tree with one level per cut finds the largest exponent. The distance of
  // each product's place from it is known in front of the last cut.
  localparam CANDIDATES = (GRADUAL != 0) ? TERMS + 1 : TERMS;

  wire [CANDIDATES*EXPONENT_WIDTH-1:0] s9_candidates;
  wire [EXPONENT_WIDTH-1:0]            s15_largest;
  wire                                 s15_unused_not_finite;
  wire [TERMS*EXPONENT_WIDTH-1:0]      s15_places;
  wire [EXPONENT_WIDTH-1:0]            s18_largest;

  generate
    if (GRADUAL != 0) begin : g_least_exponent
      assign s9_candidates = {SMALLEST[EXPONENT_WIDTH-1:0], s9_exponents};
    end else begin : g_no_least_exponent
      assign s9_candidates = s9_exponents;
    end
  endgenerate

  block_exponent #(
    .COUNT        (CANDIDATES),
    .LEVELS       (LEVELS),
    .EXPONENT_BITS(EXPONENT_WIDTH),
    .CUTS         (CUTS[14:9])
  ) s9_largest_exponent (
    .aclk      (aclk),
    .exponents (s9_candidates),
    .largest   (s15_largest),
    .not_finite(s15_unused_not_finite)
  );

  fp_ranks #(
    .WIDTH(TERMS * EXPONENT_WIDTH),
    .COUNT(LEVELS),
    .CUTS (CUTS[14:9])
  ) ranks_9_places (
    .aclk(aclk),
    .d   (s9_places),
    .q   (s15_places)
  );

  fp_ranks #(
    .WIDTH(EXPONENT_WIDTH),
    .COUNT(3),
    .CUTS (CUTS[17:15])
  ) ranks_15_largest (
    .aclk(aclk),
    .d   (s15_largest),
    .q   (s18_largest)
  );

  // Stages distances, align by steps of 2^LOW_BITS, align: bits below the window are cut off.
  wire [TERMS*ADDEND-1:0] s18_addends;

  generate
    for (k = 0; k < TERMS; k = k + 1) begin : g_align
      wire [EXPONENT_WIDTH-1:0] s15_place  = s15_places[k*EXPONENT_WIDTH+:EXPONENT_WIDTH];
      wire [EXPONENT_WIDTH:0]   s15_above  = {1'b0, s15_place} - {1'b0, s15_largest};
      wire [EXPONENT_WIDTH:0]   s15_moves  = s15_above + MARGIN[EXPONENT_WIDTH:0];
      wire [AMOUNT_BITS-1:0]    s15_amount =
          s15_moves[AMOUNT_BITS-1:0] & {AMOUNT_BITS{!s15_moves[EXPONENT_WIDTH]}};
      wire [AMOUNT_BITS-1:0]    s16_amount;

      fp_rank #(
        .WIDTH     (AMOUNT_BITS),
        .REGISTERED(CUTS[15])
      ) rank_15 (
        .aclk(aclk),
        .d   ({s15_amount[AMOUNT_BITS-1:1], s15_amount[0] && !EVEN}),
        .q   (s16_amount)
      );

      wire [PRODUCT-1:0] s16_product = s16_products[k*PRODUCT+:PRODUCT];
      wire [MOVED-1:0]   s16_moved;
      wire               s16_unused_rest;

      fp_shift_left #(
        .WIDTH      (PLACES),
        .KEPT       (MOVED),
        .AMOUNT_BITS(AMOUNT_BITS - LOW_BITS),
        .STEP       (1 << LOW_BITS)
      ) s16_align (
        .value  ({{MARGIN{1'b0}}, s16_product}),
        .amount (s16_amount[AMOUNT_BITS-1:LOW_BITS]),
        .shifted(s16_moved),
        .sticky (s16_unused_rest)
      );

      wire [MOVED-1:0]    s17_moved;
      wire [LOW_BITS-1:0] s17_amount;
      wire [WINDOW-1:0]   s17_aligned;
      wire                s17_unused_rest;

      fp_rank #(
        .WIDTH     (MOVED + LOW_BITS),
        .REGISTERED(CUTS[16])
      ) rank_16 (
        .aclk(aclk),
        .d   ({s16_moved, s16_amount[LOW_BITS-1:0]}),
        .q   ({s17_moved, s17_amount})
      );

      fp_shift_left #(
        .WIDTH      (MOVED),
        .KEPT       (WINDOW),
        .AMOUNT_BITS(LOW_BITS)
      ) s17_align (
        .value  (s17_moved),
        .amount (s17_amount),
        .shifted(s17_aligned),
        .sticky (s17_unused_rest)
      );

      wire [WINDOW-1:0] s18_aligned;

      fp_rank #(
        .WIDTH     (WINDOW),
        .REGISTERED(CUTS[17])
      ) rank_17 (
        .aclk(aclk),
        .d   (s17_aligned),
        .q   (s18_aligned)
      );

      assign s18_addends[k*ADDEND+:ADDEND] =
          {{(ADDEND - WINDOW) {1'b0}}, s18_aligned} ^ {ADDEND{s18_negatives[k]}};
    end
  endgenerate

  // Stages level 0 to 5: sums of two. -x is ~x + 1, and a complemented term lacks the 1. The 1 that
  // the first term of the second addend lacks enters as a carry out of an extra last place.
  genvar level;
  generate
    for (level = 0; level < LEVELS; level = level + 1) begin : g_level
      localparam FROM = (TERMS + (1 << level) - 1) >> level;
      localparam TO   = (FROM + 1) / 2;

      wire [FROM*ADDEND-1:0] addends;
      wire [TERMS-1:0]       owed;
      wire [TO*ADDEND-1:0]   sums;
      wire [TO*ADDEND-1:0]   totals;
      wire [TERMS-1:0]       still_owed;

      if (level == 0) begin : g_first
        assign addends = s18_addends;
        assign owed    = s18_negatives;
      end else begin : g_later
        assign addends = g_level[level-1].totals;
        assign owed    = g_level[level-1].still_owed;
      end

      for (k = 0; k < TO; k = k + 1) begin : g_pair
        if (2 * k + 1 < FROM) begin : g_two
          wire unused_place;

          assign {sums[k*ADDEND+:ADDEND], unused_place} =
              {addends[2*k*ADDEND+:ADDEND], 1'b1}
              + {addends[(2*k+1)*ADDEND+:ADDEND], owed[(2*k+1)<<level]};
        end else begin : g_one
          assign sums[k*ADDEND+:ADDEND] = addends[2*k*ADDEND+:ADDEND];
        end
      end

      fp_rank #(
        .WIDTH     (TO * ADDEND + TERMS),
        .REGISTERED(CUTS[18+level])
      ) rank (
        .aclk(aclk),
        .d   ({sums, owed}),
        .q   ({totals, still_owed})
      );
    end
  endgenerate

  wire unused_owed = ^g_level[LEVELS-1].still_owed;

  assign sum = g_level[LEVELS-1].totals;

  fp_ranks #(
    .WIDTH(EXPONENT_WIDTH + 7),
    .COUNT(LEVELS),
    .CUTS (CUTS[23:18])
  ) ranks_18 (
    .aclk(aclk),
    .d   ({s18_largest, s18_flags}),
    .q   ({largest, nan, infinite, zero, suspect, zero_sign, known_sign, first_sign})
  );

endmodule

`default_nettype wire
