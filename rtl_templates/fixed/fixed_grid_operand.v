// fixed_grid_operand: an operand below 2^TOP in magnitude that is a multiple of 2^(TOP-WIDTH) as an
// integer in units of 2^(TOP-WIDTH), exactly.
// Latency: the population count of CUTS (three bits); initiation interval 1; no reset.
// out_of_range: the operand is 2^TOP or more in magnitude, no multiple of the unit, an infinity, a
// NaN, or has its sign bit set without SIGNED. The integer is then undefined.
`default_nettype none

module fixed_grid_operand #(
  parameter       EXPONENT_BITS = 8,      // bits of the exponent, 2 to 29
  parameter       PRECISION     = 24,     // digits with the leading one, 2 or more
  // exponent of the limit 2^TOP, 3 - 2^(EXPONENT_BITS-1) to 2^(EXPONENT_BITS-1)
  parameter       TOP           = 0,
  parameter       WIDTH         = 13,     // bits of y without its sign, 1 or more
  parameter       SIGNED        = 0,      // 1: y has a sign, in two's complement; 0: y is unsigned
  parameter [2:0] CUTS          = 3'b000  // a register behind stage k if bit k is 1
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] x,
  output wire [WIDTH+SIGNED-1:0]            y,
  output wire                               out_of_range
);

  localparam integer EXPONENT = TOP;  // signed: some tools pass a negative TOP as unsigned
  // The biased exponent of 2^TOP.
  localparam integer LIMIT    = (1 << (EXPONENT_BITS - 1)) - 1 + EXPONENT;
  localparam integer LARGEST  = LIMIT - 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 29)) begin : g_refused_exponent
      EXPONENT_BITS_is_not_2_to_29 refused ();
    end else if ((LIMIT < 2) || (LIMIT > (1 << EXPONENT_BITS) - 1)) begin : g_refused_top
      TOP_is_no_power_of_two_of_the_format refused ();
    end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
  endgenerate

  // Stages distance and shift: the integer with inverted bits if x is negative.
  localparam SIGN = EXPONENT_BITS + PRECISION - 1;

  wire [WIDTH+SIGNED-1:0] s2_inverted;
  wire                    s2_lost;

  fixed_alignment #(
    .EXPONENT_BITS(EXPONENT_BITS),
    .PRECISION    (PRECISION),
    .WIDTH        (WIDTH),
    .SIGNED       (SIGNED),
    .SUBNORMALS   (1),
    .STICKY       (1),
    .CUTS         (CUTS[1:0])
  ) alignment (
    .aclk   (aclk),
    .x      (x),
    .largest(LARGEST[EXPONENT_BITS-1:0]),
    .y      ({s2_lost, s2_inverted})
  );

  wire s0_too_large = x[SIGN-1:PRECISION-1] >= LIMIT[EXPONENT_BITS-1:0];
  wire s1_misfit;
  wire s2_misfit;

  fp_rank #(
    .WIDTH     (1),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   (s0_too_large || ((SIGNED == 0) && x[SIGN])),
    .q   (s1_misfit)
  );

  fp_rank #(
    .WIDTH     (1),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   (s1_misfit),
    .q   (s2_misfit)
  );

  // Stage negate: the inverted bits plus one.
  wire [WIDTH+SIGNED-1:0] s2_integer;

  generate
    if (SIGNED != 0) begin : g_signed
      assign s2_integer = s2_inverted + {{WIDTH{1'b0}}, s2_inverted[WIDTH]};
    end else begin : g_unsigned
      assign s2_integer = s2_inverted;
    end
  endgenerate

  fp_rank #(
    .WIDTH     (WIDTH + SIGNED + 1),
    .REGISTERED(CUTS[2])
  ) rank_2 (
    .aclk(aclk),
    .d   ({s2_integer, s2_misfit || s2_lost}),
    .q   ({y, out_of_range})
  );

endmodule

`default_nettype wire
