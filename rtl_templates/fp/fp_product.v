// fp_product: the product of two significands, or the square of one.
// Latency: the population count of CUTS (three bits, seven with EMBEDDED = 0); initiation interval
// 1; no reset. The significands have a leading one; without it the product may be anything.
`default_nettype none

module fp_product #(
    parameter PRECISION = 24,
    parameter SQUARE    = 0,  // 1: of a; b is not read
    parameter EMBEDDED  = 1,  // 0: fp_logic_product instead of `*`
    parameter [((EMBEDDED != 0) ? 2 : 6):0] CUTS = 0
) (
    input  wire                   aclk,
    input  wire [PRECISION-1:0]   a,
    input  wire [PRECISION-1:0]   b,
    output wire [2*PRECISION-1:0] product
);

  wire [PRECISION-1:0] factor = (SQUARE != 0) ? a : b;

  generate
    if (EMBEDDED != 0) begin : embedded
      wire [2*PRECISION-1:0] whole = a * factor;

      // Ranks that synthesis moves into the product, where embedded multipliers and the adders
      // behind them have registers of their own.
      fp_ranks #(
          .WIDTH(2 * PRECISION),
          .COUNT(3),
          .CUTS (CUTS)
      ) product_ranks (
          .aclk(aclk),
          .d   (whole),
          .q   (product)
      );
    end else begin : gates
      wire unused_leading_ones = a[PRECISION-1] ^ factor[PRECISION-1];

      fp_logic_product #(
          .PRECISION(PRECISION),
          .SQUARE   (SQUARE),
          .CUTS     (CUTS)
      ) logic_product (
          .aclk   (aclk),
          .a      (a[PRECISION-2:0]),
          .b      (factor[PRECISION-2:0]),
          .product(product)
      );
    end
  endgenerate

endmodule

`default_nettype wire
