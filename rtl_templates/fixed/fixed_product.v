// fixed_product: a * b, or the square of a with SQUARE, less its DROPPED low bits.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// Operands are in two's complement.
//
// An embedded multiplier has factors of FACTOR_A and FACTOR_B bits, on most devices with signs, and
// registers for the cuts. If b is one or two bits wider than FACTOR_B, these bits are rows of
// gates, added by the adder behind the multiplier. Wider products are left to synthesis.
`default_nettype none

module fixed_product #(
  parameter       A_WIDTH    = 14,    // bits of a, 1 or more
  parameter       B_WIDTH    = 14,    // bits of b, 1 or more
  parameter       SQUARE     = 0,     // 1: y is the square of a, and b is not read
  parameter       POSITIVE_A = 0,     // 1 promises that a's sign bit is 0
  parameter       POSITIVE_B = 0,     // 1 promises that b's sign bit is 0
  parameter       DROPPED    = 0,     // low bits of the product that y lacks, 0 or more
  // bits of y, as its range needs; 1 to the product's less DROPPED
  parameter       WIDTH      = 28,
  parameter       FACTOR_A   = 24,    // multiplier's first factor without its sign, 1 bit or more
  parameter       FACTOR_B   = 17,    // multiplier's second factor without its sign, 1 bit or more
  parameter [1:0] CUTS       = 2'b00  // a register behind stage k if bit k is 1
) (
  input  wire               aclk,
  input  wire [A_WIDTH-1:0] a,
  input  wire [B_WIDTH-1:0] b,
  output wire [WIDTH-1:0]   y
);

  localparam SECOND  = (SQUARE != 0) ? A_WIDTH : B_WIDTH;
  localparam PRODUCT = A_WIDTH + SECOND;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (A_WIDTH < 1) begin : g_refused_a A_WIDTH_is_below_1 refused (); end
    if (B_WIDTH < 1) begin : g_refused_b B_WIDTH_is_below_1 refused (); end
    if (DROPPED < 0) begin : g_refused_dropped
      DROPPED_is_below_0 refused ();
    end else if ((WIDTH < 1) || (WIDTH + DROPPED > PRODUCT)) begin : g_refused_width
      WIDTH_is_not_1_to_that_of_the_product refused ();
    end
    if (FACTOR_A < 1) begin : g_refused_factor_a FACTOR_A_is_below_1 refused (); end
    if (FACTOR_B < 1) begin : g_refused_factor_b FACTOR_B_is_below_1 refused (); end
  endgenerate

  // Bits of the second factor that do not fit into the multiplier.
  localparam EXCESS = SECOND - 1 - FACTOR_B;
  localparam ROWS   = ((EXCESS == 1) || (EXCESS == 2)) && (A_WIDTH - 1 <= FACTOR_A);

  // Stage multiply.
  wire [SECOND-1:0] s0_second;

  generate
    if (SQUARE != 0) begin : g_square
      wire unused_b = ^b;

      assign s0_second = a;
    end else begin : g_product
      assign s0_second = b;
    end
  endgenerate

  generate
    if (ROWS) begin : g_rows
      localparam LOW  = A_WIDTH + FACTOR_B;
      localparam HIGH = A_WIDTH + EXCESS + 1;

      wire [HIGH-1:0] s0_a     = {{(EXCESS + 1) {a[A_WIDTH-1]}}, a};
      wire [HIGH-1:0] s0_row   = s0_a & {HIGH{s0_second[FACTOR_B]}};
      wire [HIGH-1:0] s0_above = s0_a & {HIGH{s0_second[FACTOR_B+1]}};
      wire [HIGH-1:0] s0_sign  = s0_a & {HIGH{s0_second[SECOND-1]}};
      wire [HIGH-1:0] s0_high  =
          (EXCESS == 1) ? s0_row - (s0_sign << 1) : s0_row + (s0_above << 1) - (s0_sign << 2);

      wire [LOW-1:0]  s1_low;
      wire [HIGH-1:0] s1_high;

      embedded_multiplier #(
        .A_WIDTH (A_WIDTH),
        .B_WIDTH (FACTOR_B),
        .SIGNED_A(1),
        .CUTS    ({1'b0, CUTS[0], 1'b0})
      ) multiplier (
        .aclk   (aclk),
        .a      (a),
        .b      (s0_second[FACTOR_B-1:0]),
        .product(s1_low)
      );
      fp_rank #(
        .WIDTH     (HIGH),
        .REGISTERED(CUTS[0])
      ) rank_0 (
        .aclk(aclk),
        .d   (s0_high),
        .q   (s1_high)
      );

      wire [PRODUCT-1:0] s1_product =
          {{(PRODUCT - LOW) {s1_low[LOW-1]}}, s1_low} + {s1_high, {FACTOR_B{1'b0}}};
      wire               unused_bits = ^s1_product;

      fp_rank #(
        .WIDTH     (WIDTH),
        .REGISTERED(CUTS[1])
      ) rank_1 (
        .aclk(aclk),
        .d   (s1_product[DROPPED+:WIDTH]),
        .q   (y)
      );
    end else begin : g_whole
      // The multiplier gets no sign bit that is always 0: it may have no room for it.
      localparam SIGNED_A = (POSITIVE_A == 0) || (A_WIDTH == 1);
      localparam SIGNED_B = (SQUARE != 0) ? SIGNED_A : (POSITIVE_B == 0) || (B_WIDTH == 1);
      localparam A        = SIGNED_A ? A_WIDTH : A_WIDTH - 1;
      localparam B        = SIGNED_B ? SECOND : SECOND - 1;

      wire [A+B-1:0] product;
      wire           negative    = (SIGNED_A || SIGNED_B) && product[A+B-1];
      wire [A+B+1:0] extended    = {negative, negative, product};
      wire           unused_bits = ^{a, s0_second, extended};

      embedded_multiplier #(
        .A_WIDTH (A),
        .B_WIDTH (B),
        .SIGNED_A(SIGNED_A),
        .SIGNED_B(SIGNED_B),
        .CUTS    ({CUTS, 1'b0})
      ) multiplier (
        .aclk   (aclk),
        .a      (a[A-1:0]),
        .b      (s0_second[B-1:0]),
        .product(product)
      );

      assign y = extended[DROPPED+:WIDTH];
    end
  endgenerate

endmodule

`default_nettype wire
