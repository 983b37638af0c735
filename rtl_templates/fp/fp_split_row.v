// fp_split_row: a row of fp_logic_product, by fp_product_row. Its bits from LATE_FROM up are late:
// they are taken from the row of late_a and late_digit, the factor and the digit of the previous
// cycle.
// Combinational.
`default_nettype none

module fp_split_row #(
  parameter PRECISION = 24,  // bits of a factor, 2 or more
  parameter SQUARE    = 0,   // 1: the row of a square; 0: of a product
  parameter SIGNED    = 0,   // 1: factors in two's complement; 0: unsigned
  parameter CODE      = 0,   // code of the digits, 0 to 2, as in fp_booth_digit
  // Number of the row: 0 to PRECISION / 2, in a square to PRECISION / 2 - 1.
  parameter ROW       = 0,
  // Bits of `row`: PRECISION + 6, in a square 2 * ROW + PRECISION % 2 + 4; no other value.
  parameter WIDTH     = PRECISION + 6,
  // Lowest late bit, 2 or more, below WIDTH only with SQUARE; WIDTH or more: no bit is late.
  parameter LATE_FROM = WIDTH
) (
  input  wire [PRECISION-1:0] a,
  input  wire [PRECISION-1:0] b,
  input  wire [2:0]           digit,
  input  wire [2:0]           previous,
  input  wire [PRECISION-1:0] late_a,
  input  wire [2:0]           late_digit,
  output wire [WIDTH-1:0]     row
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (LATE_FROM < 2) begin : g_refused_late_from LATE_FROM_is_below_2 refused (); end
    if ((LATE_FROM < WIDTH) && (SQUARE == 0))
      begin : g_refused_product LATE_FROM_of_no_square refused (); end
  endgenerate

  wire [WIDTH-1:0] early;

  fp_product_row #(
    .PRECISION(PRECISION),
    .SQUARE   (SQUARE),
    .SIGNED   (SIGNED),
    .CODE     (CODE),
    .ROW      (ROW),
    .WIDTH    (WIDTH)
  ) early_row (
    .a       (a),
    .b       (b),
    .digit   (digit),
    .previous(previous),
    .row     (early)
  );

  generate
    if (LATE_FROM >= WIDTH) begin : g_none_late
      wire unused_late = ^{late_a, late_digit};

      assign row = early;
    end else begin : g_split
      wire [WIDTH-1:0] late;
      wire             unused_bits = ^{early[WIDTH-1:LATE_FROM], late[LATE_FROM-1:0]};

      fp_product_row #(
        .PRECISION(PRECISION),
        .SQUARE   (SQUARE),
        .SIGNED   (SIGNED),
        .CODE     (CODE),
        .ROW      (ROW),
        .WIDTH    (WIDTH)
      ) late_row (
        .a       (late_a),
        .b       (b),
        .digit   (late_digit),
        .previous(3'b000),  // affects the two lowest bits only
        .row     (late)
      );

      assign row = {late[WIDTH-1:LATE_FROM], early[LATE_FROM-1:0]};
    end
  endgenerate

endmodule

`default_nettype wire
