// fp_multiply_row: one row of a product, b times one of a's digits (fp_booth_multiple).
// Combinational. The row's first place is that of the digit before, which is owed one there if it
// was negative. Signs: -s is 1 - s less one, and the ones that all rows lack together are a one
// above each row and one more in the first row's sign. The last digit of a signed factor has no row
// after it: it is owed four of the row's first places, three of which the row has and one the
// caller adds. It is -1 only where the digit before is not negative.
`default_nettype none

module fp_multiply_row #(
  parameter PRECISION = 24,
  parameter FIRST     = 0,   // 1: of the first row
  parameter SIGNED    = 0,   // 1: b is in two's complement
  parameter LAST      = 0    // 1: of a signed factor's last digit
) (
  input  wire                 single,    // the digit is 1 or -1
  input  wire                 doubled,   // 2 or -2
  input  wire                 negative,  // -1 or -2
  input  wire                 owed,      // the digit before is negative
  input  wire [PRECISION-1:0] b,
  output wire [PRECISION+5:0] row
);

  // Parameters that do not fit: an instance of a module that does not exist.
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
