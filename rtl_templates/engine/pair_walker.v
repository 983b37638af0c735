// pair_walker: reads the words of a set, block by block, in the order in which the chain of
// segments makes pairs of them.
// A set whose first item is not a `target` makes all pairs i < j. Block b is the words from b *
// LANES to the last. All of them `stay` and `meet`, so each of the first LANES stays in a lane and
// meets all words that follow. A block of one word has no pair and is left out.
//
// A set that begins with targets makes only pairs of a target with another item. Block b is LANES
// targets, which stay and meet nothing, and then all other items, which meet and do not stay. The
// blocks begin once the first of the other items has come; a target that comes later counts as one
// of the other items.
//
// Words are read as soon as they are stored, one a cycle, without a gap between blocks. After the
// last word comes one with `close`. Words: latency 1 from the address. Reset and `set_closed`
// forget the set.
`default_nettype none

module pair_walker #(
  parameter LANES = 8,        // lanes of all segments, 1 or more
  parameter CAPACITY = 1024,  // items of the largest set, 2 to 2^INDEX_BITS
  parameter INDEX_BITS = 10   // bits of an item's index, 1 to 30
) (
  input  wire                  aclk,
  input  wire                  aresetn,
  input  wire                  stored,         // the set's next word is written in this cycle
  input  wire                  stored_target,
  input  wire                  ended,          // that word is the set's last one
  input  wire                  set_closed,
  output wire                  read_enable,
  output wire [INDEX_BITS-1:0] read_address,
  output wire                  m_word_tvalid,
  input  wire                  m_word_tready,
  output wire                  m_word_close,
  output wire                  m_word_first,
  output wire                  m_word_stays,
  output wire                  m_word_meets,
  output wire [INDEX_BITS-1:0] m_word_index
);

  localparam BLOCK = (LANES < CAPACITY) ? LANES : CAPACITY;  // words of a block that stay
  localparam [INDEX_BITS:0] ZERO = 0;
  localparam [INDEX_BITS:0] ONE  = 1;
  localparam [INDEX_BITS:0] STEP = BLOCK[INDEX_BITS:0];
  localparam [INDEX_BITS:0] FULL = CAPACITY[INDEX_BITS:0];

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (LANES < 1) begin : g_refused_lanes LANES_is_below_1 refused (); end
    if (CAPACITY < 2) begin : g_refused_capacity CAPACITY_is_below_2 refused (); end
    if (INDEX_BITS < 1) begin : g_refused_index_bits INDEX_BITS_is_below_1 refused (); end
    if (INDEX_BITS > 30) begin : g_refused_index_shift INDEX_BITS_is_above_30 refused (); end
    if (((CAPACITY - 1) >>> INDEX_BITS) > 0)
      begin : g_refused_last_item INDEX_BITS_is_too_small_for_CAPACITY refused (); end
  endgenerate

  wire restart = !aresetn || set_closed;

  // The stored words: targets first, if there are any.
  reg  [INDEX_BITS:0] stored_q;
  reg  [INDEX_BITS:0] targets_q;
  reg                 has_targets_q;  // targets_q is not zero
  reg                 others_q;    // a word that is no target has come
  reg                 complete_q;
  wire                is_target = stored_target && !others_q;

  always @(posedge aclk) begin
    if (restart) begin
      stored_q      <= ZERO;
      targets_q     <= ZERO;
      has_targets_q <= 1'b0;
      others_q      <= 1'b0;
      complete_q    <= 1'b0;
    end else begin
      if (stored) begin
        stored_q <= stored_q + ONE;
        others_q <= !is_target;
      end
      if (stored && is_target) begin
        targets_q     <= targets_q + ONE;
        has_targets_q <= 1'b1;
      end
      if (ended) begin
        complete_q <= 1'b1;
      end
    end
  end

  // The walk. As long as more words may come, the last stored word may or may not be the set's last
  // one, so it waits. A set that has only targets so far waits as well.
  reg  [INDEX_BITS:0] next_q;       // the word to be read
  reg  [INDEX_BITS:0] following_q;  // next_q + 1: no adder in front of the comparisons
  reg                 first_q;      // that word starts a block
  reg                 targets_done_q;  // the targets of this block have been read
  reg  [INDEX_BITS:0] next_base_q;  // the word that starts the next block
  reg                 walked_q;     // every block has been read
  reg                 closed_q;     // the word with `close` has been sent

  wire                in_targets   = has_targets_q && !targets_done_q;
  wire                last_target  =
      in_targets && ((following_q == next_base_q) || (following_q == targets_q));
  wire                last         = complete_q && (following_q == stored_q) && !in_targets;
  wire [INDEX_BITS:0] least_block  = has_targets_q ? next_base_q : next_base_q + ONE;
  wire                more         = (least_block < (has_targets_q ? targets_q : stored_q));
  wire                known        = complete_q || (following_q != FULL);
  wire                settled      = has_targets_q ? others_q : known;
  wire                no_others    = complete_q && has_targets_q && !others_q;
  wire                no_words     = complete_q && (stored_q == ZERO);
  wire                available    = (next_q != stored_q) && settled && known && !walked_q;
  wire                room;
  wire                read         = available && room;
  wire                close        = walked_q && !closed_q && room;

  always @(posedge aclk) begin
    if (restart) begin
      next_q         <= ZERO;
      following_q    <= ONE;
      first_q        <= 1'b1;
      targets_done_q <= 1'b0;
      next_base_q    <= STEP;
      walked_q       <= 1'b0;
      closed_q       <= 1'b0;
    end else begin
      if (read) begin
        next_q         <= following_q;
        following_q    <= following_q + ONE;
        first_q        <= last;
        targets_done_q <= !last && (targets_done_q || last_target);
      end
      if (read && last_target) begin
        next_q      <= targets_q;
        following_q <= targets_q + ONE;
      end
      if (read && last) begin
        next_q      <= next_base_q;
        following_q <= next_base_q + ONE;
        next_base_q <= next_base_q + STEP;
      end
      if ((read && last && !more) || no_others || no_words) begin
        walked_q <= 1'b1;
      end
      if (close) begin
        closed_q <= 1'b1;
      end
    end
  end

  // The word on offer; the memory's output register holds its data.
  reg                  m_valid_q;
  reg                  m_close_q;
  reg                  m_first_q;
  reg                  m_stays_q;
  reg                  m_meets_q;
  reg [INDEX_BITS-1:0] m_index_q;

  assign room = !m_valid_q || m_word_tready;

  always @(posedge aclk) begin
    if (!aresetn) begin
      m_valid_q <= 1'b0;
    end else begin
      m_valid_q <= read || close || (m_valid_q && !m_word_tready);
    end
  end

  always @(posedge aclk) begin
    if (room) begin
      m_close_q <= walked_q;
      m_first_q <= first_q;
      m_stays_q <= !has_targets_q || in_targets;
      m_meets_q <= !in_targets;
      m_index_q <= next_q[INDEX_BITS-1:0];
    end
  end

  assign read_enable   = read;
  assign read_address  = next_q[INDEX_BITS-1:0];
  assign m_word_tvalid = m_valid_q;
  assign m_word_close  = m_close_q;
  assign m_word_first  = m_first_q;
  assign m_word_stays  = m_stays_q;
  assign m_word_meets  = m_meets_q;
  assign m_word_index  = m_index_q;

endmodule

`default_nettype wire
