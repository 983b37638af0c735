// fp_product: the product of two significands, or the square of one.
// Latency: the population count of CUTS (eight bits); initiation interval 1; no reset.
`default_nettype none

module fp_product #(
  parameter       PRECISION   = 24,  // digits of a significand, 2 or more
  parameter       SQUARE      = 0,   // 1: a * a, and b is not read; 0: a * b
  // 1: multipliers, as `*` of FACTOR_A by FACTOR_B bits; 0: logic, if PRECISION is 127 or less.
  parameter       EMBEDDED    = 1,
  // 1: in logic, a stage of its own finds the digits; only if PRECISION is 63 or less.
  parameter       DIGIT_STAGE = 0,
  // 1: in logic, the highest quarter of the bits is late, as in fp_logic_product; only with SQUARE
  // and CUTS[7].
  parameter       SPLIT       = 0,
  parameter       FACTOR_A    = 24,  // first factor of `*`, 1 bit or more
  parameter       FACTOR_B    = 17,  // second factor of `*`, 1 bit or more
  parameter       LEADING_ONE = 1,   // 1 promises leading ones, or `product` is undefined
  // A register at cut k if bit k is 1. Cut 0 is in front of the multipliers, in their own registers
  // if they have any.
  parameter [7:0] CUTS        = 8'b0
) (
  input  wire                   aclk,
  input  wire [PRECISION-1:0]   a,
  input  wire [PRECISION-1:0]   b,
  output wire [2*PRECISION-1:0] product
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if (FACTOR_A < 1) begin : g_refused_factor_a FACTOR_A_is_below_1 refused (); end
    if (FACTOR_B < 1) begin : g_refused_factor_b FACTOR_B_is_below_1 refused (); end
  endgenerate

  // The requirements of fp_embedded_square. C++'s EmbeddedSquare repeats them.
  localparam SPARE    = (FACTOR_A > FACTOR_B + 2) ? 2 : FACTOR_A - FACTOR_B;
  localparam PARTS    = ((FACTOR_B > 0) && (PRECISION > SPARE))
                        ? (PRECISION - SPARE + FACTOR_B - 1) / FACTOR_B : 1;
  localparam COLUMNS  = (FACTOR_A > 0) ? (PRECISION + FACTOR_A - 1) / FACTOR_A : 1;
  localparam ROWS     = (FACTOR_B > 0) ? (PRECISION + FACTOR_B - 1) / FACTOR_B : 1;
  localparam SYMMETRY = (SQUARE != 0) && (SPARE >= 0) && (PARTS > 1)
                        && (PARTS * (PARTS + 1) < 2 * COLUMNS * ROWS);

  wire [PRECISION-1:0] factor = (SQUARE != 0) ? a : b;

  generate
    if ((EMBEDDED != 0) && SYMMETRY) begin : g_embedded_square
      wire unused_factor = ^factor;

      fp_embedded_square #(
        .PRECISION  (PRECISION),
        .FACTOR_A   (FACTOR_A),
        .FACTOR_B   (FACTOR_B),
        .PARTS      (PARTS),
        .LEADING_ONE(LEADING_ONE),
        .CUTS       (CUTS)
      ) embedded_square (
        .aclk   (aclk),
        .a      (a),
        .product(product)
      );
    end else if (EMBEDDED != 0) begin : g_embedded
      fp_embedded_product #(
        .PRECISION(PRECISION),
        .FACTOR_A (FACTOR_A),
        .FACTOR_B (FACTOR_B),
        .CUTS     (CUTS)
      ) embedded_product (
        .aclk   (aclk),
        .a      (a),
        .b      (factor),
        .product(product)
      );
    end else begin : g_gates
      wire                 a_leading = (LEADING_ONE != 0) || a[PRECISION-1];
      wire                 b_leading = (LEADING_ONE != 0) || factor[PRECISION-1];
      wire [PRECISION-1:0] s1_a;
      wire [PRECISION-1:0] s1_b;

      fp_rank #(
        .WIDTH     (2 * PRECISION),
        .REGISTERED(CUTS[0])
      ) rank_0 (
        .aclk(aclk),
        .d   ({a_leading, a[PRECISION-2:0], b_leading, factor[PRECISION-2:0]}),
        .q   ({s1_a, s1_b})
      );

      fp_logic_product #(
        .PRECISION  (PRECISION),
        .SQUARE     (SQUARE),
        .DIGIT_STAGE((DIGIT_STAGE != 0) && (PRECISION < 64)),
        .SPLIT      (SPLIT),
        .CUTS       (CUTS[7:1])
      ) logic_product (
        .aclk   (aclk),
        .a      (s1_a),
        .b      (s1_b),
        .product(product)
      );
    end
  endgenerate

endmodule

`default_nettype wire
