// fp_booth_multiple: a value times a digit of -2 to 2.
// Combinational. A negative multiple is a ones' complement: it is one too small in the last place,
// and has ones in all places above it.
`default_nettype none

module fp_booth_multiple #(
  parameter WIDTH  = 24,  // bits of the value, 1 or more
  parameter SIGNED = 0    // 1: the value is in two's complement; 0: unsigned
) (
  input  wire             single,    // the digit is 1 or -1
  input  wire             doubled,   // the digit is 2 or -2
  input  wire             negative,  // the digit is -1 or -2
  input  wire [WIDTH-1:0] value,
  output wire [WIDTH:0]   multiple
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
  endgenerate

  wire [WIDTH-1:0] once  = value & {WIDTH{single}};
  wire [WIDTH-1:0] twice = value & {WIDTH{doubled}};

  assign multiple = ({(SIGNED != 0) && once[WIDTH-1], once} | {twice, 1'b0}) ^
                    {(WIDTH + 1) {negative}};

endmodule

`default_nettype wire
