// lane_scoreboard: AXI4-Stream around one free-running lane; results leave as they come.
// A comparison holds one of 2^SLOT_BITS slots from its acceptance until its tag is read out, so
// every queue has room. Latency of a decided one: LANE_LATENCY + 5. One comparison per cycle if all
// are decided, the sink is ready and 2^SLOT_BITS >= LANE_LATENCY + 6 (+ 5 with RECOMPUTE = 0, where
// the latency is LANE_LATENCY + 4). Direct and recomputed results alternate when both wait.
// Reset forgets all comparisons and clears the counters.
`default_nettype none

module lane_scoreboard #(
  parameter OPERAND_BITS = 128,
  parameter TAG_BITS = 32,
  parameter SLOT_BITS = 5,
  parameter LANE_LATENCY = 16,
  parameter COUNTER_BITS = 32,
  parameter RECOMPUTE = 1,
  parameter CARRIED = 1
) (
  input  wire                                                          aclk,
  input  wire                                                          aresetn,
  input  wire                                                          s_axis_tvalid,
  output wire                                                          s_axis_tready,
  input  wire [OPERAND_BITS-1:0]                                       s_axis_tdata,
  input  wire [TAG_BITS-1:0]                                           s_axis_tuser,
  output wire [OPERAND_BITS-1:0]                                       lane_operands,
  input  wire [1:0]                                                    lane_verdict,
  input  wire                                                          lane_decided,
  output wire                                                          m_request_tvalid,
  input  wire                                                          m_request_tready,
  output wire [SLOT_BITS+(CARRIED != 0 ? OPERAND_BITS : TAG_BITS)-1:0] m_request_tdata,
  input  wire                                                          s_answer_valid,
  input  wire [SLOT_BITS-1:0]                                          s_answer_slot,
  input  wire [1:0]                                                    s_answer_verdict,
  output wire                                                          m_axis_tvalid,
  input  wire                                                          m_axis_tready,
  output wire [7:0]                                                    m_axis_tdata,
  output wire [TAG_BITS-1:0]                                           m_axis_tuser,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]              comparisons,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]              recomputations,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]              stalls
);

  localparam PAYLOAD_BITS = (CARRIED != 0) ? OPERAND_BITS : TAG_BITS;
  localparam [SLOT_BITS:0] ONE = 1;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (OPERAND_BITS < 1) begin : g_refused_operand_bits
      OPERAND_BITS_is_below_1 refused ();
    end
    if (TAG_BITS < 1) begin : g_refused_tag_bits
      TAG_BITS_is_below_1 refused ();
    end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits
      SLOT_BITS_is_below_1 refused ();
    end
    if (LANE_LATENCY < 0) begin : g_refused_lane_latency
      LANE_LATENCY_is_below_0 refused ();
    end
    if (COUNTER_BITS < 0) begin : g_refused_counter_bits
      COUNTER_BITS_is_below_0 refused ();
    end
  endgenerate

  // Free slots: after reset a counter hands out each once, then they come back as they retire.
  reg  [SLOT_BITS:0]   fresh_q;
  wire                 recycled_valid;
  wire [SLOT_BITS-1:0] recycled_slot;
  wire                 fresh  = !fresh_q[SLOT_BITS];
  wire [SLOT_BITS-1:0] slot   = fresh ? fresh_q[SLOT_BITS-1:0] : recycled_slot;
  wire                 accept = s_axis_tvalid && s_axis_tready;
  wire                 retire;
  wire [SLOT_BITS-1:0] retire_slot;
  wire                 unused_recycled_ready;

  assign s_axis_tready = fresh || recycled_valid;
  assign lane_operands = s_axis_tdata;

  always @(posedge aclk) begin
    if (!aresetn) begin
      fresh_q <= {(SLOT_BITS+1){1'b0}};
    end else if (accept && fresh) begin
      fresh_q <= fresh_q + ONE;
    end
  end

  stream_fifo #(
    .WIDTH     (SLOT_BITS),
    .DEPTH_BITS(SLOT_BITS)
  ) recycled_slots (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(retire),
    .s_axis_tready(unused_recycled_ready),
    .s_axis_tdata (retire_slot),
    .m_axis_tvalid(recycled_valid),
    .m_axis_tready(accept && !fresh),
    .m_axis_tdata (recycled_slot)
  );

  // Through the lane.
  wire                    exit_valid;
  wire [SLOT_BITS-1:0]    exit_slot;
  wire [1:0]              exit_verdict;
  wire                    exit_decided;
  wire [PAYLOAD_BITS-1:0] payload;

  lane_tracker #(
    .PAYLOAD_BITS(PAYLOAD_BITS),
    .SLOT_BITS   (SLOT_BITS),
    .LANE_LATENCY(LANE_LATENCY),
    .RECOMPUTE   (RECOMPUTE)
  ) tracker (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .start_valid     (accept),
    .start_slot      (slot),
    .start_payload   (payload),
    .lane_verdict    (lane_verdict),
    .lane_decided    (lane_decided),
    .exit_valid      (exit_valid),
    .exit_slot       (exit_slot),
    .exit_verdict    (exit_verdict),
    .exit_decided    (exit_decided),
    .m_request_tvalid(m_request_tvalid),
    .m_request_tready(m_request_tready),
    .m_request_tdata (m_request_tdata)
  );

  generate
    if (CARRIED != 0) begin : g_carried
      assign payload = s_axis_tdata;
    end else begin : g_refetched
      assign payload = s_axis_tuser;
    end
  endgenerate

  // Results wait as {slot, undecided, recomputed, verdict}.
  wire                   direct_valid;
  wire                   direct_ready;
  wire [SLOT_BITS+4-1:0] direct_data;
  wire                   merged_valid;
  wire                   merged_ready;
  wire [3:0]             merged_result;
  wire                   unused_direct_ready;

  stream_fifo #(
    .WIDTH     (SLOT_BITS + 4),
    .DEPTH_BITS(SLOT_BITS)
  ) direct_results (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(exit_valid && (exit_decided || (RECOMPUTE == 0))),
    .s_axis_tready(unused_direct_ready),
    .s_axis_tdata ({exit_slot, !exit_decided, 1'b0, exit_verdict}),
    .m_axis_tvalid(direct_valid),
    .m_axis_tready(direct_ready),
    .m_axis_tdata (direct_data)
  );

  generate
    if (RECOMPUTE == 0) begin : g_direct
      wire unused_answer = &{s_answer_valid, s_answer_slot, s_answer_verdict};

      assign merged_valid                 = direct_valid;
      assign direct_ready                 = merged_ready;
      assign {retire_slot, merged_result} = direct_data;
    end else begin : g_merge
      wire                   answer_valid;
      wire                   answer_ready;
      wire [SLOT_BITS+2-1:0] answer_data;
      wire                   unused_answer_ready;
      wire [SLOT_BITS-1:0]   answer_slot    = answer_data[2 +: SLOT_BITS];
      wire [1:0]             answer_verdict = answer_data[1:0];

      stream_fifo #(
        .WIDTH     (SLOT_BITS + 2),
        .DEPTH_BITS(SLOT_BITS)
      ) answers (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(s_answer_valid),
        .s_axis_tready(unused_answer_ready),
        .s_axis_tdata ({s_answer_slot, s_answer_verdict}),
        .m_axis_tvalid(answer_valid),
        .m_axis_tready(answer_ready),
        .m_axis_tdata (answer_data)
      );

      stream_arbiter #(
        .INPUTS(2),
        .WIDTH (SLOT_BITS + 4)
      ) merge (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid({answer_valid, direct_valid}),
        .s_axis_tready({answer_ready, direct_ready}),
        .s_axis_tdata ({answer_slot, 2'b01, answer_verdict, direct_data}),
        .m_axis_tvalid(merged_valid),
        .m_axis_tready(merged_ready),
        .m_axis_tdata ({retire_slot, merged_result})
      );
    end
  endgenerate

  // Out: the tag is read by slot, and with that the slot is free.
  reg       m_valid_q;
  reg [3:0] m_result_q;

  assign merged_ready = !m_valid_q || m_axis_tready;
  assign retire       = merged_valid && merged_ready;

  always @(posedge aclk) begin
    if (!aresetn) begin
      m_valid_q <= 1'b0;
    end else begin
      m_valid_q <= retire || (m_valid_q && !m_axis_tready);
    end
  end

  always @(posedge aclk) begin
    if (retire) begin
      m_result_q <= merged_result;
    end
  end

  dual_port_memory #(
    .WIDTH       (TAG_BITS),
    .ADDRESS_BITS(SLOT_BITS)
  ) tags (
    .aclk         (aclk),
    .write_enable (accept),
    .write_address(slot),
    .write_data   (s_axis_tuser),
    .read_enable  (retire),
    .read_address (retire_slot),
    .read_data    (m_axis_tuser)
  );

  assign m_axis_tvalid = m_valid_q;
  assign m_axis_tdata  = {4'b0000, m_result_q};

  lane_counters #(
    .COUNTER_BITS(COUNTER_BITS)
  ) counters (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .s_axis_tvalid   (s_axis_tvalid),
    .s_axis_tready   (s_axis_tready),
    .request_sent    (m_request_tvalid && m_request_tready),
    .undecided_result(m_axis_tvalid && m_axis_tready && m_result_q[3]),
    .comparisons     (comparisons),
    .recomputations  (recomputations),
    .stalls          (stalls)
  );

endmodule

`default_nettype wire
