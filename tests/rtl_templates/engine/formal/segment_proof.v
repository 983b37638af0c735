// segment_proof: every word that pair_segment takes stays in a lane or goes on, once and in order;
// each meeting of a held word with a later word is answered once, in the beat of the later word;
// the queue has room for every beat; the closing beat leaves behind all others. The lanes are any
// function of their two words, chosen by the solver, LANE_LATENCY cycles long. TIERED: the first
// word of a block and each word that stays leave a beat as well. A beat then also has its word, the
// flags `first` and `stays`, and the number of its undecided pairs. The lemmas read registers of
// the template, and together hold by induction. They go over all words and beats inside: the words
// in the link, each with the beat that it will cause, the word at the lanes, and the beats in the
// queue.
`default_nettype none

module segment_proof #(
  parameter LANES = 2,
  parameter LANE_BITS = 1,
  parameter LANE_LATENCY = 0,
  parameter REPORT = 11,
  parameter CODE_BITS = 3,
  parameter COUNT = 0,
  parameter TIERED = 0,
  parameter QUEUE_BITS = 2
) (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       s_valid,
  input wire       s_close,
  input wire       s_first,
  input wire       s_stays,
  input wire       s_meets,
  input wire [1:0] s_index,
  input wire       s_word,
  input wire       word_ready,
  input wire       m_ready,
  input wire       choose  // the word that enters and goes on is watched, if no other is
);

  localparam CODES_BITS = LANES * CODE_BITS;
  localparam [3:0] NONE = 0;
  localparam [3:0] ONE  = 1;
  localparam MOST_QUIET = LANE_LATENCY + 8;
  localparam TIER_BITS  = (LANE_BITS + 4) * TIERED;
  localparam TIER_NUMBER = LANE_BITS + 1;  // bits of the number of undecided pairs
  localparam BEAT_BITS  = TIER_BITS + CODES_BITS + 5;
  localparam DEPTH      = 1 << QUEUE_BITS;

  (* anyconst *) reg [11:0] answers;    // {decided, verdict} of each pair of words
  (* anyconst *) reg [1:0]  watched_j;  // a word with this index is watched at the queue

  wire                  s_ready;
  wire                  word_valid;
  wire [6:0]            word_data;
  wire                  passing;
  wire [LANES-1:0]      held_words;
  wire [LANES*2-1:0]    verdicts;
  wire [LANES-1:0]      decided;
  wire                  m_valid;
  wire [CODES_BITS-1:0] m_codes;
  wire [1:0]            m_index;
  wire [1:0]            m_base;
  wire [2:0]            m_tier;  // {first, stays, word}, as a tier reads them
  wire [BEAT_BITS-2:0]  m_data;
  wire [LANE_BITS:0]    m_pairs;
  wire                  m_last;

  assign {m_codes, m_index, m_base} = m_data[CODES_BITS+3:0];

  generate
    if (TIERED == 0) begin : g_no_tier
      assign m_tier  = 3'd0;
      assign m_pairs = undecided_of(m_codes);
    end else begin : g_tier
      assign {m_pairs, m_tier} = m_data[BEAT_BITS-2 -: TIER_BITS];
    end
  endgenerate

  // The undecided pairs among the codes of a beat.
  function [LANE_BITS:0] undecided_of;
    input [CODES_BITS-1:0] of_codes;
    integer lane;
    begin
      undecided_of = 0;
      for (lane = 0; lane < LANES; lane = lane + 1) begin
        if (of_codes[lane*CODE_BITS +: CODE_BITS] == 1) begin
          undecided_of = undecided_of + 1;
        end
      end
    end
  endfunction

  reg                   started = 1'b0;
  wire                  aresetn = started && aresetn_later;

  pair_segment #(
    .LANES       (LANES),
    .LANE_BITS   (LANE_BITS),
    .WORD_BITS   (1),
    .INDEX_BITS  (2),
    .LANE_LATENCY(LANE_LATENCY),
    .REPORT      (REPORT),
    .CODE_BITS   (CODE_BITS),
    .COUNT       (COUNT),
    .TIERED      (TIERED),
    .QUEUE_BITS  (QUEUE_BITS)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_word_tvalid(s_valid),
    .s_word_tready(s_ready),
    .s_word_tdata (word),
    .m_word_tvalid(word_valid),
    .m_word_tready(word_ready),
    .m_word_tdata (word_data),
    .passing_word (passing),
    .held_words   (held_words),
    .verdicts     (verdicts),
    .decided      (decided),
    .m_axis_tvalid(m_valid),
    .m_axis_tready(m_ready),
    .m_axis_tdata (m_data),
    .m_axis_tlast (m_last)
  );

  // The lanes.
  wire             late_passing;
  wire [LANES-1:0] late_held;

  delay_line #(
    .WIDTH (1 + LANES),
    .LENGTH(LANE_LATENCY)
  ) lanes (
    .aclk(aclk),
    .d   ({passing, held_words}),
    .q   ({late_passing, late_held})
  );

  // The words as they come: those of the block that are held so far, and the report that is due for
  // the current one.
  wire                  take       = s_valid && s_ready;
  reg  [3:0]            count      = NONE;  // number of words held
  reg  [LANES-1:0]      held;
  reg  [1:0]            base;
  reg                   gone       = 1'b0;  // a word of the block went on
  reg                   stay_ended = 1'b0;  // a word of the block did not stay though it could
  reg                   between    = 1'b1;  // no set has begun since the last one
  wire [6:0]            word       = {s_close, s_first, s_stays, s_meets, s_index, s_word};
  wire [LANES+6:0]      state      = {gone, base, held, count};
  wire [LANES+6:0]      next_state;
  wire                  stays;
  wire                  goes       = take && !stays;
  wire [6:0]            goes_as;
  wire                  tells;
  wire [CODES_BITS-1:0] codes;              // the codes that are due for this word
  wire [2:0]            tier;
  wire                  comes_out  = take && tells && (s_index == watched_j);
  wire [3:0]            reported;

  segment_step #(
    .LANES    (LANES),
    .REPORT   (REPORT),
    .CODE_BITS(CODE_BITS),
    .COUNT    (COUNT),
    .TIERED   (TIERED)
  ) expected (
    .answers (answers),
    .word    (word),
    .before  (state),
    .after   (next_state),
    .stays   (stays),
    .goes_as (goes_as),
    .tells   (tells),
    .codes   (codes),
    .tier    (tier),
    .reported(reported)
  );

  // The words and beats on their way.
  reg  [3:0]            on_way    = NONE;   // words that go on
  reg  [3:0]            ahead     = NONE;   // words ahead of the watched one
  reg                   watching  = 1'b0;
  reg  [6:0]            watched_word;
  reg                   due       = 1'b0;   // a beat about watched_j
  reg  [CODES_BITS-1:0] due_codes;
  reg  [1:0]            due_base;
  reg  [2:0]            due_tier;
  reg                   close_due = 1'b0;
  reg  [3:0]            total     = NONE;   // pairs reported
  reg  [3:0]            quiet     = NONE;   // cycles without a beat although one is due
  reg                   held_word_valid = 1'b0;
  reg  [6:0]            held_word_data;
  reg                   held_valid      = 1'b0;
  reg  [BEAT_BITS-1:0]  held_beat;

  wire                  passes = word_valid && word_ready;
  wire                  leaves = m_valid && m_ready;
  wire                  about_watched = !m_last && (m_index == watched_j);

  genvar k;
  generate
    for (k = 0; k < LANES; k = k + 1) begin : g_lane
      assign {decided[k], verdicts[2*k +: 2]} = answers[3*{late_passing, late_held[k]} +: 3];
    end
  endgenerate

  always @(posedge aclk) begin
    started         <= 1'b1;
    held_word_valid <= aresetn && word_valid && !word_ready;
    held_word_data  <= word_data;
    held_valid      <= aresetn && m_valid && !m_ready;
    held_beat       <= {m_last, m_data};
    if (!aresetn) begin
      count     <= NONE;
      gone      <= 1'b0;
      between   <= 1'b1;
      on_way    <= NONE;
      watching  <= 1'b0;
      due       <= 1'b0;
      close_due <= 1'b0;
      total     <= NONE;
      quiet     <= NONE;
    end else begin
      if (take) begin
        {gone, base, held, count} <= next_state;
        stay_ended <= !s_stays;
        between    <= s_close;
        total      <= total + reported;
      end
      on_way <= on_way + {3'b000, goes} - {3'b000, passes};
      quiet  <= ((due || close_due) && !m_valid && word_ready) ? quiet + ONE : NONE;
      if (passes && watching) begin
        ahead <= ahead - ONE;
        if (ahead == NONE) begin
          watching <= 1'b0;
        end
      end
      if (goes && choose && !watching) begin
        watching     <= 1'b1;
        watched_word <= goes_as;
        ahead        <= on_way - {3'b000, passes};
      end
      if (leaves && about_watched) begin
        due <= 1'b0;
      end
      if (comes_out) begin
        due <= 1'b1;
      end
      if (leaves && m_last) begin
        close_due <= 1'b0;
        total     <= NONE;
      end
      if (take && s_close) begin
        close_due <= 1'b1;
      end
    end
    if (comes_out) begin
      due_codes <= codes;
      due_base  <= base;
      due_tier  <= tier;
    end
  end

  // The template's registers that the lemmas read.
  (* hierconn *) wire [1:0]           \dut.link.write_q ;
  (* hierconn *) wire [1:0]           \dut.link.read_q ;
  (* hierconn *) wire                 \dut.link.m_valid_q ;
  (* hierconn *) wire [6:0]           \dut.link.memory.words[0] ;
  (* hierconn *) wire [6:0]           \dut.link.memory.words[1] ;
  (* hierconn *) wire [6:0]           \dut.link.m_axis_tdata ;
  (* hierconn *) wire [LANES-1:0]     \dut.holds_q ;
  (* hierconn *) wire                 \dut.passed_q ;
  (* hierconn *) wire                 \dut.taken_q ;
  (* hierconn *) wire                 \dut.first_q ;
  (* hierconn *) wire [LANES-1:0]     \dut.fills_q ;
  (* hierconn *) wire [1:0]           \dut.index_q ;
  (* hierconn *) wire [1:0]           \dut.base_q ;
  (* hierconn *) wire [3:0]           \dut.g_count.count_q ;
  (* hierconn *) wire [1:0]           \dut.g_count.more ;
  (* hierconn *) wire [1:0]           \dut.g_count.more_q ;
  (* hierconn *) wire                 \dut.exceptions.push ;
  (* hierconn *) wire [BEAT_BITS-1:0] \dut.exceptions.beat ;
  (* hierconn *) wire [QUEUE_BITS+1:0] \dut.exceptions.queued_q ;
  (* hierconn *) wire                  \dut.exceptions.popped_q ;
  (* hierconn *) wire                 \dut.exceptions.room_q ;
  (* hierconn *) wire [QUEUE_BITS:0]  \dut.exceptions.beats.write_q ;
  (* hierconn *) wire [QUEUE_BITS:0]  \dut.exceptions.beats.read_q ;
  (* hierconn *) wire [BEAT_BITS-1:0] \dut.exceptions.beats.memory.words[0] ;
  (* hierconn *) wire [BEAT_BITS-1:0] \dut.exceptions.beats.memory.words[1] ;
  (* hierconn *) wire [BEAT_BITS-1:0] \dut.exceptions.beats.memory.words[2] ;
  (* hierconn *) wire [BEAT_BITS-1:0] \dut.exceptions.beats.memory.words[3] ;

  wire [3:0]                     link_count;
  wire [3*7-1:0]                 link_words;
  wire [3:0]                     queue_count;
  wire [(DEPTH+1)*BEAT_BITS-1:0] queue_beats;

  fifo_view #(
    .WIDTH     (7),
    .DEPTH_BITS(1)
  ) link (
    .started  (started),
    .write_q  (\dut.link.write_q ),
    .read_q   (\dut.link.read_q ),
    .m_valid_q(\dut.link.m_valid_q ),
    .words    ({\dut.link.memory.words[1] , \dut.link.memory.words[0] }),
    .m_data   (\dut.link.m_axis_tdata ),
    .count    (link_count),
    .contents (link_words)
  );

  fifo_view #(
    .WIDTH     (BEAT_BITS),
    .DEPTH_BITS(QUEUE_BITS)
  ) queue (
    .started  (started),
    .write_q  (\dut.exceptions.beats.write_q ),
    .read_q   (\dut.exceptions.beats.read_q ),
    .m_valid_q(m_valid),
    .words    ({\dut.exceptions.beats.memory.words[3] , \dut.exceptions.beats.memory.words[2] ,
                \dut.exceptions.beats.memory.words[1] , \dut.exceptions.beats.memory.words[0] }),
    .m_data   ({m_last, m_data}),
    .count    (queue_count),
    .contents (queue_beats)
  );

  // The states behind each word in the link, in the order in which the words leave it.
  localparam STATE_BITS = LANES + 7;

  wire [4*STATE_BITS-1:0] states;
  wire [2:0]              link_stays;
  wire [3*7-1:0]          link_goes_as;
  wire [2:0]              link_tells;
  wire [3*CODES_BITS-1:0] link_codes;
  wire [3*3-1:0]          link_tiers;
  wire [3*4-1:0]          link_reported;
  reg  [3:0]              lanes_held;
  wire [LANES-1:0]        filling    = \dut.fills_q & {LANES{\dut.taken_q }};
  wire [LANES-1:0]        soon_held  = (held_words & ~filling) | ({LANES{passing}} & filling);

  assign states[STATE_BITS-1:0] =
      {\dut.passed_q , (\dut.taken_q && \dut.first_q ) ? \dut.index_q : \dut.base_q ,
       soon_held, lanes_held};

  genvar p;
  generate
    for (p = 0; p < 3; p = p + 1) begin : g_link
      wire [STATE_BITS-1:0] after;

      segment_step #(
        .LANES    (LANES),
        .REPORT   (REPORT),
        .CODE_BITS(CODE_BITS),
        .COUNT    (COUNT),
        .TIERED   (TIERED)
      ) of_word (
        .answers (answers),
        .word    (link_words[7*p +: 7]),
        .before  (states[STATE_BITS*p +: STATE_BITS]),
        .after   (after),
        .stays   (link_stays[p]),
        .goes_as (link_goes_as[7*p +: 7]),
        .tells   (link_tells[p]),
        .codes   (link_codes[CODES_BITS*p +: CODES_BITS]),
        .tier    (link_tiers[3*p +: 3]),
        .reported(link_reported[4*p +: 4])
      );

      assign states[STATE_BITS*(p+1) +: STATE_BITS] =
          (p < link_count) ? after : states[STATE_BITS*p +: STATE_BITS];
    end
  endgenerate

  wire [STATE_BITS-1:0] last_state = states[3*STATE_BITS +: STATE_BITS];
  reg  [LANES-1:0]      holding;        // lanes that hold a word behind all in the link
  reg  [3:0]            going;          // words in the link that go on
  reg                   goes_right;     // the watched word is among them, in its place
  reg  [3:0]            beats_due;      // beats about the watched word that are due
  reg                   beats_right;
  reg  [3:0]            beats_closing;
  reg                   closing_last;   // nothing is behind the closing word or beat
  reg                   closing_empty;
  reg                   counted_right;
  reg  [3:0]            found;          // pairs that will be counted
  reg  [3:0]            cycles_left;    // cycles until a beat is on offer, if nobody stalls
  reg  [BEAT_BITS-1:0]  beat;
  reg                   exists;
  integer               w;

  always @* begin
    lanes_held = NONE;
    for (w = 0; w < LANES; w = w + 1) begin
      lanes_held = lanes_held + {3'b000, \dut.holds_q [w]};
      holding[w] = (w < last_state[3:0]);
    end
  end

  always @* begin
    going         = NONE;
    goes_right    = 1'b1;
    beats_due     = NONE;
    beats_right   = 1'b1;
    beats_closing = NONE;
    closing_last  = 1'b1;
    closing_empty = 1'b1;
    counted_right = 1'b1;
    pairs_right   = 1'b1;
    found         = \dut.g_count.count_q + {2'b00, \dut.g_count.more_q } +
                    (\dut.taken_q ? {2'b00, \dut.g_count.more } : NONE);
    cycles_left   = NONE;
    for (w = 0; w < 3; w = w + 1) begin
      if (w < link_count) begin
        found = found + link_reported[4*w +: 4];
        if (!link_stays[w]) begin
          goes_right = goes_right && (!watching || (going != ahead) ||
                                      (link_goes_as[7*w +: 7] == watched_word));
          going      = going + ONE;
        end
        if (link_tells[w] && (link_words[7*w+1 +: 2] == watched_j)) begin
          beats_due   = beats_due + ONE;
          beats_right = beats_right &&
              ({link_codes[CODES_BITS*w +: CODES_BITS], link_tiers[3*w +: 3]} == {due_codes, due_tier}) &&
              ((states[STATE_BITS*w+LANES+4 +: 2] == due_base) ||
               (link_codes[CODES_BITS*w +: CODES_BITS] == {CODES_BITS{1'b0}}));
        end
        if (link_words[7*w+6]) begin
          beats_closing = beats_closing + ONE;
          closing_last  = closing_last && (w + 1 == link_count);
        end
        if ((cycles_left == NONE) && (link_tells[w] || link_words[7*w+6])) begin
          cycles_left = w + 3 + ((\dut.link.m_valid_q && \dut.exceptions.room_q ) ? 0 : 1);
        end
      end
    end
    // Place 0 is that at the lanes, the others are those of the queue.
    for (w = 0; w <= DEPTH + 1; w = w + 1) begin
      beat   = (w == 0) ? \dut.exceptions.beat : queue_beats[BEAT_BITS*(w-1) +: BEAT_BITS];
      exists = (w == 0) ? \dut.exceptions.push : (w <= queue_count);
      pairs_right = pairs_right && (!exists || (TIERED == 0) ||
          (beat[BEAT_BITS-2 -: TIER_NUMBER] == undecided_of(beat[4 +: CODES_BITS])));
      if (exists && beat[BEAT_BITS-1]) begin
        beats_closing = beats_closing + ONE;
        closing_last  = closing_last && (link_count == NONE) &&
                        ((w == 0) || ((w == queue_count) && !\dut.taken_q ));
        closing_empty = closing_empty && (beat[4 +: CODES_BITS] == {CODES_BITS{1'b0}}) &&
                        ((TIERED == 0) || !beat[BEAT_BITS-3-TIER_NUMBER]);
        counted_right = counted_right && (beat[3:0] == total) && ((w == 0) || (found == NONE));
        found         = total;
      end else if (exists && (beat[3:2] == watched_j)) begin
        beats_due   = beats_due + ONE;
        beats_right = beats_right && (beat[4 +: CODES_BITS] == due_codes) &&
                      ((TIERED == 0) || (beat[BEAT_BITS-2-TIER_NUMBER -: 3] == due_tier)) &&
                      ((beat[1:0] == due_base) || (due_codes == {CODES_BITS{1'b0}}));
      end
    end
    if (\dut.exceptions.push ) begin
      cycles_left = 4'd2;
    end
    if (queue_count != NONE) begin
      cycles_left = m_valid ? NONE : ONE;
    end
    if (started) begin
      lemma_lanes_fill_up: assert((\dut.holds_q & (\dut.holds_q + ONE)) == {LANES{1'b0}});
      lemma_state: assert((last_state[3:0] == count) && (last_state[LANES+6] == gone) &&
                          (((last_state[LANES+3:4] ^ held) & holding) == {LANES{1'b0}}) &&
                          (between || (last_state[LANES+5:LANES+4] == base)));
      lemma_goes_on: assert(going == on_way);
      lemma_watched_is_inside: assert(!watching || ((ahead < on_way) && goes_right));
      lemma_one_beat: assert(beats_due == {3'b000, due});
      lemma_right_beat: assert(beats_right);
      lemma_pairs: assert(pairs_right);
      lemma_one_closes: assert(beats_closing == {3'b000, close_due});
      lemma_closes_last: assert(closing_last);
      lemma_closes_empty: assert(closing_empty);
      lemma_counts: assert((COUNT == 0) || (counted_right && (found == total)));
      lemma_queued: assert({{(4-QUEUE_BITS){1'b0}}, \dut.exceptions.queued_q } ==
                           queue_count + {3'b000, \dut.exceptions.popped_q });
      lemma_room: assert(queue_count + {3'b000, \dut.taken_q } +
                         {3'b000, \dut.exceptions.room_q } <= DEPTH);
      lemma_comes_soon: assert(quiet + cycles_left < MOST_QUIET);
    end
  end

  always @* begin
    // A set consists of blocks that begin with `first`. The words of a block that stay come before
    // its others. The word that closes comes last, and nothing comes until its beat has left.
    first_word_is_first: assume(!s_valid || s_first || !between);
    staying_ones_come_first: assume(!s_valid || s_first || s_close || !s_stays || !stay_ended);
    one_set_at_a_time: assume(!s_valid || !close_due);
    told_before_the_next: assume(!s_valid || s_close || !due || (s_index != watched_j));
    if (!aresetn) begin
      assume(!s_valid);
    end
    if (started && aresetn) begin
      goes_on_in_order: assert(!word_valid || !watching || (ahead != NONE) ||
                               (word_data == watched_word));
      goes_on_once: assert(!word_valid || (on_way != NONE));
      link_holds_as_many: assert(on_way <= 4'd3);
      answered_once: assert(!m_valid || !about_watched || due);
      answered_right: assert(!m_valid || !about_watched ||
                             (({m_codes, m_tier} == {due_codes, due_tier}) &&
                              ((m_base == due_base) || (m_codes == {CODES_BITS{1'b0}}))));
      numbers_its_undecided_pairs: assert(!m_valid || (m_pairs == undecided_of(m_codes)));
      closing_beat_has_no_pair: assert(!m_valid || !m_last ||
                                       ((m_codes == {CODES_BITS{1'b0}}) && !m_tier[1]));
      closes_once: assert(!m_valid || !m_last || close_due);
      closes_behind_all: assert(!m_valid || !m_last || !due);
      counts: assert(!m_valid || !m_last || (COUNT == 0) || ({m_index, m_base} == total));
      keeps_moving: assert(quiet < MOST_QUIET);
      word_holds: assert(!held_word_valid || (word_valid && (word_data == held_word_data)));
      beat_holds: assert(!held_valid || (m_valid && ({m_last, m_data} == held_beat)));
      can_report_in_last_lane: cover(leaves && about_watched && (m_codes[CODES_BITS-1] || (COUNT != 0)));
      can_tell_of_a_held_word: cover(leaves && about_watched && (m_tier[1] || (TIERED == 0)));
      can_tell_undecided: cover(leaves && about_watched && m_codes[0] && !m_codes[CODE_BITS-1]);
      can_close: cover(leaves && m_last && (total == 4'd3));
      can_pass: cover(passes && watching && (ahead == NONE) && watched_word[5] && !watched_word[6]);
      can_fall_behind: cover(due && close_due && !m_ready);
      can_hold: cover(held_valid && held_word_valid);
    end
  end

endmodule

`default_nettype wire
