// fp_ranks: COUNT cut points with nothing between them.
// Latency: the population count of CUTS; initiation interval 1; no reset.
`default_nettype none

module fp_ranks #(
  parameter             WIDTH = 1,  // bits of `d` and `q`, 1 or more
  parameter             COUNT = 1,  // number of cut points, 1 or more
  parameter [COUNT-1:0] CUTS  = 0   // a register at cut point k if bit k is 1
) (
  input  wire             aclk,
  input  wire [WIDTH-1:0] d,
  output wire [WIDTH-1:0] q
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if (COUNT < 1) begin : g_refused_count COUNT_is_below_1 refused (); end
  endgenerate

  wire [(COUNT+1)*WIDTH-1:0] chain;

  assign chain[WIDTH-1:0] = d;
  assign q                = chain[COUNT*WIDTH+:WIDTH];

  genvar k;
  generate
    for (k = 0; k < COUNT; k = k + 1) begin : g_cut
      fp_rank #(
        .WIDTH     (WIDTH),
        .REGISTERED(CUTS[k])
      ) rank (
        .aclk(aclk),
        .d   (chain[k*WIDTH+:WIDTH]),
        .q   (chain[(k+1)*WIDTH+:WIDTH])
      );
    end
  endgenerate

endmodule

`default_nettype wire
