// lane_tracker: keeps the slot of each word inside LANES free-running lanes, and gives the slot out
// when the word's verdicts leave the lanes. A word of comparisons enters with `start`; LANE_LATENCY
// + 1 cycles later it leaves with `exit` and its verdicts. One word per cycle. Reset forgets all.
`default_nettype none

module lane_tracker #(
  parameter LANES = 1,         // lanes in lock step, 1 to 64
  parameter SLOT_BITS = 5,     // 1 or more: 2^SLOT_BITS comparisons may be in flight
  parameter LANE_LATENCY = 16  // latency of the lane in cycles, 0 or more
) (
  input  wire                 aclk,
  input  wire                 aresetn,
  input  wire                 start_valid,
  input  wire [SLOT_BITS-1:0] start_slot,
  input  wire [2*LANES-1:0]   lane_verdict,
  input  wire [LANES-1:0]     lane_decided,
  output wire                 exit_valid,
  output wire [SLOT_BITS-1:0] exit_slot,
  output wire [2*LANES-1:0]   exit_verdict,
  output wire [LANES-1:0]     exit_decided
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((LANES < 1) || (LANES > 64)) begin : g_refused_lanes LANES_is_not_1_to_64 refused (); end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits SLOT_BITS_is_below_1 refused (); end
    if (LANE_LATENCY < 0) begin : g_refused_lane_latency LANE_LATENCY_is_below_0 refused (); end
  endgenerate

  valid_delay_line #(
    .LENGTH(LANE_LATENCY + 1)
  ) valid_beside_lane (
    .aclk   (aclk),
    .aresetn(aresetn),
    .d      (start_valid),
    .q      (exit_valid)
  );

  delay_line #(
    .WIDTH (SLOT_BITS),
    .LENGTH(LANE_LATENCY + 1)
  ) slot_beside_lane (
    .aclk(aclk),
    .d   (start_slot),
    .q   (exit_slot)
  );

  reg [2*LANES-1:0] exit_verdict_q;
  reg [LANES-1:0]   exit_decided_q;

  always @(posedge aclk) begin
    exit_verdict_q <= lane_verdict;
    exit_decided_q <= lane_decided;
  end

  assign exit_verdict = exit_verdict_q;
  assign exit_decided = exit_decided_q;

endmodule

`default_nettype wire
