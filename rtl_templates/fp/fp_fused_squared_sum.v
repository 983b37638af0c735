// fp_fused_squared_sum: a term of a fused sum that is (a + b)^2, or (a - b)^2 with SUBTRACT. The
// sum is rounded to nearest, ties to even, before it is squared.
// Sixteen cuts, initiation interval 1, no reset. The exponents and the flags leave behind the first
// nine cuts, `product` behind all sixteen. The term's magnitude is product * 2^(place - OFFSET - 2
// BIAS): the product has two bits in front of its point, and BIAS is the format's. If the operands
// cancel, the sum is squared with its leading zeros. `exponent` is the exponent without them,
// `place` the one with them.
// A zero has exponent and place 0 and an arbitrary product. The exponents of other finite terms are
// above OFFSET - 2 * PRECISION.
`default_nettype none

module fp_fused_squared_sum #(
  parameter        EXPONENT_BITS  = 8,     // bits of an operand's exponent, 2 to 28
  parameter        PRECISION      = 24,    // digits with the leading one, 3 or more
  parameter        EXPONENT_WIDTH = 10,    // bits of the exponents, enough for 4 BIAS + 2 + OFFSET
  parameter        OFFSET         = 80,    // added to the exponents; even, 2 * PRECISION or more
  parameter        SUBTRACT       = 0,     // 1: a - b; 0: a + b
  parameter        GRADUAL        = 0,     // 1: subnormals; 0: flushed to zero
  // 1: multipliers, as `*` of FACTOR_A by FACTOR_B bits; 0: logic, if PRECISION is 127 or less.
  parameter        EMBEDDED       = 1,
  parameter        SUM_SELECTS    = 2,     // bits that may select, 0 to 2; see fp_add
  parameter        FACTOR_A       = 24,    // first factor of `*`, 1 bit or more
  parameter        FACTOR_B       = 17,    // second factor of `*`, 1 bit or more
  parameter [15:0] CUTS           = 16'b0  // a register behind stage k if bit k is 1
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] a,
  input  wire [EXPONENT_BITS+PRECISION-1:0] b,
  output wire [EXPONENT_WIDTH-1:0]          exponent,
  output wire [EXPONENT_WIDTH-1:0]          place,
  output wire                               zero,
  output wire                               infinite,
  output wire                               nan,
  output wire [2*PRECISION-1:0]             product
);

  // The name differs from that of the units' own function, since Verilator 5.006 warns if one hides
  // the other.
  function integer length_of(input integer value);
    integer rest;
    begin
      length_of = 0;
      for (rest = value; rest > 0; rest = rest >> 1) length_of = length_of + 1;
    end
  endfunction

  localparam COUNT_BITS = length_of(PRECISION);
  localparam COUNTED    = 1 << COUNT_BITS;

  // Exponents are doubled last, so half of OFFSET is added to the sum's exponent.
  localparam integer BIAS        = (1 << (EXPONENT_BITS - 1)) - 1;
  localparam integer HALF_OFFSET = OFFSET / 2;
  localparam integer SMALLEST    = HALF_OFFSET + 1;
  localparam integer TOO_LARGE   = HALF_OFFSET + 2 * BIAS + 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 28))
      begin : g_refused_exponent EXPONENT_BITS_is_not_2_to_28 refused (); end
    if (PRECISION < 3) begin : g_refused_precision PRECISION_is_below_3 refused (); end
    if ((OFFSET < 2 * PRECISION) || ((OFFSET % 2) != 0))
      begin : g_refused_offset OFFSET_is_odd_or_too_small_for_PRECISION refused (); end
    if (EXPONENT_WIDTH < length_of(4 * BIAS + 2 + OFFSET)) begin : g_refused_exponent_width
      EXPONENT_WIDTH_is_too_small_for_OFFSET_and_EXPONENT_BITS refused ();
    end
    if (FACTOR_A < 1) begin : g_refused_factor_a FACTOR_A_is_below_1 refused (); end
    if (FACTOR_B < 1) begin : g_refused_factor_b FACTOR_B_is_below_1 refused (); end
  endgenerate

  // Stages of the sum.
  wire [EXPONENT_WIDTH-1:0] s7_exponent;
  wire                      s7_carry;
  wire [PRECISION-1:0]      s7_significand;
  wire                      s7_nan;
  wire                      s7_infinite;

  fp_unnormalised_sum #(
    .EXPONENT_BITS (EXPONENT_BITS),
    .PRECISION     (PRECISION),
    .EXPONENT_WIDTH(EXPONENT_WIDTH),
    .SUBTRACT      (SUBTRACT),
    .GRADUAL       (GRADUAL),
    .SUM_SELECTS   (SUM_SELECTS),
    .CUTS          ({CUTS[6], 1'b0, CUTS[5:4], 1'b0, CUTS[3:0]})
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

  // Stage count.
  wire [EXPONENT_WIDTH-1:0] s7_lifted  =
      s7_exponent + HALF_OFFSET[EXPONENT_WIDTH-1:0] + {{(EXPONENT_WIDTH - 1) {1'b0}}, s7_carry};
  wire [COUNTED-1:0]        s7_counted = {s7_significand, {(COUNTED - PRECISION) {1'b0}}};
  wire [COUNT_BITS-1:0]     s7_count;
  wire                      s7_empty;

  fp_leading_zeros #(
    .COUNT_BITS(COUNT_BITS)
  ) s7_leading_zeros (
    .aclk (aclk),
    .value(s7_counted),
    .count(s7_count),
    .empty(s7_empty)
  );

  wire [EXPONENT_WIDTH-1:0] s8_lifted;
  wire [COUNT_BITS-1:0]     s8_count;
  wire                      s8_empty;
  wire                      s8_nan;
  wire                      s8_infinite;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + COUNT_BITS + 3),
    .REGISTERED(CUTS[7])
  ) rank_7 (
    .aclk(aclk),
    .d   ({s7_lifted, s7_count, s7_empty, s7_nan, s7_infinite}),
    .q   ({s8_lifted, s8_count, s8_empty, s8_nan, s8_infinite})
  );

  // Stage normalise: the exponent. Without gradual underflow, a sum below the smallest normal
  // number is 0.
  wire [EXPONENT_WIDTH-1:0] s8_normalised =
      s8_lifted - {{(EXPONENT_WIDTH - COUNT_BITS) {1'b0}}, s8_count};
  wire                      s8_too_large  = s8_lifted == TOO_LARGE[EXPONENT_WIDTH-1:0];
  wire                      s8_zero       =
      s8_empty || ((GRADUAL == 0) && (s8_normalised < SMALLEST[EXPONENT_WIDTH-1:0]));

  wire [EXPONENT_WIDTH-1:0] s9_lifted;
  wire [EXPONENT_WIDTH-1:0] s9_normalised;

  fp_rank #(
    .WIDTH     (2 * EXPONENT_WIDTH + 3),
    .REGISTERED(CUTS[8])
  ) rank_8 (
    .aclk(aclk),
    .d   ({s8_lifted, s8_normalised, s8_zero, s8_nan, s8_infinite || s8_too_large}),
    .q   ({s9_lifted, s9_normalised, zero, nan, infinite})
  );

  assign exponent = (s9_normalised << 1) & {EXPONENT_WIDTH{!zero}};
  assign place    = (s9_lifted << 1) & {EXPONENT_WIDTH{!zero}};

  // Stages of the product. Its cut for the factor is beside stage normalise.
  wire [PRECISION-1:0] s8_significand;

  fp_rank #(
    .WIDTH     (PRECISION),
    .REGISTERED(CUTS[7])
  ) rank_7_significand (
    .aclk(aclk),
    .d   (s7_significand),
    .q   (s8_significand)
  );

  fp_product #(
    .PRECISION  (PRECISION),
    .SQUARE     (1),
    .EMBEDDED   (EMBEDDED),
    .FACTOR_A   (FACTOR_A),
    .FACTOR_B   (FACTOR_B),
    .LEADING_ONE(0),
    .CUTS       (CUTS[15:8])
  ) s8_product (
    .aclk   (aclk),
    .a      (s8_significand),
    .b      (s8_significand),
    .product(product)
  );

endmodule

`default_nettype wire
