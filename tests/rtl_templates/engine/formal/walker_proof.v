// walker_proof: pair_walker sends words so that every pair of the set meets once in a chain of
// LANES lanes, and no other pair does. Nothing is read before it was stored; one closing word
// leaves behind all others. One pair, chosen by the solver, is watched. A lane of the chain holds
// one of the block's first LANES words that stay; a word that meets others meets the held words.
`default_nettype none

module walker_proof #(
  parameter LANES = 2,
  parameter CAPACITY = 4,
  parameter INDEX_BITS = 2
) (
  input wire aclk,
  input wire aresetn_later,
  input wire stored,
  input wire stored_target,
  input wire ended,
  input wire m_ready,
  input wire close
);

  localparam [3:0] NONE = 0;
  localparam [3:0] ONE  = 1;
  localparam [3:0] FULL = CAPACITY;
  localparam [3:0] ALL  = LANES;
  localparam MOST_QUIET = 4;

  (* anyconst *) reg [INDEX_BITS-1:0] watched_i;
  (* anyconst *) reg [INDEX_BITS-1:0] watched_j;

  wire                  read_enable;
  wire [INDEX_BITS-1:0] read_address;
  wire                  m_valid;
  wire                  m_close;
  wire                  m_first;
  wire                  m_stays;
  wire                  m_meets;
  wire [INDEX_BITS-1:0] m_index;

  reg                   started = 1'b0;
  wire                  aresetn = started && aresetn_later;

  // The set, and whether the chain has taken its closing word.
  reg  [3:0]            count    = NONE;
  reg  [3:0]            targets  = NONE;
  reg                   others   = 1'b0;
  reg                   complete = 1'b0;
  reg                   closed   = 1'b0;
  wire                  set_closed = closed && close;

  pair_walker #(
    .LANES     (LANES),
    .CAPACITY  (CAPACITY),
    .INDEX_BITS(INDEX_BITS)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .stored       (stored),
    .stored_target(stored_target),
    .ended        (ended),
    .set_closed   (set_closed),
    .read_enable  (read_enable),
    .read_address (read_address),
    .m_word_tvalid(m_valid),
    .m_word_tready(m_ready),
    .m_word_close (m_close),
    .m_word_first (m_first),
    .m_word_stays (m_stays),
    .m_word_meets (m_meets),
    .m_word_index (m_index)
  );

  // The chain of lanes.
  wire                  passes   = m_valid && m_ready;
  wire                  a_word   = passes && !m_close;
  reg  [3:0]            in_lanes = NONE;  // words of the block that stayed
  reg                   holds_i  = 1'b0;
  reg                   holds_j  = 1'b0;
  wire [3:0]            before   = m_first ? NONE : in_lanes;
  wire                  stays    = m_stays && (before != ALL);
  wire                  is_i     = (m_index == watched_i);
  wire                  is_j     = (m_index == watched_j);
  wire                  meets    = a_word && m_meets && !m_first && is_j && holds_i;
  wire                  backward = a_word && m_meets && !m_first && is_i && holds_j;
  reg                   met      = 1'b0;
  reg                   first_word = 1'b1;  // no word of the set was taken
  reg  [3:0]            quiet    = NONE;
  reg  [INDEX_BITS-1:0] read_last;
  reg                   held     = 1'b0;
  reg  [INDEX_BITS+3:0] held_word;
  reg                   again    = 1'b0;

  wire                  among_all = (targets == NONE);
  wire                  of_target = ({2'b00, watched_i} < targets) && ({2'b00, watched_j} >= targets);
  wire                  exists    = (watched_i < watched_j) && ({2'b00, watched_j} < count) &&
                                    (among_all || of_target);

  always @(posedge aclk) begin
    started   <= 1'b1;
    held      <= aresetn && m_valid && !m_ready;
    held_word <= {m_close, m_first, m_stays, m_meets, m_index};
    again     <= aresetn && (again || set_closed);
    if (!aresetn || set_closed) begin
      count      <= NONE;
      targets    <= NONE;
      others     <= 1'b0;
      complete   <= 1'b0;
      closed     <= 1'b0;
      met        <= 1'b0;
      in_lanes   <= NONE;
      holds_i    <= 1'b0;
      holds_j    <= 1'b0;
      first_word <= 1'b1;
      quiet      <= NONE;
    end else begin
      if (stored) begin
        count <= count + ONE;
      end
      if (stored && stored_target && !others) begin
        targets <= targets + ONE;
      end
      others   <= others || (stored && !stored_target);
      complete <= complete || ended;
      closed   <= closed || (passes && m_close);
      met      <= met || meets;
      quiet    <= (complete && !closed && !m_valid) ? quiet + ONE : NONE;
      if (a_word) begin
        first_word <= 1'b0;
        in_lanes   <= stays ? before + ONE : before;
        holds_i    <= (holds_i && !m_first) || (stays && is_i);
        holds_j    <= (holds_j && !m_first) || (stays && is_j);
      end
    end
    if (read_enable) begin
      read_last <= read_address;
    end
  end

  always @* begin
    assume(watched_i != watched_j);
    fits: assume(!stored || (!complete && (count != FULL)));
    ends_once: assume(!ended || !complete);
    ends_with_a_word_or_full: assume(!ended || stored || (count == FULL));
    if (!aresetn) begin
      assume(!stored);
      assume(!ended);
    end
    if (started && aresetn) begin
      meets_once: assert(!meets || !met);
      only_pairs: assert(!meets || exists);
      never_backward: assert(!backward || (watched_j < watched_i));
      all_met: assert(!m_valid || !m_close || (met == exists));
      closes_when_complete: assert(!m_valid || !m_close || complete);
      closes_once: assert(!closed || !m_valid);
      reads_what_is_stored: assert(!read_enable || ({2'b00, read_address} < count));
      word_is_the_one_read: assert(!m_valid || m_close || (m_index == read_last));
      begins_a_block: assert(!m_valid || m_close || !first_word || m_first);
      others_do_not_stay: assert(!m_valid || m_close || among_all || (m_stays == ({2'b00, m_index} < targets)));
      keeps_moving: assert(quiet < MOST_QUIET);
      holds_until_taken: assert(!held || (m_valid &&
                                ({m_close, m_first, m_stays, m_meets, m_index} == held_word)));
      can_meet_in_second_block: cover(meets && (watched_i == CAPACITY - 2) && among_all);
      can_meet_early: cover(meets && !complete);
      can_meet_targets: cover(meets && (targets == ALL) && again);
      can_close_one: cover(m_valid && m_close && (count == ONE));
      can_close_targets_alone: cover(m_valid && m_close && (targets == FULL));
      can_hold: cover(held);
    end
  end

endmodule

`default_nettype wire
