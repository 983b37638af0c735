// fp_minimum_maximum: the smaller of a and b, or the larger with MAXIMUM.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// Special values as IEEE 754-2019: a NaN gives NaN, -0 is less than +0.
// rtl_templates/fp/README.md states the promises in full.
`default_nettype none

module fp_minimum_maximum #(
  parameter       EXPONENT_BITS    = 8,     // bits of an operand's exponent, 2 or more
  parameter       PRECISION        = 24,    // digits with the leading one, 2 or more
  parameter       MAXIMUM          = 0,     // 1: the larger; 0: the smaller
  parameter       SPECIAL_OPERANDS = 1,     // 0 promises no NaN and no infinity
  parameter       OVERFLOW         = 1,     // not read; other units have it
  parameter       UNDERFLOW        = 1,     // 0 promises that no operand is subnormal
  parameter       GRADUAL          = 0,     // 1: subnormals; 0: flushed to zero
  parameter [1:0] CUTS             = 2'b00  // a register behind stage k if bit k is 1
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] a,
  input  wire [EXPONENT_BITS+PRECISION-1:0] b,
  output wire [EXPONENT_BITS+PRECISION-1:0] y,
  output wire                               exceptional
);

  localparam PACKED   = EXPONENT_BITS + PRECISION;
  localparam SIGN     = PACKED - 1;
  localparam EXPONENT = PRECISION - 1;
  localparam FLUSHING = (GRADUAL == 0) && (UNDERFLOW != 0);

  wire unused_overflow = OVERFLOW != 0;

  localparam [EXPONENT-1:0] NO_FRACTION = 0;
  localparam [PACKED-1:0]   QUIET_NAN   = {1'b0, {EXPONENT_BITS{1'b1}}, ~(~NO_FRACTION >> 1)};

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
  endgenerate

  // Stage compare: packed magnitudes have the order of integers. If both operands are negative, the
  // order is reversed.
  wire s0_a_fraction = |a[EXPONENT-1:0];
  wire s0_b_fraction = |b[EXPONENT-1:0];
  wire s0_a_special  = (SPECIAL_OPERANDS != 0) && (&a[SIGN-1:EXPONENT]);
  wire s0_b_special  = (SPECIAL_OPERANDS != 0) && (&b[SIGN-1:EXPONENT]);
  wire s0_a_flush    = FLUSHING && !(|a[SIGN-1:EXPONENT]);
  wire s0_b_flush    = FLUSHING && !(|b[SIGN-1:EXPONENT]);
  wire s0_nan        = (s0_a_special && s0_a_fraction) || (s0_b_special && s0_b_fraction);
  wire s0_suspect    = s0_a_special || s0_b_special
                       || (s0_a_flush && s0_a_fraction) || (s0_b_flush && s0_b_fraction);
  wire s0_below      = a[SIGN-1:0] < b[SIGN-1:0];
  wire s0_less       = (a[SIGN] == b[SIGN]) ? (s0_below ^ a[SIGN]) : a[SIGN];

  wire [PACKED-1:0] s1_a;
  wire [PACKED-1:0] s1_b;
  wire              s1_a_flush;
  wire              s1_b_flush;
  wire              s1_nan;
  wire              s1_suspect;
  wire              s1_take_a;

  fp_rank #(
    .WIDTH     (2 * PACKED + 5),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({a, b, s0_a_flush, s0_b_flush, s0_nan, s0_suspect, s0_less ^ (MAXIMUM != 0)}),
    .q   ({s1_a, s1_b, s1_a_flush, s1_b_flush, s1_nan, s1_suspect, s1_take_a})
  );

  // Stage select: if the operands are equal, either will do. A flushed operand becomes a zero of
  // its sign.
  wire [PACKED-1:0] s1_taken   = s1_take_a ? s1_a : s1_b;
  wire              s1_flush   = s1_take_a ? s1_a_flush : s1_b_flush;
  wire [PACKED-1:0] s1_flushed = s1_taken & {1'b1, {(PACKED - 1) {!s1_flush}}};

  fp_rank #(
    .WIDTH     (PACKED + 1),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ({s1_nan ? QUIET_NAN : s1_flushed, s1_suspect}),
    .q   ({y, exceptional})
  );

endmodule

`default_nettype wire
