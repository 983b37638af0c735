// fp_product_row: row ROW of fp_logic_product.
// Combinational.
`default_nettype none

module fp_product_row #(
  parameter PRECISION = 24,
  parameter SQUARE    = 0,
  parameter SIGNED    = 0,
  parameter ROW       = 0,
  parameter WIDTH     = PRECISION + 6
) (
  input  wire [PRECISION-1:0] a,
  input  wire [PRECISION-1:0] b,
  output wire [WIDTH-1:0]     row
);

  localparam ROWS      = (SQUARE != 0) ? PRECISION / 2 : PRECISION / 2 + 1;
  localparam LAST      = (SIGNED != 0) && (ROW == ROWS - 1);
  localparam ROW_WIDTH = (SQUARE != 0) ? 2 * ROW + PRECISION % 2 + 4 : PRECISION + 6;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (PRECISION < 2) begin : g_refused_precision
      PRECISION_is_below_2 refused ();
    end
    if ((ROW < 0) || (ROW >= ROWS)) begin : g_refused_row
      ROW_is_not_a_row_of_PRECISION refused ();
    end
    if (WIDTH != ROW_WIDTH) begin : g_refused_width
      WIDTH_is_not_that_of_the_row refused ();
    end
  endgenerate

  generate
    if (SQUARE != 0) begin : g_square
      localparam PLACE = 2 * ROW + 1 + PRECISION % 2;

      wire [PRECISION:0] extended = {(SIGNED != 0) && a[PRECISION-1], a};
      wire               unused   = ^{extended, b};

      fp_square_row #(
        .PLACE(PLACE),
        .LAST (LAST)
      ) square_row (
        .a  (extended[PLACE+1:0]),
        .row(row)
      );
    end else begin : g_multiply
      wire                 sign     = (SIGNED != 0) && a[PRECISION-1];
      wire [PRECISION+4:0] extended = {sign, sign, a, 3'b000};
      wire                 unused   = ^extended;

      fp_multiply_row #(
        .PRECISION(PRECISION),
        .FIRST    (ROW == 0),
        .SIGNED   (SIGNED),
        .LAST     (LAST)
      ) multiply_row (
        .digits(extended[2*ROW+4:2*ROW]),
        .b     (b),
        .row   (row)
      );
    end
  endgenerate

endmodule

`default_nettype wire
