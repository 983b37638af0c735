// valid_delay_line: q is d delayed by LENGTH cycles. Latency LENGTH. It is for valid bits: reset
// forgets all bits inside.
`default_nettype none

module valid_delay_line #(
  parameter LENGTH = 1  // cycles of delay, 0 or more; 0: a wire
) (
  input  wire aclk,
  input  wire aresetn,
  input  wire d,
  output wire q
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (LENGTH < 0) begin : g_refused_length LENGTH_is_below_0 refused (); end
  endgenerate

  generate
    if (LENGTH == 0) begin : g_wire
      wire unused_clock = aclk && aresetn;
      assign q = d;
    end else begin : g_shift
      reg  [LENGTH-1:0] rank_q;
      wire [LENGTH:0]   taps = {rank_q, d};  // bit k came k cycles ago

      always @(posedge aclk) begin
        if (!aresetn) begin
          rank_q <= {LENGTH{1'b0}};
        end else begin
          rank_q <= taps[LENGTH-1:0];
        end
      end

      assign q = taps[LENGTH];
    end
  endgenerate

endmodule

`default_nettype wire
