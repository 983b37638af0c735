// fixed_operand: an operand below 2^TOP in magnitude as an integer that counts units of
// 2^(TOP-WIDTH), rounded down: its magnitude truncated and, if its sign bit is set, all bits
// inverted. The integer has WIDTH bits, or WIDTH + 1 in two's complement if SIGNED.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// out_of_range: a magnitude from 2^TOP on, an infinity, a NaN; a set sign bit where not SIGNED. The
// integer then means nothing.
`default_nettype none

module fixed_operand #(
  parameter       EXPONENT_BITS = 8,
  parameter       PRECISION     = 24,
  parameter       TOP           = 0,
  parameter       WIDTH         = 13,
  parameter       SIGNED        = 0,
  parameter [1:0] CUTS          = 2'b00
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] x,
  output wire [WIDTH+SIGNED-1:0]            y,
  output wire                               out_of_range
);

  function integer bits_for(input integer value);
    integer rest;
    begin
      bits_for = 0;
      for (rest = value; rest > 0; rest = rest >> 1) bits_for = bits_for + 1;
    end
  endfunction

  localparam integer EXPONENT = TOP;  // negative where a command line gave it without a sign, too
  // The biased exponent of 2^TOP.
  localparam integer LIMIT    = (1 << (EXPONENT_BITS - 1)) - 1 + EXPONENT;
  localparam integer LARGEST  = LIMIT - 1;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 29)) begin : g_refused_exponent
      EXPONENT_BITS_is_not_2_to_29 refused ();
    end else if ((LIMIT < 2) || (LIMIT > (1 << EXPONENT_BITS) - 1)) begin : g_refused_top
      TOP_is_no_power_of_two_of_the_format refused ();
    end
    if (PRECISION < 2) begin : g_refused_precision
      PRECISION_is_below_2 refused ();
    end
    if (WIDTH < 1) begin : g_refused_width
      WIDTH_is_below_1 refused ();
    end
    if ((SIGNED != 0) && (SIGNED != 1)) begin : g_refused_signed
      SIGNED_is_not_0_or_1 refused ();
    end
  endgenerate

  localparam FRACTION = PRECISION - 1;
  localparam SIGN     = EXPONENT_BITS + FRACTION;
  // The bits of a distance that leaves something of the significand.
  localparam PLACES   = (WIDTH < 3) ? 1 : bits_for(WIDTH - 1);
  localparam SHIFT    = (PLACES < EXPONENT_BITS) ? PLACES : EXPONENT_BITS;
  // Subnormal numbers vanish, unless so few exponents lie between them and the top.
  localparam TINY     = LIMIT - 1 < WIDTH;

  // Stage distance: how far the leading one is below 2^(TOP-1).
  wire [EXPONENT_BITS-1:0] s0_exponent  = x[SIGN-1:FRACTION];
  wire                     s0_normal    = (s0_exponent != 0) || (TINY == 0);
  wire [EXPONENT_BITS-1:0] s0_distance  =
      LARGEST[EXPONENT_BITS-1:0] - s0_exponent - {{(EXPONENT_BITS - 1) {1'b0}}, !s0_normal};
  wire                     s0_far       = (s0_distance >> SHIFT) != 0;
  wire                     s0_too_large = s0_exponent >= LIMIT[EXPONENT_BITS-1:0];
  wire                     s0_negative  = x[SIGN];

  wire [WIDTH-1:0]         s0_leading;
  wire                     unused_lost;

  fp_fit #(
    .FROM(PRECISION),
    .TO  (WIDTH)
  ) s0_fit (
    .value ({s0_normal, x[FRACTION-1:0]}),
    .fitted(s0_leading),
    .sticky(unused_lost)
  );

  wire [WIDTH-1:0] s1_leading;
  wire [SHIFT-1:0] s1_distance;
  wire             s1_far;
  wire             s1_negative;
  wire             s1_out_of_range;

  fp_rank #(
    .WIDTH     (WIDTH + SHIFT + 3),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_leading, s0_distance[SHIFT-1:0], s0_far, s0_negative,
           s0_too_large || ((SIGNED == 0) && s0_negative)}),
    .q   ({s1_leading, s1_distance, s1_far, s1_negative, s1_out_of_range})
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
    .WIDTH     (WIDTH + SIGNED + 1),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ({s1_integer, s1_out_of_range}),
    .q   ({y, out_of_range})
  );

endmodule

`default_nettype wire
