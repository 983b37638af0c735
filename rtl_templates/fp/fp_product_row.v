// fp_product_row: row ROW of fp_logic_product.
// Combinational.
`default_nettype none

module fp_product_row #(
  parameter PRECISION = 24,  // bits of a factor, 2 or more
  parameter SQUARE    = 0,   // 1: the row of a square; 0: of a product
  parameter SIGNED    = 0,   // 1: factors in two's complement; 0: unsigned
  parameter CODE      = 0,   // code of the digits, 0 to 2, as in fp_booth_digit
  // Number of the row: 0 to PRECISION / 2, in a square to PRECISION / 2 - 1.
  parameter ROW       = 0,
  // Bits of `row`: PRECISION + 6, in a square 2 * ROW + PRECISION % 2 + 4; no other value.
  parameter WIDTH     = PRECISION + 6
) (
  input  wire [PRECISION-1:0] a,
  input  wire [PRECISION-1:0] b,
  input  wire [2:0]           digit,
  input  wire [2:0]           previous,  // the previous row's digit; unused in row 0
  output wire [WIDTH-1:0]     row
);

  localparam ROWS      = (SQUARE != 0) ? PRECISION / 2 : PRECISION / 2 + 1;
  localparam LAST      = (SIGNED != 0) && (ROW == ROWS - 1);
  localparam ROW_WIDTH = (SQUARE != 0) ? 2 * ROW + PRECISION % 2 + 4 : PRECISION + 6;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if ((ROW < 0) || (ROW >= ROWS))
      begin : g_refused_row ROW_is_not_a_row_of_PRECISION refused (); end
    if (WIDTH != ROW_WIDTH) begin : g_refused_width WIDTH_is_not_that_of_the_row refused (); end
  endgenerate

  wire single;
  wire doubled;
  wire negative;

  fp_booth_digit #(
    .CODE(CODE)
  ) booth_digit (
    .digit   (digit),
    .single  (single),
    .doubled (doubled),
    .negative(negative)
  );

  wire [1:0] unused_size;
  wire       previous_negative;
  wire       owed = (ROW > 0) && previous_negative;

  fp_booth_digit #(
    .CODE(CODE)
  ) previous_digit (
    .digit   (previous),
    .single  (unused_size[0]),
    .doubled (unused_size[1]),
    .negative(previous_negative)
  );

  generate
    if (SQUARE != 0) begin : g_square
      localparam PLACE = 2 * ROW + 1 + PRECISION % 2;

      wire unused = ^{a, b};

      fp_square_row #(
        .PLACE(PLACE),
        .LAST (LAST)
      ) square_row (
        .single  (single),
        .doubled (doubled),
        .negative(negative),
        .owed    (owed),
        .a       (a[PLACE-1:0]),
        .row     (row)
      );
    end else begin : g_multiply
      wire unused = ^a;

      fp_multiply_row #(
        .PRECISION(PRECISION),
        .FIRST    (ROW == 0),
        .SIGNED   (SIGNED),
        .LAST     (LAST)
      ) multiply_row (
        .single  (single),
        .doubled (doubled),
        .negative(negative),
        .owed    (owed),
        .b       (b),
        .row     (row)
      );
    end
  endgenerate

endmodule

`default_nettype wire
