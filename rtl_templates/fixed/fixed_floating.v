// fixed_floating: a as a floating-point number: where its leading one is, and the bits behind that.
// y is the exponent field and the fraction. If bit A_WIDTH-1 of a is one, the field is all ones, and
// one less for each zero in front. The fraction is a behind its leading one, from the left.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
`default_nettype none

module fixed_floating #(
  parameter       A_WIDTH       = 12,    // bits of a, 2 or more
  parameter       EXPONENT_BITS = 4,     // 2^EXPONENT_BITS >= A_WIDTH
  parameter [1:0] CUTS          = 2'b00  // a register behind stage k if bit k is 1
) (
  input  wire                             aclk,
  input  wire [A_WIDTH-1:0]               a,
  output wire [EXPONENT_BITS+A_WIDTH-2:0] y
);

  localparam FRACTION = A_WIDTH - 1;
  localparam WIDE     = 1 << EXPONENT_BITS;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (A_WIDTH < 2) begin : g_refused_a
      A_WIDTH_is_below_2 refused ();
    end else if (((A_WIDTH - 1) >> EXPONENT_BITS) != 0) begin : g_refused_exponent
      EXPONENT_BITS_do_not_hold_the_zeros refused ();
    end
  endgenerate

  // Stage count. Ones behind a end the count where a has none.
  wire [WIDE+A_WIDTH-1:0]  s0_padded = {a, {WIDE{1'b1}}};
  wire [EXPONENT_BITS-1:0] s0_zeros;
  wire                     s0_empty;
  wire                     unused_bits = ^{s0_padded, s0_empty};

  fp_leading_zeros #(
    .COUNT_BITS(EXPONENT_BITS),
    .REGISTERED(0)
  ) leading_zeros (
    .aclk (aclk),
    .value(s0_padded[WIDE+A_WIDTH-1:A_WIDTH]),
    .count(s0_zeros),
    .empty(s0_empty)
  );

  wire [EXPONENT_BITS-1:0] s1_zeros;
  wire [FRACTION-1:0]      s1_a;

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + FRACTION),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_zeros, a[FRACTION-1:0]}),
    .q   ({s1_zeros, s1_a})
  );

  // Stage shift. The leading one leaves.
  wire [FRACTION-1:0] s1_fraction = s1_a << s1_zeros;

  fp_rank #(
    .WIDTH     (EXPONENT_BITS + FRACTION),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ({~s1_zeros, s1_fraction}),
    .q   (y)
  );

endmodule

`default_nettype wire
