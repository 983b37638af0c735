// fp_rank: one cut point, which is a row of registers or of wires.
// Latency REGISTERED, initiation interval 1, no reset.
`default_nettype none

module fp_rank #(
  parameter       WIDTH      = 1,  // bits of `d` and `q`, 1 or more
  parameter       REGISTERED = 1   // 1: registers; 0: wires
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
