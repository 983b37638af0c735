// scoreboard_inside: a lane_scoreboard of four slots, and lemmas about its registers that make the
// claims of lane_proof hold by induction. Each slot is in exactly one place: the pool, a rank of
// the lane, a queue, a register on the way to the reference or back, the reference, or the register
// in front of the tags. The watched comparison has one slot from its acceptance until its tag is
// read. Wherever that slot is, the right data are beside it, and no other slot in use has its tag.
`default_nettype none

module scoreboard_inside #(
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
  input  wire [7:0]              expected
);

  localparam SENDS_OPERANDS = ((RECOMPUTE != 0) && (CARRIED != 0)) ? 1 : 0;
  localparam SENDS_TAG      = ((RECOMPUTE != 0) && (CARRIED == 0)) ? 1 : 0;

  wire [3:0] recomputations;
  wire [3:0] stalls;

  lane_scoreboard #(
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
  (* hierconn *) wire [2:0] \dut.slots.write_q ;
  (* hierconn *) wire [2:0] \dut.slots.read_q ;
  (* hierconn *) wire       \dut.slots.valid_q ;
  (* hierconn *) wire       \dut.slots.first_lap_q ;
  (* hierconn *) wire [1:0] \dut.slot ;
  (* hierconn *) wire [1:0] \dut.slots.places.words[0] ;
  (* hierconn *) wire [1:0] \dut.slots.places.words[1] ;
  (* hierconn *) wire [1:0] \dut.slots.places.words[2] ;
  (* hierconn *) wire [1:0] \dut.slots.places.words[3] ;
  (* hierconn *) wire [1:0] \dut.tracker.valid_beside_lane.g_shift.rank_q ;
  (* hierconn *) wire [3:0] \dut.tracker.slot_beside_lane.g_shift.rank_q ;
  (* hierconn *) wire [1:0] \dut.tracker.exit_verdict_q ;
  (* hierconn *) wire       \dut.tracker.exit_decided_q ;
  (* hierconn *) wire [2:0] \dut.direct_results.write_q ;
  (* hierconn *) wire [2:0] \dut.direct_results.read_q ;
  (* hierconn *) wire       \dut.direct_results.m_valid_q ;
  (* hierconn *) wire [4:0] \dut.direct_results.m_axis_tdata ;
  (* hierconn *) wire [4:0] \dut.direct_results.memory.words[0] ;
  (* hierconn *) wire [4:0] \dut.direct_results.memory.words[1] ;
  (* hierconn *) wire [4:0] \dut.direct_results.memory.words[2] ;
  (* hierconn *) wire [4:0] \dut.direct_results.memory.words[3] ;
  (* hierconn *) wire [2:0] \dut.g_merge.answers.queue.write_q ;
  (* hierconn *) wire [2:0] \dut.g_merge.answers.queue.read_q ;
  (* hierconn *) wire       \dut.g_merge.answers.queue.m_valid_q ;
  (* hierconn *) wire [3:0] \dut.g_merge.answers.queue.m_axis_tdata ;
  (* hierconn *) wire [3:0] \dut.g_merge.answers.queue.memory.words[0] ;
  (* hierconn *) wire [3:0] \dut.g_merge.answers.queue.memory.words[1] ;
  (* hierconn *) wire [3:0] \dut.g_merge.answers.queue.memory.words[2] ;
  (* hierconn *) wire [3:0] \dut.g_merge.answers.queue.memory.words[3] ;
  (* hierconn *) wire       \dut.g_merge.merge.m_valid_q ;
  (* hierconn *) wire [5:0] \dut.g_merge.merge.m_data_q ;
  (* hierconn *) wire [1:0] \dut.tags.memory.words[0] ;
  (* hierconn *) wire [1:0] \dut.tags.memory.words[1] ;
  (* hierconn *) wire [1:0] \dut.tags.memory.words[2] ;
  (* hierconn *) wire [1:0] \dut.tags.memory.words[3] ;
  (* hierconn *) wire       \dut.tags.ask_valid_q ;
  (* hierconn *) wire [1:0] \dut.tags.ask_slot_q ;
  (* hierconn *) wire [2:0] \dut.g_carried.operands.waiting_slots.write_q ;
  (* hierconn *) wire [2:0] \dut.g_carried.operands.waiting_slots.read_q ;
  (* hierconn *) wire       \dut.g_carried.operands.waiting_slots.m_valid_q ;
  (* hierconn *) wire [1:0] \dut.g_carried.operands.waiting_slots.m_axis_tdata ;
  (* hierconn *) wire [1:0] \dut.g_carried.operands.waiting_slots.memory.words[0] ;
  (* hierconn *) wire [1:0] \dut.g_carried.operands.waiting_slots.memory.words[1] ;
  (* hierconn *) wire [1:0] \dut.g_carried.operands.waiting_slots.memory.words[2] ;
  (* hierconn *) wire [1:0] \dut.g_carried.operands.waiting_slots.memory.words[3] ;
  (* hierconn *) wire [2:0] \dut.g_carried.operands.memory.g_word.memory.words[0] ;
  (* hierconn *) wire [2:0] \dut.g_carried.operands.memory.g_word.memory.words[1] ;
  (* hierconn *) wire [2:0] \dut.g_carried.operands.memory.g_word.memory.words[2] ;
  (* hierconn *) wire [2:0] \dut.g_carried.operands.memory.g_word.memory.words[3] ;

  wire [4:0]  pool_holds;
  wire [9:0]  pool_slots;
  wire [4:0]  direct_holds;
  wire [4:0]  answers_holds;
  wire [4:0]  waiting_holds;

  // The words of each queue; the word on offer is lowest.
  wire [24:0] direct_words  = {\dut.direct_results.memory.words[3] ,
                               \dut.direct_results.memory.words[2] ,
                               \dut.direct_results.memory.words[1] ,
                               \dut.direct_results.memory.words[0] ,
                               \dut.direct_results.m_axis_tdata };
  wire [19:0] answers_words = {\dut.g_merge.answers.queue.memory.words[3] ,
                               \dut.g_merge.answers.queue.memory.words[2] ,
                               \dut.g_merge.answers.queue.memory.words[1] ,
                               \dut.g_merge.answers.queue.memory.words[0] ,
                               \dut.g_merge.answers.queue.m_axis_tdata };
  wire [9:0]  waiting_words = {\dut.g_carried.operands.waiting_slots.memory.words[3] ,
                               \dut.g_carried.operands.waiting_slots.memory.words[2] ,
                               \dut.g_carried.operands.waiting_slots.memory.words[1] ,
                               \dut.g_carried.operands.waiting_slots.memory.words[0] ,
                               \dut.g_carried.operands.waiting_slots.m_axis_tdata };

  pool_view pool (
    .started    (started),
    .write_q    (\dut.slots.write_q ),
    .read_q     (\dut.slots.read_q ),
    .valid_q    (\dut.slots.valid_q ),
    .first_lap_q(\dut.slots.first_lap_q ),
    .words      ({\dut.slots.places.words[3] , \dut.slots.places.words[2] ,
                  \dut.slots.places.words[1] , \dut.slots.places.words[0] }),
    .m_slot     (\dut.slot ),
    .holds      (pool_holds),
    .slots      (pool_slots)
  );

  fifo_view #(
    .WIDTH     (5),
    .DEPTH_BITS(2)
  ) direct (
    .started  (started),
    .write_q  (\dut.direct_results.write_q ),
    .read_q   (\dut.direct_results.read_q ),
    .m_valid_q(\dut.direct_results.m_valid_q ),
    .words    (direct_words[24:5]),
    .m_data   (direct_words[4:0]),
    .count    (),
    .contents (),
    .holds    (direct_holds),
    .ranks    ()
  );

  fifo_view #(
    .WIDTH     (4),
    .DEPTH_BITS(2)
  ) answers (
    .started  (started && (RECOMPUTE != 0)),
    .write_q  (\dut.g_merge.answers.queue.write_q ),
    .read_q   (\dut.g_merge.answers.queue.read_q ),
    .m_valid_q(\dut.g_merge.answers.queue.m_valid_q ),
    .words    (answers_words[19:4]),
    .m_data   (answers_words[3:0]),
    .count    (),
    .contents (),
    .holds    (answers_holds),
    .ranks    ()
  );

  fifo_view #(
    .WIDTH     (2),
    .DEPTH_BITS(2)
  ) waiting (
    .started  (started && (SENDS_OPERANDS != 0)),
    .write_q  (\dut.g_carried.operands.waiting_slots.write_q ),
    .read_q   (\dut.g_carried.operands.waiting_slots.read_q ),
    .m_valid_q(\dut.g_carried.operands.waiting_slots.m_valid_q ),
    .words    (waiting_words[9:2]),
    .m_data   (waiting_words[1:0]),
    .count    (),
    .contents (),
    .holds    (waiting_holds),
    .ranks    ()
  );

  // All places where a slot may be, each with its slot.
  localparam LANE      = 0;   // both ranks
  localparam DIRECT    = 2;
  localparam REFERENCE = 7;   // the proof's reference
  localparam REQUEST   = 8;
  localparam ASK       = 9;   // read from the tags, on its way to the request register
  localparam WAITING   = 10;
  localparam ANSWERS   = 15;
  localparam MERGED    = 20;
  localparam POOL      = 21;
  localparam PLACES    = 26;

  wire [2*PLACES-1:0] slots = {
      pool_slots, \dut.g_merge.merge.m_data_q [5:4],
      answers_words[19:18], answers_words[15:14], answers_words[11:10], answers_words[7:6],
      answers_words[3:2], waiting_words, \dut.tags.ask_slot_q , request[PAYLOAD_BITS +: 2],
      asked_slot, direct_words[24:23], direct_words[19:18], direct_words[14:13],
      direct_words[9:8], direct_words[4:3], \dut.tracker.slot_beside_lane.g_shift.rank_q };
  wire [PLACES-1:0]   holds = {
      pool_holds,
      (RECOMPUTE != 0) ? {\dut.g_merge.merge.m_valid_q , answers_holds} : 6'd0,
      (SENDS_OPERANDS != 0) ? waiting_holds : 5'd0,
      (SENDS_TAG != 0) && \dut.tags.ask_valid_q ,
      (RECOMPUTE != 0) ? {request_valid, asked} : 2'b00,
      direct_holds, \dut.tracker.valid_beside_lane.g_shift.rank_q };

  // The watched comparison's slot.
  reg  [1:0]  slot;
  wire        leaving = m_valid && (m_tag == watched);  // its tag was read
  wire        has_slot = inside && !leaving;

  always @(posedge aclk) begin
    if (s_valid && s_ready && (s_tag == watched)) begin
      slot <= \dut.slot ;
    end
  end

  wire [7:0]  tags   = {\dut.tags.memory.words[3] , \dut.tags.memory.words[2] ,
                        \dut.tags.memory.words[1] , \dut.tags.memory.words[0] };
  wire [11:0] stored = {\dut.g_carried.operands.memory.g_word.memory.words[3] ,
                        \dut.g_carried.operands.memory.g_word.memory.words[2] ,
                        \dut.g_carried.operands.memory.g_word.memory.words[1] ,
                        \dut.g_carried.operands.memory.g_word.memory.words[0] };

  // Results on their way out are {undecided, recomputed, verdict}.
  wire        decided = operands[0];
  wire [3:0]  answered = {2'b01, ~operands[2:1]};
  wire [3:0]  said     = {!decided, 1'b0, operands[2:1]};  // the lane's result
  wire [1:0]  ask_tag  = tags[2*\dut.tags.ask_slot_q +: 2];

  wire [2:0]  exit      = {\dut.tracker.exit_verdict_q , \dut.tracker.exit_decided_q };
  wire        is_answer = \dut.g_merge.merge.m_data_q [2];

  reg  [4:0]  held;       // places that hold a slot
  reg  [3:0]  somewhere;  // slots that some place holds
  reg  [3:0]  in_use;     // slots that a place beside the pool holds
  reg  [PLACES-1:0] here; // places that hold the watched comparison's slot
  reg         tags_right;
  reg         data_right;
  integer     p;

  always @* begin
    held      = 5'd0;
    somewhere = 4'd0;
    in_use    = 4'd0;
    for (p = 0; p < PLACES; p = p + 1) begin
      held = held + {4'd0, holds[p]};
      here[p] = holds[p] && has_slot && (slots[2*p +: 2] == slot);
      if (holds[p]) begin
        somewhere[slots[2*p +: 2]] = 1'b1;
        if (p < POOL) begin
          in_use[slots[2*p +: 2]] = 1'b1;
        end
      end
    end
    tags_right = 1'b1;
    for (p = 0; p < 4; p = p + 1) begin
      tags_right = tags_right && (!in_use[p] ||
                                  ((tags[2*p +: 2] == watched) == (has_slot && (slot == p))));
    end
    data_right = (!here[LANE] || (lane_q == operands)) &&
        (!here[LANE+1] || (exit == operands)) &&
        (!here[REFERENCE] || (asked_operands == operands)) &&
        (!here[MERGED] || (\dut.g_merge.merge.m_data_q [3:0] ==
                           (is_answer ? answered : said)));
    for (p = 0; p < 5; p = p + 1) begin
      data_right = data_right &&
          (!here[DIRECT+p] || (direct_words[5*p +: 3] == {said[3], said[1:0]})) &&
          (!here[ANSWERS+p] || (answers_words[4*p +: 2] == answered[1:0]));
    end
  end

  wire asks_reference = (|here[WAITING+4:REFERENCE]) || (|here[ANSWERS+4:ANSWERS]) ||
                        (here[MERGED] && is_answer);
  wire says_directly  = (|here[DIRECT+4:DIRECT]) || (here[MERGED] && !is_answer);

  always @* begin
    if (started) begin
      lemma_each_slot_is_somewhere: assert(&somewhere);
      lemma_no_slot_is_twice: assert(held == 5'd4);
      lemma_has_a_slot: assert(!has_slot || in_use[slot]);
      lemma_tags: assert(tags_right);
      lemma_data: assert(data_right);
      lemma_only_undecided_ask: assert(!asks_reference || !decided);
      lemma_decided_need_no_answer: assert(!says_directly || decided || (SENDS_OPERANDS == 0));
      lemma_leaves: assert(!leaving || (inside && (m_result == expected)));
      if (SENDS_OPERANDS != 0) begin
        lemma_stored_operands: assert(!has_slot || (stored[3*slot +: 3] == operands));
        lemma_requested_operands: assert(!here[REQUEST] || (request[PAYLOAD_BITS-1:0] == operands));
      end
      if (SENDS_TAG != 0) begin
        lemma_reads_one: assert(!m_valid || !\dut.tags.ask_valid_q );
        lemma_ask_tag: assert(!\dut.tags.ask_valid_q || (m_tag == ask_tag));
        lemma_request_tag: assert(!request_valid ||
                                  (request[1:0] == tags[2*request[PAYLOAD_BITS +: 2] +: 2]));
      end
    end
  end

endmodule

`default_nettype wire
