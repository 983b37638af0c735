// fixed_logic_product: fixed_product without `*`: a * b, or the square of a with SQUARE, less its
// DROPPED low bits.
// Latency: the population count of CUTS (seven bits); initiation interval 1; no reset.
// Operands are in two's complement.
`default_nettype none

module fixed_logic_product #(
  parameter       A_WIDTH = 14,  // bits of a, 1 to 127
  parameter       B_WIDTH = 14,  // bits of b, 1 to 127
  parameter       SQUARE  = 0,   // 1: y is the square of a, and b is not read
  parameter       DROPPED = 0,   // low bits of the product that y lacks, 0 or more
  parameter       WIDTH   = 28,  // bits of y, as its range needs; 1 to the product's less DROPPED
  // a register behind stage k if bit k is 1; see fp_logic_product
  parameter [6:0] CUTS    = 7'b0
) (
  input  wire               aclk,
  input  wire [A_WIDTH-1:0] a,
  input  wire [B_WIDTH-1:0] b,
  output wire [WIDTH-1:0]   y
);

  localparam WIDER     = ((SQUARE != 0) || (A_WIDTH > B_WIDTH)) ? A_WIDTH : B_WIDTH;
  localparam PRECISION = (WIDER < 4) ? 4 : WIDER;
  localparam SECOND    = (SQUARE != 0) ? A_WIDTH : B_WIDTH;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (A_WIDTH < 1) begin : g_refused_a A_WIDTH_is_below_1 refused (); end
    if (B_WIDTH < 1) begin : g_refused_b B_WIDTH_is_below_1 refused (); end
    if (DROPPED < 0) begin : g_refused_dropped
      DROPPED_is_below_0 refused ();
    end else if ((WIDTH < 1) || (WIDTH + DROPPED > A_WIDTH + SECOND)) begin : g_refused_width
      WIDTH_is_not_1_to_that_of_the_product refused ();
    end
  endgenerate

  // One bit wider than a factor, so that there is always a bit to repeat.
  wire [PRECISION:0]     a_extended = {{(PRECISION + 1 - A_WIDTH) {a[A_WIDTH-1]}}, a};
  wire [PRECISION:0]     b_extended;
  wire [2*PRECISION-1:0] product;
  wire                   unused_bits = ^{a_extended, b_extended, product};

  generate
    if (SQUARE != 0) begin : g_square
      wire unused_b = ^b;

      assign b_extended = {(PRECISION + 1) {1'b0}};
    end else begin : g_product
      assign b_extended = {{(PRECISION + 1 - B_WIDTH) {b[B_WIDTH-1]}}, b};
    end
  endgenerate

  fp_logic_product #(
    .PRECISION(PRECISION),
    .SQUARE   (SQUARE),
    .SIGNED   (1),
    .CUTS     (CUTS)
  ) logic_product (
    .aclk   (aclk),
    .a      (a_extended[PRECISION-1:0]),
    .b      (b_extended[PRECISION-1:0]),
    .product(product)
  );

  assign y = product[DROPPED+:WIDTH];

endmodule

`default_nettype wire
