// fixed_alignment: an operand as an integer in units of 2^(E+1-WIDTH), rounded down. E is the
// exponent whose biased code is `largest`. The magnitude is truncated and, if the sign bit is set,
// all bits are inverted. With STICKY = 1 one more bit stands above the integer: the truncated bits
// are not all 0. All are undefined if the operand's exponent is above E; `largest` is at least 1.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
`default_nettype none

module fixed_alignment #(
  parameter       EXPONENT_BITS = 8,     // bits of the exponent, 2 or more
  parameter       PRECISION     = 24,    // digits with the leading one, 1 or more
  parameter       WIDTH         = 13,    // bits of y without its sign, 1 or more
  parameter       SIGNED        = 0,     // 1: y has a sign, in two's complement; 0: y is unsigned
  parameter       SUBNORMALS    = 1,     // 0 promises that subnormal x is always less than a unit
  parameter       STICKY        = 0,     // 1: y has the sticky bit; SUBNORMALS is 1
  parameter [1:0] CUTS          = 2'b00  // a register behind stage k if bit k is 1
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] x,
  input  wire [EXPONENT_BITS-1:0]           largest,
  output wire [WIDTH+SIGNED+STICKY-1:0]     y
);

  function integer bits_for(input integer value);
    integer rest;
    begin
      bits_for = 0;
      for (rest = value; rest > 0; rest = rest >> 1) bits_for = bits_for + 1;
    end
  endfunction

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 1) begin : g_refused_precision PRECISION_is_below_1 refused (); end
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if ((SIGNED != 0) && (SIGNED != 1))
      begin : g_refused_signed SIGNED_is_not_0_or_1 refused (); end
    if ((STICKY != 0) && ((STICKY != 1) || (SUBNORMALS == 0)))
      begin : g_refused_sticky STICKY_is_not_0_or_1_with_SUBNORMALS refused (); end
  endgenerate

  localparam FRACTION = PRECISION - 1;
  localparam SIGN     = EXPONENT_BITS + FRACTION;
  // A distance of more bits than SHIFT leaves no bit of the significand.
  localparam PLACES   = (WIDTH < 3) ? 1 : bits_for(WIDTH - 1);
  localparam SHIFT    = (PLACES < EXPONENT_BITS) ? PLACES : EXPONENT_BITS;

  // Stage distance: the integer's leading bit less the place of the operand's leading digit.
  wire [EXPONENT_BITS-1:0] s0_exponent = x[SIGN-1:FRACTION];
  wire                     s0_normal   = (s0_exponent != 0) || (SUBNORMALS == 0);
  wire [EXPONENT_BITS-1:0] s0_distance =
      largest - s0_exponent - {{(EXPONENT_BITS - 1) {1'b0}}, !s0_normal};
  wire                     s0_far      = (s0_distance >> SHIFT) != 0;
  wire                     s0_negative = x[SIGN];
  wire [PRECISION-1:0]     s0_significand;
  wire [WIDTH-1:0]         s0_leading;
  wire                     s0_lost;

  generate
    if (FRACTION > 0) begin : g_fraction
      assign s0_significand = {s0_normal, x[FRACTION-1:0]};
    end else begin : g_no_fraction
      assign s0_significand = s0_normal;
    end
  endgenerate

  fp_fit #(
    .FROM(PRECISION),
    .TO  (WIDTH)
  ) s0_fit (
    .value (s0_significand),
    .fitted(s0_leading),
    .sticky(s0_lost)
  );

  wire [WIDTH-1:0] s1_leading;
  wire [SHIFT-1:0] s1_distance;
  wire             s1_far;
  wire             s1_negative;
  wire             s1_lost;

  fp_rank #(
    .WIDTH     (WIDTH + SHIFT + 2),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_leading, s0_distance[SHIFT-1:0], s0_far, s0_negative}),
    .q   ({s1_leading, s1_distance, s1_far, s1_negative})
  );

  fp_rank #(
    .WIDTH     (1),
    .REGISTERED(CUTS[0])
  ) rank_0_lost (
    .aclk(aclk),
    .d   (s0_lost),
    .q   (s1_lost)
  );

  // Stage shift.
  wire [WIDTH-1:0]        s1_magnitude = s1_far ? {WIDTH{1'b0}} : s1_leading >> s1_distance;
  wire [WIDTH+SIGNED-1:0] s1_integer;

  generate
    if (SIGNED != 0) begin : g_signed
      assign s1_integer = {s1_negative, s1_magnitude ^ {WIDTH{s1_negative}}};
    end else begin : g_unsigned
      wire unused_negative = s1_negative;

      assign s1_integer = s1_magnitude;
    end
  endgenerate

  fp_rank #(
    .WIDTH     (WIDTH + SIGNED),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   (s1_integer),
    .q   (y[WIDTH+SIGNED-1:0])
  );

  generate
    if (STICKY != 0) begin : g_sticky
      wire [WIDTH-1:0] s1_kept = s1_far ? {WIDTH{1'b0}} : {WIDTH{1'b1}} << s1_distance;

      fp_rank #(
        .WIDTH     (1),
        .REGISTERED(CUTS[1])
      ) rank_1_lost (
        .aclk(aclk),
        .d   (s1_lost || ((s1_leading & ~s1_kept) != 0)),
        .q   (y[WIDTH+SIGNED])
      );
    end else begin : g_no_sticky
      wire unused_lost = s1_lost;
    end
  endgenerate

endmodule

`default_nettype wire
