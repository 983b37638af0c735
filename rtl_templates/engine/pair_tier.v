// pair_tier: decides the pairs that the lanes of a segment left undecided, by one lane of higher
// precision, one pair a cycle. It takes the beats of a pair_segment with TIERED = 1, and gives out
// beats like those of a segment with TIERED = 0.
//
// Beats stay in order, so only the words in the lanes have to be stored. The beat of a word that
// stays has the flag `stays`, that of the first word of a block the flag `first`. A beat passes the
// lane once for each of its undecided pairs, or once if it has none. After each pass a beat may
// leave. The first of these beats has the pairs that the segment reported. Each of them also has
// the pair that passed: as reported if its verdict is reported, as undecided if the tier left it
// undecided.
//
// Latency LANE_LATENCY + 4, interval 1 for each pair. Reset forgets all.
`default_nettype none

module pair_tier #(
  parameter LANES = 8,         // lanes in lock step, 1 to 2^LANE_BITS
  parameter LANE_BITS = 3,     // bits of a lane's number, 1 to 30
  parameter WORD_BITS = 32,    // bits of an item's word, 1 or more
  parameter INDEX_BITS = 10,   // bits of an item's index, 1 or more
  parameter LANE_LATENCY = 8,  // latency of the tier's lane in cycles, 0 or more
  parameter REPORT = 11,       // 0 to 15: bit v is 1 where verdict v is reported
  parameter CODE_BITS = 3,     // bits of a code: 3, or 2 if at most one verdict is reported
  parameter COUNT = 0,         // 1: the closing beat's number grows by the pairs reported here
  parameter QUEUE_BITS = 5     // 1 to 30: room for 2^QUEUE_BITS beats, more than LANE_LATENCY + 4
) (
  input  wire                                    aclk,
  input  wire                                    aresetn,
  input  wire                                    s_axis_tvalid,
  output wire                                    s_axis_tready,
  // {undecided pairs, first, stays, word j, codes, index j, index base}
  input  wire [LANE_BITS+WORD_BITS+2*INDEX_BITS+LANES*CODE_BITS+2:0] s_axis_tdata,
  input  wire                                    s_axis_tlast,
  output wire [WORD_BITS-1:0]                    item_i,
  output wire [WORD_BITS-1:0]                    item_j,
  input  wire [1:0]                              verdict,
  input  wire                                    decided,
  output wire                                    m_axis_tvalid,
  input  wire                                    m_axis_tready,
  output wire [2*INDEX_BITS+LANES*CODE_BITS-1:0] m_axis_tdata,  // {codes, index j, index base}
  output wire                                    m_axis_tlast
);

  localparam TAG_BITS   = 2 * INDEX_BITS;
  localparam CODES_BITS = LANES * CODE_BITS;
  localparam [LANES-1:0]     ONE_LANE = 1;
  localparam [LANE_BITS-1:0] NONE     = 0;
  localparam [LANE_BITS-1:0] ONE      = 1;
  localparam [LANE_BITS:0]   ONE_LEFT = 1;
  localparam [LANE_BITS:0]   TWO_LEFT = 2;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (LANES < 1) begin : g_refused_lanes LANES_is_below_1 refused (); end
    if ((LANE_BITS < 1) || (LANE_BITS > 30)) begin : g_refused_lane_bits
      LANE_BITS_is_not_1_to_30 refused ();
    end else if (LANES > (1 << LANE_BITS)) begin : g_refused_few_lane_bits
      LANE_BITS_is_too_small_for_LANES refused ();
    end
    if (WORD_BITS < 1) begin : g_refused_word_bits WORD_BITS_is_below_1 refused (); end
    if (INDEX_BITS < 1) begin : g_refused_index_bits INDEX_BITS_is_below_1 refused (); end
    if (LANE_LATENCY < 0) begin : g_refused_lane_latency LANE_LATENCY_is_below_0 refused (); end
  endgenerate

  // The current beat, and those of its pairs that have not passed the lane. Flags say which pair is
  // next, but the choice among them takes most of a cycle. The next beat is taken with the last
  // pair, so a number says early in the cycle whether the pair is the last.
  wire [LANE_BITS:0]    pairs;
  wire                  first;
  wire                  stays;
  wire [WORD_BITS-1:0]  word;
  wire [CODES_BITS-1:0] codes;
  wire [TAG_BITS-1:0]   tag;
  wire [LANES-1:0]      undecided;
  wire [CODES_BITS-1:0] reports;
  reg                   again_q;  // the current beat has passed the lane before
  reg                   last_q;   // if again_q: one pair is left
  reg  [LANE_BITS:0]    left_q;   // if again_q: the number of pairs that are left
  reg  [LANES-1:0]      rest_q;   // if again_q: the lanes of these pairs
  wire [LANES-1:0]      waiting = again_q ? rest_q : undecided;
  wire [LANES-1:0]      lowest  = waiting & (~waiting + ONE_LANE);
  wire [LANE_BITS:0]    left    = again_q ? left_q : pairs;
  wire                  last    = again_q ? last_q : (pairs[LANE_BITS:1] == NONE);
  wire                  room;
  wire                  step    = s_axis_tvalid && room;

  assign {pairs, first, stays, word, codes, tag} = s_axis_tdata;
  assign s_axis_tready                           = room && last;

  genvar k;
  generate
    for (k = 0; k < LANES; k = k + 1) begin : g_code
      wire [CODE_BITS-1:0] code = codes[k*CODE_BITS +: CODE_BITS];
      wire                 kept = code[CODE_BITS-1] && !again_q && (COUNT == 0);

      assign undecided[k]                      = !code[CODE_BITS-1] && code[0];
      assign reports[k*CODE_BITS +: CODE_BITS] = code & {CODE_BITS{kept}};
    end
  endgenerate

  always @(posedge aclk) begin
    if (!aresetn) begin
      again_q <= 1'b0;
    end else if (step) begin
      again_q <= !last;
    end
  end

  always @(posedge aclk) begin
    if (step) begin
      last_q <= (left == TWO_LEFT);
      left_q <= left - ONE_LEFT;
      rest_q <= waiting & ~lowest;
    end
  end

  reg [LANE_BITS-1:0] picked;
  integer             l;

  always @* begin
    picked = NONE;
    for (l = 0; l < LANES; l = l + 1) begin
      if (lowest[l]) begin
        picked = picked | l[LANE_BITS-1:0];
      end
    end
  end

  // Stage 1: the word that lane `picked` holds is read. A word that stays is written into the
  // lowest place that its block has not taken yet, for later beats.
  reg                   s1_valid_q;
  reg                   s1_write_q;
  reg                   s1_close_q;
  reg  [LANES-1:0]      s1_pair_q;
  reg  [LANE_BITS-1:0]  s1_picked_q;
  reg  [LANE_BITS-1:0]  s1_place_q;
  reg  [LANE_BITS-1:0]  places_q;     // places that the current block has taken
  reg  [WORD_BITS-1:0]  s1_word_q;
  reg  [CODES_BITS-1:0] s1_reports_q;
  reg  [TAG_BITS-1:0]   s1_tag_q;
  wire [LANE_BITS-1:0]  place = first ? NONE : places_q;

  always @(posedge aclk) begin
    if (!aresetn) begin
      s1_valid_q <= 1'b0;
      s1_write_q <= 1'b0;
    end else begin
      s1_valid_q <= step;
      s1_write_q <= step && stays && s_axis_tready;
    end
  end

  always @(posedge aclk) begin
    if (step) begin
      s1_close_q   <= s_axis_tlast;
      s1_pair_q    <= lowest;
      s1_picked_q  <= picked;
      s1_place_q   <= place;
      s1_word_q    <= word;
      s1_reports_q <= reports;
      s1_tag_q     <= tag;
    end
    if (step && s_axis_tready) begin
      places_q <= stays ? place + ONE : place;
    end
  end

  dual_port_memory #(
    .WIDTH       (WORD_BITS),
    .ADDRESS_BITS(LANE_BITS)
  ) held_words (
    .aclk         (aclk),
    .write_enable (s1_write_q),
    .write_address(s1_place_q),
    .write_data   (s1_word_q),
    .read_enable  (s1_valid_q && (s1_pair_q != {LANES{1'b0}})),
    .read_address (s1_picked_q),
    .read_data    (item_i)
  );

  // Stage 2: both words are at the lane, and beside them the data that the lane's answer needs.
  reg                   s2_valid_q;
  reg                   s2_close_q;
  reg  [LANES-1:0]      s2_pair_q;
  reg  [WORD_BITS-1:0]  s2_word_q;
  reg  [CODES_BITS-1:0] s2_reports_q;
  reg  [TAG_BITS-1:0]   s2_tag_q;

  assign item_j = s2_word_q;

  always @(posedge aclk) begin
    if (!aresetn) begin
      s2_valid_q <= 1'b0;
    end else begin
      s2_valid_q <= s1_valid_q;
    end
  end

  always @(posedge aclk) begin
    s2_close_q   <= s1_close_q;
    s2_pair_q    <= s1_pair_q;
    s2_word_q    <= s1_word_q;
    s2_reports_q <= s1_reports_q;
    s2_tag_q     <= s1_tag_q;
  end

  wire                  answered;
  wire                  closes;
  wire [LANES-1:0]      pair;
  wire [CODES_BITS-1:0] first_codes;
  wire [TAG_BITS-1:0]   answered_tag;

  valid_delay_line #(
    .LENGTH(LANE_LATENCY)
  ) valid_beside_lane (
    .aclk   (aclk),
    .aresetn(aresetn),
    .d      (s2_valid_q),
    .q      (answered)
  );

  delay_line #(
    .WIDTH (1 + LANES + CODES_BITS + TAG_BITS),
    .LENGTH(LANE_LATENCY)
  ) beat_beside_lane (
    .aclk(aclk),
    .d   ({s2_close_q, s2_pair_q, s2_reports_q, s2_tag_q}),
    .q   ({closes, pair, first_codes, answered_tag})
  );

  // The code that the tier found for the pair replaces the code of the pair's lane in the beat.
  wire                  reported;
  wire [CODE_BITS-1:0]  found;
  wire [CODES_BITS-1:0] leaving_codes;

  pair_code #(
    .REPORT   (REPORT),
    .CODE_BITS(CODE_BITS),
    .COUNT    (COUNT)
  ) code_of_pair (
    .met     (pair != {LANES{1'b0}}),
    .decided (decided),
    .verdict (verdict),
    .reported(reported),
    .code    (found)
  );

  generate
    for (k = 0; k < LANES; k = k + 1) begin : g_leaving
      assign leaving_codes[k*CODE_BITS +: CODE_BITS] =
          first_codes[k*CODE_BITS +: CODE_BITS] | (found & {CODE_BITS{pair[k]}});
    end
  endgenerate

  wire [TAG_BITS-1:0] leaving_tag;

  generate
    if (COUNT == 0) begin : g_no_count
      wire unused_reported = reported;

      assign leaving_tag = answered_tag;
    end else begin : g_count
      reg [TAG_BITS-1:0] count_q;

      always @(posedge aclk) begin
        if (!aresetn || (answered && closes)) begin
          count_q <= {TAG_BITS{1'b0}};
        end else if (answered) begin
          count_q <= count_q + {{(TAG_BITS-1){1'b0}}, reported};
        end
      end

      assign leaving_tag = closes ? answered_tag + count_q : answered_tag;
    end
  endgenerate

  exception_queue #(
    .WIDTH     (1 + CODES_BITS + TAG_BITS),
    .DEPTH_BITS(QUEUE_BITS),
    .MAY_COME  (LANE_LATENCY + 4)
  ) exceptions (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .on_offer     (1'b0),
    .room         (room),
    .push         (answered && (closes || (leaving_codes != {CODES_BITS{1'b0}}))),
    .beat         ({closes, leaving_codes, leaving_tag}),
    .m_axis_tvalid(m_axis_tvalid),
    .m_axis_tready(m_axis_tready),
    .m_axis_tdata ({m_axis_tlast, m_axis_tdata})
  );

endmodule

`default_nettype wire
