// lane_counters: the run-time profile of one lane or group of lanes. It counts comparisons accepted
// (with a group: words), recomputations (requests sent or, without a reference, verdicts reported
// undecided), and cycles in which a comparison was offered and not accepted. Reset clears the
// counts.
`default_nettype none

module lane_counters #(
  parameter LANES = 1,         // lanes in lock step, 1 to 64
  parameter COUNTER_BITS = 32  // bits of a counter, which wraps; 0: no counters
) (
  input  wire                                             aclk,
  input  wire                                             aresetn,
  input  wire                                             s_axis_tvalid,
  input  wire                                             s_axis_tready,
  input  wire                                             request_sent,
  input  wire [LANES-1:0]                                 undecided_result,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0] comparisons,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0] recomputations,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0] stalls
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (COUNTER_BITS < 0) begin : g_refused_counter_bits COUNTER_BITS_is_below_0 refused (); end
  endgenerate

  event_counter #(
    .COUNTER_BITS(COUNTER_BITS)
  ) comparison_counter (
    .aclk   (aclk),
    .aresetn(aresetn),
    .step   (s_axis_tvalid && s_axis_tready),
    .count  (comparisons)
  );

  wire [LANES-1:0] recomputed;

  genvar k;
  generate
    for (k = 0; k < LANES; k = k + 1) begin : g_lane
      assign recomputed[k] = undecided_result[k] || ((k == 0) && request_sent);
    end
  endgenerate

  event_counter #(
    .COUNTER_BITS(COUNTER_BITS),
    .EVENTS      (LANES)
  ) recomputation_counter (
    .aclk   (aclk),
    .aresetn(aresetn),
    .step   (recomputed),
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
