// arg_min_proof: whatever stalls, rows leave in the order in which they came, none is lost or made up, and
// each lane compares the best candidate so far with its own. One row at a time, chosen by the solver, is
// watched on its way past candidates 0, 1 and 2; its tag is 1, and the rows ahead of it are counted. Both
// lanes hold one pair each for as long as they like.
// The lemmas read registers of the template, and together hold by induction. They say which candidates
// of a load have come how far, and go over all places of rows from the last to the first.
`default_nettype none

module arg_min_proof (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       c_valid,
  input wire       c_last,
  input wire [1:0] c_data,
  input wire       s_valid,
  input wire       s_last,
  input wire       s_data,
  input wire       choose,     // the row that enters is watched, if no other is
  input wire       m_ready,
  input wire [1:0] willing,    // a lane without a pair takes one
  input wire [1:0] finishing,  // a lane with a pair offers its verdict
  input wire [3:0] verdicts    // and this is it
);

  localparam [3:0] NONE = 0;
  localparam [3:0] ONE  = 1;
  localparam MOST_QUIET = 10;

  wire       c_ready;
  wire       s_ready;
  wire [1:0] pair_valid;
  wire [1:0] pair_ready;
  wire [1:0] pair_row;
  wire [3:0] pair_best;
  wire [3:0] pair_own;
  wire [1:0] result_valid;
  wire [1:0] result_ready;
  wire [1:0] verdict_1;
  wire [1:0] verdict_2;
  wire       m_valid;
  wire [7:0] m_data;
  wire       m_user;
  wire       m_last;
  wire       overrun;

  reg        started  = 1'b0;
  wire       aresetn  = started && aresetn_later;
  reg        watching = 1'b0;
  wire       chosen   = choose && !watching;

  arg_min_engine #(
    .CANDIDATES    (3),
    .CANDIDATE_BITS(2),
    .ROW_BITS      (1),
    .TAG_BITS      (1),
    .INDEX_BITS    (2),
    .SLOT_BITS     (1),
    .COUNTER_BITS  (0)
  ) dut (
    .aclk              (aclk),
    .aresetn           (aresetn),
    .s_candidate_tvalid(c_valid),
    .s_candidate_tready(c_ready),
    .s_candidate_tdata (c_data),
    .s_candidate_tlast (c_last),
    .s_axis_tvalid     (s_valid),
    .s_axis_tready     (s_ready),
    .s_axis_tdata      (s_data),
    .s_axis_tuser      (chosen),
    .s_axis_tlast      (s_last),
    .pair_tvalid       (pair_valid),
    .pair_tready       (pair_ready),
    .pair_row          (pair_row),
    .pair_best         (pair_best),
    .pair_own          (pair_own),
    .result_tvalid     (result_valid),
    .result_tready     (result_ready),
    .result_tdata      ({6'd0, verdict_2, 6'd0, verdict_1}),
    .m_axis_tvalid     (m_valid),
    .m_axis_tready     (m_ready),
    .m_axis_tdata      (m_data),
    .m_axis_tuser      (m_user),
    .m_axis_tlast      (m_last),
    .overrun           (overrun),
    .rows              (),
    .stalled_cycles    ()
  );

  // Candidates as they were offered: the last of a short load is each of those that are missing.
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

  // Rows: how many are before a lane or inside at all, and how many of these ahead of the watched one.
  reg  [3:0] before_1 = NONE;
  reg  [3:0] before_2 = NONE;
  reg  [3:0] inside   = NONE;
  reg  [3:0] ahead_1;
  reg  [3:0] ahead_2;
  reg  [3:0] ahead;
  reg        meets_1  = 1'b0;  // the watched row has to meet lane 1
  reg        meets_2  = 1'b0;
  reg  [3:0] quiet    = NONE;  // cycles in which nothing moves though everybody would
  reg        again    = 1'b0;  // a row left before
  reg        row;
  reg        last;
  reg        better_1;  // candidate 1 costs the watched row less than candidate 0
  reg        better_2;  // and candidate 2 less than the better of them
  wire       enters  = s_valid && s_ready;
  wire       leaves  = m_valid && m_ready;
  wire [1:0] takes   = pair_valid & pair_ready;
  wire [1:0] best    = better_1 ? candidate_1 : candidate_0;
  wire       watched_1 = meets_1 && (ahead_1 == NONE);
  wire       watched_2 = meets_2 && (ahead_2 == NONE);
  wire       watched_m = watching && (ahead == NONE);
  wire       calm;

  always @(posedge aclk) begin
    if (!aresetn) begin
      before_1 <= NONE;
      before_2 <= NONE;
      inside   <= NONE;
      meets_1  <= 1'b0;
      meets_2  <= 1'b0;
      watching <= 1'b0;
      quiet    <= NONE;
      again    <= 1'b0;
    end else begin
      before_1 <= before_1 + {3'b000, enters} - {3'b000, takes[0]};
      before_2 <= before_2 + {3'b000, enters} - {3'b000, takes[1]};
      inside   <= inside + {3'b000, enters} - {3'b000, leaves};
      quiet    <= (calm && (takes == 2'b00) && !leaves && (inside != NONE)) ? quiet + ONE : NONE;
      again    <= again || leaves;
      if (takes[0]) begin
        ahead_1 <= ahead_1 - ONE;
        meets_1 <= meets_1 && (ahead_1 != NONE);
      end
      if (takes[1]) begin
        ahead_2 <= ahead_2 - ONE;
        meets_2 <= meets_2 && (ahead_2 != NONE);
      end
      if (leaves) begin
        ahead    <= ahead - ONE;
        watching <= watching && (ahead != NONE);
      end
      if (enters && chosen) begin
        watching <= 1'b1;
        meets_1  <= 1'b1;
        meets_2  <= 1'b1;
        ahead_1  <= before_1 - {3'b000, takes[0]};
        ahead_2  <= before_2 - {3'b000, takes[1]};
        ahead    <= inside - {3'b000, leaves};
      end
    end
    if (enters && chosen) begin
      row  <= s_data;
      last <= s_last;
    end
    if (takes[0] && watched_1) begin
      better_1 <= (verdicts[1:0] == 2'd2);
    end
    if (takes[1] && watched_2) begin
      better_2 <= (verdicts[3:2] == 2'd2);
    end
  end

  // Lanes.
  reg  [1:0] holds   = 2'b00;
  reg  [1:0] offered = 2'b00;
  reg  [1:0] verdict_1_q;
  reg  [1:0] verdict_2_q;

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
    end
    if (takes[1]) begin
      verdict_2_q <= verdicts[3:2];
    end
  end

  reg       held = 1'b0;
  reg [9:0] held_result;

  always @(posedge aclk) begin
    held        <= aresetn && m_valid && !m_ready;
    held_result <= {m_data, m_user, m_last};
  end

  // Registers of the template.
  (* hierconn *) wire [2:0] \dut.loader.sent_q ;
  (* hierconn *) wire       \dut.loader.ended_q ;
  (* hierconn *) wire       \dut.loader.complete_q ;
  (* hierconn *) wire       \dut.loader.overrun_q ;
  (* hierconn *) wire       \dut.loader.word_valid_q ;
  (* hierconn *) wire [1:0] \dut.loader.word_index_q ;
  (* hierconn *) wire [1:0] \dut.loader.word_data_q ;
  (* hierconn *) wire [3:0] \dut.inside_q ;
  (* hierconn *) wire       \dut.g_stage[0].stage.moving_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[0].stage.index_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[0].stage.candidate_q ;
  (* hierconn *) wire       \dut.g_stage[0].stage.row_valid_q ;
  (* hierconn *) wire [2:0] \dut.g_stage[0].stage.row_q ;
  (* hierconn *) wire       \dut.g_stage[0].stage.best_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[0].stage.queue.write_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[0].stage.queue.read_q ;
  (* hierconn *) wire       \dut.g_stage[0].stage.queue.m_valid_q ;
  (* hierconn *) wire [3:0] \dut.g_stage[0].stage.queue.m_axis_tdata ;
  (* hierconn *) wire [3:0] \dut.g_stage[0].stage.queue.memory.words[0] ;
  (* hierconn *) wire [3:0] \dut.g_stage[0].stage.queue.memory.words[1] ;
  (* hierconn *) wire       \dut.g_stage[1].stage.moving_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[1].stage.index_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[1].stage.candidate_q ;
  (* hierconn *) wire       \dut.g_stage[1].stage.row_valid_q ;
  (* hierconn *) wire [2:0] \dut.g_stage[1].stage.row_q ;
  (* hierconn *) wire       \dut.g_stage[1].stage.best_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[1].stage.queue.write_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[1].stage.queue.read_q ;
  (* hierconn *) wire       \dut.g_stage[1].stage.queue.m_valid_q ;
  (* hierconn *) wire [3:0] \dut.g_stage[1].stage.queue.m_axis_tdata ;
  (* hierconn *) wire [3:0] \dut.g_stage[1].stage.queue.memory.words[0] ;
  (* hierconn *) wire [3:0] \dut.g_stage[1].stage.queue.memory.words[1] ;
  (* hierconn *) wire [1:0] \dut.g_stage[0].stage.g_first.candidate_0_q ;
  (* hierconn *) wire [1:0] \dut.g_stage[1].stage.g_inner.candidates.words[0] ;
  (* hierconn *) wire [1:0] \dut.g_stage[1].stage.g_inner.candidates.words[1] ;

  wire [3:0]  queue_1_count;
  wire [11:0] queue_1;
  wire [3:0]  queue_2_count;
  wire [11:0] queue_2;

  fifo_view #(
    .WIDTH     (4),
    .DEPTH_BITS(1)
  ) queue_1_inside (
    .started  (started),
    .write_q  (\dut.g_stage[0].stage.queue.write_q ),
    .read_q   (\dut.g_stage[0].stage.queue.read_q ),
    .m_valid_q(\dut.g_stage[0].stage.queue.m_valid_q ),
    .words    ({\dut.g_stage[0].stage.queue.memory.words[1] ,
                \dut.g_stage[0].stage.queue.memory.words[0] }),
    .m_data   (\dut.g_stage[0].stage.queue.m_axis_tdata ),
    .count    (queue_1_count),
    .contents (queue_1),
    .holds    (),
    .ranks    ()
  );

  fifo_view #(
    .WIDTH     (4),
    .DEPTH_BITS(1)
  ) queue_2_inside (
    .started  (started),
    .write_q  (\dut.g_stage[1].stage.queue.write_q ),
    .read_q   (\dut.g_stage[1].stage.queue.read_q ),
    .m_valid_q(\dut.g_stage[1].stage.queue.m_valid_q ),
    .words    ({\dut.g_stage[1].stage.queue.memory.words[1] ,
                \dut.g_stage[1].stage.queue.memory.words[0] }),
    .m_data   (\dut.g_stage[1].stage.queue.m_axis_tdata ),
    .count    (queue_2_count),
    .contents (queue_2),
    .holds    (),
    .ranks    ()
  );

  // Candidates: of the words that were sent, how many have come to a stage.
  wire [7:0] candidates = {candidate_2, candidate_2, candidate_1, candidate_0};
  wire [2:0] sent       = \dut.loader.sent_q ;
  wire [2:0] at_2       = sent - {2'b00, \dut.loader.word_valid_q };
  wire [2:0] stored_2   = at_2 - {2'b00, \dut.g_stage[1].stage.moving_q };
  wire [2:0] at_1       = (stored_2 > 3'd2) ? 3'd2 : stored_2;
  wire [2:0] stored_1   = at_1 - {2'b00, \dut.g_stage[0].stage.moving_q };
  wire       is_next    = ended && !\dut.loader.ended_q ;  // nothing of the next load has come

  // Rows, {best, last, tag, row}: those beyond lane 2, before it, beyond lane 1, before it.
  wire [31:0] rows    = {\dut.g_stage[0].stage.best_q , \dut.g_stage[0].stage.row_q , queue_1,
                         \dut.g_stage[1].stage.best_q , \dut.g_stage[1].stage.row_q , queue_2};
  wire [7:0]  exist   = {\dut.g_stage[0].stage.row_valid_q , (4'd2 < queue_1_count),
                         (4'd1 < queue_1_count), (4'd0 < queue_1_count),
                         \dut.g_stage[1].stage.row_valid_q , (4'd2 < queue_2_count),
                         (4'd1 < queue_2_count), (4'd0 < queue_2_count)};
  reg  [3:0]  places;          // with a row, up to here
  reg  [3:0]  places_before_2;
  reg  [3:0]  watched_places;
  reg         is_watched;
  reg         watched_right;
  reg         best_right;
  reg  [1:0]  lane_left;       // cycles until a lane's result can leave, if nobody stalls
  reg  [3:0]  cycles_left;     // until a row enters a lane or leaves
  integer     w;

  always @* begin
    places          = NONE;
    places_before_2 = NONE;
    watched_places  = NONE;
    watched_right   = 1'b1;
    best_right      = 1'b1;
    for (w = 0; w < 8; w = w + 1) begin
      is_watched     = exist[w] && rows[4*w+1];
      watched_places = watched_places + {3'b000, is_watched};
      watched_right  = watched_right && (!is_watched || (
          (places == ahead) && ({rows[4*w+2], rows[4*w]} == {last, row}) && (meets_1 == (w == 7)) &&
          (meets_2 == (w > 2)) && ((w < 3) || (places_before_2 == ahead_2)) &&
          ((w != 7) || (ahead_1 == NONE))));
      best_right     = best_right && (!exist[w] || (w <= 3) || !rows[4*w+3]) &&
          (!is_watched || (w > 3) || (rows[4*w+3] == better_1)) &&
          (!is_watched || (w < 4) || (w > 6) || (better_1 == (verdict_1_q == 2'd2))) &&
          (!is_watched || (w > 2) || (better_2 == (verdict_2_q == 2'd2)));
      places          = places + {3'b000, exist[w]};
      places_before_2 = places_before_2 + {3'b000, exist[w] && (w > 2)};
    end
  end

  always @* begin
    lane_left   = 2'd0;
    cycles_left = NONE;
    if (holds[1]) begin
      cycles_left = (offered[1] && \dut.g_stage[1].stage.queue.m_valid_q ) ? NONE : ONE;
    end else if (holds[0] && !exist[3]) begin
      cycles_left = (offered[0] && \dut.g_stage[0].stage.queue.m_valid_q ) ? ONE : 4'd2;
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
          ({1'b0, \dut.loader.word_index_q } == at_2) &&
          (\dut.loader.word_data_q == candidates[2*at_2[1:0] +: 2]));
      lemma_stage_2: assert((stored_2 <= at_2) && (at_2 <= sent) && ((at_2 == 3'd0) ||
          (({1'b0, \dut.g_stage[1].stage.index_q } == at_2 - 3'd1) &&
           (\dut.g_stage[1].stage.candidate_q == candidates[2*(at_2-3'd1) +: 2]))));
      lemma_memory: assert(((stored_2 == 3'd0) ||
                            (\dut.g_stage[1].stage.g_inner.candidates.words[0] == candidate_0)) &&
                           ((stored_2 < 3'd2) ||
                            (\dut.g_stage[1].stage.g_inner.candidates.words[1] == candidate_1)));
      lemma_stage_1: assert((stored_1 <= at_1) && ((at_1 == 3'd0) ||
          (({1'b0, \dut.g_stage[0].stage.index_q } == at_1 - 3'd1) &&
           (\dut.g_stage[0].stage.candidate_q == candidates[2*(at_1-3'd1) +: 2]))));
      lemma_candidate_0: assert((stored_1 == 3'd0) ||
                                (\dut.g_stage[0].stage.g_first.candidate_0_q == candidate_0));
      lemma_inside: assert((inside == \dut.inside_q ) && (inside == places) &&
                           ((inside == NONE) || \dut.loader.complete_q ));
      lemma_before: assert((before_1 == {3'b000, exist[7]}) && (before_2 == places_before_2));
      lemma_in_lanes: assert((queue_1_count == {3'b000, holds[0]}) &&
                             (queue_2_count == {3'b000, holds[1]}) && ((offered & ~holds) == 2'b00));
      lemma_watched: assert((watched_places == {3'b000, watching}) && watched_right &&
                            (watching || (!meets_1 && !meets_2)));
      lemma_best: assert(best_right);
      lemma_operands: assert(!exist[3] || (pair_best[3:2] == (rows[15] ? candidate_1 : candidate_0)));
      lemma_moves_soon: assert(quiet + cycles_left < MOST_QUIET);
    end
  end

  always @* begin
    if (!aresetn) begin
      assume(!c_valid);
      assume(!s_valid);
    end
    if (started && aresetn) begin
      nothing_made_up: assert(!m_valid || (inside != NONE));
      few_inside: assert(inside < 4'd12);
      lane_1_takes_what_came: assert(!takes[0] || (before_1 != NONE));
      lane_2_takes_what_came: assert(!takes[1] || (before_2 != NONE));
      meets_0_and_1: assert(!takes[0] || !watched_1 ||
                            ({pair_row[0], pair_best[1:0], pair_own[1:0]} ==
                             {row, candidate_0, candidate_1}));
      meets_best_and_2: assert(!takes[1] || !watched_2 ||
                               ({pair_row[1], pair_best[3:2], pair_own[3:2]} ==
                                {row, best, candidate_2}));
      leaves_once_in_order: assert(!m_valid || (m_user == watched_m));
      leaves_as_it_came: assert(!m_valid || !watched_m || (m_last == last));
      leaves_behind_its_lanes: assert(!m_valid || !watched_m || (!meets_1 && !meets_2));
      names_the_best: assert(!m_valid || !watched_m || (m_data == (better_2 ? 8'd2 : {7'd0, better_1})));
      holds_still: assert(!held || (m_valid && ({m_data, m_user, m_last} == held_result)));
      loads_when_empty: assert(!c_accept || !ended || (inside == NONE));
      rows_meet_whole_loads: assert(!enters || ended);
      overrun_told: assert(!enters || (overrun == too_many));
      keeps_moving: assert(quiet < MOST_QUIET);
      can_choose_2_of_many: cover(leaves && watched_m && better_2 && (inside == 4'd3));
      can_choose_1_of_few: cover(leaves && watched_m && better_1 && !better_2 && short);
      can_load_again: cover(enters && again && too_many);
      can_hold: cover(held && watched_m);
    end
  end

endmodule

`default_nettype wire
