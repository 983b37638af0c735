// fp_square_row: one row of a square, a digit (fp_booth_multiple) times itself and all below it.
// Combinational. The digits below place p are x = a[p-1:0] in two's complement; with them a digit d
// adds d (2 x + d 2^p) 2^p to the square, which is never negative: d 2^p takes the sign out of 2 x.
// The row's first place is p - 1, where the digit before is owed one if it was negative. The last
// digit of a signed number has no row after it: it is owed four of the row's first places, three of
// which the row has and one the caller adds. It is -1 only where the digit before is not negative.
`default_nettype none

module fp_square_row #(
  parameter PLACE = 3,  // of the digit's middle bit; of the first row 1 or 2
  parameter LAST  = 0   // 1: of a signed number's last digit, which is not its first
) (
  input  wire             single,    // the digit is 1 or -1
  input  wire             doubled,   // 2 or -2
  input  wire             negative,  // -1 or -2
  input  wire             owed,      // the digit before is negative
  input  wire [PLACE-1:0] a,         // below the digit's middle bit
  output wire [PLACE+2:0] row
);

  localparam [PLACE-1:0] NO_DIGITS = 0;
  localparam [PLACE-1:0] SIGN      = ~(~NO_DIGITS >> 1);

  // Parameters that do not fit: an instance of a module that does not exist.
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

  // Below the first row's digit there are one or two bits, and their square has room here.
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
