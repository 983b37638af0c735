// fp_operand: one packed operand with a normalised significand.
// Two cuts, initiation interval 1, no reset. `exponent` is biased and signed. Exponent and
// significand are arbitrary for zeros, infinities and NaNs.
`default_nettype none

module fp_operand #(
  parameter       EXPONENT_BITS    = 8,     // bits of the operand's exponent, 2 or more
  parameter       PRECISION        = 24,    // digits with the leading one, 2 or more
  // Bits of `exponent`: more than EXPONENT_BITS, and more than PRECISION has in binary.
  parameter       EXPONENT_WIDTH   = 10,
  parameter       SPECIAL_OPERANDS = 1,     // 0 promises no NaN and no infinity
  parameter       UNDERFLOW        = 1,     // 0 promises that no operand is subnormal
  parameter       GRADUAL          = 0,     // 1: subnormals, only with UNDERFLOW; 0: flushed
  parameter [1:0] CUTS             = 2'b00  // a register behind stage k if bit k is 1
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] a,
  output wire                               sign,
  output wire [EXPONENT_WIDTH-1:0]          exponent,
  output wire [PRECISION-1:0]               significand,
  output wire                               zero,
  output wire                               infinite,
  output wire                               nan,
  output wire                               flushed
);

  // The name differs from that of the units' own function, since Verilator 5.006 warns if one hides
  // the other.
  function integer width_of(input integer value);
    integer rest;
    begin
      width_of = 0;
      for (rest = value; rest > 0; rest = rest >> 1) width_of = width_of + 1;
    end
  endfunction

  localparam COUNT_BITS = width_of(PRECISION);
  localparam COUNTED    = 1 << COUNT_BITS;
  localparam FLAGS      = 5;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if (EXPONENT_WIDTH <= EXPONENT_BITS)
      begin : g_refused_exponent_width EXPONENT_WIDTH_is_too_small_for_EXPONENT_BITS refused (); end
    if (EXPONENT_WIDTH <= COUNT_BITS)
      begin : g_refused_precision_width EXPONENT_WIDTH_is_too_small_for_PRECISION refused (); end
    if ((GRADUAL != 0) && (UNDERFLOW == 0))
      begin : g_refused_gradual GRADUAL_without_UNDERFLOW refused (); end
  endgenerate

  // Stage count: leading zeros of the significand; a normal number has none.
  wire                     s0_sign;
  wire [EXPONENT_BITS-1:0] s0_exponent;
  wire [PRECISION-1:0]     s0_significand;
  wire                     s0_zero;
  wire                     s0_infinite;
  wire                     s0_nan;
  wire                     s0_flushed;

  fp_unpack #(
    .EXPONENT_BITS   (EXPONENT_BITS),
    .PRECISION       (PRECISION),
    .SPECIAL_OPERANDS(SPECIAL_OPERANDS),
    .UNDERFLOW       (UNDERFLOW),
    .GRADUAL         (GRADUAL)
  ) s0_unpack (
    .a          (a),
    .sign       (s0_sign),
    .exponent   (s0_exponent),
    .significand(s0_significand),
    .zero       (s0_zero),
    .infinite   (s0_infinite),
    .nan        (s0_nan),
    .flushed    (s0_flushed)
  );

  wire [EXPONENT_BITS-1:0] s1_exponent;
  wire [PRECISION-1:0]     s1_significand;
  wire [FLAGS-1:0]         s1_flags;

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + PRECISION + FLAGS),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_exponent, s0_significand, s0_sign, s0_zero, s0_infinite, s0_nan, s0_flushed}),
    .q   ({s1_exponent, s1_significand, s1_flags})
  );

  // Stage normalise: the leading one moves up, the exponent down by as much.
  wire [EXPONENT_WIDTH-1:0] s1_wide_exponent = {
    {(EXPONENT_WIDTH - EXPONENT_BITS) {1'b0}}, s1_exponent
  };
  wire [EXPONENT_WIDTH-1:0] s1_normal_exponent;
  wire [PRECISION-1:0]      s1_normal_significand;

  generate
    if (GRADUAL != 0) begin : g_gradual
      wire [COUNTED-1:0]    s0_counted = {s0_significand, {(COUNTED - PRECISION) {1'b0}}};
      wire [COUNT_BITS-1:0] s0_count;
      wire                  s0_unused_empty;
      wire [COUNT_BITS-1:0] s1_count;

      fp_leading_zeros #(
        .COUNT_BITS(COUNT_BITS)
      ) s0_leading_zeros (
        .aclk (aclk),
        .value(s0_counted),
        .count(s0_count),
        .empty(s0_unused_empty)
      );

      fp_rank #(
        .WIDTH     (COUNT_BITS),
        .REGISTERED(CUTS[0])
      ) rank_0_count (
        .aclk(aclk),
        .d   (s0_count),
        .q   (s1_count)
      );

      assign s1_normal_significand = s1_significand << s1_count;
      assign s1_normal_exponent    =
          s1_wide_exponent - {{(EXPONENT_WIDTH - COUNT_BITS) {1'b0}}, s1_count};
    end else begin : g_flush
      assign s1_normal_significand = s1_significand;
      assign s1_normal_exponent    = s1_wide_exponent;
    end
  endgenerate

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + PRECISION + FLAGS),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ({s1_normal_exponent, s1_normal_significand, s1_flags}),
    .q   ({exponent, significand, sign, zero, infinite, nan, flushed})
  );

endmodule

`default_nettype wire
