// lane_scoreboard: AXI4-Stream around one free-running lane; results leave as they come. A
// comparison holds a slot from its acceptance until its tag is read out, so every queue has room. A
// decided comparison has latency LANE_LATENCY + 5. One comparison per cycle if all are decided, the
// sink is ready and 2^SLOT_BITS >= LANE_LATENCY + 6 (+ 5 with RECOMPUTE = 0, where the latency is
// LANE_LATENCY + 4). Direct and recomputed results alternate when both wait.
//
// LANES > 1: a group of lanes in lock step. Everything here about a comparison then holds for a
// word, with one comparison for each lane and one tag; lane k's own tag is the word's + k. Each
// undecided comparison has its own request, and the word leaves once all are answered.
//
// A request of carried operands is a packet of beats {slot, part of the operands}. Reset forgets
// all comparisons and clears the counters.
`default_nettype none

module lane_scoreboard #(
  parameter LANES = 1,           // lanes in lock step, 1 to 64
  parameter OPERAND_BITS = 128,  // bits of a comparison's operands, 1 or more
  parameter TAG_BITS = 32,       // bits of a tag (m_axis_tuser), 1 or more
  // 1 to 30, with carried operands to 20: 2^SLOT_BITS comparisons may be in flight
  parameter SLOT_BITS = 5,
  parameter LANE_LATENCY = 16,   // latency of the lane in cycles, 0 or more
  parameter COUNTER_BITS = 32,   // bits of a counter, which wraps; 0: no counters
  parameter RECOMPUTE = 1,       // 1: undecided comparisons are recomputed; 0: they are results
  parameter CARRIED = 1,         // 1: a request carries the operands; 0: the tag
  // 0 to 8: a packet has 2^BEAT_BITS beats; LANES << BEAT_BITS is at most 256
  parameter BEAT_BITS = 0,
  parameter BLOCK = 0,           // 0 or 1: the kind of memory, as in beat_memory
  parameter INPUT_REGISTERS = 0  // registers in front of the lane, 0 or more, added to its latency
) (
  input  wire                                                                         aclk,
  input  wire                                                                         aresetn,
  input  wire                                                                         s_axis_tvalid,
  output wire                                                                         s_axis_tready,
  input  wire [LANES*OPERAND_BITS-1:0]                                                s_axis_tdata,
  input  wire [TAG_BITS-1:0]                                                          s_axis_tuser,
  output wire [LANES*OPERAND_BITS-1:0]                                                lane_operands,
  input  wire [2*LANES-1:0]                                                           lane_verdict,
  input  wire [LANES-1:0]                                                             lane_decided,
  output wire                                                                         m_request_tvalid,
  input  wire                                                                         m_request_tready,
  output wire [SLOT_BITS+(CARRIED != 0 ? (OPERAND_BITS-1)>>BEAT_BITS : TAG_BITS-1):0] m_request_tdata,
  input  wire                                                                         s_answer_valid,
  input  wire [SLOT_BITS-1:0]                                                         s_answer_slot,
  input  wire [1:0]                                                                   s_answer_verdict,
  output wire                                                                         m_axis_tvalid,
  input  wire                                                                         m_axis_tready,
  output wire [8*LANES-1:0]                                                           m_axis_tdata,
  output wire [TAG_BITS-1:0]                                                          m_axis_tuser,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]                             comparisons,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]                             recomputations,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]                             stalls
);

  localparam PART_BITS      = ((OPERAND_BITS - 1) >> BEAT_BITS) + 1;
  localparam REQUEST_BITS   = SLOT_BITS + ((CARRIED != 0) ? PART_BITS : TAG_BITS);
  // SENDS_OPERANDS: the operands of an undecided comparison leave at once. Otherwise the comparison
  // waits among the results until its tag is read. With SENDS_TAG the tag then leaves as a request,
  // without it the comparison leaves as a result.
  localparam SENDS_OPERANDS = ((RECOMPUTE != 0) && (CARRIED != 0)) ? 1 : 0;
  localparam SENDS_TAG      = ((RECOMPUTE != 0) && (CARRIED == 0)) ? 1 : 0;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((LANES < 1) || (LANES > 64)) begin : g_refused_lanes LANES_is_not_1_to_64 refused (); end
    if (OPERAND_BITS < 1) begin : g_refused_operand_bits OPERAND_BITS_is_below_1 refused (); end
    if (TAG_BITS < 1) begin : g_refused_tag_bits TAG_BITS_is_below_1 refused (); end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits SLOT_BITS_is_below_1 refused (); end
    if (LANE_LATENCY < 0) begin : g_refused_lane_latency LANE_LATENCY_is_below_0 refused (); end
    if (COUNTER_BITS < 0) begin : g_refused_counter_bits COUNTER_BITS_is_below_0 refused (); end
    if ((BEAT_BITS < 0) || (BEAT_BITS > 8))
      begin : g_refused_beat_bits BEAT_BITS_is_not_0_to_8 refused (); end
    if (INPUT_REGISTERS < 0)
      begin : g_refused_input_registers INPUT_REGISTERS_is_below_0 refused (); end
  endgenerate

  // Each comparison takes a slot, which is free again when its result leaves.
  wire                 slot_valid;
  wire [SLOT_BITS-1:0] slot;
  wire                 accept = s_axis_tvalid && slot_valid;
  wire                 retire;
  wire [SLOT_BITS-1:0] retire_slot;

  assign s_axis_tready = slot_valid;

  slot_pool #(
    .SLOT_BITS(SLOT_BITS)
  ) slots (
    .aclk        (aclk),
    .aresetn     (aresetn),
    .m_slot_valid(slot_valid),
    .m_slot_ready(s_axis_tvalid),
    .m_slot      (slot),
    .s_free_valid(retire),
    .s_free_slot (retire_slot)
  );

  // Operands pass the lane.
  delay_line #(
    .WIDTH (LANES * OPERAND_BITS),
    .LENGTH(INPUT_REGISTERS)
  ) operands_to_lane (
    .aclk(aclk),
    .d   (s_axis_tdata),
    .q   (lane_operands)
  );

  wire                 exit_valid;
  wire [SLOT_BITS-1:0] exit_slot;
  wire [2*LANES-1:0]   exit_verdict;
  wire [LANES-1:0]     exit_decided;
  wire                 exit_undecided = exit_valid && !(&exit_decided);  // in some lane

  lane_tracker #(
    .LANES       (LANES),
    .SLOT_BITS   (SLOT_BITS),
    .LANE_LATENCY(LANE_LATENCY + INPUT_REGISTERS)
  ) tracker (
    .aclk        (aclk),
    .aresetn     (aresetn),
    .start_valid (accept),
    .start_slot  (slot),
    .lane_verdict(lane_verdict),
    .lane_decided(lane_decided),
    .exit_valid  (exit_valid),
    .exit_slot   (exit_slot),
    .exit_verdict(exit_verdict),
    .exit_decided(exit_decided)
  );

  // Verdicts of the lanes wait as {slot, undecided, verdicts}.
  wire                 direct_valid;
  wire                 direct_ready;
  wire [SLOT_BITS-1:0] direct_slot;
  wire [LANES-1:0]     direct_undecided;
  wire [2*LANES-1:0]   direct_verdict;
  wire                 unused_direct_ready;

  stream_fifo #(
    .WIDTH     (SLOT_BITS + 3 * LANES),
    .DEPTH_BITS(SLOT_BITS)
  ) direct_results (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(exit_valid && (!exit_undecided || (SENDS_OPERANDS == 0))),
    .s_axis_tready(unused_direct_ready),
    .s_axis_tdata ({exit_slot, ~exit_decided & {LANES{SENDS_OPERANDS == 0}}, exit_verdict}),
    .m_axis_tvalid(direct_valid),
    .m_axis_tready(direct_ready),
    .m_axis_tdata ({direct_slot, direct_undecided, direct_verdict})
  );

  // Results on their way out are {undecided, recomputed, verdicts}.
  wire                 merged_valid;
  wire                 merged_ready;
  wire [SLOT_BITS-1:0] merged_slot;
  wire [4*LANES-1:0]   merged_result;

  generate
    if (RECOMPUTE == 0) begin : g_direct
      wire unused_answer = &{s_answer_valid, s_answer_slot, s_answer_verdict};

      assign merged_valid  = direct_valid;
      assign direct_ready  = merged_ready;
      assign merged_slot   = direct_slot;
      assign merged_result = {direct_undecided, {LANES{1'b0}}, direct_verdict};
    end else begin : g_merge
      wire                 answer_valid;
      wire                 answer_ready;
      wire [SLOT_BITS-1:0] answer_slot;
      wire [LANES-1:0]     answer_recomputed;
      wire [2*LANES-1:0]   answer_verdict;

      lane_answers #(
        .LANES    (LANES),
        .SLOT_BITS(SLOT_BITS)
      ) answers (
        .aclk             (aclk),
        .aresetn          (aresetn),
        .s_word_valid     (exit_undecided),
        .s_word_slot      (exit_slot),
        .s_word_undecided (~exit_decided),
        .s_word_verdict   (exit_verdict),
        .s_answer_valid   (s_answer_valid),
        .s_answer_slot    (s_answer_slot),
        .s_answer_verdict (s_answer_verdict),
        .m_axis_tvalid    (answer_valid),
        .m_axis_tready    (answer_ready),
        .m_axis_slot      (answer_slot),
        .m_axis_recomputed(answer_recomputed),
        .m_axis_verdict   (answer_verdict)
      );

      stream_arbiter #(
        .INPUTS(2),
        .WIDTH (SLOT_BITS + 4 * LANES)
      ) merge (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid({answer_valid, direct_valid}),
        .s_axis_tready({answer_ready, direct_ready}),
        .s_axis_tdata ({answer_slot, {LANES{1'b0}}, answer_recomputed, answer_verdict,
                        direct_slot, direct_undecided, {LANES{1'b0}}, direct_verdict}),
        .m_axis_tvalid(merged_valid),
        .m_axis_tready(merged_ready),
        .m_axis_tdata ({merged_slot, merged_result})
      );
    end
  endgenerate

  // Output: the tag is read by slot, which frees the slot unless the comparison only asks.
  wire [LANES-1:0]              asks = merged_result[3*LANES +: LANES] & {LANES{SENDS_TAG != 0}};
  wire                          tag_request_valid;
  wire [SLOT_BITS+TAG_BITS-1:0] tag_request_data;

  assign retire      = merged_valid && merged_ready && !(|asks);
  assign retire_slot = merged_slot;

  lane_tags #(
    .LANES    (LANES),
    .TAG_BITS (TAG_BITS),
    .SLOT_BITS(SLOT_BITS)
  ) tags (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .start_valid     (accept),
    .start_slot      (slot),
    .start_tag       (s_axis_tuser),
    .s_result_valid  (merged_valid),
    .s_result_ready  (merged_ready),
    .s_result_slot   (merged_slot),
    .s_result_asks   (asks),
    .s_result        (merged_result),
    .m_request_tvalid(tag_request_valid),
    .m_request_tready(m_request_tready),
    .m_request_tdata (tag_request_data),
    .m_axis_tvalid   (m_axis_tvalid),
    .m_axis_tready   (m_axis_tready),
    .m_axis_tdata    (m_axis_tdata),
    .m_axis_tuser    (m_axis_tuser)
  );

  // Whole requests are counted, when their last beat leaves.
  wire request_last;

  generate
    if (SENDS_TAG != 0) begin : g_refetched
      assign m_request_tvalid = tag_request_valid;
      assign m_request_tdata  = tag_request_data;
    end else begin : g_no_tag_requests
      wire unused_tag_request = &{tag_request_valid, tag_request_data};
    end
    if (SENDS_OPERANDS != 0) begin : g_carried
      carried_operands #(
        .LANES       (LANES),
        .OPERAND_BITS(OPERAND_BITS),
        .SLOT_BITS   (SLOT_BITS),
        .BEAT_BITS   (BEAT_BITS),
        .BLOCK       (BLOCK)
      ) operands (
        .aclk            (aclk),
        .aresetn         (aresetn),
        .start_valid     (accept),
        .start_slot      (slot),
        .start_operands  (s_axis_tdata),
        .undecided_valid (exit_undecided),
        .undecided_slot  (exit_slot),
        .undecided_lanes (~exit_decided),
        .m_request_tvalid(m_request_tvalid),
        .m_request_tready(m_request_tready),
        .m_request_tdata (m_request_tdata),
        .m_request_tlast (request_last)
      );
    end else begin : g_one_beat
      assign request_last = 1'b1;
    end
    if (RECOMPUTE == 0) begin : g_no_requests
      assign m_request_tvalid = 1'b0;
      assign m_request_tdata  = {REQUEST_BITS{1'b0}};
    end
  endgenerate

  // Without references an undecided comparison is a result, counted as it leaves.
  wire [LANES-1:0] undecided_results;

  genvar k;
  generate
    for (k = 0; k < LANES; k = k + 1) begin : g_result
      assign undecided_results[k] = (RECOMPUTE == 0) && m_axis_tvalid && m_axis_tready &&
                                    m_axis_tdata[8*k+3];
    end
  endgenerate

  lane_counters #(
    .LANES       (LANES),
    .COUNTER_BITS(COUNTER_BITS)
  ) counters (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .s_axis_tvalid   (s_axis_tvalid),
    .s_axis_tready   (s_axis_tready),
    .request_sent    (m_request_tvalid && m_request_tready && request_last),
    .undecided_result(undecided_results),
    .comparisons     (comparisons),
    .recomputations  (recomputations),
    .stalls          (stalls)
  );

endmodule

`default_nettype wire
