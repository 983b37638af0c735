// fp_square_row: one row of a square: a digit (fp_booth_multiple) times itself and all lower
// digits.
// Combinational. The digits below place p are x = a[p-1:0] in two's complement. A digit d adds d (2
// x + d 2^p) 2^p to the square. That is never negative, and its term d 2^p cancels the sign of 2 x.
// The row's first place is p - 1, and the row adds a 1 there if the previous digit was negative
// (`owed`). No row follows the last digit of a signed number, so none could add that digit's 1.
// This 1 is worth four times the row's first place: the row itself adds three of the four, the
// caller one. That digit is -1 only if the previous digit is not negative.
`default_nettype none

module fp_square_row #(
  parameter PLACE = 3,  // place of the digit's middle bit, 1 or more; 1 or 2 in the first row
  parameter LAST  = 0   // 1: the last digit of a signed number, and not the first; 0: another
) (
  input  wire             single,    // the digit is 1 or -1
  input  wire             doubled,   // the digit is 2 or -2
  input  wire             negative,  // the digit is -1 or -2
  input  wire             owed,      // the previous digit is negative
  input  wire [PLACE-1:0] a,         // bits below the digit's middle bit
  output wire [PLACE+2:0] row
);

  localparam [PLACE-1:0] NO_DIGITS = 0;
  localparam [PLACE-1:0] SIGN      = ~(~NO_DIGITS >> 1);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (PLACE < 1) begin : g_refused_place PLACE_is_below_1 refused (); end
    if ((LAST != 0) && (PLACE < 3)) begin : g_refused_last LAST_is_also_the_first refused (); end
  endgenerate

  wire [PLACE:0] multiple;
  wire           unused_above = multiple[PLACE];

  fp_booth_multiple #(
    .WIDTH(PLACE)
  ) booth_multiple (
    .single  (single),
    .doubled (doubled),
    .negative(negative),
    .value   (a ^ SIGN),
    .multiple(multiple)
  );

  wire own = (LAST != 0) && negative;

  // Below the first row's digit are one or two bits. The row has room for their square.
  wire [1:0] below;

  generate
    if (PLACE == 1) begin : g_one_bit
      wire unused_owed = own ^ owed;

      assign below = {1'b0, a[0]};
    end else if (PLACE == 2) begin : g_two_bits
      wire unused_owed = own ^ owed;

      assign below = {a[1] && !a[0], 1'b0};  // and a[0] one place down
    end else begin : g_digits
      assign below = {own, own || owed};
    end
  endgenerate

  assign row = {doubled, multiple[PLACE-1:0], below};

endmodule

`default_nettype wire
