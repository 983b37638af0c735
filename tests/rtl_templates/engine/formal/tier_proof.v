// tier_proof: each pair that a beat leaves undecided is answered once by pair_tier, with what its lane
// says of the word that the pair's lane holds and the beat's own; what a beat reports leaves once and
// unchanged; beats stay in order, and the closing one leaves behind all others with the right count.
// Beats are those of a pair_segment: codes are about lanes that hold a word, and words that stay fill
// the lanes from the lowest up. The lane is any function of its two words, chosen by the solver,
// LANE_LATENCY cycles long.
`default_nettype none

module tier_proof #(
  parameter LANES = 2,
  parameter LANE_BITS = 1,
  parameter LANE_LATENCY = 0,
  parameter REPORT = 11,
  parameter CODE_BITS = 3,
  parameter COUNT = 0,
  parameter QUEUE_BITS = 3
) (
  input wire                       aclk,
  input wire                       aresetn_later,
  input wire                       s_valid,
  input wire                       s_first,
  input wire                       s_stays,
  input wire                       s_word,
  input wire [LANES*CODE_BITS-1:0] s_codes,
  input wire [1:0]                 s_index,
  input wire [1:0]                 s_base,
  input wire                       s_last,
  input wire                       m_ready
);

  localparam CODES_BITS = LANES * CODE_BITS;
  localparam [CODES_BITS-1:0] NOTHING = 0;
  localparam [3:0] NONE = 0;
  localparam [3:0] ONE  = 1;
  localparam [3:0] ALL  = LANES;
  localparam [3:0] REPORTS = REPORT[3:0];
  localparam MOST_QUIET = LANES + LANE_LATENCY + 8;

  (* anyconst *) reg [11:0] answers;    // {decided, verdict} of each pair of words
  (* anyconst *) reg [1:0]  watched_j;  // beats with this index are watched
  (* anyconst *) reg [1:0]  later_j;    // one beat has this index, and stays behind those before it

  wire                  s_ready;
  wire                  item_i;
  wire                  item_j;
  wire [1:0]            verdict;
  wire                  decided;
  wire                  m_valid;
  wire [CODES_BITS-1:0] m_codes;
  wire [1:0]            m_index;
  wire [1:0]            m_base;
  wire                  m_last;

  reg                   started = 1'b0;
  wire                  aresetn = started && aresetn_later;

  pair_tier #(
    .LANES       (LANES),
    .LANE_BITS   (LANE_BITS),
    .WORD_BITS   (1),
    .INDEX_BITS  (2),
    .LANE_LATENCY(LANE_LATENCY),
    .REPORT      (REPORT),
    .CODE_BITS   (CODE_BITS),
    .COUNT       (COUNT),
    .QUEUE_BITS  (QUEUE_BITS)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_valid),
    .s_axis_tready(s_ready),
    .s_axis_tdata ({s_first, s_stays, s_word, s_codes, s_index, s_base}),
    .s_axis_tlast (s_last),
    .item_i       (item_i),
    .item_j       (item_j),
    .verdict      (verdict),
    .decided      (decided),
    .m_axis_tvalid(m_valid),
    .m_axis_tready(m_ready),
    .m_axis_tdata ({m_codes, m_index, m_base}),
    .m_axis_tlast (m_last)
  );

  delay_line #(
    .WIDTH (3),
    .LENGTH(LANE_LATENCY)
  ) lane (
    .aclk(aclk),
    .d   (answers[3*{item_j, item_i} +: 3]),
    .q   ({decided, verdict})
  );

  // Beats as they come: what the lanes hold of the block so far, and what is due of this beat.
  wire                  take    = s_valid && s_ready;
  reg                   offered = 1'b0;  // the beat on offer was there in the cycle before
  wire                  comes   = s_valid && !offered;
  reg  [3:0]            count   = NONE;  // of words held
  reg  [LANES-1:0]      held;
  reg                   between = 1'b1;  // sets
  wire [3:0]            counted = s_first ? NONE : count;
  reg  [CODES_BITS-1:0] expected;
  reg  [3:0]            found;           // pairs that the lane reports
  reg                   fits;            // the codes are those of a segment
  reg  [CODE_BITS-1:0]  code;
  reg  [2:0]            answer;

  // On the way.
  wire                  leaves        = m_valid && m_ready;
  wire                  about_watched = !m_last && (m_index == watched_j);
  wire                  about_later   = !m_last && (m_index == later_j);
  wire                  watched_comes = comes && !s_last && (s_index == watched_j);
  wire                  later_comes   = comes && !s_last && (s_index == later_j);
  reg  [CODES_BITS-1:0] due           = NOTHING;  // of the watched beat
  reg  [1:0]            due_base;
  reg                   later_seen    = 1'b0;
  reg                   later_behind  = 1'b0;     // the watched beat
  reg                   close_due     = 1'b0;
  reg  [3:0]            close_tag;
  reg  [3:0]            total         = NONE;     // pairs reported
  reg  [3:0]            quiet         = NONE;     // cycles in which nothing moves
  reg                   held_valid    = 1'b0;
  reg  [CODES_BITS+4:0] held_beat;
  reg  [CODES_BITS+7:0] offered_beat;
  reg  [CODES_BITS-1:0] left;                     // the lanes that a leaving beat is about
  reg                   lane_right;

  integer l;

  always @* begin
    expected = NOTHING;
    found    = NONE;
    fits     = 1'b1;
    for (l = 0; l < LANES; l = l + 1) begin
      code   = s_codes[l*CODE_BITS +: CODE_BITS];
      answer = answers[3*{s_word, held[l]} +: 3];
      if (code[CODE_BITS-1]) begin
        expected[l*CODE_BITS +: CODE_BITS] = code;
        fits = fits && (COUNT == 0) && ((CODE_BITS == 2) ? !code[0] : REPORTS[code[1:0]]);
      end else if (code[0]) begin
        fits = fits && (code == 1);
        if (!answer[2]) begin
          expected[l*CODE_BITS +: CODE_BITS] = 1;
        end else if (REPORTS[answer[1:0]]) begin
          found = found + ONE;
          if (COUNT == 0) begin
            expected[l*CODE_BITS + CODE_BITS - 1] = 1'b1;
            if (CODE_BITS == 3) begin
              expected[l*CODE_BITS +: 2] = answer[1:0];
            end
          end
        end
      end else begin
        fits = fits && (code == 0);
      end
      fits = fits && ((code == 0) || ((l < counted) && !s_last));
    end
  end

  always @* begin
    left       = NOTHING;
    lane_right = 1'b1;
    for (l = 0; l < LANES; l = l + 1) begin
      if (m_codes[l*CODE_BITS +: CODE_BITS] != 0) begin
        left[l*CODE_BITS +: CODE_BITS] = {CODE_BITS{1'b1}};
        lane_right = lane_right && (m_codes[l*CODE_BITS +: CODE_BITS] == due[l*CODE_BITS +: CODE_BITS]);
      end
    end
  end

  always @(posedge aclk) begin
    started      <= 1'b1;
    offered      <= aresetn && s_valid && !s_ready;
    offered_beat <= {s_first, s_stays, s_word, s_codes, s_index, s_base, s_last};
    held_valid   <= aresetn && m_valid && !m_ready;
    held_beat    <= {m_last, m_codes, m_index, m_base};
    if (!aresetn) begin
      count        <= NONE;
      between      <= 1'b1;
      due          <= NOTHING;
      later_seen   <= 1'b0;
      later_behind <= 1'b0;
      close_due    <= 1'b0;
      total        <= NONE;
      quiet        <= NONE;
    end else begin
      if (take) begin
        count   <= s_stays ? counted + ONE : counted;
        between <= s_last;
      end
      quiet <= (((due != NOTHING) || close_due || s_valid) && !m_valid && !take) ? quiet + ONE : NONE;
      if (leaves && about_watched) begin
        due <= due & ~left;
      end
      if (watched_comes) begin
        due <= expected;
      end
      later_seen   <= later_seen || later_comes;
      later_behind <= (due != NOTHING) && (later_behind || later_comes);
      if (comes) begin
        total <= total + found;
      end
      if (leaves && m_last) begin
        close_due <= 1'b0;
        total     <= NONE;
      end
      if (comes && s_last) begin
        close_due <= 1'b1;
        close_tag <= {s_index, s_base};
      end
    end
    if (take && s_stays) begin
      held[counted] <= s_word;
    end
    if (watched_comes) begin
      due_base <= s_base;
    end
  end

  always @* begin
    beat_on_offer_stays: assume(!offered || (s_valid && (offered_beat ==
        {s_first, s_stays, s_word, s_codes, s_index, s_base, s_last})));
    codes_of_a_segment: assume(!s_valid || fits);
    first_beat_is_first: assume(!s_valid || s_first || !between);
    stays_in_a_free_lane: assume(!s_valid || !s_stays || ((counted != ALL) && !s_last));
    one_set_at_a_time: assume(!comes || !close_due);
    told_before_the_next: assume(!watched_comes || (due == NOTHING));
    later_comes_once: assume(!later_comes || !later_seen);
    assume(watched_j != later_j);
    if (!aresetn) begin
      assume(!s_valid);
    end
    if (started && aresetn) begin
      tells_of_a_pair: assert(!m_valid || m_last || (m_codes != NOTHING));
      answered_once_and_right: assert(!m_valid || !about_watched ||
                                      (lane_right && (m_base == due_base)));
      in_order: assert(!m_valid || !about_later || !later_behind || (due == NOTHING));
      closes_once: assert(!m_valid || !m_last || close_due);
      closes_behind_all: assert(!m_valid || !m_last || (due == NOTHING));
      closes_with_its_tag: assert(!m_valid || !m_last || ({m_index, m_base} ==
                                  ((COUNT != 0) ? close_tag + total : close_tag)));
      closing_beat_has_no_pair: assert(!m_valid || !m_last || (m_codes == NOTHING));
      keeps_moving: assert(quiet < MOST_QUIET);
      beat_holds: assert(!held_valid || (m_valid && ({m_last, m_codes, m_index, m_base} == held_beat)));
      can_report_in_last_lane: cover(leaves && about_watched && (m_codes[CODES_BITS-1] || (COUNT != 0)));
      can_leave_undecided: cover(leaves && about_watched && m_codes[0] && !m_codes[CODE_BITS-1]);
      can_tell_of_one_beat_twice: cover(leaves && about_watched && ((due & ~left) != NOTHING));
      can_close: cover(leaves && m_last && (total == 4'd3));
      can_fall_behind: cover((due != NOTHING) && close_due && !m_ready);
      can_leave_later: cover(leaves && about_later && later_seen);
      can_start_a_block: cover(take && s_first && !between && (count == ALL));
      can_wait_for_room: cover(offered && (s_codes == NOTHING));
      can_hold: cover(held_valid);
    end
  end

endmodule

`default_nettype wire
