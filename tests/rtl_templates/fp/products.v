// products: fp_product at many precisions, only for the regression. Each precision has a product
// and a square, of logic, of logic with a stage for the digits, and of multipliers whose sizes
// differ from precision to precision; the slots are {precision, kind, SQUARE, complemented}, the
// precisions counting slowest, three kinds each. Logic products of few digits are built twice, with
// masks of cuts that complement each other. All others have one of the two masks in turn. Squares
// of logic with the last cut are split. Multipliers have fewer precisions: many small ones compile
// slowly. products_test.cpp repeats the list of products and masks.
`default_nettype none

module products #(
    parameter SLOTS = 1368,
    parameter WIDEST = 113
) (
    input wire              aclk,
    input wire [WIDEST-1:0] a,  // each precision takes the last places, below a leading one
    input wire [WIDEST-1:0] b
);

  // The answers, which the test reads by hierarchical name, as in fp_units.
  wire [255:0] y[0:SLOTS-1]  /* verilator public_flat_rd */;

  genvar precision;
  genvar kind;
  genvar square;
  genvar complemented;

  generate
    for (precision = 2; precision <= WIDEST; precision = precision + 1) begin : with_precision
      if (precision <= 12 || (precision >= 16 && precision <= 18) || precision == 24
          || precision == 33 || precision == 34 || precision == 53 || precision == 64
          || precision == 65 || precision == WIDEST) begin : built
        wire [precision-1:0] x0 = {1'b1, a[precision-2:0]};
        wire [precision-1:0] x1 = {1'b1, b[precision-2:0]};

        // Factors of few bits have many small parts, factors of many bits have parts as devices
        // have them.
        localparam FACTOR_A = (precision <= 12) ? 2 + precision % 5
                                                : (precision % 2 == 0) ? 18 : 24;
        localparam FACTOR_B = (precision <= 12) ? 2 + precision % 4
                                                : (precision % 2 == 0) ? 18 : 17;
        localparam KINDS = (precision <= 12 || precision == 17 || precision == 24 || precision == 34
                            || precision == 53 || precision == 64 || precision == WIDEST) ? 3 : 2;

        for (kind = 0; kind < KINDS; kind = kind + 1) begin : made
          for (square = 0; square < 2; square = square + 1) begin : of
            for (complemented = 0; complemented < 2; complemented = complemented + 1) begin : with_cuts
              if ((precision <= 12 && kind < 2)
                  || complemented == (precision + kind + square) % 2) begin : chosen
                localparam       SLOT = 12 * precision + 4 * kind + 2 * square + complemented;
                localparam [7:0] MASK = 37 * precision + 53 * square + 139 * kind;
                localparam [7:0] CUTS = complemented ? ~MASK : MASK;

                wire [2*precision-1:0] product;

                fp_product #(
                    .PRECISION  (precision),
                    .SQUARE     (square),
                    .EMBEDDED   (kind == 2),
                    .DIGIT_STAGE(kind == 1),
                    .SPLIT      (kind == 0 && square == 1 && precision <= 65 && CUTS[7]),
                    .FACTOR_A   (FACTOR_A),
                    .FACTOR_B   (FACTOR_B),
                    .CUTS       (CUTS)
                ) unit (
                    .aclk   (aclk),
                    .a      (x0),
                    .b      (x1),
                    .product(product)
                );

                assign y[SLOT] = product;
              end
            end
          end
        end
      end
    end
  endgenerate

endmodule

`default_nettype wire
