// stream_system_bench: lanes, crossbar and references with stubs for the datapaths. The stubs make
// a comparison's result a function of only its operand word (`word` of the first 32 bits):
//   lane's verdict word[1:0] ^ word[11:10], decided word[2], reference's verdict word[9:8] ^ word[17:16].
// The reference reads word[17:16] in phase LAST_OPERAND_PHASE, the rest in phase 0. The operands are
// COPIES rotated copies of the word: the lane looks at the lowest, the reference at the highest.
// GROUP > 1: LANES groups of so many lanes, at most 4. Lane k of a group has the group's word with
// bit 23 + k in the place of bit 2 (lane 0: its own), and k added to its verdicts without carry.
// Every port has room for 32 lanes or 16 references, 32 bits each.
`default_nettype none

module stream_system_bench #(
  parameter LANES = 8,
  parameter REFERENCES = 1,
  parameter IN_ORDER = 0,
  parameter CARRIED = 1,
  parameter LANE_LATENCY = 4,
  parameter REFERENCE_LATENCY = 7,
  parameter INITIATION_INTERVAL = 1,
  parameter LAST_OPERAND_PHASE = 0,
  parameter SLOT_BITS = 4,
  parameter OUTSTANDING_BITS = 2,
  parameter COPIES = 1,
  parameter BEAT_BITS = 0,
  parameter BLOCK = 0,
  parameter INPUT_REGISTERS = 0,
  parameter GROUP = 1
) (
  input  wire          aclk,
  input  wire          aresetn,
  input  wire [31:0]   s_valid,
  output wire [31:0]   s_ready,
  input  wire [1023:0] s_operands,
  input  wire [1023:0] s_tags,
  output wire [31:0]   m_valid,
  input  wire [31:0]   m_ready,
  output wire [1023:0] m_results,
  output wire [1023:0] m_tags,
  output wire [1023:0] comparisons,
  output wire [1023:0] recomputations,
  output wire [1023:0] stalls,
  output wire [15:0]   m_refetch_valid,
  input  wire [15:0]   m_refetch_ready,
  output wire [511:0]  m_refetch_tags,
  input  wire [15:0]   s_refetch_valid,
  output wire [15:0]   s_refetch_ready,
  input  wire [511:0]  s_refetch_operands
);

  localparam LANE_BITS    = 5;
  localparam OPERAND_BITS = 32 * COPIES;
  localparam PAYLOAD_BITS = (CARRIED != 0) ? ((OPERAND_BITS - 1) >> BEAT_BITS) + 1 : 32;
  localparam REQUEST_BITS = SLOT_BITS + PAYLOAD_BITS;
  localparam NAMED_BITS   = LANE_BITS + REQUEST_BITS;
  localparam ANSWER_BITS  = LANE_BITS + SLOT_BITS + 2;
  localparam RECOMPUTE    = (REFERENCES > 0) ? 1 : 0;

  wire [LANES-1:0]              request_valid;
  wire [LANES-1:0]              request_ready;
  wire [LANES*REQUEST_BITS-1:0] request_data;
  wire [LANES-1:0]              answer_valid;
  wire [LANES*SLOT_BITS-1:0]    answer_slot;
  wire [LANES*2-1:0]            answer_verdict;

  genvar i;
  genvar c;
  genvar k;
  generate
    for (i = 0; i < 32; i = i + 1) begin : g_lane
      if (i >= LANES) begin : g_absent
        wire unused_inputs = &{s_valid[i], m_ready[i], s_operands[32*i +: 32], s_tags[32*i +: 32]};

        assign s_ready[i]                 = 1'b0;
        assign m_valid[i]                 = 1'b0;
        assign m_results[32*i +: 32]      = 32'd0;
        assign m_tags[32*i +: 32]         = 32'd0;
        assign comparisons[32*i +: 32]    = 32'd0;
        assign recomputations[32*i +: 32] = 32'd0;
        assign stalls[32*i +: 32]         = 32'd0;
      end else begin : g_present
        wire [31:0]                   word = s_operands[32*i +: 32];
        wire [GROUP*OPERAND_BITS-1:0] operands;
        wire [GROUP*OPERAND_BITS-1:0] lane_operands;
        wire [2*GROUP-1:0]            verdict;
        wire [GROUP-1:0]              decided;

        for (k = 0; k < GROUP; k = k + 1) begin : g_member
          localparam [1:0] NUMBER = k;

          wire [31:0]             own_word = {word[31:10], word[9:8] ^ NUMBER, word[7:3],
                                              word[(k == 0) ? 2 : 23 + k], word[1:0] ^ NUMBER};
          wire [OPERAND_BITS-1:0] own = lane_operands[k*OPERAND_BITS +: OPERAND_BITS];
          wire                    unused_own = &own;
          wire [1:0]              verdict_in = own[1:0] ^ own[11:10];

          for (c = 0; c < COPIES; c = c + 1) begin : g_copy
            if (c % 32 == 0) begin : g_plain
              assign operands[k*OPERAND_BITS+32*c +: 32] = own_word;
            end else begin : g_rotated
              assign operands[k*OPERAND_BITS+32*c +: 32] = {own_word[(c%32)-1:0],
                                                            own_word[31:c%32]};
            end
          end

          delay_line #(
            .WIDTH (3),
            .LENGTH(LANE_LATENCY)
          ) lane (
            .aclk(aclk),
            .d   ({own[2], verdict_in}),
            .q   ({decided[k], verdict[2*k +: 2]})
          );
        end

        if (GROUP < 4) begin : g_no_results
          assign m_results[32*i+8*GROUP +: 32-8*GROUP] = {(32-8*GROUP){1'b0}};
        end

        if (IN_ORDER != 0) begin : g_reorder
          lane_reorder #(
            .OPERAND_BITS   (OPERAND_BITS),
            .TAG_BITS       (32),
            .SLOT_BITS      (SLOT_BITS),
            .LANE_LATENCY   (LANE_LATENCY),
            .COUNTER_BITS   (32),
            .RECOMPUTE      (RECOMPUTE),
            .CARRIED        (CARRIED),
            .BEAT_BITS      (BEAT_BITS),
            .BLOCK          (BLOCK),
            .INPUT_REGISTERS(INPUT_REGISTERS),
            .LANES          (GROUP)
          ) channel (
            .aclk            (aclk),
            .aresetn         (aresetn),
            .s_axis_tvalid   (s_valid[i]),
            .s_axis_tready   (s_ready[i]),
            .s_axis_tdata    (operands),
            .s_axis_tuser    (s_tags[32*i +: 32]),
            .lane_operands   (lane_operands),
            .lane_verdict    (verdict),
            .lane_decided    (decided),
            .m_request_tvalid(request_valid[i]),
            .m_request_tready(request_ready[i]),
            .m_request_tdata (request_data[i*REQUEST_BITS +: REQUEST_BITS]),
            .s_answer_valid  (answer_valid[i]),
            .s_answer_slot   (answer_slot[i*SLOT_BITS +: SLOT_BITS]),
            .s_answer_verdict(answer_verdict[i*2 +: 2]),
            .m_axis_tvalid   (m_valid[i]),
            .m_axis_tready   (m_ready[i]),
            .m_axis_tdata    (m_results[32*i +: 8*GROUP]),
            .m_axis_tuser    (m_tags[32*i +: 32]),
            .comparisons     (comparisons[32*i +: 32]),
            .recomputations  (recomputations[32*i +: 32]),
            .stalls          (stalls[32*i +: 32])
          );
        end else begin : g_scoreboard
          lane_scoreboard #(
            .OPERAND_BITS   (OPERAND_BITS),
            .TAG_BITS       (32),
            .SLOT_BITS      (SLOT_BITS),
            .LANE_LATENCY   (LANE_LATENCY),
            .COUNTER_BITS   (32),
            .RECOMPUTE      (RECOMPUTE),
            .CARRIED        (CARRIED),
            .BEAT_BITS      (BEAT_BITS),
            .BLOCK          (BLOCK),
            .INPUT_REGISTERS(INPUT_REGISTERS),
            .LANES          (GROUP)
          ) channel (
            .aclk            (aclk),
            .aresetn         (aresetn),
            .s_axis_tvalid   (s_valid[i]),
            .s_axis_tready   (s_ready[i]),
            .s_axis_tdata    (operands),
            .s_axis_tuser    (s_tags[32*i +: 32]),
            .lane_operands   (lane_operands),
            .lane_verdict    (verdict),
            .lane_decided    (decided),
            .m_request_tvalid(request_valid[i]),
            .m_request_tready(request_ready[i]),
            .m_request_tdata (request_data[i*REQUEST_BITS +: REQUEST_BITS]),
            .s_answer_valid  (answer_valid[i]),
            .s_answer_slot   (answer_slot[i*SLOT_BITS +: SLOT_BITS]),
            .s_answer_verdict(answer_verdict[i*2 +: 2]),
            .m_axis_tvalid   (m_valid[i]),
            .m_axis_tready   (m_ready[i]),
            .m_axis_tdata    (m_results[32*i +: 8*GROUP]),
            .m_axis_tuser    (m_tags[32*i +: 32]),
            .comparisons     (comparisons[32*i +: 32]),
            .recomputations  (recomputations[32*i +: 32]),
            .stalls          (stalls[32*i +: 32])
          );
        end
      end
    end

    if (REFERENCES == 0) begin : g_lanes_only
      wire unused_requests = &{request_valid, request_data};

      assign request_ready  = {LANES{1'b0}};
      assign answer_valid   = {LANES{1'b0}};
      assign answer_slot    = {(LANES*SLOT_BITS){1'b0}};
      assign answer_verdict = {(LANES*2){1'b0}};
    end else begin : g_crossbar
      wire [REFERENCES-1:0]             named_valid;
      wire [REFERENCES-1:0]             named_ready;
      wire [REFERENCES*NAMED_BITS-1:0]  named_data;
      wire [REFERENCES-1:0]             reply_valid;
      wire [REFERENCES*ANSWER_BITS-1:0] reply_data;

      stream_crossbar #(
        .LANES       (LANES),
        .REFERENCES  (REFERENCES),
        .LANE_BITS   (LANE_BITS),
        .SLOT_BITS   (SLOT_BITS),
        .PAYLOAD_BITS(PAYLOAD_BITS),
        .BEAT_BITS   (BEAT_BITS)
      ) between (
        .aclk            (aclk),
        .aresetn         (aresetn),
        .s_request_tvalid(request_valid),
        .s_request_tready(request_ready),
        .s_request_tdata (request_data),
        .m_request_tvalid(named_valid),
        .m_request_tready(named_ready),
        .m_request_tdata (named_data),
        .s_answer_valid  (reply_valid),
        .s_answer_tdata  (reply_data),
        .m_answer_valid  (answer_valid),
        .m_answer_slot   (answer_slot),
        .m_answer_verdict(answer_verdict)
      );

      for (i = 0; i < REFERENCES; i = i + 1) begin : g_reference
        localparam TOP    = COPIES - 1;
        localparam ROTATE = TOP % 32;

        wire [OPERAND_BITS-1:0] refetched;
        wire [OPERAND_BITS-1:0] operands;
        wire                    unused_operands = &operands;
        wire [31:0]             top_copy = operands[32*TOP +: 32];
        wire [63:0]             twice    = {top_copy, top_copy};
        wire [31:0]             word     = twice[32-ROTATE +: 32];
        wire                    unused_word = &{word, twice};
        wire [1:0]              early;
        wire [1:0]              verdict;
        wire [3:0]              unused_phase;

        for (c = 0; c < COPIES; c = c + 1) begin : g_copy
          if (c % 32 == 0) begin : g_plain
            assign refetched[32*c +: 32] = s_refetch_operands[32*i +: 32];
          end else begin : g_rotated
            assign refetched[32*c +: 32] = {s_refetch_operands[32*i +: (c%32)],
                                            s_refetch_operands[32*i+(c%32) +: 32-(c%32)]};
          end
        end

        delay_line #(
          .WIDTH (2),
          .LENGTH(LAST_OPERAND_PHASE)
        ) reference_begin (
          .aclk(aclk),
          .d   (word[9:8]),
          .q   (early)
        );

        delay_line #(
          .WIDTH (2),
          .LENGTH(REFERENCE_LATENCY - LAST_OPERAND_PHASE)
        ) reference (
          .aclk(aclk),
          .d   (early ^ word[17:16]),
          .q   (verdict)
        );

        reference_port #(
          .OPERAND_BITS     (OPERAND_BITS),
          .TAG_BITS         (32),
          .LANE_BITS        (LANE_BITS),
          .SLOT_BITS        (SLOT_BITS),
          .REFERENCE_LATENCY(REFERENCE_LATENCY),
          .INITIATION_INTERVAL(INITIATION_INTERVAL),
          .LAST_OPERAND_PHASE(LAST_OPERAND_PHASE),
          .PHASE_BITS       (4),
          .CARRIED          (CARRIED),
          .BEAT_BITS        (BEAT_BITS),
          .OUTSTANDING_BITS (OUTSTANDING_BITS)
        ) port (
          .aclk              (aclk),
          .aresetn           (aresetn),
          .s_request_tvalid  (named_valid[i]),
          .s_request_tready  (named_ready[i]),
          .s_request_tdata   (named_data[i*NAMED_BITS +: NAMED_BITS]),
          .reset_phase       (4'd0),
          .reference_phase   (unused_phase),
          .reference_operands(operands),
          .reference_verdict (verdict),
          .m_answer_valid    (reply_valid[i]),
          .m_answer_tdata    (reply_data[i*ANSWER_BITS +: ANSWER_BITS]),
          .m_refetch_tvalid  (m_refetch_valid[i]),
          .m_refetch_tready  (m_refetch_ready[i]),
          .m_refetch_tdata   (m_refetch_tags[32*i +: 32]),
          .s_refetch_tvalid  (s_refetch_valid[i]),
          .s_refetch_tready  (s_refetch_ready[i]),
          .s_refetch_tdata   (refetched)
        );
      end
    end

    for (i = REFERENCES; i < 16; i = i + 1) begin : g_no_reference
      wire unused_refetch = &{m_refetch_ready[i], s_refetch_valid[i],
                              s_refetch_operands[32*i +: 32]};

      assign m_refetch_valid[i]          = 1'b0;
      assign m_refetch_tags[32*i +: 32] = 32'd0;
      assign s_refetch_ready[i]          = 1'b0;
    end
  endgenerate

endmodule

`default_nettype wire
