// fp_fused_sum: a sum of TERMS products, aligned, added up and rounded once.
// Latency: the population count of CUTS (30 bits); initiation interval 1; no reset.
// Terms are those of fp_cut_sum.
// Each term is cut toward zero at PRECISION + GUARD bits below the largest exponent. The cut terms
// are added exactly, and their sum is rounded; docs/error_bounds.md bounds its error.
// Special values as IEEE 754: infinities of unlike signs and infinity * 0 give a NaN. A zero sum is
// negative if all terms are negative, zeros included.
`default_nettype none

module fp_fused_sum #(
  parameter             EXPONENT_BITS = 8,     // bits of an operand's exponent, 2 to 28
  parameter             PRECISION     = 24,    // digits with the leading one, 2 or more
  parameter             TERMS         = 3,     // number of terms, 2 to 63
  parameter [TERMS-1:0] SQUARES       = 0,     // bit k: term k is a_k * a_k
  parameter [TERMS-1:0] PLAIN         = 0,     // bit k: term k is a_k
  parameter [TERMS-1:0] SUMS          = 0,     // bit k: term k is (a_k + b_k)^2
  parameter [TERMS-1:0] DIFFERENCES   = 0,     // bit k: term k is (a_k - b_k)^2
  parameter [TERMS-1:0] NEGATED       = 0,     // bit k: term k is subtracted
  parameter             CANCELLATION  = 1,     // 0 promises like signs, except of zeros
  parameter             GRADUAL       = 0,     // 1: subnormals; 0: flushed to zero
  parameter             TOWARD_ZERO   = 0,     // 1: rounds toward zero; 0: nearest even
  // 1: multipliers, as `*` of FACTOR_A by FACTOR_B bits; 0: logic, if PRECISION is 127 or less.
  parameter             EMBEDDED      = 1,
  parameter             SUM_SELECTS   = 2,     // bits that may select, 0 to 2; see fp_add
  parameter             FACTOR_A      = 24,    // first factor of `*`, 1 bit or more
  parameter             FACTOR_B      = 17,    // second factor of `*`, 1 bit or more
  parameter [29:0]      CUTS          = 30'b0  // a register behind stage k if bit k is 1
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

  localparam GROWTH = bits_for(TERMS - 1);  // bits of a sum of TERMS above those of one term

  // A term has two bits in front of its point. C++'s golden model and schedule repeat GUARD.
  localparam GUARD  = GROWTH + 5;
  localparam WINDOW = PRECISION + GUARD + 2;
  localparam SUM    = WINDOW + GROWTH;
  localparam KEPT   = PRECISION + 2;

  // Without cancellation the leading one is in one of the first places. A subnormal sum needs no
  // search for it.
  localparam GROWING = (CANCELLATION == 0);
  localparam HEAD    = GROWTH + 1;
  localparam ADDEND  = GROWING ? SUM : SUM + 1;

  // A zero's exponent is 0, and any other term's is at least WINDOW higher, so a zero lies below
  // the window.
  localparam integer BIAS           = (1 << (EXPONENT_BITS - 1)) - 1;
  localparam integer OFFSET         = 2 * (PRECISION + (WINDOW + 1) / 2);
  localparam         EXPONENT_WIDTH = bits_for(4 * BIAS + 2 + OFFSET);
  localparam integer SMALLEST       = OFFSET + BIAS + 1;  // the exponent of 1 * 2^(1 - BIAS)
  localparam integer REBIAS         = OFFSET + BIAS - HEAD;

  localparam COUNT_BITS  = GROWING ? bits_for(HEAD) : bits_for(SUM);
  localparam ROUND_WIDTH = larger(EXPONENT_WIDTH, COUNT_BITS) + 2;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 28))
      begin : g_refused_exponent EXPONENT_BITS_is_not_2_to_28 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if ((TERMS < 2) || (TERMS > 63)) begin : g_refused_terms TERMS_are_not_2_to_63 refused (); end
  endgenerate

  // Stages of the terms and of their sum.
  wire [ADDEND-1:0]         s24_sum;
  wire [EXPONENT_WIDTH-1:0] s24_largest;
  wire [6:0]                s24_flags;

  fp_cut_sum #(
    .EXPONENT_BITS (EXPONENT_BITS),
    .PRECISION     (PRECISION),
    .TERMS         (TERMS),
    .SQUARES       (SQUARES),
    .PLAIN         (PLAIN),
    .SUMS          (SUMS),
    .DIFFERENCES   (DIFFERENCES),
    .NEGATED       (NEGATED),
    .CANCELLATION  (CANCELLATION),
    .GRADUAL       (GRADUAL),
    .EMBEDDED      (EMBEDDED),
    .SUM_SELECTS   (SUM_SELECTS),
    .FACTOR_A      (FACTOR_A),
    .FACTOR_B      (FACTOR_B),
    .WINDOW        (WINDOW),
    .ADDEND        (ADDEND),
    .EXPONENT_WIDTH(EXPONENT_WIDTH),
    .OFFSET        (OFFSET),
    .CUTS          (CUTS[23:0])
  ) s0_cut_sum (
    .aclk      (aclk),
    .a         (a),
    .b         (b),
    .sum       (s24_sum),
    .largest   (s24_largest),
    .nan       (s24_flags[6]),
    .infinite  (s24_flags[5]),
    .zero      (s24_flags[4]),
    .suspect   (s24_flags[3]),
    .zero_sign (s24_flags[2]),
    .known_sign(s24_flags[1]),
    .first_sign(s24_flags[0])
  );

  // Stage magnitude: a negative sum has the sign opposite to that of term 0.
  wire [SUM-1:0]            s24_magnitude;
  wire                      s24_turned;
  wire [SUM-1:0]            s25_sum;
  wire                      s25_turned;
  wire [EXPONENT_WIDTH-1:0] s25_largest;
  wire                      s25_nan;
  wire                      s25_infinite;
  wire                      s25_all_zero;
  wire                      s25_suspect;
  wire                      s25_zero_sign;
  wire                      s25_known_sign;
  wire                      s25_first_sign;

  generate
    if (GROWING) begin : g_magnitude
      assign s24_magnitude = s24_sum;
      assign s24_turned    = 1'b0;
    end else begin : g_absolute
      assign s24_turned    = s24_sum[SUM];
      assign s24_magnitude = (s24_sum[SUM-1:0] ^ {SUM{s24_turned}})
                             + {{(SUM - 1) {1'b0}}, s24_turned};
    end
  endgenerate

  fp_rank #(
    .WIDTH     (SUM + EXPONENT_WIDTH + 8),
    .REGISTERED(CUTS[24])
  ) rank_24 (
    .aclk(aclk),
    .d   ({s24_magnitude, s24_turned, s24_largest, s24_flags}),
    .q   ({s25_sum, s25_turned, s25_largest,
           s25_nan, s25_infinite, s25_all_zero, s25_suspect, s25_zero_sign, s25_known_sign,
           s25_first_sign})
  );

  // Stage count: leading zeros. Without cancellation at most HEAD of them matter.
  wire [COUNT_BITS-1:0] s25_count;
  wire                  s25_empty;

  generate
    if (GROWING) begin : g_few
      localparam COUNTED = 1 << COUNT_BITS;

      wire [COUNTED-1:0] s25_counted = {
        s25_sum[SUM-1:SUM-HEAD], {(COUNTED - HEAD) {1'b1}}
      };
      wire               s25_unused_empty;

      fp_leading_zeros #(
        .COUNT_BITS(COUNT_BITS)
      ) s25_leading_zeros (
        .aclk (aclk),
        .value(s25_counted),
        .count(s25_count),
        .empty(s25_unused_empty)
      );

      assign s25_empty = !(|s25_sum);
    end else begin : g_all
      localparam COUNTED = 1 << COUNT_BITS;

      wire [COUNTED-1:0] s25_counted = {s25_sum, {(COUNTED - SUM) {1'b0}}};

      fp_leading_zeros #(
        .COUNT_BITS(COUNT_BITS)
      ) s25_leading_zeros (
        .aclk (aclk),
        .value(s25_counted),
        .count(s25_count),
        .empty(s25_empty)
      );
    end
  endgenerate

  wire s25_zero     = s25_all_zero || s25_empty;
  wire s25_sum_sign = (GROWING || s25_infinite) ? s25_known_sign : (s25_turned ^ s25_first_sign);
  wire s25_sign     = (s25_zero && !s25_infinite) ? s25_zero_sign : s25_sum_sign;

  wire [SUM-1:0]            s26_sum;
  wire [COUNT_BITS-1:0]     s26_count;
  wire [EXPONENT_WIDTH-1:0] s26_largest;
  wire [4:0]                s26_flags;

  fp_rank #(
    .WIDTH     (SUM + COUNT_BITS + EXPONENT_WIDTH + 5),
    .REGISTERED(CUTS[25])
  ) rank_25 (
    .aclk(aclk),
    .d   ({s25_sum, s25_count, s25_largest, s25_sign, s25_nan, s25_infinite,
           GROWING ? s25_all_zero : s25_zero, s25_suspect}),
    .q   ({s26_sum, s26_count, s26_largest, s26_flags})
  );

  // Stage normalise: the largest exponent belongs to place HEAD.
  wire [ROUND_WIDTH-1:0] s26_wide_largest = {
    {(ROUND_WIDTH - EXPONENT_WIDTH) {1'b0}}, s26_largest
  };
  wire [COUNT_BITS-1:0]  s26_amount;
  wire [ROUND_WIDTH-1:0] s26_exponent =
      s26_wide_largest - REBIAS[ROUND_WIDTH-1:0]
      - {{(ROUND_WIDTH - COUNT_BITS) {1'b0}}, s26_amount};
  wire [KEPT-1:0]        s26_significand;
  wire                   s26_sticky;

  generate
    if ((GRADUAL != 0) && !GROWING) begin : g_gradual
      localparam integer ROOMLESS = SMALLEST - HEAD;

      wire [ROUND_WIDTH-1:0] s26_room = s26_wide_largest - ROOMLESS[ROUND_WIDTH-1:0];
      wire s26_little_room = s26_room < {{(ROUND_WIDTH - COUNT_BITS) {1'b0}}, s26_count};

      assign s26_amount = s26_little_room ? s26_room[COUNT_BITS-1:0] : s26_count;
    end else begin : g_free
      assign s26_amount = s26_count;
    end
  endgenerate

  fp_shift_left #(
    .WIDTH      (SUM),
    .KEPT       (KEPT),
    .AMOUNT_BITS(COUNT_BITS)
  ) s26_normalise (
    .value  (s26_sum),
    .amount (s26_amount),
    .shifted(s26_significand),
    .sticky (s26_sticky)
  );

  // Stages denormalise, round, pack.
  wire [ROUND_WIDTH-1:0] s27_exponent;
  wire [KEPT-1:0]        s27_significand;
  wire                   s27_sticky;
  wire                   s27_sign;
  wire                   s27_nan;
  wire                   s27_infinite;
  wire                   s27_zero;
  wire                   s27_suspect;

  fp_rank #(
    .WIDTH     (ROUND_WIDTH + KEPT + 6),
    .REGISTERED(CUTS[26])
  ) rank_26 (
    .aclk(aclk),
    .d   ({s26_exponent, s26_significand, s26_sticky, s26_flags}),
    .q   ({s27_exponent, s27_significand, s27_sticky,
           s27_sign, s27_nan, s27_infinite, s27_zero, s27_suspect})
  );

  fp_round #(
    .EXPONENT_WIDTH      (ROUND_WIDTH),
    .RESULT_EXPONENT_BITS(EXPONENT_BITS),
    .RESULT_PRECISION    (PRECISION),
    .GRADUAL             (GRADUAL),
    .DENORMALISE         (0),
    .TOWARD_ZERO         (TOWARD_ZERO),
    .CUTS                ({CUTS[29:28], 1'b0, CUTS[27]})
  ) s27_round (
    .aclk       (aclk),
    .sign       (s27_sign),
    .exponent   (s27_exponent),
    .value      (s27_significand),
    .amount     (2'b00),
    .sticky     (s27_sticky),
    .nan        (s27_nan),
    .infinite   (s27_infinite),
    .zero       (s27_zero),
    .suspect    (s27_suspect),
    .y          (y),
    .exceptional(exceptional)
  );

endmodule

`default_nettype wire
