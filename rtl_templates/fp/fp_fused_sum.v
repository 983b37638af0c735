// fp_fused_sum: a sum of TERMS products, aligned, added up and rounded once.
// Latency: the population count of CUTS (22 bits); initiation interval 1; no reset.
// Term k is a_k * b_k; a_k * a_k where SQUARES[k] is 1, a_k where PLAIN[k] is 1. It is subtracted
// where NEGATED[k] is 1.
// Each term is cut toward zero at PRECISION + GUARD bits below the largest exponent, that of a term
// being the sum of its factors'. With GRADUAL it is the smallest normal number's if that is larger.
// What the cuts leave is added exactly and rounded; docs/error_bounds.md says how near that is.
// Special values as IEEE 754: a NaN comes from infinities of unlike signs and from infinity * 0; a
// zero is negative if all terms are, zeros among them.
// CANCELLATION = 0 promises that terms do not have unlike signs, zeros aside.
`default_nettype none

module fp_fused_sum #(
  parameter             EXPONENT_BITS = 8,
  parameter             PRECISION     = 24,
  parameter             TERMS         = 3,   // 2 to 63
  parameter [TERMS-1:0] SQUARES       = 0,
  parameter [TERMS-1:0] PLAIN         = 0,
  parameter [TERMS-1:0] NEGATED       = 0,
  parameter             CANCELLATION  = 1,
  parameter             GRADUAL       = 0,
  parameter             TOWARD_ZERO   = 0,
  parameter             EMBEDDED      = 1,
  parameter             FACTOR_A      = 24,
  parameter             FACTOR_B      = 17,
  parameter [21:0]      CUTS          = 22'b0
) (
  input  wire                                         aclk,
  input  wire [TERMS*(EXPONENT_BITS+PRECISION)-1:0]   a,  // term 0 in the lowest bits
  input  wire [TERMS*(EXPONENT_BITS+PRECISION)-1:0]   b,
  output wire [EXPONENT_BITS+PRECISION-1:0]           y,
  output wire                                         exceptional
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

  localparam PACKED  = EXPONENT_BITS + PRECISION;
  localparam PRODUCT = 2 * PRECISION;
  localparam LEVELS  = 6;                    // of the trees: for 63 terms and one exponent more
  localparam GROWTH  = bits_for(TERMS - 1);  // bits that a sum of so many has in front of a term's

  // A term has two bits in front of its point. C++'s golden model and schedule repeat GUARD.
  localparam GUARD  = GROWTH + 5;
  localparam WINDOW = PRECISION + GUARD + 2;
  localparam SUM    = WINDOW + GROWTH;
  localparam KEPT   = PRECISION + 2;

  // Without cancellation the leading one is in one of the first places, or, in a subnormal sum,
  // nothing has to be found.
  localparam GROWING = (CANCELLATION == 0);
  localparam HEAD    = GROWTH + 1;
  localparam ADDEND  = GROWING ? SUM : SUM + 1;

  // A zero's exponent is 0, and that of any other term WINDOW above it or more: far enough for a
  // zero to be shifted out.
  localparam integer BIAS           = (1 << (EXPONENT_BITS - 1)) - 1;
  localparam integer OFFSET         = PRODUCT + WINDOW;
  localparam         EXPONENT_WIDTH = bits_for(4 * BIAS + 2 + OFFSET);
  localparam integer SMALLEST       = OFFSET + BIAS + 1;  // the exponent of 1 * 2^(1 - BIAS)
  localparam integer REBIAS         = OFFSET + BIAS - HEAD;

  localparam AMOUNT_BITS = bits_for(WINDOW);
  localparam COUNT_BITS  = GROWING ? bits_for(HEAD) : bits_for(SUM);
  localparam ROUND_WIDTH = larger(EXPONENT_WIDTH, COUNT_BITS) + 2;

  // The cut by which a subnormal number's square is zero: it is below 2^(2 - 2 BIAS), and no cut is
  // lower than 2^(1 - BIAS - PRECISION - GUARD).
  localparam VANISHING = (GRADUAL != 0) && (BIAS > PRECISION + GUARD);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 28)) begin : g_refused_exponent
      EXPONENT_BITS_is_not_2_to_28 refused ();
    end
    if (PRECISION < 2) begin : g_refused_precision
      PRECISION_is_below_2 refused ();
    end
    if ((TERMS < 2) || (TERMS > 63)) begin : g_refused_terms
      TERMS_are_not_2_to_63 refused ();
    end
    if ((SQUARES & PLAIN) != 0) begin : g_refused_kinds
      SQUARES_and_PLAIN_overlap refused ();
    end
    if (FACTOR_A < 1) begin : g_refused_factor_a
      FACTOR_A_is_below_1 refused ();
    end
    if (FACTOR_B < 1) begin : g_refused_factor_b
      FACTOR_B_is_below_1 refused ();
    end
  endgenerate

  // Stages count, normalise, multiply and those of the product, for each term.
  wire [TERMS*EXPONENT_WIDTH-1:0] s2_exponents;
  wire [TERMS-1:0]                s2_signs;
  wire [TERMS-1:0]                s2_zeros;
  wire [TERMS-1:0]                s2_infinities;
  wire [TERMS-1:0]                s2_nans;
  wire [TERMS-1:0]                s2_flushed;
  wire [TERMS*PRODUCT-1:0]        s9_products;

  genvar k;
  generate
    for (k = 0; k < TERMS; k = k + 1) begin : g_terms
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
        .CUTS          (CUTS[8:0])
      ) s0_term (
        .aclk    (aclk),
        .a       (a[k*PACKED+:PACKED]),
        .b       (b[k*PACKED+:PACKED]),
        .exponent(s2_exponents[k*EXPONENT_WIDTH+:EXPONENT_WIDTH]),
        .sign    (s2_signs[k]),
        .zero    (s2_zeros[k]),
        .infinite(s2_infinities[k]),
        .nan     (s2_nans[k]),
        .flushed (s2_flushed[k]),
        .product (s9_products[k*PRODUCT+:PRODUCT])
      );
    end
  endgenerate

  // Beside the product: what is special; the sign of a zero; and that of an infinity or of a sum
  // without cancellation.
  wire s2_infinite = |s2_infinities;
  wire s2_unlike   = (|(s2_infinities & s2_signs)) && (|(s2_infinities & ~s2_signs));
  wire s2_nan      = (|s2_nans) || s2_unlike;
  wire s2_zero     = &s2_zeros;
  wire s2_suspect  = s2_nan || s2_infinite || (|s2_flushed);
  wire s2_zero_sign  = &s2_signs;
  wire s2_known_sign = s2_infinite ? (|(s2_infinities & s2_signs)) : (&(s2_signs | s2_zeros));

  // Term 0 is added, and of the others those that have its sign.
  wire [TERMS-1:0] s2_negatives = (s2_signs ^ {TERMS{s2_signs[0]}}) & {TERMS{!GROWING}};

  wire [6:0]       s9_flags;
  wire [TERMS-1:0] s9_negatives;

  fp_ranks #(
    .WIDTH(TERMS + 7),
    .COUNT(7),
    .CUTS (CUTS[8:2])
  ) ranks_2 (
    .aclk(aclk),
    .d   ({s2_nan, s2_infinite, s2_zero, s2_suspect, s2_zero_sign, s2_known_sign, s2_signs[0],
           s2_negatives}),
    .q   ({s9_flags, s9_negatives})
  );

  // Beside the product: the largest exponent, by a tree with one level a cut, and the distances
  // from it in front of the last cut.
  localparam CANDIDATES = (GRADUAL != 0) ? TERMS + 1 : TERMS;

  wire [CANDIDATES*EXPONENT_WIDTH-1:0] s2_candidates;
  wire [EXPONENT_WIDTH-1:0]            s8_largest;
  wire                                 s8_unused_not_finite;
  wire [TERMS*EXPONENT_WIDTH-1:0]      s8_exponents;
  wire [TERMS*EXPONENT_WIDTH-1:0]      s8_distances;
  wire [EXPONENT_WIDTH-1:0]            s9_largest;
  wire [TERMS*EXPONENT_WIDTH-1:0]      s9_distances;

  generate
    if (GRADUAL != 0) begin : g_least_exponent
      assign s2_candidates = {SMALLEST[EXPONENT_WIDTH-1:0], s2_exponents};
    end else begin : g_no_least_exponent
      assign s2_candidates = s2_exponents;
    end
  endgenerate

  block_exponent #(
    .COUNT        (CANDIDATES),
    .LEVELS       (LEVELS),
    .EXPONENT_BITS(EXPONENT_WIDTH),
    .CUTS         (CUTS[7:2])
  ) s2_largest_exponent (
    .aclk      (aclk),
    .exponents (s2_candidates),
    .largest   (s8_largest),
    .not_finite(s8_unused_not_finite)
  );

  fp_ranks #(
    .WIDTH(TERMS * EXPONENT_WIDTH),
    .COUNT(LEVELS),
    .CUTS (CUTS[7:2])
  ) ranks_2_exponents (
    .aclk(aclk),
    .d   (s2_exponents),
    .q   (s8_exponents)
  );

  fp_rank #(
    .WIDTH     ((TERMS + 1) * EXPONENT_WIDTH),
    .REGISTERED(CUTS[8])
  ) rank_8 (
    .aclk(aclk),
    .d   ({s8_largest, s8_distances}),
    .q   ({s9_largest, s9_distances})
  );

  // Stage align: what a shift moves out of the window is cut off.
  wire [TERMS*WINDOW-1:0]   s9_aligned;
  wire [TERMS*WINDOW-1:0]   s10_aligned;
  wire [EXPONENT_WIDTH-1:0] s10_largest;
  wire [6:0]                s10_flags;
  wire [TERMS-1:0]          s10_negatives;

  generate
    for (k = 0; k < TERMS; k = k + 1) begin : g_align
      wire [EXPONENT_WIDTH-1:0] s9_distance = s9_distances[k*EXPONENT_WIDTH+:EXPONENT_WIDTH];
      wire                      s9_far      = |s9_distance[EXPONENT_WIDTH-1:AMOUNT_BITS];
      wire [AMOUNT_BITS-1:0]    s9_amount   = s9_distance[AMOUNT_BITS-1:0] | {AMOUNT_BITS{s9_far}};
      wire [WINDOW-1:0]         s9_cut;
      wire                      s9_unused_rest;

      assign s8_distances[k*EXPONENT_WIDTH+:EXPONENT_WIDTH] =
          s8_largest - s8_exponents[k*EXPONENT_WIDTH+:EXPONENT_WIDTH];

      fp_fit #(
        .FROM(PRODUCT),
        .TO  (WINDOW)
      ) s9_fit (
        .value (s9_products[k*PRODUCT+:PRODUCT]),
        .fitted(s9_cut),
        .sticky(s9_unused_rest)
      );

      assign s9_aligned[k*WINDOW+:WINDOW] = s9_cut >> s9_amount;
    end
  endgenerate

  fp_rank #(
    .WIDTH     (TERMS * WINDOW + EXPONENT_WIDTH + 7 + TERMS),
    .REGISTERED(CUTS[9])
  ) rank_9 (
    .aclk(aclk),
    .d   ({s9_aligned, s9_largest, s9_flags, s9_negatives}),
    .q   ({s10_aligned, s10_largest, s10_flags, s10_negatives})
  );

  // Stages level 0 to 5: sums of two. Minus x is not x plus one; of each two, the one that the
  // first term of the second owes enters as a carry out of an extra last place.
  wire [TERMS*ADDEND-1:0] s10_addends;

  genvar level;
  generate
    for (k = 0; k < TERMS; k = k + 1) begin : g_addend
      assign s10_addends[k*ADDEND+:ADDEND] =
          {{(ADDEND - WINDOW) {1'b0}}, s10_aligned[k*WINDOW+:WINDOW]}
          ^ {ADDEND{s10_negatives[k]}};
    end

    for (level = 0; level < LEVELS; level = level + 1) begin : g_level
      localparam FROM = (TERMS + (1 << level) - 1) >> level;
      localparam TO   = (FROM + 1) / 2;

      wire [FROM*ADDEND-1:0] addends;
      wire [TERMS-1:0]       owed;
      wire [TO*ADDEND-1:0]   sums;
      wire [TO*ADDEND-1:0]   totals;
      wire [TERMS-1:0]       still_owed;

      if (level == 0) begin : g_first
        assign addends = s10_addends;
        assign owed    = s10_negatives;
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
        .REGISTERED(CUTS[10+level])
      ) rank (
        .aclk(aclk),
        .d   ({sums, owed}),
        .q   ({totals, still_owed})
      );
    end
  endgenerate

  wire [ADDEND-1:0]         s16_sum          = g_level[LEVELS-1].totals;
  wire                      s16_unused_owed  = ^g_level[LEVELS-1].still_owed;
  wire [EXPONENT_WIDTH-1:0] s16_largest;
  wire [6:0]                s16_flags;

  fp_ranks #(
    .WIDTH(EXPONENT_WIDTH + 7),
    .COUNT(LEVELS),
    .CUTS (CUTS[15:10])
  ) ranks_10 (
    .aclk(aclk),
    .d   ({s10_largest, s10_flags}),
    .q   ({s16_largest, s16_flags})
  );

  // Stage magnitude: a negative sum has the sign that term 0 does not have.
  wire [SUM-1:0]            s16_magnitude;
  wire                      s16_turned;
  wire [SUM-1:0]            s17_sum;
  wire                      s17_turned;
  wire [EXPONENT_WIDTH-1:0] s17_largest;
  wire                      s17_nan;
  wire                      s17_infinite;
  wire                      s17_all_zero;
  wire                      s17_suspect;
  wire                      s17_zero_sign;
  wire                      s17_known_sign;
  wire                      s17_first_sign;

  generate
    if (GROWING) begin : g_magnitude
      assign s16_magnitude = s16_sum;
      assign s16_turned    = 1'b0;
    end else begin : g_absolute
      assign s16_turned    = s16_sum[SUM];
      assign s16_magnitude = (s16_sum[SUM-1:0] ^ {SUM{s16_turned}})
                             + {{(SUM - 1) {1'b0}}, s16_turned};
    end
  endgenerate

  fp_rank #(
    .WIDTH     (SUM + EXPONENT_WIDTH + 8),
    .REGISTERED(CUTS[16])
  ) rank_16 (
    .aclk(aclk),
    .d   ({s16_magnitude, s16_turned, s16_largest, s16_flags}),
    .q   ({s17_sum, s17_turned, s17_largest,
           s17_nan, s17_infinite, s17_all_zero, s17_suspect, s17_zero_sign, s17_known_sign,
           s17_first_sign})
  );

  // Stage count: leading zeros. Without cancellation there are at most HEAD that matter.
  wire [COUNT_BITS-1:0] s17_count;
  wire                  s17_empty;

  generate
    if (GROWING) begin : g_few
      localparam COUNTED = 1 << COUNT_BITS;

      wire [COUNTED-1:0] s17_counted = {
        s17_sum[SUM-1:SUM-HEAD], {(COUNTED - HEAD) {1'b1}}
      };
      wire               s17_unused_empty;

      fp_leading_zeros #(
        .COUNT_BITS(COUNT_BITS)
      ) s17_leading_zeros (
        .value(s17_counted),
        .count(s17_count),
        .empty(s17_unused_empty)
      );

      assign s17_empty = !(|s17_sum);
    end else begin : g_all
      localparam COUNTED = 1 << COUNT_BITS;

      wire [COUNTED-1:0] s17_counted = {s17_sum, {(COUNTED - SUM) {1'b0}}};

      fp_leading_zeros #(
        .COUNT_BITS(COUNT_BITS)
      ) s17_leading_zeros (
        .value(s17_counted),
        .count(s17_count),
        .empty(s17_empty)
      );
    end
  endgenerate

  wire s17_zero     = s17_all_zero || s17_empty;
  wire s17_sum_sign = (GROWING || s17_infinite) ? s17_known_sign : (s17_turned ^ s17_first_sign);
  wire s17_sign     = (s17_zero && !s17_infinite) ? s17_zero_sign : s17_sum_sign;

  wire [SUM-1:0]            s18_sum;
  wire [COUNT_BITS-1:0]     s18_count;
  wire [EXPONENT_WIDTH-1:0] s18_largest;
  wire [4:0]                s18_flags;

  fp_rank #(
    .WIDTH     (SUM + COUNT_BITS + EXPONENT_WIDTH + 5),
    .REGISTERED(CUTS[17])
  ) rank_17 (
    .aclk(aclk),
    .d   ({s17_sum, s17_count, s17_largest, s17_sign, s17_nan, s17_infinite,
           GROWING ? s17_all_zero : s17_zero, s17_suspect}),
    .q   ({s18_sum, s18_count, s18_largest, s18_flags})
  );

  // Stage normalise: the largest exponent is that of the place HEAD.
  wire [ROUND_WIDTH-1:0] s18_wide_largest = {
    {(ROUND_WIDTH - EXPONENT_WIDTH) {1'b0}}, s18_largest
  };
  wire [COUNT_BITS-1:0]  s18_amount;
  wire [ROUND_WIDTH-1:0] s18_exponent =
      s18_wide_largest - REBIAS[ROUND_WIDTH-1:0]
      - {{(ROUND_WIDTH - COUNT_BITS) {1'b0}}, s18_amount};
  wire [KEPT-1:0]        s18_significand;
  wire                   s18_sticky;

  generate
    if ((GRADUAL != 0) && !GROWING) begin : g_gradual
      localparam integer ROOMLESS = SMALLEST - HEAD;

      wire [ROUND_WIDTH-1:0] s18_room = s18_wide_largest - ROOMLESS[ROUND_WIDTH-1:0];
      wire s18_little_room = s18_room < {{(ROUND_WIDTH - COUNT_BITS) {1'b0}}, s18_count};

      assign s18_amount = s18_little_room ? s18_room[COUNT_BITS-1:0] : s18_count;
    end else begin : g_free
      assign s18_amount = s18_count;
    end
  endgenerate

  fp_shift_left #(
    .WIDTH      (SUM),
    .KEPT       (KEPT),
    .AMOUNT_BITS(COUNT_BITS)
  ) s18_normalise (
    .value  (s18_sum),
    .amount (s18_amount),
    .shifted(s18_significand),
    .sticky (s18_sticky)
  );

  // Stages denormalise, round, pack.
  wire [ROUND_WIDTH-1:0] s19_exponent;
  wire [KEPT-1:0]        s19_significand;
  wire                   s19_sticky;
  wire                   s19_sign;
  wire                   s19_nan;
  wire                   s19_infinite;
  wire                   s19_zero;
  wire                   s19_suspect;

  fp_rank #(
    .WIDTH     (ROUND_WIDTH + KEPT + 6),
    .REGISTERED(CUTS[18])
  ) rank_18 (
    .aclk(aclk),
    .d   ({s18_exponent, s18_significand, s18_sticky, s18_flags}),
    .q   ({s19_exponent, s19_significand, s19_sticky,
           s19_sign, s19_nan, s19_infinite, s19_zero, s19_suspect})
  );

  fp_round #(
    .EXPONENT_WIDTH      (ROUND_WIDTH),
    .RESULT_EXPONENT_BITS(EXPONENT_BITS),
    .RESULT_PRECISION    (PRECISION),
    .GRADUAL             (GRADUAL),
    .DENORMALISE         (0),
    .TOWARD_ZERO         (TOWARD_ZERO),
    .CUTS                (CUTS[21:19])
  ) s19_round (
    .aclk       (aclk),
    .sign       (s19_sign),
    .exponent   (s19_exponent),
    .significand(s19_significand),
    .sticky     (s19_sticky),
    .nan        (s19_nan),
    .infinite   (s19_infinite),
    .zero       (s19_zero),
    .suspect    (s19_suspect),
    .y          (y),
    .exceptional(exceptional)
  );

endmodule

`default_nettype wire
