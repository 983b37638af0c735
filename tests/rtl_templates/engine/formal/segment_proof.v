// segment_proof: every word that pair_segment takes stays in a lane or goes on, once and in order; each
// meeting of a held word with one behind it is answered once, in the beat of the latter; nothing is
// lost for want of room in the queue; the closing beat leaves behind all others. The lanes are any
// function of their two words, chosen by the solver, LANE_LATENCY cycles long.
// TIERED: the first word of a block and each that stays leave a beat, too, and a beat tells which
// of both its word is, and the word.
`default_nettype none

module segment_proof #(
  parameter LANES = 2,
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
  localparam [3:0] ALL  = LANES;
  localparam [3:0] REPORTS = REPORT[3:0];
  localparam MOST_QUIET = LANE_LATENCY + 8;
  localparam TIER_BITS  = 3 * TIERED;
  localparam BEAT_BITS  = TIER_BITS + CODES_BITS + 5;

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
  wire [2:0]            m_tier;  // {first, stays, word}, where a tier reads them
  wire [BEAT_BITS-2:0]  m_data;
  wire                  m_last;

  assign {m_codes, m_index, m_base} = m_data[CODES_BITS+3:0];

  generate
    if (TIERED == 0) begin : g_no_tier
      assign m_tier = 3'd0;
    end else begin : g_tier
      assign m_tier = m_data[BEAT_BITS-2 -: 3];
    end
  endgenerate

  reg                   started = 1'b0;
  wire                  aresetn = started && aresetn_later;

  pair_segment #(
    .LANES       (LANES),
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
    .s_word_tdata ({s_close, s_first, s_stays, s_meets, s_index, s_word}),
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

  // Lanes.
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

  // Words as they come: what is held of the block so far, and what is to be said of this one.
  wire                  take       = s_valid && s_ready;
  reg  [3:0]            count      = NONE;  // of words held
  reg  [LANES-1:0]      held;
  reg  [1:0]            base;
  reg                   gone       = 1'b0;  // a word of the block went on
  reg                   stay_ended = 1'b0;  // a word of the block did not stay though it could
  reg                   between    = 1'b1;  // sets
  wire [3:0]            counted    = s_first ? NONE : count;
  wire                  stays      = s_stays && !s_close && (counted != ALL);
  wire                  goes       = take && !stays;
  wire [6:0]            goes_as    = {s_close, s_first || !gone, s_stays, s_meets, s_index, s_word};
  reg  [CODES_BITS-1:0] codes;              // of this word
  wire [2:0]            tier       = (TIERED != 0) ? {s_first, stays, s_word} : 3'd0;
  wire                  informs    = (TIERED != 0) && (s_first || stays);
  wire                  comes_out  = take && !s_close && (s_index == watched_j) &&
                                     (informs || (codes != {CODES_BITS{1'b0}}));
  reg  [3:0]            reported;
  wire [LANES*3-1:0]    answered;

  // On the way.
  reg  [3:0]            on_way    = NONE;   // words that go on
  reg  [3:0]            ahead     = NONE;   // of the watched one
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
      assign answered[3*k +: 3]               = answers[3*{s_word, held[k]} +: 3];
    end
  endgenerate

  integer l;

  always @* begin
    codes    = {CODES_BITS{1'b0}};
    reported = NONE;
    for (l = 0; l < LANES; l = l + 1) begin
      if ((l < counted) && s_meets && !s_close) begin
        if (!answered[3*l + 2]) begin
          codes[l*CODE_BITS] = 1'b1;
        end else if (REPORTS[answered[3*l +: 2]]) begin
          reported = reported + ONE;
          if (COUNT == 0) begin
            codes[l*CODE_BITS + CODE_BITS - 1] = 1'b1;
            if (CODE_BITS == 3) begin
              codes[l*CODE_BITS +: 2] = answered[3*l +: 2];
            end
          end
        end
      end
    end
  end

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
        count      <= stays ? counted + ONE : counted;
        gone       <= !stays;
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
    if (take && stays) begin
      held[counted] <= s_word;
    end
    if (take && s_first) begin
      base <= s_index;
    end
    if (comes_out) begin
      due_codes <= codes;
      due_base  <= base;
      due_tier  <= tier;
    end
  end

  always @* begin
    // A set: blocks that begin with `first`; those of a block that stay come before the others; then
    // the word that closes, and nothing until its beat has left.
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
