// fp_selected_sum_modes: fp_selected_sum without its cut and with it, side by side.
`default_nettype none

module fp_selected_sum_modes #(
  parameter WIDTH = 9
) (
  input  wire               aclk,
  input  wire [WIDTH-1:0]   a,
  input  wire               select,
  input  wire [WIDTH-1:0]   b,
  input  wire [WIDTH-1:0]   c,
  input  wire               carry,
  output wire [2*WIDTH-1:0] sums
);

  genvar mode;
  generate
    for (mode = 0; mode < 2; mode = mode + 1) begin : g_mode
      localparam [0:0] MODE = mode;

      fp_selected_sum #(
        .WIDTH(WIDTH),
        .CUTS (MODE)
      ) selected_sum (
        .aclk  (aclk),
        .a     (a),
        .select(select),
        .b     (b),
        .c     (c),
        .carry (carry),
        .sum   (sums[mode*WIDTH+:WIDTH])
      );
    end
  endgenerate

endmodule

`default_nettype wire
