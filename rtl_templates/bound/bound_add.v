// bound_add: a + b, rounded up.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// The result is infinite if an operand is infinite or the sum leaves the format.
`default_nettype none

module bound_add #(
  parameter       EXPONENT_BITS   = 8,     // bits of the exponent, 2 or more
  parameter       BOUND_PRECISION = 4,     // digits of a bound, 1 or more
  parameter [1:0] CUTS            = 2'b00  // a register behind stage k if bit k is 1
) (
  input  wire                                     aclk,
  input  wire [EXPONENT_BITS+BOUND_PRECISION-2:0] a,
  input  wire [EXPONENT_BITS+BOUND_PRECISION-2:0] b,
  output wire [EXPONENT_BITS+BOUND_PRECISION-2:0] y
);

  localparam BOUND    = EXPONENT_BITS + BOUND_PRECISION - 1;
  localparam EXPONENT = BOUND_PRECISION - 1;

  localparam [BOUND_PRECISION-1:0] NO_DIGITS   = 0;
  localparam [BOUND_PRECISION-1:0] LEADING_ONE = ~(~NO_DIGITS >> 1);
  localparam [BOUND_PRECISION-1:0] ONE         = 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (BOUND_PRECISION < 1)
      begin : g_refused_bound_precision BOUND_PRECISION_is_below_1 refused (); end
  endgenerate

  // Stage align: for n > 0, n / 2^k rounded up is (n - 1) / 2^k rounded down, plus one. The
  // complement of a negative difference of the exponents is their distance less one.
  wire [EXPONENT_BITS-1:0] s0_a_exponent = a[BOUND-1:EXPONENT];
  wire [EXPONENT_BITS-1:0] s0_b_exponent = b[BOUND-1:EXPONENT];
  wire [EXPONENT_BITS-1:0] s0_difference;
  wire                     s0_b_larger;

  assign {s0_b_larger, s0_difference} = {1'b0, s0_a_exponent} - {1'b0, s0_b_exponent};

  wire [EXPONENT_BITS-1:0]   s0_exponent = s0_b_larger ? s0_b_exponent : s0_a_exponent;
  wire [BOUND_PRECISION-1:0] s0_a        = a[BOUND_PRECISION-1:0] | LEADING_ONE;
  wire [BOUND_PRECISION-1:0] s0_b        = b[BOUND_PRECISION-1:0] | LEADING_ONE;
  wire [BOUND_PRECISION-1:0] s0_larger   = s0_b_larger ? s0_b : s0_a;
  wire [BOUND_PRECISION-1:0] s0_smaller  = s0_b_larger ? s0_a : s0_b;
  wire [EXPONENT_BITS-1:0]   s0_distance = s0_difference ^ {EXPONENT_BITS{s0_b_larger}};
  wire [BOUND_PRECISION-1:0] s0_shifted  =
      ((s0_smaller - ONE) >> s0_distance) >> s0_b_larger;
  wire                       s0_adds     = (|s0_a_exponent) && (|s0_b_exponent);

  wire [EXPONENT_BITS-1:0]   s1_exponent;
  wire [BOUND_PRECISION-1:0] s1_larger;
  wire [BOUND_PRECISION-1:0] s1_shifted;
  wire                       s1_adds;

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + 2 * BOUND_PRECISION + 1),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_exponent, s0_larger, s0_shifted & {BOUND_PRECISION{s0_adds}}, s0_adds}),
    .q   ({s1_exponent, s1_larger, s1_shifted, s1_adds})
  );

  // Stage sum: a carry out of the fraction gives the next power of two, or infinity above the
  // largest one. The 1 that rounding up adds enters as the carry out of an extra last place.
  wire [BOUND_PRECISION-1:0] s1_sum;
  wire                       s1_carry;
  wire                       s1_unused_place;

  assign {s1_carry, s1_sum, s1_unused_place} =
      {1'b0, s1_larger, 1'b1} + {1'b0, s1_shifted, s1_adds};

  wire                     s1_top      = &s1_exponent[EXPONENT_BITS-1:1];
  wire                     s1_infinite = s1_top && (s1_exponent[0] || s1_carry);
  wire                     s1_step     = s1_carry && !(s1_top && s1_exponent[0]);
  wire [EXPONENT_BITS-1:0] s1_stepped  = s1_exponent + {{(EXPONENT_BITS - 1) {1'b0}}, s1_step};
  wire [BOUND-1:0]         s1_y;

  generate
    if (BOUND_PRECISION == 1) begin : g_exponent_alone
      wire unused = &{1'b0, s1_sum, s1_infinite};

      assign s1_y = s1_stepped;
    end else begin : g_digits
      wire [EXPONENT-1:0] s1_halved   = s1_sum[EXPONENT:1] + {{(EXPONENT-1){1'b0}}, s1_sum[0]};
      wire [EXPONENT-1:0] s1_fraction = s1_carry ? s1_halved : s1_sum[EXPONENT-1:0];

      assign s1_y = {s1_stepped, s1_fraction & {EXPONENT{!s1_infinite}}};
    end
  endgenerate

  fp_rank #(
    .WIDTH     (BOUND),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   (s1_y),
    .q   (y)
  );

endmodule

`default_nettype wire
