// pair_segment: a link of the chain that carries words past the lanes. It serves LANES lanes in
// lock step. A word is the part of an item that the lanes need.
//
// The first LANES words of a block that may stay do so, one in each lane, on held_words. A later
// word that meets them is on passing_word one cycle after it was taken. LANE_LATENCY cycles later
// the lanes answer for all of its pairs at once. Words that did not stay go on to the next segment,
// which does the same. So the lanes of the whole chain hold the words base, base + 1, ..., and each
// later word meets each of them once.
//
// Only exceptions leave, by a queue: a beat for each word with at least one pair that is undecided
// or whose verdict is in REPORT. The beat has a code for each lane (pair_code). The word that
// closes a set passes the lanes like any other and leaves as the beat with tlast.
//
// TIERED = 1: a beat also carries its word. Each word that is the first of its block, or that
// stays, also sends a beat, so that a pair_tier knows the words in the lanes. A beat also carries
// the number of its undecided pairs, since the tier has to know early in a cycle which of them is
// the last.
//
// Lanes never wait: no word is taken unless the queue has room for all beats that may still come.
// Room is reserved for a word on offer to the next segment, and the word stays on offer. Interval
// 1, latency 3 to the next segment. Reset forgets all.
`default_nettype none

module pair_segment #(
  parameter LANES = 8,         // lanes in lock step, 1 to 2^LANE_BITS
  parameter LANE_BITS = 3,     // bits of a lane's number, 1 to 30
  parameter WORD_BITS = 32,    // bits of an item's word, 1 or more
  parameter INDEX_BITS = 10,   // bits of an item's index, 1 or more
  parameter LANE_LATENCY = 8,  // latency of the lane in cycles, 0 or more
  parameter REPORT = 11,       // 0 to 15: bit v is 1 where verdict v is reported
  parameter CODE_BITS = 3,     // bits of a code: 3, or 2 if at most one verdict is reported
  parameter COUNT = 0,         // 1: reported pairs are only counted; tlast's beat has their number
  parameter TIERED = 0,        // 1: beats are for a pair_tier; 0: for the engine
  parameter QUEUE_BITS = 5     // 1 to 30: room for 2^QUEUE_BITS beats, more than LANE_LATENCY + 3
) (
  input  wire                                  aclk,
  input  wire                                  aresetn,
  input  wire                                  s_word_tvalid,
  output wire                                  s_word_tready,
  input  wire [WORD_BITS+INDEX_BITS+3:0]       s_word_tdata,
  output wire                                  m_word_tvalid,
  input  wire                                  m_word_tready,
  output wire [WORD_BITS+INDEX_BITS+3:0]       m_word_tdata,
  output wire [WORD_BITS-1:0]                  passing_word,
  output wire [LANES*WORD_BITS-1:0]            held_words,
  input  wire [LANES*2-1:0]                    verdicts,
  input  wire [LANES-1:0]                      decided,
  output wire                                  m_axis_tvalid,
  input  wire                                  m_axis_tready,
  // {codes, index j, index base}; TIERED: {undecided pairs, first, stays, word j} above
  output wire [2*INDEX_BITS+LANES*CODE_BITS+TIERED*(WORD_BITS+LANE_BITS+3)-1:0] m_axis_tdata,
  output wire                                  m_axis_tlast
);

  localparam TAG_BITS    = 2 * INDEX_BITS;
  localparam CODES_BITS  = LANES * CODE_BITS;
  localparam NUMBER_BITS = LANE_BITS + 1;  // bits of a count of lanes
  localparam WORD_PART   = (TIERED != 0) ? NUMBER_BITS + WORD_BITS + 2 : 0;

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
    if ((TIERED != 0) && (TIERED != 1))
      begin : g_refused_tiered TIERED_is_not_0_or_1 refused (); end
  endgenerate

  // The current word.
  wire                  word_valid;
  wire                  word_close;
  wire                  word_first;  // the first of its block in this segment
  wire                  word_stays;
  wire                  word_meets;
  wire [INDEX_BITS-1:0] word_index;
  wire [WORD_BITS-1:0]  word;
  wire                  step;

  stream_fifo #(
    .WIDTH     (WORD_BITS + INDEX_BITS + 4),
    .DEPTH_BITS(1)
  ) link (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_word_tvalid),
    .s_axis_tready(s_word_tready),
    .s_axis_tdata (s_word_tdata),
    .m_axis_tvalid(word_valid),
    .m_axis_tready(step),
    .m_axis_tdata ({word_close, word_first, word_stays, word_meets, word_index, word})
  );

  // Lanes are filled from the lowest up.
  reg  [LANES-1:0] holds_q;
  reg              passed_q;  // the previous word went on to the next segment
  wire             room;      // the queue has room for one more word
  wire [LANES-1:0] holds  = holds_q & {LANES{!word_first}};
  wire [LANES:0]   filled = {holds, 1'b1};  // bit k: all lanes below k hold a word
  wire             stays  = word_stays && !word_close && !filled[LANES];
  wire [LANES-1:0] fills  = filled[LANES-1:0] & ~holds & {LANES{stays}};

  assign step          = word_valid && room && (stays || m_word_tready);
  assign m_word_tvalid = word_valid && room && !stays;
  assign m_word_tdata  =
      {word_close, word_first || !passed_q, word_stays, word_meets, word_index, word};

  always @(posedge aclk) begin
    if (!aresetn) begin
      holds_q  <= {LANES{1'b0}};
      passed_q <= 1'b0;
    end else if (step) begin
      holds_q  <= holds | fills;
      passed_q <= !stays;
    end
  end

  // The word at the lanes, and beside it the data that their answer needs. Only `taken_q` says
  // whether a word was taken. The other registers load the current word in every cycle, since
  // `step` is known late and would have to reach all of their enables.
  reg                   taken_q;
  reg                   close_q;
  reg                   first_q;
  reg  [LANES-1:0]      meets_q;
  reg  [LANES-1:0]      fills_q;
  reg  [INDEX_BITS-1:0] index_q;
  reg  [WORD_BITS-1:0]  passing_q;
  wire                  answered;
  wire                  closes;
  wire                  starts;
  wire [LANES-1:0]      met;
  wire [INDEX_BITS-1:0] index;

  assign passing_word = passing_q;

  always @(posedge aclk) begin
    if (!aresetn) begin
      taken_q <= 1'b0;
    end else begin
      taken_q <= step;
    end
  end

  always @(posedge aclk) begin
    close_q   <= word_close;
    first_q   <= word_first;
    meets_q   <= holds & {LANES{word_meets && !word_close}};
    fills_q   <= fills;
    index_q   <= word_index;
    passing_q <= word;
  end

  // A lane holds its word when the next word is at the lanes.
  genvar k;
  generate
    for (k = 0; k < LANES; k = k + 1) begin : g_held
      reg [WORD_BITS-1:0] word_q;

      always @(posedge aclk) begin
        if (taken_q && fills_q[k]) begin
          word_q <= passing_q;
        end
      end

      assign held_words[k*WORD_BITS +: WORD_BITS] = word_q;
    end
  endgenerate

  valid_delay_line #(
    .LENGTH(LANE_LATENCY)
  ) taken_beside_lanes (
    .aclk   (aclk),
    .aresetn(aresetn),
    .d      (taken_q),
    .q      (answered)
  );

  delay_line #(
    .WIDTH (INDEX_BITS + LANES + 2),
    .LENGTH(LANE_LATENCY)
  ) word_beside_lanes (
    .aclk(aclk),
    .d   ({close_q, first_q, meets_q, index_q}),
    .q   ({closes, starts, met, index})
  );

  // The index of a block's first word, which stays in the lowest lane.
  reg [INDEX_BITS-1:0] base_q;

  always @(posedge aclk) begin
    if (answered && starts) begin
      base_q <= index;
    end
  end

  // The exceptions: the code of each lane's pair.
  wire [LANES-1:0]      reported;
  wire [CODES_BITS-1:0] codes;

  generate
    for (k = 0; k < LANES; k = k + 1) begin : g_code
      pair_code #(
        .REPORT   (REPORT),
        .CODE_BITS(CODE_BITS),
        .COUNT    (COUNT)
      ) code_of_lane (
        .met     (met[k]),
        .decided (decided[k]),
        .verdict (verdicts[2*k +: 2]),
        .reported(reported[k]),
        .code    (codes[k*CODE_BITS +: CODE_BITS])
      );
    end
  endgenerate

  // The closing beat has no pair: its tag may be a number.
  wire [TAG_BITS-1:0] tag;

  generate
    if (COUNT == 0) begin : g_no_count
      wire unused_reported = ^reported;

      assign tag = {index, base_q};
    end else begin : g_count
      // The pairs of one word are counted in one cycle, and added to the sum in the next.
      localparam MORE_BITS = (NUMBER_BITS < TAG_BITS) ? NUMBER_BITS : TAG_BITS;

      reg  [TAG_BITS-1:0]  count_q;
      reg  [MORE_BITS-1:0] more;
      reg  [MORE_BITS-1:0] more_q;
      reg  [TAG_BITS-1:0]  counted;
      integer              lane;

      always @* begin
        more = {MORE_BITS{1'b0}};
        for (lane = 0; lane < LANES; lane = lane + 1) begin
          more = more + {{(MORE_BITS-1){1'b0}}, reported[lane]};
        end
      end

      always @* begin
        counted                = {TAG_BITS{1'b0}};
        counted[MORE_BITS-1:0] = more_q;
        counted                = count_q + counted;
      end

      always @(posedge aclk) begin
        if (!aresetn || (answered && closes)) begin
          count_q <= {TAG_BITS{1'b0}};
          more_q  <= {MORE_BITS{1'b0}};
        end else begin
          count_q <= counted;
          more_q  <= more & {MORE_BITS{answered}};
        end
      end

      assign tag = closes ? counted : {index, base_q};
    end
  endgenerate

  // With TIERED a beat carries its word and says whether the word begins a block, whether it stays,
  // and how many of its pairs are undecided.
  wire                               informs;
  wire [CODES_BITS+TAG_BITS+WORD_PART-1:0] beat;

  generate
    if (TIERED == 0) begin : g_no_tier
      assign informs = 1'b0;
      assign beat    = {codes, tag};
    end else begin : g_tier
      wire                 stayed;
      wire [WORD_BITS-1:0] answered_word;
      reg                  stays_q;

      always @(posedge aclk) begin
        stays_q <= stays;
      end

      delay_line #(
        .WIDTH (WORD_BITS + 1),
        .LENGTH(LANE_LATENCY)
      ) passing_beside_lanes (
        .aclk(aclk),
        .d   ({stays_q, passing_q}),
        .q   ({stayed, answered_word})
      );

      reg [NUMBER_BITS-1:0] undecided;
      integer               pair;

      always @* begin
        undecided = {NUMBER_BITS{1'b0}};
        for (pair = 0; pair < LANES; pair = pair + 1) begin
          undecided = undecided + {{LANE_BITS{1'b0}}, met[pair] && !decided[pair]};
        end
      end

      assign informs = starts || stayed;
      assign beat    = {undecided, starts, stayed, answered_word, codes, tag};
    end
  endgenerate

  // The beats of LANE_LATENCY + 3 words may not be counted yet: those of LANE_LATENCY words in the
  // lanes, of the word before them, of the one that is taken, and the beat that was pushed in the
  // previous cycle.
  exception_queue #(
    .WIDTH     (1 + CODES_BITS + TAG_BITS + WORD_PART),
    .DEPTH_BITS(QUEUE_BITS),
    .MAY_COME  (LANE_LATENCY + 3)
  ) exceptions (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .on_offer     (m_word_tvalid && !m_word_tready),
    .room         (room),
    .push         (answered && (closes || informs || (codes != {CODES_BITS{1'b0}}))),
    .beat         ({closes, beat}),
    .m_axis_tvalid(m_axis_tvalid),
    .m_axis_tready(m_axis_tready),
    .m_axis_tdata ({m_axis_tlast, m_axis_tdata})
  );

endmodule

`default_nettype wire
