// reorder_inside: a lane_reorder of four slots, and lemmas about its registers that make the claims
// of lane_proof hold by induction. The slots in use, the oldest first, are those in the queue of
// the lane's verdicts, then those in its ranks. For each undecided slot in that queue there is, in
// the same order, an answer, a request at the reference or on its way, or a slot that waits. Among
// the slots in use only the watched comparison's own slot has its tag. The same holds for its
// follower.
`default_nettype none

module reorder_inside #(
  parameter RECOMPUTE = 1,
  parameter CARRIED = 1,
  parameter PAYLOAD_BITS = 3
) (
  input  wire                    aclk,
  input  wire                    aresetn,
  input  wire                    s_valid,
  output wire                    s_ready,
  input  wire [2:0]              s_operands,
  input  wire [1:0]              s_tag,
  output wire [2:0]              lane_operands,
  input  wire [2:0]              lane_q,
  output wire                    request_valid,
  input  wire                    request_ready,
  output wire [PAYLOAD_BITS+1:0] request,
  input  wire                    answer,
  output wire                    m_valid,
  input  wire                    m_ready,
  output wire [7:0]              m_result,
  output wire [1:0]              m_tag,
  output wire [3:0]              comparisons,
  // The inputs from here on come from the proof: the request at the reference and the watched
  // comparison.
  input  wire                    started,
  input  wire                    asked,
  input  wire [1:0]              asked_slot,
  input  wire [2:0]              asked_operands,
  input  wire [1:0]              watched,
  input  wire                    inside,
  input  wire [2:0]              operands,
  input  wire [7:0]              expected,
  input  wire [1:0]              follower,
  input  wire                    follower_in,
  input  wire                    follows
);

  localparam SENDS_OPERANDS = ((RECOMPUTE != 0) && (CARRIED != 0)) ? 1 : 0;
  localparam SENDS_TAG      = ((RECOMPUTE != 0) && (CARRIED == 0)) ? 1 : 0;

  wire [3:0] recomputations;
  wire [3:0] stalls;

  lane_reorder #(
    .OPERAND_BITS(3), .TAG_BITS(2), .SLOT_BITS(2), .LANE_LATENCY(1),
    .COUNTER_BITS(4), .RECOMPUTE(RECOMPUTE), .CARRIED(CARRIED)
  ) dut (
    .aclk(aclk), .aresetn(aresetn),
    .s_axis_tvalid(s_valid), .s_axis_tready(s_ready),
    .s_axis_tdata(s_operands), .s_axis_tuser(s_tag),
    .lane_operands(lane_operands), .lane_verdict(lane_q[2:1]), .lane_decided(lane_q[0]),
    .m_request_tvalid(request_valid), .m_request_tready(request_ready),
    .m_request_tdata(request),
    .s_answer_valid(answer), .s_answer_slot(asked_slot),
    .s_answer_verdict(~asked_operands[2:1]),
    .m_axis_tvalid(m_valid), .m_axis_tready(m_ready),
    .m_axis_tdata(m_result), .m_axis_tuser(m_tag),
    .comparisons(comparisons), .recomputations(recomputations), .stalls(stalls)
  );

  // The template's registers that the lemmas read. Those of forms that this instance does not have
  // mean nothing.
  (* hierconn *) wire [2:0] \dut.next_q ;
  (* hierconn *) wire [2:0] \dut.oldest_q ;
  (* hierconn *) wire [1:0] \dut.tracker.valid_beside_lane.g_shift.rank_q ;
  (* hierconn *) wire [3:0] \dut.tracker.slot_beside_lane.g_shift.rank_q ;
  (* hierconn *) wire [1:0] \dut.tracker.exit_verdict_q ;
  (* hierconn *) wire       \dut.tracker.exit_decided_q ;
  (* hierconn *) wire [2:0] \dut.direct_results.write_q ;
  (* hierconn *) wire [2:0] \dut.direct_results.read_q ;
  (* hierconn *) wire       \dut.direct_results.m_valid_q ;
  (* hierconn *) wire [2:0] \dut.direct_results.m_axis_tdata ;
  (* hierconn *) wire [2:0] \dut.direct_results.memory.words[0] ;
  (* hierconn *) wire [2:0] \dut.direct_results.memory.words[1] ;
  (* hierconn *) wire [2:0] \dut.direct_results.memory.words[2] ;
  (* hierconn *) wire [2:0] \dut.direct_results.memory.words[3] ;
  (* hierconn *) wire [2:0] \dut.g_merge.answers.queue.write_q ;
  (* hierconn *) wire [2:0] \dut.g_merge.answers.queue.read_q ;
  (* hierconn *) wire       \dut.g_merge.answers.queue.m_valid_q ;
  (* hierconn *) wire [1:0] \dut.g_merge.answers.queue.m_axis_tdata ;
  (* hierconn *) wire [1:0] \dut.g_merge.answers.queue.memory.words[0] ;
  (* hierconn *) wire [1:0] \dut.g_merge.answers.queue.memory.words[1] ;
  (* hierconn *) wire [1:0] \dut.g_merge.answers.queue.memory.words[2] ;
  (* hierconn *) wire [1:0] \dut.g_merge.answers.queue.memory.words[3] ;
  (* hierconn *) wire [1:0] \dut.tags.memory.words[0] ;
  (* hierconn *) wire [1:0] \dut.tags.memory.words[1] ;
  (* hierconn *) wire [1:0] \dut.tags.memory.words[2] ;
  (* hierconn *) wire [1:0] \dut.tags.memory.words[3] ;
  (* hierconn *) wire       \dut.tags.ask_valid_q ;
  (* hierconn *) wire [1:0] \dut.tags.ask_slot_q ;
  (* hierconn *) wire [2:0] \dut.g_carried.operands.waiting_slots.write_q ;
  (* hierconn *) wire [2:0] \dut.g_refetched.asking_slots.write_q ;
  (* hierconn *) wire [2:0] \dut.g_carried.operands.waiting_slots.read_q ;
  (* hierconn *) wire [2:0] \dut.g_refetched.asking_slots.read_q ;
  (* hierconn *) wire       \dut.g_carried.operands.waiting_slots.m_valid_q ;
  (* hierconn *) wire       \dut.g_refetched.asking_slots.m_valid_q ;
  (* hierconn *) wire [1:0] \dut.g_carried.operands.waiting_slots.m_axis_tdata ;
  (* hierconn *) wire [1:0] \dut.g_refetched.asking_slots.m_axis_tdata ;
  (* hierconn *) wire [1:0] \dut.g_carried.operands.waiting_slots.memory.words[0] ;
  (* hierconn *) wire [1:0] \dut.g_refetched.asking_slots.memory.words[0] ;
  (* hierconn *) wire [1:0] \dut.g_carried.operands.waiting_slots.memory.words[1] ;
  (* hierconn *) wire [1:0] \dut.g_refetched.asking_slots.memory.words[1] ;
  (* hierconn *) wire [1:0] \dut.g_carried.operands.waiting_slots.memory.words[2] ;
  (* hierconn *) wire [1:0] \dut.g_refetched.asking_slots.memory.words[2] ;
  (* hierconn *) wire [1:0] \dut.g_carried.operands.waiting_slots.memory.words[3] ;
  (* hierconn *) wire [1:0] \dut.g_refetched.asking_slots.memory.words[3] ;
  (* hierconn *) wire [2:0] \dut.g_carried.operands.memory.g_word.memory.words[0] ;
  (* hierconn *) wire [2:0] \dut.g_carried.operands.memory.g_word.memory.words[1] ;
  (* hierconn *) wire [2:0] \dut.g_carried.operands.memory.g_word.memory.words[2] ;
  (* hierconn *) wire [2:0] \dut.g_carried.operands.memory.g_word.memory.words[3] ;

  wire [3:0]  direct_count;
  wire [14:0] direct_words;
  wire [3:0]  answers_count;
  wire [9:0]  answers_words;
  wire [3:0]  carried_count;
  wire [9:0]  carried_words;
  wire [3:0]  refetched_count;
  wire [9:0]  refetched_words;

  fifo_view #(
    .WIDTH     (3),
    .DEPTH_BITS(2)
  ) direct (
    .started  (started),
    .write_q  (\dut.direct_results.write_q ),
    .read_q   (\dut.direct_results.read_q ),
    .m_valid_q(\dut.direct_results.m_valid_q ),
    .words    ({\dut.direct_results.memory.words[3] ,
                \dut.direct_results.memory.words[2] ,
                \dut.direct_results.memory.words[1] ,
                \dut.direct_results.memory.words[0] }),
    .m_data   (\dut.direct_results.m_axis_tdata ),
    .count    (direct_count),
    .contents (direct_words),
    .holds    (),
    .ranks    ()
  );

  fifo_view #(
    .WIDTH     (2),
    .DEPTH_BITS(2)
  ) answers (
    .started  (started && (RECOMPUTE != 0)),
    .write_q  (\dut.g_merge.answers.queue.write_q ),
    .read_q   (\dut.g_merge.answers.queue.read_q ),
    .m_valid_q(\dut.g_merge.answers.queue.m_valid_q ),
    .words    ({\dut.g_merge.answers.queue.memory.words[3] ,
                \dut.g_merge.answers.queue.memory.words[2] ,
                \dut.g_merge.answers.queue.memory.words[1] ,
                \dut.g_merge.answers.queue.memory.words[0] }),
    .m_data   (\dut.g_merge.answers.queue.m_axis_tdata ),
    .count    (answers_count),
    .contents (answers_words),
    .holds    (),
    .ranks    ()
  );

  fifo_view #(
    .WIDTH     (2),
    .DEPTH_BITS(2)
  ) carried (
    .started  (started && (SENDS_OPERANDS != 0)),
    .write_q  (\dut.g_carried.operands.waiting_slots.write_q ),
    .read_q   (\dut.g_carried.operands.waiting_slots.read_q ),
    .m_valid_q(\dut.g_carried.operands.waiting_slots.m_valid_q ),
    .words    ({\dut.g_carried.operands.waiting_slots.memory.words[3] ,
                \dut.g_carried.operands.waiting_slots.memory.words[2] ,
                \dut.g_carried.operands.waiting_slots.memory.words[1] ,
                \dut.g_carried.operands.waiting_slots.memory.words[0] }),
    .m_data   (\dut.g_carried.operands.waiting_slots.m_axis_tdata ),
    .count    (carried_count),
    .contents (carried_words),
    .holds    (),
    .ranks    ()
  );

  fifo_view #(
    .WIDTH     (2),
    .DEPTH_BITS(2)
  ) refetched (
    .started  (started && (SENDS_TAG != 0)),
    .write_q  (\dut.g_refetched.asking_slots.write_q ),
    .read_q   (\dut.g_refetched.asking_slots.read_q ),
    .m_valid_q(\dut.g_refetched.asking_slots.m_valid_q ),
    .words    ({\dut.g_refetched.asking_slots.memory.words[3] ,
                \dut.g_refetched.asking_slots.memory.words[2] ,
                \dut.g_refetched.asking_slots.memory.words[1] ,
                \dut.g_refetched.asking_slots.memory.words[0] }),
    .m_data   (\dut.g_refetched.asking_slots.m_axis_tdata ),
    .count    (refetched_count),
    .contents (refetched_words),
    .holds    (),
    .ranks    ()
  );

  // The slots of the watched comparison and of its follower, while their tags are not read.
  wire [2:0]  used = \dut.next_q - \dut.oldest_q ;
  wire [1:0]  oldest = \dut.oldest_q [1:0];
  reg  [1:0]  slot;
  reg  [1:0]  follower_slot;
  wire        leaving = m_valid && (m_tag == watched);
  wire        has_slot = inside && !leaving;
  wire        follower_leaving = m_valid && (m_tag == follower);
  wire        follower_has_slot = follower_in && !follower_leaving;
  wire [1:0]  place = slot - oldest;  // comparisons that leave before it
  wire [1:0]  follower_place = follower_slot - oldest;

  always @(posedge aclk) begin
    if (s_valid && s_ready && (s_tag == watched)) begin
      slot <= \dut.next_q [1:0];
    end
    if (s_valid && s_ready && (s_tag == follower)) begin
      follower_slot <= \dut.next_q [1:0];
    end
  end

  wire [7:0]  tags   = {\dut.tags.memory.words[3] , \dut.tags.memory.words[2] ,
                        \dut.tags.memory.words[1] , \dut.tags.memory.words[0] };
  wire [11:0] stored = {\dut.g_carried.operands.memory.g_word.memory.words[3] ,
                        \dut.g_carried.operands.memory.g_word.memory.words[2] ,
                        \dut.g_carried.operands.memory.g_word.memory.words[1] ,
                        \dut.g_carried.operands.memory.g_word.memory.words[0] };
  wire [1:0]  ranks      = \dut.tracker.valid_beside_lane.g_shift.rank_q ;
  wire [3:0]  rank_slots = \dut.tracker.slot_beside_lane.g_shift.rank_q ;
  wire [2:0]  exit       = {\dut.tracker.exit_verdict_q , \dut.tracker.exit_decided_q };
  wire [3:0]  waiting_count = (SENDS_OPERANDS != 0) ? carried_count : refetched_count;
  wire [9:0]  waiting_words = (SENDS_OPERANDS != 0) ? carried_words : refetched_words;
  wire        is_asking     = (SENDS_TAG != 0) && \dut.tags.ask_valid_q ;
  wire [1:0]  request_slot  = request[PAYLOAD_BITS +: 2];

  reg  [3:0]  undecided;       // undecided entries in the queue of verdicts
  reg  [3:0]  asking;          // number of answers, requests and waiting slots
  reg  [9:0]  undecided_slots; // the oldest lowest
  reg         order_right;
  reg         tags_right;
  reg         data_right;
  reg  [1:0]  k_slot;
  integer     k;

  always @* begin
    undecided       = 4'd0;
    undecided_slots = 10'd0;
    data_right      = !has_slot ||
        ((!ranks[0] || (rank_slots[1:0] != slot) || (lane_q == operands)) &&
         (!ranks[1] || (rank_slots[3:2] != slot) || (exit == operands)));
    for (k = 0; k < 5; k = k + 1) begin
      k_slot = oldest + k;
      if (k < direct_count) begin
        data_right = data_right && (!has_slot || (k_slot != slot) ||
                     (direct_words[3*k +: 3] == {operands[0], operands[2:1]}));
        if (!direct_words[3*k+2]) begin
          undecided_slots[2*undecided[2:0] +: 2] = k_slot;
          undecided = undecided + 4'd1;
        end
      end
    end
    // Answers first, then requests at the reference, then requests on the way to it.
    asking      = (RECOMPUTE != 0) ? answers_count : 4'd0;
    order_right = 1'b1;
    for (k = 0; k < 5; k = k + 1) begin
      if ((RECOMPUTE != 0) && (k < answers_count)) begin
        data_right = data_right && (!has_slot || (undecided_slots[2*k +: 2] != slot) ||
                                    (answers_words[2*k +: 2] == ~operands[2:1]));
      end
    end
    if ((RECOMPUTE != 0) && asked) begin
      order_right = order_right && (asked_slot == undecided_slots[2*asking[2:0] +: 2]);
      data_right  = data_right &&
                    (!has_slot || (asked_slot != slot) || (asked_operands == operands));
      asking      = asking + 4'd1;
    end
    if ((RECOMPUTE != 0) && request_valid) begin
      order_right = order_right && (request_slot == undecided_slots[2*asking[2:0] +: 2]);
      asking      = asking + 4'd1;
    end
    if (is_asking) begin
      order_right = order_right &&
                    (\dut.tags.ask_slot_q == undecided_slots[2*asking[2:0] +: 2]);
      asking      = asking + 4'd1;
    end
    for (k = 0; k < 5; k = k + 1) begin
      if ((RECOMPUTE != 0) && (k < waiting_count)) begin
        order_right = order_right &&
                      (waiting_words[2*k +: 2] == undecided_slots[2*asking[2:0] +: 2]);
        asking      = asking + 4'd1;
      end
    end
    tags_right = 1'b1;
    for (k = 0; k < 4; k = k + 1) begin
      k_slot = k - oldest;
      tags_right = tags_right && (({1'b0, k_slot} >= used) ||
          (((tags[2*k +: 2] == watched) == (has_slot && (slot == k))) &&
           ((tags[2*k +: 2] == follower) == (follower_has_slot && (follower_slot == k)))));
    end
  end

  always @* begin
    if (started) begin
      lemma_used: assert((used <= 3'd4) &&
                         ({1'b0, used} == direct_count + {3'd0, ranks[0]} + {3'd0, ranks[1]}));
      lemma_ranks: assert((!ranks[1] || (rank_slots[3:2] == oldest + direct_count[1:0])) &&
          (!ranks[0] || (rank_slots[1:0] == oldest + direct_count[1:0] + {1'b0, ranks[1]})));
      lemma_has_a_slot: assert((!has_slot || ({1'b0, place} < used)) &&
                               (!follower_has_slot || ({1'b0, follower_place} < used)));
      lemma_tags: assert(tags_right);
      lemma_data: assert(data_right);
      lemma_leaves: assert((!leaving || (inside && (m_result == expected))) &&
                           (!follower_leaving || follower_in));
      lemma_follows: assert(!follows || (inside && follower_has_slot &&
                                         (leaving || (place < follower_place))));
      if (RECOMPUTE != 0) begin
        lemma_all_undecided_ask: assert(asking == undecided);
        lemma_order: assert(order_right);
      end
      if (SENDS_OPERANDS != 0) begin
        lemma_stored_operands: assert(!has_slot || (stored[3*slot +: 3] == operands));
        lemma_requested_operands: assert(!request_valid || !has_slot || (request_slot != slot) ||
                                         (request[PAYLOAD_BITS-1:0] == operands));
      end
      if (SENDS_TAG != 0) begin
        lemma_reads_one: assert(!m_valid || !\dut.tags.ask_valid_q );
        lemma_ask_tag: assert(!\dut.tags.ask_valid_q ||
                              (m_tag == tags[2*\dut.tags.ask_slot_q +: 2]));
        lemma_request_tag: assert(!request_valid ||
                                  (request[1:0] == tags[2*request_slot +: 2]));
      end
    end
  end

endmodule

`default_nettype wire
