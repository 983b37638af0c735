// recomputation_proof: every pair that pair_recomputation takes is asked of one reference, once, with
// its own items, and its verdict leaves once if it is reported; the closing beat leaves behind all
// verdicts. The pair with one tag, chosen by the solver, is watched; REFERENCES references hold one
// pair each for as long as they like. The items' memory is any table, and holds its word until it is
// read again.
// The lemmas read registers of the template, and together hold by induction. They count the pairs in all
// places: those that wait, the one whose items come, the one on offer, those in references, and verdicts
// in the queues and behind them.
`default_nettype none

module recomputation_proof #(
  parameter REPORT = 11,
  parameter EVERY_CYCLE = -1
) (
  input wire                    aclk,
  input wire                    aresetn_later,
  input wire                    s_valid,
  input wire                    s_last,
  input wire [1:0]              s_tag,        // j, i
  input wire [1:0]              willing,      // a reference without a pair takes one
  input wire [1:0]              finishing,    // a reference with a pair answers
  input wire [3:0]              verdicts,     // the verdict of each reference
  input wire                    m_ready
);

  localparam REFERENCES = 2;
  localparam [4:0] NONE = 0;
  localparam [4:0] ONE  = 1;
  localparam [3:0] REPORTS = REPORT[3:0];
  localparam MOST_QUIET = 12;

  (* anyconst *) reg [1:0] items;    // item i is bit i
  (* anyconst *) reg [1:0] watched;  // a tag

  wire                    s_ready;
  wire                    memory_enable;
  wire [1:0]              memory_addresses;
  reg  [1:0]              memory_q;
  wire [REFERENCES-1:0]   request_valid;
  wire [REFERENCES-1:0]   request_ready;
  wire [1:0]              request_tag;
  wire [1:0]              request_items;
  wire [REFERENCES-1:0]   answer_valid;
  wire [4*REFERENCES-1:0] answers;
  wire                    m_valid;
  wire [1:0]              m_tag;
  wire [1:0]              m_verdict;
  wire                    m_last;
  wire                    answered;

  reg                     started = 1'b0;
  wire                    aresetn = started && aresetn_later;

  pair_recomputation #(
    .REFERENCES      (REFERENCES),
    .ITEM_BITS       (1),
    .INDEX_BITS      (1),
    .REPORT          (REPORT),
    .EVERY_CYCLE     (EVERY_CYCLE),
    .OUTSTANDING_BITS(1),
    .QUEUE_BITS      (1)
  ) dut (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .s_pair_tvalid   (s_valid),
    .s_pair_tready   (s_ready),
    .s_pair_tag      (s_tag),
    .s_pair_tlast    (s_last),
    .memory_enable   (memory_enable),
    .memory_addresses(memory_addresses),
    .memory_items    (memory_q),
    .m_request_tvalid(request_valid),
    .m_request_tready(request_ready),
    .m_request_tag   (request_tag),
    .m_request_items (request_items),
    .s_answer_valid  (answer_valid),
    .s_answer_tdata  (answers),
    .m_axis_tvalid   (m_valid),
    .m_axis_tready   (m_ready),
    .m_axis_tdata    ({m_tag, m_verdict}),
    .m_axis_tlast    (m_last),
    .answered        (answered)
  );

  wire take      = s_valid && s_ready;
  wire leave     = m_valid && m_ready;
  wire is_watched = (s_tag == watched);

  // The references.
  reg  [REFERENCES-1:0]   busy  = {REFERENCES{1'b0}};
  reg  [2*REFERENCES-1:0] tags;
  wire [REFERENCES-1:0]   asked = request_valid & request_ready;
  wire [REFERENCES-1:0]   about_watched;

  assign request_ready = willing & ~busy;
  assign answer_valid  = busy & finishing;

  genvar r;
  generate
    for (r = 0; r < REFERENCES; r = r + 1) begin : g_reference
      assign answers[4*r +: 4] = {tags[2*r +: 2], verdicts[2*r +: 2]};
      assign about_watched[r]  = answer_valid[r] && (tags[2*r +: 2] == watched);

      always @(posedge aclk) begin
        if (!aresetn) begin
          busy[r] <= 1'b0;
        end else begin
          busy[r] <= asked[r] || (busy[r] && !finishing[r]);
        end
        if (asked[r]) begin
          tags[2*r +: 2] <= request_tag;
        end
      end
    end
  endgenerate

  // The watched pair comes once in a set; the closing beat comes last.
  reg        waits     = 1'b0;  // taken and not yet asked of a reference
  reg        computes  = 1'b0;  // asked and not yet answered
  reg        due       = 1'b0;  // answered, and its verdict has to leave
  reg        seen      = 1'b0;
  reg  [1:0] verdict;
  reg  [4:0] open      = NONE;  // pairs taken and not yet answered
  reg        close_due = 1'b0;
  reg  [4:0] quiet     = NONE;  // cycles in which nothing moves though everybody would
  reg        held_request = 1'b0;
  reg  [REFERENCES+3:0] held_request_data;
  reg        held = 1'b0;
  reg  [4:0] held_data;
  integer    k;

  wire       moves = (asked != {REFERENCES{1'b0}}) || answered || (leave && m_last) ||
                     (answer_valid != {REFERENCES{1'b0}});
  wire       calm  = m_ready && (((busy & ~finishing) | (~busy & ~willing)) == {REFERENCES{1'b0}});

  always @(posedge aclk) begin
    started           <= 1'b1;
    held_request      <= aresetn && (request_valid != {REFERENCES{1'b0}}) &&
                         (asked == {REFERENCES{1'b0}});
    held_request_data <= {request_valid, request_tag, request_items};
    held              <= aresetn && m_valid && !m_ready;
    held_data         <= {m_last, m_tag, m_verdict};
    if (memory_enable) begin
      memory_q <= {items[memory_addresses[1]], items[memory_addresses[0]]};
    end
    if (!aresetn) begin
      waits     <= 1'b0;
      computes  <= 1'b0;
      due       <= 1'b0;
      seen      <= 1'b0;
      open      <= NONE;
      close_due <= 1'b0;
      quiet     <= NONE;
    end else begin
      waits     <= (take && !s_last && is_watched) ||
                   (waits && !((asked != {REFERENCES{1'b0}}) && (request_tag == watched)));
      computes  <= ((asked != {REFERENCES{1'b0}}) && (request_tag == watched)) ||
                   (computes && (about_watched == {REFERENCES{1'b0}}));
      seen      <= !(leave && m_last) && (seen || (take && !s_last && is_watched));
      open      <= open + {4'd0, take && !s_last} - {4'd0, answered};
      close_due <= (take && s_last) || (close_due && !(leave && m_last));
      quiet     <= (calm && !moves && ((open != NONE) || close_due)) ? quiet + ONE : NONE;
      if (leave && !m_last && (m_tag == watched)) begin
        due <= 1'b0;
      end
      for (k = 0; k < REFERENCES; k = k + 1) begin
        if (about_watched[k]) begin
          due     <= REPORTS[verdicts[2*k +: 2]];
          verdict <= verdicts[2*k +: 2];
        end
      end
    end
  end

  // The template's registers that the lemmas read.
  (* hierconn *) wire       \dut.comes_q ;
  (* hierconn *) wire       \dut.offered_q ;
  (* hierconn *) wire       \dut.closes_q ;
  (* hierconn *) wire [1:0] \dut.outstanding_q ;
  (* hierconn *) wire [1:0] \dut.turn_q ;
  (* hierconn *) wire [1:0] \dut.coming_tag_q ;
  (* hierconn *) wire [1:0] \dut.tag_q ;
  (* hierconn *) wire [1:0] \dut.items_q ;
  (* hierconn *) wire [1:0] \dut.pairs.write_q ;
  (* hierconn *) wire [1:0] \dut.pairs.read_q ;
  (* hierconn *) wire       \dut.pairs.m_valid_q ;
  (* hierconn *) wire [2:0] \dut.pairs.m_axis_tdata ;
  (* hierconn *) wire [2:0] \dut.pairs.memory.words[0] ;
  (* hierconn *) wire [2:0] \dut.pairs.memory.words[1] ;
  (* hierconn *) wire       \dut.verdict_valid ;
  (* hierconn *) wire [3:0] \dut.verdict ;
  (* hierconn *) wire [1:0] \dut.g_answers[0].queue.write_q ;
  (* hierconn *) wire [1:0] \dut.g_answers[0].queue.read_q ;
  (* hierconn *) wire       \dut.g_answers[0].queue.m_valid_q ;
  (* hierconn *) wire [3:0] \dut.g_answers[0].queue.m_axis_tdata ;
  (* hierconn *) wire [3:0] \dut.g_answers[0].queue.memory.words[0] ;
  (* hierconn *) wire [3:0] \dut.g_answers[0].queue.memory.words[1] ;
  (* hierconn *) wire [1:0] \dut.g_answers[1].queue.write_q ;
  (* hierconn *) wire [1:0] \dut.g_answers[1].queue.read_q ;
  (* hierconn *) wire       \dut.g_answers[1].queue.m_valid_q ;
  (* hierconn *) wire [3:0] \dut.g_answers[1].queue.m_axis_tdata ;
  (* hierconn *) wire [3:0] \dut.g_answers[1].queue.memory.words[0] ;
  (* hierconn *) wire [3:0] \dut.g_answers[1].queue.memory.words[1] ;

  wire [3:0]  pairs_count;
  wire [8:0]  pairs;
  wire [3:0]  answers_0_count;
  wire [11:0] answers_0;
  wire [3:0]  answers_1_count;
  wire [11:0] answers_1;

  fifo_view #(
    .WIDTH     (3),
    .DEPTH_BITS(1)
  ) pairs_inside (
    .started  (started),
    .write_q  (\dut.pairs.write_q ),
    .read_q   (\dut.pairs.read_q ),
    .m_valid_q(\dut.pairs.m_valid_q ),
    .words    ({\dut.pairs.memory.words[1] , \dut.pairs.memory.words[0] }),
    .m_data   (\dut.pairs.m_axis_tdata ),
    .count    (pairs_count),
    .contents (pairs),
    .holds    (),
    .ranks    ()
  );

  fifo_view #(
    .WIDTH     (4),
    .DEPTH_BITS(1)
  ) answers_inside_0 (
    .started  (started),
    .write_q  (\dut.g_answers[0].queue.write_q ),
    .read_q   (\dut.g_answers[0].queue.read_q ),
    .m_valid_q(\dut.g_answers[0].queue.m_valid_q ),
    .words    ({\dut.g_answers[0].queue.memory.words[1] , \dut.g_answers[0].queue.memory.words[0] }),
    .m_data   (\dut.g_answers[0].queue.m_axis_tdata ),
    .count    (answers_0_count),
    .contents (answers_0),
    .holds    (),
    .ranks    ()
  );

  fifo_view #(
    .WIDTH     (4),
    .DEPTH_BITS(1)
  ) answers_inside_1 (
    .started  (started),
    .write_q  (\dut.g_answers[1].queue.write_q ),
    .read_q   (\dut.g_answers[1].queue.read_q ),
    .m_valid_q(\dut.g_answers[1].queue.m_valid_q ),
    .words    ({\dut.g_answers[1].queue.memory.words[1] , \dut.g_answers[1].queue.memory.words[0] }),
    .m_data   (\dut.g_answers[1].queue.m_axis_tdata ),
    .count    (answers_1_count),
    .contents (answers_1),
    .holds    (),
    .ranks    ()
  );

  // The pairs with verdicts in the queues and behind them.
  wire [27:0] answered_pairs = {\dut.verdict , answers_1, answers_0};
  wire [6:0]  answered_exist = {\dut.verdict_valid , (4'd2 < answers_1_count), (4'd1 < answers_1_count),
                                (4'd0 < answers_1_count), (4'd2 < answers_0_count),
                                (4'd1 < answers_0_count), (4'd0 < answers_0_count)};
  wire [4:0]  under_way = {4'd0, \dut.comes_q } + {4'd0, \dut.offered_q } + {4'd0, busy[0]} +
                          {4'd0, busy[1]} + {4'd0, \dut.verdict_valid } + answers_0_count +
                          answers_1_count;
  reg  [4:0]  waiting;        // pairs in the queue
  reg  [4:0]  closing;
  reg         closing_last;
  reg  [4:0]  watched_waits;  // places with the watched pair
  reg  [4:0]  watched_computes;
  reg  [4:0]  watched_due;
  reg  [4:0]  watched_unreported;
  reg         verdict_right;
  reg         pair_waits;
  reg         closes;
  reg         about;          // the entry is about the watched pair
  reg         reports;
  reg  [4:0]  cycles_left;    // cycles until anything moves, if nobody stalls
  wire [4:0]  watched_places = watched_waits + watched_computes + watched_due + watched_unreported;

  always @* begin
    waiting          = NONE;
    closing          = NONE;
    closing_last     = 1'b1;
    watched_waits    = {4'd0, \dut.comes_q && (\dut.coming_tag_q == watched)} +
                       {4'd0, \dut.offered_q && (\dut.tag_q == watched)};
    watched_computes = NONE;
    for (k = 0; k < 3; k = k + 1) begin
      pair_waits    = (k < pairs_count) && !pairs[3*k+2];
      closes        = (k < pairs_count) && pairs[3*k+2];
      waiting       = waiting + {4'd0, pair_waits};
      watched_waits = watched_waits + {4'd0, pair_waits && (pairs[3*k +: 2] == watched)};
      closing       = closing + {4'd0, closes};
      closing_last  = closing_last && (!closes || (k + 1 == pairs_count));
    end
    for (k = 0; k < REFERENCES; k = k + 1) begin
      watched_computes = watched_computes + {4'd0, busy[k] && (tags[2*k +: 2] == watched)};
    end
  end

  always @* begin
    watched_due        = NONE;
    watched_unreported = NONE;
    verdict_right      = 1'b1;
    for (k = 0; k < 7; k = k + 1) begin
      about              = answered_exist[k] && (answered_pairs[4*k+2 +: 2] == watched);
      reports            = REPORTS[answered_pairs[4*k +: 2]];
      watched_due        = watched_due + {4'd0, about && reports};
      watched_unreported = watched_unreported + {4'd0, about && !reports};
      verdict_right      = verdict_right && (!about || (answered_pairs[4*k +: 2] == verdict));
    end
  end

  always @* begin
    cycles_left = NONE;
    if (pairs_count != NONE) begin
      cycles_left = \dut.pairs.m_valid_q ? 5'd2 : 5'd3;
    end
    if (answers_0_count + answers_1_count != NONE) begin
      cycles_left = 5'd2;
    end
    if (\dut.comes_q || \dut.g_answers[0].queue.m_valid_q || \dut.g_answers[1].queue.m_valid_q ) begin
      cycles_left = ONE;
    end
    if ((busy != {REFERENCES{1'b0}}) || \dut.offered_q || \dut.closes_q || \dut.verdict_valid ) begin
      cycles_left = NONE;
    end
    if (started) begin
      lemma_one_turn: assert((\dut.turn_q == 2'b01) || (\dut.turn_q == 2'b10));
      lemma_items_come: assert(!\dut.comes_q || (memory_q == {items[\dut.coming_tag_q [1]],
                                                             items[\dut.coming_tag_q [0]]}));
      lemma_items: assert(!\dut.offered_q || (\dut.items_q == {items[\dut.tag_q [1]],
                                                              items[\dut.tag_q [0]]}));
      lemma_outstanding: assert(under_way == {3'd0, \dut.outstanding_q });
      lemma_few_outstanding: assert(under_way <= 5'd2);
      lemma_open: assert(open == waiting + under_way);
      lemma_one_closes: assert(closing == {4'd0, close_due});
      lemma_closes_last: assert(closing_last);
      lemma_closes_alone: assert(!\dut.closes_q || (\dut.pairs.m_valid_q && pairs[2] &&
                                                    (under_way == NONE)));
      lemma_waits: assert(watched_waits == {4'd0, waits});
      lemma_computes: assert(watched_computes == {4'd0, computes});
      lemma_due: assert(watched_due == {4'd0, due});
      lemma_verdict: assert(verdict_right);
      lemma_one_place: assert((watched_places <= ONE) && ((watched_places == NONE) || seen));
      lemma_moves_soon: assert(quiet + cycles_left < MOST_QUIET);
    end
  end

  always @* begin
    once_in_a_set: assume(!s_valid || s_last || !is_watched || !seen);
    nothing_behind_the_last: assume(!s_valid || !close_due);
    if (!aresetn) begin
      assume(!s_valid);
    end
    if (started && aresetn) begin
      asks_one: assert((request_valid & (request_valid - 1'b1)) == {REFERENCES{1'b0}});
      asks_once: assert((request_valid == {REFERENCES{1'b0}}) || (request_tag != watched) || waits);
      with_its_items: assert((request_valid == {REFERENCES{1'b0}}) ||
                             (request_items == {items[request_tag[1]], items[request_tag[0]]}));
      told_once: assert(!m_valid || m_last || (m_tag != watched) || due);
      told_right: assert(!m_valid || m_last || (m_tag != watched) || (m_verdict == verdict));
      reported_kinds_only: assert(!m_valid || m_last || REPORTS[m_verdict]);
      closes_once: assert(!m_valid || !m_last || close_due);
      closes_behind_all: assert(!m_valid || !m_last ||
                                (!waits && !computes && !due && (open == NONE)));
      answers_what_was_taken: assert(!answered || (open != NONE));
      keeps_moving: assert(quiet < MOST_QUIET);
      request_holds: assert(!held_request ||
                            (held_request_data == {request_valid, request_tag, request_items}));
      holds_until_taken: assert(!held || (m_valid && ({m_last, m_tag, m_verdict} == held_data)));
      can_tell_from_last: cover(leave && !m_last && (m_tag == watched) && (watched == 2'd2));
      can_leave_out: cover(computes && (about_watched != {REFERENCES{1'b0}}) && (verdicts[1:0] == 2'd2)
                           && about_watched[0]);
      can_close: cover(leave && m_last && seen);
      can_wait_for_references: cover(close_due && computes && !m_ready);
      can_hold: cover(held && held_request);
    end
  end

endmodule

`default_nettype wire
