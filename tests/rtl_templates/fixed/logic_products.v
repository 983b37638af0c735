// logic_products: products of logic of some widths, only for the tests. logic_products_test.cpp
// describes the slots in the same words.
`default_nettype none

module logic_products #(
    parameter SQUARES  = 22,
    parameter PRODUCTS = 36
) (
    input wire        aclk,
    input wire [31:0] a,
    input wire [31:0] b
);

  // The answers, which the test reads by hierarchical name.
  wire [63:0] results[0:SQUARES+PRODUCTS-1]  /* verilator public_flat_rd */;

  genvar slot;

  // Squares of 1 to 22 bits. Products of 2, 5, 8, 11, 14 and 17 bits by 1, 4, 7, 10, 13 and 16.
  // Every third result drops two bits, unless it has no more than these.
  generate
    for (slot = 0; slot < SQUARES + PRODUCTS; slot = slot + 1) begin : g_products
      localparam       SQUARE  = (slot < SQUARES) ? 1 : 0;
      localparam       A       = SQUARE ? slot + 1 : 2 + (slot - SQUARES) / 6 * 3;
      localparam       B       = SQUARE ? 1 : 1 + (slot - SQUARES) % 6 * 3;
      localparam       WHOLE   = SQUARE ? 2 * A : A + B;
      localparam       DROPPED = ((slot % 3 == 2) && (WHOLE > 3)) ? 2 : 0;
      localparam       WIDTH   = WHOLE - DROPPED;
      localparam [6:0] CUTS    = 37 * slot + slot / 6;

      wire [WIDTH-1:0] y;

      assign results[slot] = {{(64 - WIDTH) {1'b0}}, y};

      fixed_logic_product #(
          .A_WIDTH(A),
          .B_WIDTH(B),
          .SQUARE (SQUARE),
          .DROPPED(DROPPED),
          .WIDTH  (WIDTH),
          .CUTS   (CUTS)
      ) unit (
          .aclk(aclk),
          .a   (a[A-1:0]),
          .b   (b[B-1:0]),
          .y   (y)
      );
    end
  endgenerate

endmodule

`default_nettype wire
