// fp_product_row: row ROW of fp_logic_product.
// Combinational.
`default_nettype none

module fp_product_row #(
  parameter PRECISION = 24,
  parameter SQUARE    = 0,
  parameter ROW       = 0,
  parameter WIDTH     = PRECISION + 6
) (
  input  wire [PRECISION-1:0] a,
  input  wire [PRECISION-1:0] b,
  output wire [WIDTH-1:0]     row
);

  generate
    if (SQUARE != 0) begin : g_square
      localparam PLACE = 2 * ROW + 1 + PRECISION % 2;

      wire [PRECISION:0] extended = {1'b0, a};
      wire               unused   = ^{extended, b};

      fp_square_row #(
        .PLACE(PLACE)
      ) square_row (
        .a  (extended[PLACE+1:0]),
        .row(row)
      );
    end else begin : g_multiply
      wire [PRECISION+4:0] extended = {2'b00, a, 3'b000};
      wire                 unused   = ^extended;

      fp_multiply_row #(
        .PRECISION(PRECISION),
        .FIRST    (ROW == 0)
      ) multiply_row (
        .digits(extended[2*ROW+4:2*ROW]),
        .b     (b),
        .row   (row)
      );
    end
  endgenerate

endmodule

`default_nettype wire
