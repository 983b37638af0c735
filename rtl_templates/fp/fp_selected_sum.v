// fp_selected_sum: a + (select ? c : b) + carry, modulo 2^WIDTH, with the cut of fp_halved_sum.
// Latency: CUTS; initiation interval 1; no reset.
`default_nettype none

module fp_selected_sum #(
  parameter       WIDTH = 8,    // bits of each operand, 2 or more
  parameter [0:0] CUTS  = 1'b0  // 1: registers between lower and upper half
) (
  input  wire             aclk,
  input  wire [WIDTH-1:0] a,
  input  wire             select,
  input  wire [WIDTH-1:0] b,
  input  wire [WIDTH-1:0] c,
  input  wire             carry,
  output wire [WIDTH-1:0] sum
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 2) begin : g_refused_width WIDTH_is_below_2 refused (); end
  endgenerate

  fp_halved_sum #(
    .WIDTH(WIDTH),
    .GATED(1),
    .CUTS (CUTS)
  ) halved_sum (
    .aclk (aclk),
    .a    (a),
    .b    (select ? c : b),
    .carry(carry),
    .sum  (sum)
  );

endmodule

`default_nettype wire
