// fp_rank: one cut point, a row of registers where REGISTERED is 1 and wires where it is 0.
// Latency REGISTERED, initiation interval 1, no reset.
`default_nettype none

module fp_rank #(
  parameter       WIDTH      = 1,
  parameter       REGISTERED = 1
) (
  input  wire             aclk,
  input  wire [WIDTH-1:0] d,
  output wire [WIDTH-1:0] q
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
  endgenerate

  generate
    if (REGISTERED != 0) begin : g_cut
      reg [WIDTH-1:0] value_q;

      always @(posedge aclk) begin
        value_q <= d;
      end

      assign q = value_q;
    end else begin : g_through
      wire unused_aclk = aclk;

      assign q = d;
    end
  endgenerate

endmodule

`default_nettype wire
