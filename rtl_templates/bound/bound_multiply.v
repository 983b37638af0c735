// bound_multiply: a * b, rounded up.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// The result is infinite if an operand is infinite (even times zero) or the product leaves the
// format. It is at least the smallest bound unless an operand is zero.
`default_nettype none

module bound_multiply #(
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
  localparam PRODUCT  = 2 * BOUND_PRECISION;
  localparam WIDE     = EXPONENT_BITS + 2;  // exponents with a sign

  localparam [BOUND_PRECISION-1:0] NO_DIGITS   = 0;
  localparam [BOUND_PRECISION-1:0] LEADING_ONE = ~(~NO_DIGITS >> 1);
  localparam [BOUND-1:0]           FRACTION    = {BOUND{1'b1}} >> EXPONENT_BITS;
  localparam [BOUND-1:0]           SMALLEST    = FRACTION + 1'b1;
  localparam [BOUND_PRECISION-1:0] ONE         = 1;

  // The product as rows of additions. `*` would use an embedded multiplier for a few bits.
  function [PRODUCT-1:0] multiplied(input [BOUND_PRECISION-1:0] first,
                                    input [BOUND_PRECISION-1:0] second);
    reg [PRODUCT-1:0] row;
    integer           place;
    begin
      multiplied = 0;
      for (place = 0; place < BOUND_PRECISION; place = place + 1) begin
        row        = {{BOUND_PRECISION{1'b0}}, first & {BOUND_PRECISION{second[place]}}};
        multiplied = multiplied + (row << place);
      end
    end
  endfunction

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (BOUND_PRECISION < 1)
      begin : g_refused_bound_precision BOUND_PRECISION_is_below_1 refused (); end
  endgenerate

  // Stage multiply: the product of two significands in [1, 2) lies in [1, 4). The bias is 2^(E-1) -
  // 1. Inverting the first exponent's leading bit and reading it as a sign subtracts 2^(E-1). The 1
  // enters as the carry out of an extra last place.
  wire [EXPONENT_BITS-1:0] s0_a_exponent = a[BOUND-1:EXPONENT];
  wire [EXPONENT_BITS-1:0] s0_b_exponent = b[BOUND-1:EXPONENT];
  wire [PRODUCT-1:0]       s0_product    = multiplied(a[BOUND_PRECISION-1:0] | LEADING_ONE,
                                                      b[BOUND_PRECISION-1:0] | LEADING_ONE);
  wire                     s0_a_below    = !a[BOUND-1];
  wire                     s0_infinite   = (&s0_a_exponent) || (&s0_b_exponent);
  wire                     s0_zero       = !(|s0_a_exponent) || !(|s0_b_exponent);
  wire [WIDE-1:0]          s0_exponent;
  wire                     s0_unused_place;

  assign {s0_exponent, s0_unused_place} =
      {{3{s0_a_below}}, s0_a_exponent[EXPONENT_BITS-2:0], 1'b1} + {2'b00, s0_b_exponent, 1'b1};

  wire [PRODUCT-1:0] s1_product;
  wire [WIDE-1:0]    s1_exponent;
  wire               s1_infinite;
  wire               s1_zero;

  fp_rank #(
    .WIDTH     (PRODUCT + WIDE + 2),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_product, s0_exponent, s0_infinite, s0_zero}),
    .q   ({s1_product, s1_exponent, s1_infinite, s1_zero})
  );

  // Stage round: exponent and fraction are one number. If the product is 2 or more, the leading one
  // of s1_stepped increments the exponent. The 1 that rounding up adds enters as the carry out of
  // an extra last place. If it carries out of the fraction, the result is the next power of two.
  wire                       s1_high = s1_product[PRODUCT-1];
  wire [BOUND_PRECISION-1:0] s1_kept;
  wire [BOUND_PRECISION-1:0] s1_rest;
  wire [BOUND_PRECISION-1:0] s1_stepped = s1_kept & ~(LEADING_ONE & {BOUND_PRECISION{!s1_high}});
  wire [BOUND+1:0]           s1_rounded;
  wire                       s1_unused_place;

  assign {s1_kept, s1_rest} = s1_high ? s1_product : {s1_product[PRODUCT-2:0], 1'b0};

  assign {s1_rounded, s1_unused_place} =
      {s1_exponent, ONE} + {{(EXPONENT_BITS + 1) {1'b0}}, s1_stepped, |s1_rest};

  wire [WIDE-1:0]  s1_field     = s1_rounded[BOUND+1:EXPONENT];
  wire             s1_negative  = s1_field[WIDE-1];
  wire             s1_underflow = s1_negative || !(|s1_field);
  wire             s1_overflow  =
      !s1_negative && (s1_field[EXPONENT_BITS] || (&s1_field[EXPONENT_BITS-1:0]));
  wire [BOUND-1:0] s1_nonzero   = s1_underflow ? SMALLEST : s1_rounded[BOUND-1:0];
  wire [BOUND-1:0] s1_finite    = s1_nonzero & {BOUND{!s1_zero}};

  fp_rank #(
    .WIDTH     (BOUND),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ((s1_infinite || s1_overflow) ? ~FRACTION : s1_finite),
    .q   (y)
  );

endmodule

`default_nettype wire
