// arg_min_proof: whatever stalls, rows leave in the order in which they came, and none is lost or
// made up. Each lane compares the best candidate so far with its own, by words that were made of
// the right row and candidates; the full operands are in the memories at the places that the pair's
// tag names. One row at a time, chosen by the solver, is watched on its way past candidates 0, 1
// and 2, by its place. Both lanes hold one pair each for as long as they like, and return its tag.
// operand_memory_proof covers how references get operands. The lemmas read registers of the
// template, and together hold by induction. They say how far each candidate of a load has come, and
// go over all rows inside from the last to the first: their places follow one another.
`default_nettype none

module arg_min_proof (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       c_valid,
  input wire       c_last,
  input wire [1:0] c_data,
  input wire       s_valid,
  input wire       s_last,
  input wire       s_user,
  input wire       s_data,
  input wire       choose,     // the row that enters is watched, if no other is
  input wire       m_ready,
  input wire [1:0] willing,    // a lane without a pair takes one
  input wire [1:0] finishing,  // a lane with a pair offers its verdict
  input wire [3:0] verdicts    // the verdict of each lane
);

  localparam [3:0] NONE = 0;
  localparam [3:0] ONE  = 1;
  localparam MOST_QUIET = 10;

  wire        c_ready;
  wire        s_ready;
  wire [1:0]  candidate;
  wire [1:0]  pair_valid;
  wire [1:0]  pair_ready;
  wire [3:0]  pair_best;
  wire [3:0]  pair_own;
  wire [13:0] pair_tag;      // {word of the row, own, best, place}
  wire [1:0]  result_valid;
  wire [1:0]  result_ready;
  wire [1:0]  verdict_1;
  wire [1:0]  verdict_2;
  wire        m_valid;
  wire [7:0]  m_data;
  wire        m_user;
  wire        m_last;
  wire        overrun;

  reg         started  = 1'b0;
  wire        aresetn  = started && aresetn_later;
  reg         watching = 1'b0;
  wire        chosen   = choose && !watching;

  // The conversions take a cycle, and change the bits.
  reg  [1:0]  candidate_word;
  reg         row_word;

  always @(posedge aclk) begin
    candidate_word <= ~candidate;
    row_word       <= !s_data;
  end

  // The lanes.
  reg  [1:0] holds   = 2'b00;
  reg  [1:0] offered = 2'b00;
  reg  [6:0] tag_1_q;
  reg  [6:0] tag_2_q;
  reg  [1:0] verdict_1_q;
  reg  [1:0] verdict_2_q;

  arg_min_engine #(
    .CANDIDATES    (3),
    .CANDIDATE_BITS(2),
    .ROW_BITS      (1),
    .WORD_BITS     (2),
    .ROW_WORD_BITS (1),
    .WORD_LATENCY  (1),
    .TAG_BITS      (1),
    .INDEX_BITS    (2),
    .PLACE_BITS    (2),
    .REFERENCES    (1),
    .COUNTER_BITS  (0)
  ) dut (
    .aclk              (aclk),
    .aresetn           (aresetn),
    .s_candidate_tvalid(c_valid),
    .s_candidate_tready(c_ready),
    .s_candidate_tdata (c_data),
    .s_candidate_tlast (c_last),
    .candidate         (candidate),
    .candidate_word    (candidate_word),
    .s_axis_tvalid     (s_valid),
    .s_axis_tready     (s_ready),
    .s_axis_tdata      (s_data),
    .s_axis_tuser      (s_user),
    .s_axis_tlast      (s_last),
    .row_word          (row_word),
    .pair_tvalid       (pair_valid),
    .pair_tready       (pair_ready),
    .pair_best         (pair_best),
    .pair_own          (pair_own),
    .pair_tag          (pair_tag),
    .result_tvalid     (result_valid),
    .result_tready     (result_ready),
    .result_tdata      ({6'd0, verdict_2, 6'd0, verdict_1}),
    .result_tag        ({tag_2_q, tag_1_q}),
    .refetch_tvalid    (1'b0),
    .refetch_tready    (),
    .refetch_tdata     (6'd0),
    .refetched_tvalid  (),
    .refetched_tready  (1'b1),
    .refetched_tdata   (),
    .m_axis_tvalid     (m_valid),
    .m_axis_tready     (m_ready),
    .m_axis_tdata      (m_data),
    .m_axis_tuser      (m_user),
    .m_axis_tlast      (m_last),
    .overrun           (overrun),
    .rows              (),
    .stalled_cycles    ()
  );

  // The candidates as they were offered. In a short load the last one stands for each missing one.
  reg  [1:0] candidate_0;
  reg  [1:0] candidate_1;
  reg  [1:0] candidate_2;
  reg  [1:0] loaded   = 2'd0;
  reg        ended    = 1'b0;
  reg        short    = 1'b0;
  reg        too_many = 1'b0;
  wire       c_accept = c_valid && c_ready;
  wire [1:0] place    = ended ? 2'd0 : loaded;

  always @(posedge aclk) begin
    started <= 1'b1;
    if (!aresetn) begin
      loaded   <= 2'd0;
      ended    <= 1'b0;
      too_many <= 1'b0;
    end else if (c_accept) begin
      loaded   <= (place == 2'd3) ? 2'd3 : place + 2'd1;
      ended    <= c_last;
      short    <= c_last && (place < 2'd2);
      too_many <= (place == 2'd3);
    end
    if (c_accept && (place == 2'd0)) begin
      candidate_0 <= c_data;
    end
    if (c_accept && (place <= 2'd1)) begin
      candidate_1 <= c_data;
    end
    if (c_accept && (place <= 2'd2)) begin
      candidate_2 <= c_data;
    end
  end

  // The rows: how many are inside, and how many of these are ahead of the watched one.
  reg  [3:0] inside   = NONE;
  reg  [3:0] ahead;
  reg        meets_1  = 1'b0;  // the watched row has to meet lane 1
  reg        meets_2  = 1'b0;
  reg  [3:0] quiet    = NONE;  // cycles in which nothing moves though everybody would
  reg        again    = 1'b0;  // a row left before
  reg  [1:0] place_of_next = 2'd0;
  reg  [1:0] watched_place;
  reg        row;
  reg        last;
  reg        user;
  reg        better_1;  // candidate 1 costs the watched row less than candidate 0
  reg        better_2;  // candidate 2 costs it less than the better of these two
  wire       enters  = s_valid && s_ready;
  wire       leaves  = m_valid && m_ready;
  wire [1:0] takes   = pair_valid & pair_ready;
  wire [1:0] best    = better_1 ? candidate_1 : candidate_0;
  wire       watched_1 = watching && (pair_tag[1:0] == watched_place);
  wire       watched_2 = watching && (pair_tag[8:7] == watched_place);
  wire       watched_m = watching && (ahead == NONE);
  wire       calm;

  always @(posedge aclk) begin
    if (!aresetn) begin
      inside        <= NONE;
      meets_1       <= 1'b0;
      meets_2       <= 1'b0;
      watching      <= 1'b0;
      quiet         <= NONE;
      again         <= 1'b0;
      place_of_next <= 2'd0;
    end else begin
      inside <= inside + {3'b000, enters} - {3'b000, leaves};
      quiet  <= (calm && (takes == 2'b00) && !leaves && (inside != NONE)) ? quiet + ONE : NONE;
      again  <= again || leaves;
      if (enters) begin
        place_of_next <= place_of_next + 2'd1;
      end
      if (takes[0] && watched_1) begin
        meets_1 <= 1'b0;
      end
      if (takes[1] && watched_2) begin
        meets_2 <= 1'b0;
      end
      if (leaves) begin
        ahead    <= ahead - ONE;
        watching <= watching && (ahead != NONE);
      end
      if (enters && chosen) begin
        watching <= 1'b1;
        meets_1  <= 1'b1;
        meets_2  <= 1'b1;
        ahead    <= inside - {3'b000, leaves};
      end
    end
    if (enters && chosen) begin
      watched_place <= place_of_next;
      row           <= s_data;
      last          <= s_last;
      user          <= s_user;
    end
    if (takes[0] && watched_1) begin
      better_1 <= (verdicts[1:0] == 2'd2);
    end
    if (takes[1] && watched_2) begin
      better_2 <= (verdicts[3:2] == 2'd2);
    end
  end

  assign pair_ready   = willing & ~holds;
  assign calm         = m_ready && ((willing | holds) == 2'b11) && ((finishing | ~holds) == 2'b11);
  assign result_valid = offered;
  assign verdict_1    = verdict_1_q;
  assign verdict_2    = verdict_2_q;

  always @(posedge aclk) begin
    if (!aresetn) begin
      holds   <= 2'b00;
      offered <= 2'b00;
    end else begin
      holds   <= takes | (holds & ~(offered & result_ready));
      offered <= (offered & ~result_ready) | (holds & ~offered & finishing);
    end
    if (takes[0]) begin
      verdict_1_q <= verdicts[1:0];
      tag_1_q     <= pair_tag[6:0];
    end
    if (takes[1]) begin
      verdict_2_q <= verdicts[3:2];
      tag_2_q     <= pair_tag[13:7];
    end
  end

  reg       held = 1'b0;
  reg [9:0] held_result;

  always @(posedge aclk) begin
    held        <= aresetn && m_valid && !m_ready;
    held_result <= {m_data, m_user, m_last};
  end

  // The template's registers that the lemmas read.
  (* hierconn *) wire [2:0] \dut.loader.sent_q ;
  (* hierconn *) wire       \dut.loader.ended_q ;
  (* hierconn *) wire       \dut.loader.complete_q ;
  (* hierconn *) wire       \dut.loader.overrun_q ;
  (* hierconn *) wire       \dut.loader.word_valid_q ;
  (* hierconn *) wire [1:0] \dut.loader.word_index_q ;
  (* hierconn *) wire [1:0] \dut.loader.word_data_q ;
  (* hierconn *) wire       \dut.loaded_beside_word.g_shift.rank_q ;
  (* hierconn *) wire [1:0] \dut.index_beside_word.g_shift.rank_q ;
  (* hierconn *) wire [2:0] \dut.inside_q ;
  (* hierconn *) wire [1:0] \dut.free_place_q ;
  (* hierconn *) wire [1:0] \dut.next_place_q ;
  (* hierconn *) wire       \dut.row_beside_word.g_shift.rank_q ;
  (* hierconn *) wire [3:0] \dut.converted_rows.beats.write_q ;
  (* hierconn *) wire [3:0] \dut.converted_rows.beats.read_q ;
  (* hierconn *) wire       \dut.converted_rows.beats.m_valid_q ;
  (* hierconn *) wire       \dut.converted_rows.beats.m_axis_tdata ;
  (* hierconn *) wire       \dut.converted_rows.beats.memory.words[0] ;
  (* hierconn *) wire       \dut.converted_rows.beats.memory.words[1] ;
  (* hierconn *) wire       \dut.converted_rows.beats.memory.words[2] ;
  (* hierconn *) wire       \dut.converted_rows.beats.memory.words[3] ;
  (* hierconn *) wire       \dut.converted_rows.beats.memory.words[4] ;
  (* hierconn *) wire       \dut.converted_rows.beats.memory.words[5] ;
  (* hierconn *) wire       \dut.converted_rows.beats.memory.words[6] ;
  (* hierconn *) wire       \dut.converted_rows.beats.memory.words[7] ;
  (* hierconn *) wire [2:0] \dut.tags.write_q ;
  (* hierconn *) wire [2:0] \dut.tags.read_q ;
  (* hierconn *) wire       \dut.tags.m_valid_q ;
  (* hierconn *) wire [1:0] \dut.tags.m_axis_tdata ;
  (* hierconn *) wire [1:0] \dut.tags.memory.words[0] ;
  (* hierconn *) wire [1:0] \dut.tags.memory.words[1] ;
  (* hierconn *) wire [1:0] \dut.tags.memory.words[2] ;
  (* hierconn *) wire [1:0] \dut.tags.memory.words[3] ;
  (* hierconn *) wire       \dut.g_references.operands.rows.words[0] ;
  (* hierconn *) wire       \dut.g_references.operands.rows.words[1] ;
  (* hierconn *) wire       \dut.g_references.operands.rows.words[2] ;
  (* hierconn *) wire       \dut.g_references.operands.rows.words[3] ;
  (* hierconn *) wire [1:0] \dut.g_references.operands.candidates.words[0] ;
  (* hierconn *) wire [1:0] \dut.g_references.operands.candidates.words[1] ;
  (* hierconn *) wire [1:0] \dut.g_references.operands.candidates.words[2] ;
  (* hierconn *) wire [1:0] \dut.g_references.operands.candidates.words[3] ;
  (* hierconn *) wire       \dut.g_stage[0].stage.moving_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[0].stage.index_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[0].stage.word_q ;
  (* hierconn *) wire       \dut.g_stage[0].stage.row_valid_q ;
  (* hierconn *) wire [2:0] \dut.g_stage[0].stage.row_q ;
  (* hierconn *) wire       \dut.g_stage[0].stage.best_q ;
  (* hierconn *) wire       \dut.g_stage[1].stage.moving_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[1].stage.index_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[1].stage.word_q ;
  (* hierconn *) wire       \dut.g_stage[1].stage.row_valid_q ;
  (* hierconn *) wire [2:0] \dut.g_stage[1].stage.row_q ;
  (* hierconn *) wire       \dut.g_stage[1].stage.best_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[0].stage.g_first.word_0_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[1].stage.g_inner.words_before.words[0] ;
  (* hierconn *) wire [1:0] \dut.g_stage[1].stage.g_inner.words_before.words[1] ;

  wire [3:0] queued;
  wire [8:0] queue;
  wire [3:0] tags_inside;
  wire [9:0] tags;

  fifo_view #(
    .WIDTH     (1),
    .DEPTH_BITS(3)
  ) queue_inside (
    .started  (started),
    .write_q  (\dut.converted_rows.beats.write_q ),
    .read_q   (\dut.converted_rows.beats.read_q ),
    .m_valid_q(\dut.converted_rows.beats.m_valid_q ),
    .words    ({\dut.converted_rows.beats.memory.words[7] ,
                \dut.converted_rows.beats.memory.words[6] ,
                \dut.converted_rows.beats.memory.words[5] ,
                \dut.converted_rows.beats.memory.words[4] ,
                \dut.converted_rows.beats.memory.words[3] ,
                \dut.converted_rows.beats.memory.words[2] ,
                \dut.converted_rows.beats.memory.words[1] ,
                \dut.converted_rows.beats.memory.words[0] }),
    .m_data   (\dut.converted_rows.beats.m_axis_tdata ),
    .count    (queued),
    .contents (queue),
    .holds    (),
    .ranks    ()
  );

  fifo_view #(
    .WIDTH     (2),
    .DEPTH_BITS(2)
  ) tags_view (
    .started  (started),
    .write_q  (\dut.tags.write_q ),
    .read_q   (\dut.tags.read_q ),
    .m_valid_q(\dut.tags.m_valid_q ),
    .words    ({\dut.tags.memory.words[3] ,
                \dut.tags.memory.words[2] ,
                \dut.tags.memory.words[1] ,
                \dut.tags.memory.words[0] }),
    .m_data   (\dut.tags.m_axis_tdata ),
    .count    (tags_inside),
    .contents (tags),
    .holds    (),
    .ranks    ()
  );

  // Candidates that were sent: how many are in the memory, have come to a stage, and are stored
  // there. A stage that has its own hands nothing on.
  wire [7:0] candidates = {candidate_2, candidate_2, candidate_1, candidate_0};
  wire [2:0] sent       = \dut.loader.sent_q ;
  wire       converts   = \dut.loaded_beside_word.g_shift.rank_q ;
  wire       passes_2   = \dut.g_stage[1].stage.moving_q && (\dut.g_stage[1].stage.index_q != 2'd2);
  wire       passes_1   = \dut.g_stage[0].stage.moving_q && (\dut.g_stage[0].stage.index_q != 2'd1);
  wire [2:0] in_memory  = sent - {2'b00, \dut.loader.word_valid_q };
  wire [2:0] at_2       = in_memory - {2'b00, converts};
  wire [2:0] stored_2   = at_2 - {2'b00, passes_2};
  wire [2:0] at_1       = (stored_2 > 3'd2) ? 3'd2 : stored_2;
  wire [2:0] stored_1   = at_1 - {2'b00, passes_1};
  wire       is_next    = ended && !\dut.loader.ended_q ;  // no candidate of the next load has come
  wire [7:0] in_full    = {\dut.g_references.operands.candidates.words[3] , \dut.g_references.operands.candidates.words[2] ,
                           \dut.g_references.operands.candidates.words[1] , \dut.g_references.operands.candidates.words[0] };
  wire [3:0] full_rows  = {\dut.g_references.operands.rows.words[3] , \dut.g_references.operands.rows.words[2] ,
                           \dut.g_references.operands.rows.words[1] , \dut.g_references.operands.rows.words[0] };

  // The rows as {best, word, place}: in lane 2, in front of it, in lane 1, in front of it.
  wire        converting = \dut.row_beside_word.g_shift.rank_q ;
  wire [19:0] rows       = {1'b0, \dut.g_stage[0].stage.best_q , \dut.g_stage[0].stage.row_q ,
                            tag_1_q[3:2], tag_1_q[6], tag_1_q[1:0],
                            1'b0, \dut.g_stage[1].stage.best_q , \dut.g_stage[1].stage.row_q ,
                            tag_2_q[3:2], tag_2_q[6], tag_2_q[1:0]};
  wire [3:0]  exist      = {\dut.g_stage[0].stage.row_valid_q , holds[0],
                            \dut.g_stage[1].stage.row_valid_q , holds[1]};
  wire [1:0]  oldest     = place_of_next - inside[1:0];
  wire [1:0]  from_next  = watched_place - \dut.next_place_q ;
  reg  [3:0]  places;          // the places of the chain so far that hold a row
  reg         in_order;
  reg         in_chain;        // the watched row is in the chain
  reg         watched_right;
  reg         best_right;
  reg         is_watched;
  reg  [3:0]  cycles_left;     // cycles until a row enters a lane or leaves, if no one stalls
  integer     w;

  always @* begin
    places        = NONE;
    in_order      = 1'b1;
    in_chain      = 1'b0;
    watched_right = 1'b1;
    best_right    = 1'b1;
    for (w = 0; w < 4; w = w + 1) begin
      is_watched    = watching && exist[w] && (rows[5*w +: 2] == watched_place);
      in_order      = in_order && (!exist[w] || (rows[5*w +: 2] == oldest + places[1:0]));
      in_chain      = in_chain || is_watched;
      watched_right = watched_right && (!is_watched || (
          (rows[5*w+2] == !row) && (meets_1 == (w == 3)) && (meets_2 == (w > 0))));
      best_right    = best_right && (!exist[w] || (w < 2) || (rows[5*w+3 +: 2] == 2'd0)) &&
          (!is_watched || (w > 1) || (rows[5*w+3 +: 2] == {1'b0, better_1})) &&
          (!is_watched || (w != 2) || (better_1 == (verdict_1_q == 2'd2))) &&
          (!is_watched || (w != 0) || (better_2 == (verdict_2_q == 2'd2)));
      places        = places + {3'b000, exist[w]};
    end
  end

  always @* begin
    cycles_left = 4'd3;
    if (holds[1]) begin
      cycles_left = offered[1] ? NONE : ONE;
    end else if (exist[1]) begin
      cycles_left = NONE;
    end else if (holds[0]) begin
      cycles_left = offered[0] ? ONE : 4'd2;
    end else if (exist[3]) begin
      cycles_left = NONE;
    end else if (\dut.converted_rows.beats.m_valid_q ) begin
      cycles_left = ONE;
    end else if (queued != NONE) begin
      cycles_left = 4'd2;
    end
    if (started) begin
      lemma_loading: assert(is_next ? (sent == 3'd0)
                                    : (\dut.loader.ended_q || (sent == {1'b0, loaded})));
      lemma_sent: assert((sent <= 3'd3) && (!\dut.loader.ended_q || (ended && (sent != 3'd0))));
      lemma_overrun: assert((\dut.loader.overrun_q == (too_many && !is_next)) &&
                            (!\dut.loader.overrun_q || (sent == 3'd3)));
      lemma_complete: assert(!\dut.loader.complete_q || (\dut.loader.ended_q && (sent == 3'd3) &&
                                                         !\dut.loader.word_valid_q ));
      lemma_repeated: assert(!\dut.loader.ended_q || (sent == 3'd3) ||
                             ((\dut.loader.word_data_q == candidate_2) &&
                              ((sent == 3'd2) || (candidate_1 == candidate_2))));
      lemma_word: assert(!\dut.loader.word_valid_q || (sent != 3'd0) &&
          ({1'b0, \dut.loader.word_index_q } == in_memory) &&
          (\dut.loader.word_data_q == candidates[2*in_memory[1:0] +: 2]));
      lemma_in_memory: assert((in_memory <= sent) &&
          ((in_memory < 3'd1) || (in_full[1:0] == candidate_0)) &&
          ((in_memory < 3'd2) || (in_full[3:2] == candidate_1)) &&
          ((in_memory < 3'd3) || (in_full[5:4] == candidate_2)));
      lemma_conversion: assert((at_2 <= in_memory) && (!converts ||
          (({1'b0, \dut.index_beside_word.g_shift.rank_q } == at_2) &&
           (candidate_word == ~candidates[2*at_2[1:0] +: 2]))));
      lemma_stage_2: assert((stored_2 <= at_2) && ((at_2 == 3'd0) ||
          (({1'b0, \dut.g_stage[1].stage.index_q } == at_2 - 3'd1) &&
           (\dut.g_stage[1].stage.word_q == ~candidates[2*(at_2-3'd1) +: 2]))));
      lemma_words_before_2: assert(
          ((stored_2 == 3'd0) ||
           (\dut.g_stage[1].stage.g_inner.words_before.words[0] == ~candidate_0)) &&
          ((stored_2 < 3'd2) ||
           (\dut.g_stage[1].stage.g_inner.words_before.words[1] == ~candidate_1)));
      lemma_stage_1: assert((stored_1 <= at_1) && ((at_1 == 3'd0) ||
          (({1'b0, \dut.g_stage[0].stage.index_q } == at_1 - 3'd1) &&
           (\dut.g_stage[0].stage.word_q == ~candidates[2*(at_1-3'd1) +: 2]))));
      lemma_word_0: assert((stored_1 == 3'd0) ||
                           (\dut.g_stage[0].stage.g_first.word_0_q == ~candidate_0));
      lemma_inside: assert((inside == {1'b0, \dut.inside_q }) && (inside <= 4'd4) &&
                           (inside == places + queued + {3'b000, converting}) &&
                           ((inside == NONE) || (\dut.loader.complete_q && (at_2 == 3'd3))));
      lemma_places: assert(in_order && (\dut.free_place_q == place_of_next) &&
                           (\dut.next_place_q == oldest + places[1:0]));
      lemma_tags: assert((tags_inside == inside) &&
                         (\dut.tags.m_valid_q || (inside == NONE) ||
                          ((inside == ONE) && converting)));
      lemma_in_lanes: assert((offered & ~holds) == 2'b00);
      lemma_watched: assert(!watching || (
          (ahead < inside) && (watched_place == oldest + ahead[1:0]) && watched_right &&
          (tags[2*ahead[2:0] +: 2] == {last, user}) && (full_rows[watched_place] == row) &&
          (in_chain == (ahead < places)) &&
          (in_chain || (meets_1 && meets_2 &&
                        (({2'b00, from_next} < queued) ? (queue[from_next] == !row)
                                                       : (converting && (row_word == !row)))))));
      lemma_not_watched: assert(watching || (!meets_1 && !meets_2));
      lemma_best: assert(best_right);
      lemma_word_of_best: assert(!exist[1] ||
                                 (pair_best[3:2] == ~(rows[8] ? candidate_1 : candidate_0)));
      lemma_moves_soon: assert((inside == NONE) || (quiet + cycles_left < MOST_QUIET));
      lemma_is_quiet: assert((inside != NONE) || (quiet == NONE));
    end
  end

  always @* begin
    if (!aresetn) begin
      assume(!c_valid);
      assume(!s_valid);
    end
    if (started && aresetn) begin
      nothing_made_up: assert(!m_valid || (inside != NONE));
      few_inside: assert(inside <= 4'd4);
      meets_1_once: assert(!takes[0] || !watched_1 || meets_1);
      meets_2_once: assert(!takes[1] || !watched_2 || (meets_2 && !meets_1));
      meets_0_and_1: assert(!takes[0] || !watched_1 ||
                            ({pair_tag[6], pair_best[1:0], pair_own[1:0]} ==
                             {!row, ~candidate_0, ~candidate_1}));
      meets_best_and_2: assert(!takes[1] || !watched_2 ||
                               ({pair_tag[13], pair_best[3:2], pair_own[3:2]} ==
                                {!row, ~best, ~candidate_2}));
      tag_1_names_the_full_ones: assert(!holds[0] || !watching || (tag_1_q[1:0] != watched_place) ||
          ({full_rows[tag_1_q[1:0]], in_full[2*tag_1_q[3:2] +: 2], in_full[2*tag_1_q[5:4] +: 2]} ==
           {row, candidate_0, candidate_1}));
      tag_2_names_the_full_ones: assert(!holds[1] || !watching || (tag_2_q[1:0] != watched_place) ||
          ({full_rows[tag_2_q[1:0]], in_full[2*tag_2_q[3:2] +: 2], in_full[2*tag_2_q[5:4] +: 2]} ==
           {row, best, candidate_2}));
      leaves_once_in_order: assert(!m_valid || !watched_m || (!meets_1 && !meets_2));
      leaves_as_it_came: assert(!m_valid || !watched_m || ({m_last, m_user} == {last, user}));
      names_the_best: assert(!m_valid || !watched_m || (m_data == (better_2 ? 8'd2 : {7'd0, better_1})));
      holds_still: assert(!held || (m_valid && ({m_data, m_user, m_last} == held_result)));
      loads_when_empty: assert(!c_accept || !ended || (inside == NONE));
      rows_meet_whole_loads: assert(!enters || ended);
      overrun_told: assert(!enters || (overrun == too_many));
      keeps_moving: assert(quiet < MOST_QUIET);
      can_choose_2_of_many: cover(leaves && watched_m && better_2 && (inside == 4'd4));
      can_choose_1_of_few: cover(leaves && watched_m && better_1 && !better_2 && short);
      can_load_again: cover(enters && again && too_many);
      can_wrap: cover(leaves && watched_m && (watched_place == 2'd1) && (place_of_next == 2'd0));
      can_hold: cover(held && watched_m);
    end
  end

endmodule

`default_nettype wire
