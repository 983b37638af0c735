// fp_ulp_distance: decides the order of f and g iff their packed encodings are at least GUARD_ULP
// steps apart and nothing that led to them was exceptional: 0 less, 1 equal, 2 greater.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// A verdict is valid where `decided` is 1. `exceptional` must be 1 if f or g is a NaN.
`default_nettype none

module fp_ulp_distance #(
  parameter EXPONENT_BITS = 8,     // bits of the exponents of f and g, 2 or more
  parameter PRECISION     = 24,    // digits with the leading one, 2 or more
  // Least distance in ulp that decides the order; 0: equality is decided as well.
  parameter [EXPONENT_BITS+PRECISION-1:0] GUARD_ULP = 8,
  parameter NONNEGATIVE   = 0,     // 1 promises that f and g are never below zero
  parameter [1:0] CUTS    = 2'b00  // a register behind stage k if bit k is 1
) (
  input  wire                               aclk,
  input  wire [EXPONENT_BITS+PRECISION-1:0] f,
  input  wire [EXPONENT_BITS+PRECISION-1:0] g,
  input  wire                               exceptional,
  output wire [1:0]                         verdict,
  output wire                               decided
);

  localparam SIGN       = EXPONENT_BITS + PRECISION - 1;
  localparam DIFFERENCE = SIGN + 2;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
  endgenerate

  // Stage distance: like signs subtract magnitudes, unlike signs add them. -m is ~m + 1; the 1 is a
  // carry out of an extra last place.
  wire                  s0_like       = (NONNEGATIVE != 0) || (f[SIGN] == g[SIGN]);
  wire                  s0_f_negative = (NONNEGATIVE == 0) && f[SIGN];
  wire [DIFFERENCE-1:0] s0_addend     = {2'b00, g[SIGN-1:0]} ^ {DIFFERENCE{s0_like}};
  wire [DIFFERENCE-1:0] s0_difference;
  wire                  s0_unused_place;

  assign {s0_difference, s0_unused_place} = {2'b00, f[SIGN-1:0], 1'b1} + {s0_addend, s0_like};

  wire [DIFFERENCE-1:0] s1_difference;
  wire                  s1_f_negative;
  wire                  s1_exceptional;

  fp_rank #(
    .WIDTH     (DIFFERENCE + 2),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_difference, s0_f_negative, exceptional}),
    .q   ({s1_difference, s1_f_negative, s1_exceptional})
  );

  // Stage decide: the guard has few bits. If the difference is below 2^k for these k bits, all its
  // higher bits equal its sign.
  wire s1_less = s1_difference[DIFFERENCE-1] ^ s1_f_negative;
  wire s1_near;
  wire s1_equal;

  function integer bits_for(input [SIGN:0] value);
    reg [SIGN:0] rest;
    begin
      bits_for = 0;
      for (rest = value; rest != 0; rest = rest >> 1) bits_for = bits_for + 1;
    end
  endfunction

  generate
    if (GUARD_ULP == 0) begin : g_exact
      assign s1_near  = 1'b0;
      assign s1_equal = !(|s1_difference);
    end else begin : g_guarded
      localparam GUARD_BITS = bits_for(GUARD_ULP);
      localparam [SIGN:0] GUARD_LESS_ONE = GUARD_ULP - 1;

      wire [DIFFERENCE-1:GUARD_BITS] upper = s1_difference[DIFFERENCE-1:GUARD_BITS];
      wire [GUARD_BITS-1:0]          lower = s1_difference[GUARD_BITS-1:0];
      wire [GUARD_BITS:0]            lower_plus_guard =
          {1'b0, lower} + {1'b0, GUARD_LESS_ONE[GUARD_BITS-1:0]};
      wire near_above = !(|upper) && (lower <= GUARD_LESS_ONE[GUARD_BITS-1:0]);
      wire near_below = (&upper) && lower_plus_guard[GUARD_BITS];

      assign s1_near  = near_above || near_below;
      assign s1_equal = 1'b0;
    end
  endgenerate

  fp_rank #(
    .WIDTH     (3),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ({!s1_equal && !s1_less, s1_equal, !s1_near && !s1_exceptional}),
    .q   ({verdict, decided})
  );

endmodule

`default_nettype wire
