// event_counter: counts the cycles in which `step` is high, modulo 2^COUNTER_BITS.
// COUNTER_BITS = 0 builds nothing and ties the one bit of `count` to 0. Reset clears it.
`default_nettype none

module event_counter #(
  parameter COUNTER_BITS = 32
) (
  input  wire                                             aclk,
  input  wire                                             aresetn,
  input  wire                                             step,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0] count
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (COUNTER_BITS < 0) begin : g_refused_counter_bits
      COUNTER_BITS_is_below_0 refused ();
    end
  endgenerate

  generate
    if (COUNTER_BITS == 0) begin : g_none
      wire unused_inputs = &{aclk, aresetn, step};
      assign count = 1'b0;
    end else begin : g_count
      wire [COUNTER_BITS-1:0] one = 1;

      reg  [COUNTER_BITS-1:0] count_q;

      always @(posedge aclk) begin
        if (!aresetn) begin
          count_q <= {COUNTER_BITS{1'b0}};
        end else if (step) begin
          count_q <= count_q + one;
        end
      end

      assign count = count_q;
    end
  endgenerate

endmodule

`default_nettype wire
