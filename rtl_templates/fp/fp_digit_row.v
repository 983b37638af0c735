// fp_digit_row: a value times a digit of -1 to 2, which comes plus one.
// Combinational. A negative row is a complement: it lacks one in its last place.
`default_nettype none

module fp_digit_row #(
  parameter WIDTH = 25
) (
  input  wire [1:0]       digit_plus_one,
  input  wire [WIDTH-1:0] value,           // not negative
  output wire [WIDTH+1:0] row,             // in two's complement
  output wire             negative
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (WIDTH < 1) begin : g_refused_width
      WIDTH_is_below_1 refused ();
    end
  endgenerate

  wire single  = !digit_plus_one[0];
  wire doubled = &digit_plus_one;

  wire [WIDTH-1:0] once  = value & {WIDTH{single}};
  wire [WIDTH-1:0] twice = value & {WIDTH{doubled}};

  assign negative = digit_plus_one == 2'b00;
  assign row      = ({2'b00, once} | {1'b0, twice, 1'b0}) ^ {(WIDTH + 2) {negative}};

endmodule

`default_nettype wire
