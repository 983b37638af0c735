// lane_counters: the run-time profile of one lane, each count modulo 2^COUNTER_BITS: comparisons
// accepted, recomputations (requests sent, or results reported undecided where there is no
// reference), and cycles in which a comparison was offered and not accepted. Reset clears them.
`default_nettype none

module lane_counters #(
  parameter COUNTER_BITS = 32
) (
  input  wire                                             aclk,
  input  wire                                             aresetn,
  input  wire                                             s_axis_tvalid,
  input  wire                                             s_axis_tready,
  input  wire                                             request_sent,
  input  wire                                             undecided_result,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0] comparisons,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0] recomputations,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0] stalls
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (COUNTER_BITS < 0) begin : g_refused_counter_bits
      COUNTER_BITS_is_below_0 refused ();
    end
  endgenerate

  event_counter #(
    .COUNTER_BITS(COUNTER_BITS)
  ) comparison_counter (
    .aclk   (aclk),
    .aresetn(aresetn),
    .step   (s_axis_tvalid && s_axis_tready),
    .count  (comparisons)
  );

  event_counter #(
    .COUNTER_BITS(COUNTER_BITS)
  ) recomputation_counter (
    .aclk   (aclk),
    .aresetn(aresetn),
    .step   (request_sent || undecided_result),
    .count  (recomputations)
  );

  event_counter #(
    .COUNTER_BITS(COUNTER_BITS)
  ) stall_counter (
    .aclk   (aclk),
    .aresetn(aresetn),
    .step   (s_axis_tvalid && !s_axis_tready),
    .count  (stalls)
  );

endmodule

`default_nettype wire
