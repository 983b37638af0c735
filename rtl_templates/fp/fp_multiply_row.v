// fp_multiply_row: one row of a product: b times one of a's digits (fp_booth_multiple).
// Combinational. The row's first place is that of the previous digit, and the row adds a 1 there if
// that digit was negative (`owed`). A sign bit s is worth -s, which is (1 - s) - 1. The constants
// -1 of all rows add up to a one above each row and one more in the first row's sign. No row
// follows the last digit of a signed factor, so none could add that digit's 1. This 1 is worth four
// times the row's first place: the row itself adds three of the four, the caller one. That digit is
// -1 only if the previous digit is not negative.
`default_nettype none

module fp_multiply_row #(
  parameter PRECISION = 24,  // bits of b, 2 or more
  parameter FIRST     = 0,   // 1: the first row; 0: a later one
  parameter SIGNED    = 0,   // 1: b is in two's complement; 0: unsigned
  parameter LAST      = 0    // 1: the last digit's row, with a signed factor; 0: another
) (
  input  wire                 single,    // the digit is 1 or -1
  input  wire                 doubled,   // the digit is 2 or -2
  input  wire                 negative,  // the digit is -1 or -2
  input  wire                 owed,      // the previous digit is negative
  input  wire [PRECISION-1:0] b,
  output wire [PRECISION+5:0] row
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
  endgenerate

  wire [PRECISION:0] multiple;

  fp_booth_multiple #(
    .WIDTH (PRECISION),
    .SIGNED(SIGNED)
  ) booth_multiple (
    .single  (single),
    .doubled (doubled),
    .negative(negative),
    .value   (b),
    .multiple(multiple)
  );

  wire       minus = (SIGNED != 0) ? multiple[PRECISION] : negative;
  wire [2:0] sign  = (FIRST != 0) ? {!minus, minus, minus} : {2'b01, !minus};

  wire       own   = (LAST != 0) && negative;

  assign row = {sign, multiple, own, own || owed};

endmodule

`default_nettype wire
