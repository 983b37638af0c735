// lane_reorder: AXI4-Stream around one free-running lane; results leave in the order of acceptance.
// The lane keeps order, and so do the answers: one reference serves a lane, first come, first
// served. Direct verdicts wait in one queue, answers in another. An undecided entry at the head of
// the first queue takes the head of the second. Slots are used circularly. A decided comparison has
// latency LANE_LATENCY + 4. One comparison per cycle if all are decided, the sink is ready and
// 2^SLOT_BITS >= LANE_LATENCY + 4.
//
// LANES > 1: a group of lanes in lock step. Everything here about a comparison then holds for a
// word, with one comparison for each lane and one tag; lane k's own tag is the word's + k. Each
// undecided comparison has its own request, and the word leaves once all are answered.
//
// A request of carried operands is a packet of beats {slot, part of the operands}. Reset forgets
// all comparisons and clears the counters.
`default_nettype none

module lane_reorder #(
  parameter LANES = 1,           // lanes in lock step, 1 to 64
  parameter OPERAND_BITS = 128,  // bits of a comparison's operands, 1 or more
  parameter TAG_BITS = 32,       // bits of a tag (m_axis_tuser), 1 or more
  // 1 to 30, with carried operands to 20: 2^SLOT_BITS comparisons may be in flight
  parameter SLOT_BITS = 5,
  parameter LANE_LATENCY = 16,   // latency of the lane in cycles, 0 or more
  parameter COUNTER_BITS = 32,   // bits of a counter, which wraps; 0: no counters
  parameter RECOMPUTE = 1,       // 1: undecided comparisons are recomputed; 0: they are results
  parameter CARRIED = 1,         // 1: a request carries the operands (but see ASK_BITS); 0: the tag
  // 0 to TAG_BITS; 0 with LANES > 1. Above 0, the low bits of the tag are carried instead of the
  // operands, and references ask for the operands by them.
  parameter ASK_BITS = 0,
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
  output wire [SLOT_BITS+(CARRIED != 0 ? ((ASK_BITS > 0 ? ASK_BITS : OPERAND_BITS)-1)>>BEAT_BITS : TAG_BITS-1):0] m_request_tdata,
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

  localparam CARRIED_BITS = (ASK_BITS > 0) ? ASK_BITS : OPERAND_BITS;
  localparam PART_BITS    = ((CARRIED_BITS - 1) >> BEAT_BITS) + 1;
  localparam REQUEST_BITS = SLOT_BITS + ((CARRIED != 0) ? PART_BITS : TAG_BITS);
  localparam [SLOT_BITS:0] ONE = 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((LANES < 1) || (LANES > 64)) begin : g_refused_lanes LANES_is_not_1_to_64 refused (); end
    if (OPERAND_BITS < 1) begin : g_refused_operand_bits OPERAND_BITS_is_below_1 refused (); end
    if (TAG_BITS < 1) begin : g_refused_tag_bits
      TAG_BITS_is_below_1 refused ();
    end else if ((ASK_BITS < 0) || (ASK_BITS > TAG_BITS)) begin : g_refused_ask_bits
      ASK_BITS_is_not_0_to_TAG_BITS refused ();
    end else if ((ASK_BITS > 0) && (LANES > 1)) begin : g_refused_asking_group
      ASK_BITS_is_not_0_with_LANES_above_1 refused ();
    end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits SLOT_BITS_is_below_1 refused (); end
    if (LANE_LATENCY < 0) begin : g_refused_lane_latency LANE_LATENCY_is_below_0 refused (); end
    if (COUNTER_BITS < 0) begin : g_refused_counter_bits COUNTER_BITS_is_below_0 refused (); end
    if ((BEAT_BITS < 0) || (BEAT_BITS > 8))
      begin : g_refused_beat_bits BEAT_BITS_is_not_0_to_8 refused (); end
    if (INPUT_REGISTERS < 0)
      begin : g_refused_input_registers INPUT_REGISTERS_is_below_0 refused (); end
  endgenerate

  // Slots oldest_q to next_q - 1 are taken. One bit more than a slot tells full from empty.
  reg  [SLOT_BITS:0] next_q;
  reg  [SLOT_BITS:0] oldest_q;
  wire               same_slot = (next_q[SLOT_BITS-1:0] == oldest_q[SLOT_BITS-1:0]);
  wire               same_lap  = (next_q[SLOT_BITS] == oldest_q[SLOT_BITS]);
  wire               accept    = s_axis_tvalid && s_axis_tready;
  wire               retire;

  assign s_axis_tready = !same_slot || same_lap;

  always @(posedge aclk) begin
    if (!aresetn) begin
      next_q   <= {(SLOT_BITS+1){1'b0}};
      oldest_q <= {(SLOT_BITS+1){1'b0}};
    end else begin
      if (accept) begin
        next_q <= next_q + ONE;
      end
      if (retire) begin
        oldest_q <= oldest_q + ONE;
      end
    end
  end

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
    .start_slot  (next_q[SLOT_BITS-1:0]),
    .lane_verdict(lane_verdict),
    .lane_decided(lane_decided),
    .exit_valid  (exit_valid),
    .exit_slot   (exit_slot),
    .exit_verdict(exit_verdict),
    .exit_decided(exit_decided)
  );

  // Direct verdicts wait in the order of acceptance, as {decided, verdicts}. With references it is
  // enough to know whether all lanes have decided.
  localparam FLAGS = (RECOMPUTE != 0) ? 1 : LANES;

  wire               direct_valid;
  wire [FLAGS-1:0]   exit_flags;
  wire [FLAGS-1:0]   direct_decided;
  wire [2*LANES-1:0] direct_verdict;
  wire               unused_direct_ready;

  stream_fifo #(
    .WIDTH     (FLAGS + 2 * LANES),
    .DEPTH_BITS(SLOT_BITS)
  ) direct_results (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(exit_valid),
    .s_axis_tready(unused_direct_ready),
    .s_axis_tdata ({exit_flags, exit_verdict}),
    .m_axis_tvalid(direct_valid),
    .m_axis_tready(retire),
    .m_axis_tdata ({direct_decided, direct_verdict})
  );

  // The head's result as {undecided, recomputed, verdicts}.
  wire               head_valid;
  wire [4*LANES-1:0] head_result;

  generate
    if (RECOMPUTE == 0) begin : g_direct
      wire unused_answer = &{s_answer_valid, s_answer_slot, s_answer_verdict};

      assign exit_flags  = exit_decided;
      assign head_valid  = direct_valid;
      assign head_result = {~direct_decided, {LANES{1'b0}}, direct_verdict};
    end else begin : g_merge
      wire                 answer_valid;
      wire [LANES-1:0]     answer_recomputed;
      wire [2*LANES-1:0]   answer_verdict;
      wire [SLOT_BITS-1:0] unused_slot;

      lane_answers #(
        .LANES    (LANES),
        .SLOT_BITS(SLOT_BITS),
        .WITH_SLOT(0)
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
        .m_axis_tready    (retire && !direct_decided),
        .m_axis_slot      (unused_slot),
        .m_axis_recomputed(answer_recomputed),
        .m_axis_verdict   (answer_verdict)
      );

      assign exit_flags  = &exit_decided;
      assign head_valid  = direct_valid && (direct_decided || answer_valid);
      assign head_result = direct_decided ? {{LANES{1'b0}}, {LANES{1'b0}}, direct_verdict}
                                          : {{LANES{1'b0}}, answer_recomputed, answer_verdict};
    end
  endgenerate

  // Output: the tag of the oldest slot is read, which frees the slot. If the tag is also the
  // request, a comparison that asks has priority.
  wire                          asks;
  wire [SLOT_BITS-1:0]          asking_slot;
  wire [LANES-1:0]              asking_lanes;
  wire                          read_ready;
  wire                          tag_request_valid;
  wire [SLOT_BITS+TAG_BITS-1:0] tag_request_data;

  assign retire = head_valid && !asks && read_ready;

  lane_tags #(
    .LANES    (LANES),
    .TAG_BITS (TAG_BITS),
    .SLOT_BITS(SLOT_BITS)
  ) tags (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .start_valid     (accept),
    .start_slot      (next_q[SLOT_BITS-1:0]),
    .start_tag       (s_axis_tuser),
    .s_result_valid  (head_valid || asks),
    .s_result_ready  (read_ready),
    .s_result_slot   (asks ? asking_slot : oldest_q[SLOT_BITS-1:0]),
    .s_result_asks   (asking_lanes & {LANES{asks}}),
    .s_result        (head_result),
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
    if ((RECOMPUTE != 0) && (CARRIED == 0)) begin : g_refetched
      localparam MARKS = (LANES == 1) ? 0 : LANES;  // a slot of one lane needs no mark

      wire [MARKS+SLOT_BITS-1:0] exit_asks;
      wire [MARKS+SLOT_BITS-1:0] asking;
      wire                       unused_ready;

      stream_fifo #(
        .WIDTH     (MARKS + SLOT_BITS),
        .DEPTH_BITS(SLOT_BITS)
      ) asking_slots (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(exit_undecided),
        .s_axis_tready(unused_ready),
        .s_axis_tdata (exit_asks),
        .m_axis_tvalid(asks),
        .m_axis_tready(read_ready),
        .m_axis_tdata (asking)
      );

      assign exit_asks[SLOT_BITS-1:0] = exit_slot;
      assign asking_slot              = asking[SLOT_BITS-1:0];
      if (LANES == 1) begin : g_one_lane
        assign asking_lanes = 1'b1;
      end else begin : g_group
        assign exit_asks[SLOT_BITS +: LANES] = ~exit_decided;
        assign asking_lanes                  = asking[SLOT_BITS +: LANES];
      end

      assign m_request_tvalid = tag_request_valid;
      assign m_request_tdata  = tag_request_data;
    end else begin : g_no_tag_requests
      wire unused_tag_request = &{tag_request_valid, tag_request_data};

      assign asks         = 1'b0;
      assign asking_slot  = {SLOT_BITS{1'b0}};
      assign asking_lanes = {LANES{1'b0}};
    end
    if (RECOMPUTE == 0) begin : g_no_requests
      wire unused_exit = &{exit_slot, exit_undecided, m_request_tready};

      assign m_request_tvalid = 1'b0;
      assign m_request_tdata  = {REQUEST_BITS{1'b0}};
    end
    if ((RECOMPUTE != 0) && (CARRIED != 0)) begin : g_carried
      wire [LANES*CARRIED_BITS-1:0] carried;

      if (ASK_BITS > 0) begin : g_names
        assign carried = s_axis_tuser[CARRIED_BITS-1:0];
      end else begin : g_operands
        assign carried = s_axis_tdata;
      end

      carried_operands #(
        .LANES       (LANES),
        .OPERAND_BITS(CARRIED_BITS),
        .SLOT_BITS   (SLOT_BITS),
        .BEAT_BITS   (BEAT_BITS),
        .BLOCK       (BLOCK)
      ) operands (
        .aclk            (aclk),
        .aresetn         (aresetn),
        .start_valid     (accept),
        .start_slot      (next_q[SLOT_BITS-1:0]),
        .start_operands  (carried),
        .undecided_valid (exit_undecided),
        .undecided_slot  (exit_slot),
        .undecided_lanes (~exit_decided),
        .m_request_tvalid(m_request_tvalid),
        .m_request_tready(m_request_tready),
        .m_request_tdata (m_request_tdata),
        .m_request_tlast (request_last)
      );
    end
    if ((RECOMPUTE == 0) || (CARRIED == 0)) begin : g_one_beat
      assign request_last = 1'b1;
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
