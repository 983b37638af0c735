// fp_booth_digit: decodes one digit of a factor, which selects a multiple of the other factor.
// Combinational.
`default_nettype none

module fp_booth_digit #(
  // Code of `digit`. 0: a Booth digit, -2 to 2, as three bits {h, m, l} of the factor: m + l - 2h.
  // 1: {negative, doubled, single}. 2: a digit of -1 to 2, plus one.
  parameter CODE = 0
) (
  input  wire [2:0] digit,
  output wire       single,   // the digit is 1 or -1
  output wire       doubled,  // the digit is 2 or -2
  output wire       negative  // the digit is -1 or -2
);

  // An invalid parameter instantiates a module that does not exist: elaboration fails.
  generate
    if (CODE == 0) begin : g_booth
      assign single   = digit[1] ^ digit[0];
      assign doubled  = !single && (digit[2] ^ digit[1]);
      assign negative = digit[2] && !(digit[1] && digit[0]);
    end else if (CODE == 1) begin : g_decoded
      assign {negative, doubled, single} = digit;
    end else if (CODE == 2) begin : g_plus_one
      wire unused_bit = digit[2];

      assign single   = !digit[0];
      assign doubled  = digit[1] && digit[0];
      assign negative = !digit[1] && !digit[0];
    end else begin : g_refused_code
      CODE_is_not_0_to_2 refused ();
    end
  endgenerate

endmodule

`default_nettype wire
