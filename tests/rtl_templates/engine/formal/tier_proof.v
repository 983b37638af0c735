// tier_proof: pair_tier answers each pair that a beat leaves undecided once, with its lane's result
// for the word that the pair's lane holds and the beat's own word. Each report of a beat leaves
// once and unchanged. Beats stay in order, and the closing one leaves behind all others with the
// right count. Beats are those of a pair_segment: codes are about lanes that hold a word, and words
// that stay fill the lanes from the lowest up. The lane is any function of its two words, chosen by
// the solver, LANE_LATENCY cycles long, 0 or 1. The lemmas read registers of the template, and
// together hold by induction. They go over all places where a beat may be: the queue, the beat at
// its input, both stages, and the beat on offer. For each place they have the results of the beat's
// pairs that are still due.
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
  localparam DEPTH     = 1 << QUEUE_BITS;
  localparam BEAT_BITS = CODES_BITS + 5;
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
    .s_axis_tdata ({s_pairs, s_first, s_stays, s_word, s_codes, s_index, s_base}),
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

  // The beats as they come: the words of the block that the lanes hold so far, and the results that
  // are due for the current beat.
  wire                  take    = s_valid && s_ready;
  reg                   offered = 1'b0;  // the beat on offer was there in the cycle before
  wire                  comes   = s_valid && !offered;
  reg  [3:0]            count   = NONE;  // number of words held
  reg  [LANES-1:0]      held;
  reg                   between = 1'b1;  // no set has begun since the last one
  wire [3:0]            counted = s_first ? NONE : count;
  reg  [CODES_BITS-1:0] expected;
  reg  [3:0]            found;           // pairs that the lane reports
  reg  [3:0]            found_later;     // those that have not passed the lane
  reg                   fits;            // the codes are those of a segment
  reg  [LANE_BITS:0]    s_pairs;         // pairs that the codes leave undecided
  reg  [LANE_BITS:0]    pairs_left;      // those that have not passed the lane
  reg  [CODE_BITS-1:0]  code;
  reg  [2:0]            answer;

  // The beats on their way.
  wire                  leaves        = m_valid && m_ready;
  wire                  about_watched = !m_last && (m_index == watched_j);
  wire                  about_later   = !m_last && (m_index == later_j);
  wire                  watched_comes = comes && !s_last && (s_index == watched_j);
  wire                  later_comes   = comes && !s_last && (s_index == later_j);
  reg  [CODES_BITS-1:0] due           = NOTHING;  // results due for the watched beat
  reg  [1:0]            due_base;
  reg                   later_seen    = 1'b0;
  reg                   later_behind  = 1'b0;     // the later beat came behind the watched beat
  reg                   close_due     = 1'b0;
  reg  [3:0]            close_tag;
  reg  [3:0]            total         = NONE;     // pairs reported
  reg  [3:0]            quiet         = NONE;     // cycles in which nothing moves
  reg                   held_valid    = 1'b0;
  reg  [CODES_BITS+4:0] held_beat;
  reg  [CODES_BITS+7:0] offered_beat;
  reg  [CODES_BITS-1:0] left;                     // the lanes that a leaving beat is about
  reg                   lane_right;

  // The code that a beat has for a pair which the lane answers with `said`.
  function [CODE_BITS-1:0] code_of;
    input [2:0] said;
    begin
      code_of = 0;
      if (!said[2]) begin
        code_of = 1;
      end else if (REPORTS[said[1:0]] && (COUNT == 0)) begin
        code_of[CODE_BITS-1] = 1'b1;
        if (CODE_BITS == 3) begin
          code_of[1:0] = said[1:0];
        end
      end
    end
  endfunction

  integer l;

  always @* begin
    expected = NOTHING;
    found    = NONE;
    found_later = NONE;
    s_pairs  = 0;
    pairs_left = 0;
    fits     = 1'b1;
    for (l = 0; l < LANES; l = l + 1) begin
      code   = s_codes[l*CODE_BITS +: CODE_BITS];
      answer = answers[3*{s_word, held[l]} +: 3];
      if (code[CODE_BITS-1]) begin
        expected[l*CODE_BITS +: CODE_BITS] = code;
        fits = fits && (COUNT == 0) && ((CODE_BITS == 2) ? !code[0] : REPORTS[code[1:0]]);
      end else if (code[0]) begin
        fits = fits && (code == 1);
        s_pairs = s_pairs + 1'b1;
        if (\dut.rest_q [l]) begin
          pairs_left = pairs_left + 1'b1;
        end
        expected[l*CODE_BITS +: CODE_BITS] = code_of(answer);
        if (answer[2] && REPORTS[answer[1:0]]) begin
          found = found + ONE;
          if (!\dut.again_q || \dut.rest_q [l]) begin
            found_later = found_later + ONE;
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

  // The template's registers that the lemmas read.
  (* hierconn *) wire                   \dut.again_q ;
  (* hierconn *) wire                   \dut.last_q ;
  (* hierconn *) wire [LANE_BITS:0]     \dut.left_q ;
  (* hierconn *) wire [LANES-1:0]       \dut.rest_q ;
  (* hierconn *) wire [LANE_BITS-1:0]   \dut.places_q ;
  (* hierconn *) wire                   \dut.s1_valid_q ;
  (* hierconn *) wire                   \dut.s1_write_q ;
  (* hierconn *) wire                   \dut.s1_close_q ;
  (* hierconn *) wire [LANES-1:0]       \dut.s1_pair_q ;
  (* hierconn *) wire [LANE_BITS-1:0]   \dut.s1_picked_q ;
  (* hierconn *) wire [LANE_BITS-1:0]   \dut.s1_place_q ;
  (* hierconn *) wire                   \dut.s1_word_q ;
  (* hierconn *) wire [CODES_BITS-1:0]  \dut.s1_reports_q ;
  (* hierconn *) wire [3:0]             \dut.s1_tag_q ;
  (* hierconn *) wire                   \dut.s2_valid_q ;
  (* hierconn *) wire                   \dut.s2_close_q ;
  (* hierconn *) wire [LANES-1:0]       \dut.s2_pair_q ;
  (* hierconn *) wire [CODES_BITS-1:0]  \dut.s2_reports_q ;
  (* hierconn *) wire [3:0]             \dut.s2_tag_q ;
  (* hierconn *) wire                   \dut.held_words.words[0] ;
  (* hierconn *) wire                   \dut.held_words.words[1] ;
  (* hierconn *) wire                   \dut.held_words.words[2] ;
  (* hierconn *) wire                   \dut.held_words.words[3] ;
  (* hierconn *) wire                   \dut.answered ;
  (* hierconn *) wire                   \dut.closes ;
  (* hierconn *) wire                   \dut.reported ;
  (* hierconn *) wire [LANES-1:0]       \dut.pair ;
  (* hierconn *) wire [3:0]             \dut.g_count.count_q ;
  (* hierconn *) wire                   \dut.exceptions.push ;
  (* hierconn *) wire [BEAT_BITS-1:0]   \dut.exceptions.beat ;
  (* hierconn *) wire [QUEUE_BITS+1:0]  \dut.exceptions.queued_q ;
  (* hierconn *) wire                   \dut.exceptions.popped_q ;
  (* hierconn *) wire                   \dut.exceptions.room_q ;
  (* hierconn *) wire [QUEUE_BITS:0]    \dut.exceptions.beats.write_q ;
  (* hierconn *) wire [QUEUE_BITS:0]    \dut.exceptions.beats.read_q ;
  (* hierconn *) wire [BEAT_BITS-1:0]   \dut.exceptions.beats.memory.words[0] ;
  (* hierconn *) wire [BEAT_BITS-1:0]   \dut.exceptions.beats.memory.words[1] ;
  (* hierconn *) wire [BEAT_BITS-1:0]   \dut.exceptions.beats.memory.words[2] ;
  (* hierconn *) wire [BEAT_BITS-1:0]   \dut.exceptions.beats.memory.words[3] ;
  (* hierconn *) wire [BEAT_BITS-1:0]   \dut.exceptions.beats.memory.words[4] ;
  (* hierconn *) wire [BEAT_BITS-1:0]   \dut.exceptions.beats.memory.words[5] ;
  (* hierconn *) wire [BEAT_BITS-1:0]   \dut.exceptions.beats.memory.words[6] ;
  (* hierconn *) wire [BEAT_BITS-1:0]   \dut.exceptions.beats.memory.words[7] ;

  wire [3:0]                     queue_count;
  wire [DEPTH:0]                 queue_holds;
  wire [4*(DEPTH+1)-1:0]         queue_ranks;
  wire [DEPTH*BEAT_BITS-1:0]     queue_words =
      {\dut.exceptions.beats.memory.words[7] , \dut.exceptions.beats.memory.words[6] ,
       \dut.exceptions.beats.memory.words[5] , \dut.exceptions.beats.memory.words[4] ,
       \dut.exceptions.beats.memory.words[3] , \dut.exceptions.beats.memory.words[2] ,
       \dut.exceptions.beats.memory.words[1] , \dut.exceptions.beats.memory.words[0] };

  fifo_view #(
    .WIDTH     (BEAT_BITS),
    .DEPTH_BITS(QUEUE_BITS)
  ) queue (
    .started  (started),
    .write_q  (\dut.exceptions.beats.write_q ),
    .read_q   (\dut.exceptions.beats.read_q ),
    .m_valid_q(m_valid),
    .words    (queue_words),
    .m_data   ({m_last, m_codes, m_index, m_base}),
    .count    (queue_count),
    .contents (),
    .holds    (queue_holds),
    .ranks    (queue_ranks)
  );

  // The places where a beat may be, in the order in which their beats leave.
  localparam PUSHED = DEPTH + 1;
  localparam STAGE2 = DEPTH + 2;  // the same as PUSHED if the lane has no latency
  localparam STAGE1 = DEPTH + 3;
  localparam OFFER  = DEPTH + 4;

  wire [LANES-1:0]       memory       = {\dut.held_words.words[3] , \dut.held_words.words[2] ,
                                         \dut.held_words.words[1] , \dut.held_words.words[0] };
  wire [2:0]             s1_answer    = answers[3*{\dut.s1_word_q , memory[\dut.s1_picked_q ]} +: 3];
  wire [2:0]             s2_answer    = answers[3*{item_j, item_i} +: 3];
  wire                   s2_apart     = \dut.s2_valid_q && (LANE_LATENCY != 0);
  reg  [CODES_BITS-1:0]  s1_codes;
  reg  [CODES_BITS-1:0]  s2_codes;
  reg  [CODES_BITS-1:0]  offer_codes;
  reg  [LANES-1:0]       undecided;    // undecided pairs of the beat on offer
  reg  [LANES-1:0]       waiting;      // undecided pairs that have not passed the lane
  reg                    held_right;
  reg                    picked_right;
  reg  [OFFER:0]         exists;
  reg  [4*(OFFER+1)-1:0] ranks;         // beats that leave before this one, or more
  wire [(OFFER+1)*BEAT_BITS-1:0] beats =
      {{s_last, offer_codes, s_index, s_base},
       {\dut.s1_close_q , s1_codes, \dut.s1_tag_q },
       {\dut.s2_close_q , s2_codes, \dut.s2_tag_q },
       \dut.exceptions.beat , queue_words, m_last, m_codes, m_index, m_base};
  reg  [BEAT_BITS-1:0]   beat;
  reg  [CODE_BITS-1:0]   code_here;
  reg  [CODES_BITS-1:0]  told;          // results of the watched beat, from all places
  reg                    told_once;
  reg                    told_right;
  reg  [3:0]             first_later;   // the first place of the later beat
  reg  [3:0]             last_watched;
  reg                    order_right;
  reg                    closes;
  reg                    tells;
  reg                    of_watched;
  reg  [3:0]             rank;
  reg  [3:0]             closing;
  reg  [3:0]             closing_rank;
  reg                    closed_count;  // the closing beat waits in the queue
  reg                    closing_last;
  reg                    closing_right;
  reg                    beats_tell;    // each beat that leaves has something to tell
  reg  [3:0]             pending;       // words whose beats may come to the queue
  reg  [3:0]             to_count;
  reg  [4:0]             offer_left;    // cycles until the beat on offer is taken, if nobody stalls
  reg  [4:0]             cycles_left;   // cycles until any beat leaves or is taken
  integer                w;

  always @* begin
    s1_codes     = \dut.s1_reports_q ;
    s2_codes     = \dut.s2_reports_q ;
    offer_codes  = expected;
    held_right   = 1'b1;
    picked_right = 1'b1;
    for (w = 0; w < LANES; w = w + 1) begin
      undecided[w] = (s_codes[w*CODE_BITS +: CODE_BITS] == 1);
      waiting[w]   = \dut.again_q ? \dut.rest_q [w] : undecided[w];
      if (\dut.s1_pair_q [w]) begin
        s1_codes[w*CODE_BITS +: CODE_BITS] = s1_codes[w*CODE_BITS +: CODE_BITS] | code_of(s1_answer);
        picked_right = picked_right && (\dut.s1_picked_q == w) && (\dut.s1_pair_q == (1 << w));
      end
      if (\dut.s2_pair_q [w]) begin
        s2_codes[w*CODE_BITS +: CODE_BITS] = s2_codes[w*CODE_BITS +: CODE_BITS] | code_of(s2_answer);
      end
      if (\dut.again_q && !\dut.rest_q [w]) begin
        offer_codes[w*CODE_BITS +: CODE_BITS] = 0;
      end
      if (w < count) begin
        held_right = held_right &&
            (held[w] == ((\dut.s1_write_q && (\dut.s1_place_q == w)) ? \dut.s1_word_q : memory[w]));
      end
    end
  end

  always @* begin
    told           = NOTHING;
    told_once      = 1'b1;
    told_right     = 1'b1;
    first_later    = 4'd15;
    last_watched   = NONE;
    order_right    = 1'b1;
    closing        = NONE;
    closed_count   = 1'b0;
    closing_rank   = 4'd15;
    closing_last   = 1'b1;
    closing_right  = 1'b1;
    beats_tell     = 1'b1;
    exists         = queue_holds;
    ranks          = {4'd13, 4'd12, 4'd11, 4'd10, queue_ranks};
    exists[PUSHED] = \dut.exceptions.push ;
    exists[STAGE2] = s2_apart;
    exists[STAGE1] = \dut.s1_valid_q ;
    exists[OFFER]  = offered && aresetn;
    to_count = \dut.g_count.count_q ;
    if (\dut.answered && \dut.reported ) begin
      to_count = to_count + ONE;
    end
    if (s2_apart && (\dut.s2_pair_q != 0) && s2_answer[2] && REPORTS[s2_answer[1:0]]) begin
      to_count = to_count + ONE;
    end
    if (\dut.s1_valid_q && (\dut.s1_pair_q != 0) && s1_answer[2] && REPORTS[s1_answer[1:0]]) begin
      to_count = to_count + ONE;
    end
    if (exists[OFFER]) begin
      to_count = to_count + found_later;
    end
    for (w = 0; w <= OFFER; w = w + 1) begin
      beat          = beats[w*BEAT_BITS +: BEAT_BITS];
      rank          = ranks[4*w +: 4];
      closes        = exists[w] && beat[BEAT_BITS-1];
      tells         = exists[w] && !beat[BEAT_BITS-1] && (beat[4 +: CODES_BITS] != NOTHING);
      of_watched    = tells && (beat[3:2] == watched_j);
      closing       = closing + {3'b000, closes};
      closed_count  = closed_count || (closes && (w < PUSHED));
      closing_right = closing_right && (!closes || (
          (beat[4 +: CODES_BITS] == NOTHING) &&
          (beat[3:0] == (((COUNT != 0) && (w <= PUSHED)) ? close_tag + total : close_tag)) &&
          ((COUNT == 0) || (w >= PUSHED) || (to_count == NONE))));
      beats_tell    = beats_tell && (!exists[w] || (w > PUSHED) || closes || tells);
      told_right    = told_right && (!of_watched || (beat[1:0] == due_base));
      if (closes) begin
        closing_rank = rank;
      end
      if (exists[w] && !closes && (beat[3:2] == later_j) && (rank < first_later)) begin
        first_later = rank;
      end
      if (of_watched && (rank > last_watched)) begin
        last_watched = rank;
      end
      for (l = 0; l < LANES; l = l + 1) begin
        code_here = beat[4+l*CODE_BITS +: CODE_BITS] & {CODE_BITS{of_watched}};
        told_once = told_once && ((told[l*CODE_BITS +: CODE_BITS] == 0) || (code_here == 0));
        told[l*CODE_BITS +: CODE_BITS] = told[l*CODE_BITS +: CODE_BITS] | code_here;
      end
    end
    order_right = (due == NOTHING) || (last_watched < first_later);
    for (w = 0; w <= OFFER; w = w + 1) begin
      closing_last = closing_last && (!exists[w] || (ranks[4*w +: 4] <= closing_rank));
    end
  end

  always @* begin
    pending = {3'b000, \dut.s1_valid_q } + {3'b000, \dut.s2_valid_q } +
              ((LANE_LATENCY != 0) ? {3'b000, \dut.answered } : NONE);
    offer_left = \dut.exceptions.room_q ? 5'd0 : 5'd1;
    for (w = 0; w < LANES; w = w + 1) begin
      offer_left = offer_left + {4'd0, waiting[w]};
    end
    cycles_left = 5'd31;
    if (exists[STAGE1] && ((s1_codes != NOTHING) || \dut.s1_close_q )) begin
      cycles_left = LANE_LATENCY + 3;
    end
    if (exists[STAGE2] && ((s2_codes != NOTHING) || \dut.s2_close_q )) begin
      cycles_left = LANE_LATENCY + 2;
    end
    if (exists[PUSHED]) begin
      cycles_left = 5'd2;
    end
    if (queue_count != NONE) begin
      cycles_left = 5'd1;
    end
    if (exists[OFFER] && (offer_left < cycles_left)) begin
      cycles_left = offer_left;
    end
    if (started) begin
      lemma_again: assert(!\dut.again_q || (offered && (\dut.rest_q != 0)));
      lemma_rest: assert(!\dut.again_q || !exists[OFFER] || ((\dut.rest_q & ~undecided) == 0));
      lemma_left: assert(!\dut.again_q || !exists[OFFER] || ((\dut.left_q == pairs_left) &&
                         (\dut.last_q == (pairs_left == 1))));
      lemma_places: assert(between || (\dut.places_q == count[LANE_BITS-1:0]));
      lemma_few_held: assert(count <= ALL);
      lemma_held: assert(held_right);
      lemma_picked: assert(!\dut.s1_valid_q || picked_right);
      lemma_reads_another: assert(!\dut.s1_write_q || (\dut.s1_pair_q == 0) ||
                                  (\dut.s1_place_q != \dut.s1_picked_q ));
      lemma_tells_all: assert(!aresetn || (told == due));
      lemma_tells_once: assert(!aresetn || told_once);
      lemma_tells_its_base: assert(!aresetn || told_right);
      lemma_beats_tell: assert(beats_tell);
      lemma_later_seen: assert(!aresetn || (first_later == 4'd15) || later_seen);
      lemma_order: assert(!aresetn || !later_behind || order_right);
      lemma_one_closes: assert(!aresetn || (closing == {3'b000, close_due}));
      lemma_closes_last: assert(closing_last);
      lemma_closes_right: assert(closing_right);
      lemma_closes_without_pair: assert((!\dut.s1_valid_q || !\dut.s1_close_q || (\dut.s1_pair_q == 0)) &&
          (!\dut.s2_valid_q || !\dut.s2_close_q || (\dut.s2_pair_q == 0)) &&
          (!\dut.answered || !\dut.closes || (\dut.pair == 0)));
      lemma_counts: assert((COUNT == 0) || !aresetn || (closed_count || (to_count == total)));
      lemma_queued: assert({1'b0, queue_count} + {4'b0000, \dut.exceptions.popped_q } ==
                           \dut.exceptions.queued_q );
      lemma_room: assert(queue_count + pending + {3'b000, \dut.exceptions.room_q } <= DEPTH);
      lemma_quiet_if_due: assert(!aresetn || (quiet == NONE) || (due != NOTHING) || close_due || offered);
      lemma_moves_soon: assert(!aresetn || m_valid || (quiet == NONE) ||
                               (quiet + cycles_left < MOST_QUIET));
    end
  end

  always @* begin
    beat_on_offer_stays: assume(!offered || !aresetn || (s_valid && (offered_beat ==
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
