// delay_line: q is d delayed by LENGTH cycles.
// Latency LENGTH. There is no reset, so that synthesis can use shift registers. It is for data,
// never for valid bits.
`default_nettype none

module delay_line #(
  parameter WIDTH = 1,  // bits of d and q, 1 or more
  parameter LENGTH = 1  // cycles of delay, 0 or more; 0: a wire
) (
  input  wire             aclk,
  input  wire [WIDTH-1:0] d,
  output wire [WIDTH-1:0] q
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if (LENGTH < 0) begin : g_refused_length LENGTH_is_below_0 refused (); end
  endgenerate

  generate
    if (LENGTH == 0) begin : g_wire
      wire unused_aclk = aclk;
      assign q = d;
    end
    if ((LENGTH > 0) && (WIDTH > 0)) begin : g_shift
      reg  [LENGTH*WIDTH-1:0]     rank_q;
      wire [(LENGTH+1)*WIDTH-1:0] taps = {rank_q, d};  // word k came k cycles ago

      always @(posedge aclk) begin
        rank_q <= taps[LENGTH*WIDTH-1:0];
      end

      assign q = taps[LENGTH*WIDTH +: WIDTH];
    end
  endgenerate

endmodule

`default_nettype wire
