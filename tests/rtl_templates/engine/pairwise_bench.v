// pairwise_bench: pairwise_engine with its segments, around lanes and references whose answers are
// a hash of the two items. A word is the item itself, WORD_LATENCY cycles late. All segments have
// LANES_PER_SEGMENT lanes but the last, which has LAST_LANES.
// TIERED = 1: a pair_tier stands behind each segment. Its lane answers by other bits of the hash.
`default_nettype none

module pairwise_bench #(
  parameter SEGMENTS = 2,
  parameter LANES_PER_SEGMENT = 4,
  parameter LAST_LANES = 4,
  parameter STREAMS = 1,
  parameter REFERENCES = 1,
  parameter CAPACITY = 40,
  parameter INDEX_BITS = 6,
  parameter REPORT = 11,
  parameter CODE_BITS = 3,
  parameter BITMAP = 0,
  parameter COUNT = 0,
  parameter LANE_LATENCY = 5,
  parameter QUEUE_BITS = 4,
  parameter WORD_LATENCY = 3,
  parameter UNDECIDED = 2,       // undecided pairs among 16
  parameter TIERED = 0,
  parameter LANE_BITS = 2,
  parameter TIER_LATENCY = 4,
  parameter TIER_UNDECIDED = 2   // undecided pairs among 16 that the segment left undecided
) (
  input  wire                                                       aclk,
  input  wire                                                       aresetn,
  input  wire                                                       s_axis_tvalid,
  output wire                                                       s_axis_tready,
  input  wire [19:0]                                                s_axis_tdata,
  input  wire                                                       s_axis_tuser,
  input  wire                                                       s_axis_tlast,
  input  wire [(REFERENCES > 0 ? REFERENCES : 1)-1:0]               reference_ready,
  output wire [STREAMS-1:0]                                         m_axis_tvalid,
  input  wire [STREAMS-1:0]                                         m_axis_tready,
  output wire [STREAMS*(8*((BITMAP*LANES_PER_SEGMENT+7)/8)+16*((INDEX_BITS+7)/8))-1:0] m_axis_tdata,
  output wire [STREAMS*8-1:0]                                       m_axis_tuser,
  output wire [STREAMS-1:0]                                         m_axis_tlast,
  output wire [STREAMS*32-1:0]                                      reports,
  output wire [31:0]                                                recomputations,
  output wire [31:0]                                                busy_cycles,
  output wire [31:0]                                                stalled_cycles
);

  localparam ITEM_BITS   = 20;
  localparam LANES       = (SEGMENTS - 1) * LANES_PER_SEGMENT + LAST_LANES;
  localparam WORD_BITS   = ITEM_BITS + INDEX_BITS + 4;
  localparam TAG_BITS    = 2 * INDEX_BITS;
  localparam ENTRY_BITS  = TAG_BITS + LANES_PER_SEGMENT * CODE_BITS;
  localparam ANSWER_BITS = TAG_BITS + 2;
  localparam ANSWERERS   = (REFERENCES > 0) ? REFERENCES : 1;

  function [31:0] hash;
    input [ITEM_BITS-1:0] item_i;
    input [ITEM_BITS-1:0] item_j;
    reg   [31:0]          mixed;
    begin
      mixed = {item_i, 12'h000} ^ ({12'h000, item_j} * 32'h9e3779b1);
      mixed = (mixed ^ (mixed >> 15)) * 32'h85ebca77;
      hash  = mixed ^ (mixed >> 13);
    end
  endfunction

  wire [ITEM_BITS-1:0]              item_word;
  wire [SEGMENTS:0]                 word_valid;
  wire [SEGMENTS:0]                 word_ready;
  wire [(SEGMENTS+1)*WORD_BITS-1:0] words;
  wire [SEGMENTS-1:0]               entry_valid;
  wire [SEGMENTS-1:0]               entry_ready;
  wire [SEGMENTS*ENTRY_BITS-1:0]    entries;
  wire [SEGMENTS-1:0]               entry_last;
  wire [ANSWERERS-1:0]              request_valid;
  wire [TAG_BITS-1:0]               request_tag;
  wire [2*ITEM_BITS-1:0]            request_items;
  wire [ANSWERERS-1:0]              answer_valid;
  wire [ANSWERERS*ANSWER_BITS-1:0]  answers;

  delay_line #(
    .WIDTH (ITEM_BITS),
    .LENGTH(WORD_LATENCY)
  ) conversion (
    .aclk(aclk),
    .d   (s_axis_tdata),
    .q   (item_word)
  );

  pairwise_engine #(
    .SEGMENTS         (SEGMENTS),
    .LANES_PER_SEGMENT(LANES_PER_SEGMENT),
    .LANES            (LANES),
    .STREAMS          (STREAMS),
    .REFERENCES       (REFERENCES),
    .CAPACITY         (CAPACITY),
    .ITEM_BITS        (ITEM_BITS),
    .WORD_BITS        (ITEM_BITS),
    .WORD_LATENCY     (WORD_LATENCY),
    .INDEX_BITS       (INDEX_BITS),
    .REPORT           (REPORT),
    .CODE_BITS        (CODE_BITS),
    .BITMAP           (BITMAP),
    .COUNT            (COUNT)
  ) engine (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .s_axis_tvalid   (s_axis_tvalid),
    .s_axis_tready   (s_axis_tready),
    .s_axis_tdata    (s_axis_tdata),
    .s_axis_tuser    (s_axis_tuser),
    .s_axis_tlast    (s_axis_tlast),
    .item_word       (item_word),
    .m_word_tvalid   (word_valid[0]),
    .m_word_tready   (word_ready[0]),
    .m_word_tdata    (words[WORD_BITS-1:0]),
    .s_entry_tvalid  (entry_valid),
    .s_entry_tready  (entry_ready),
    .s_entry_tdata   (entries),
    .s_entry_tlast   (entry_last),
    .m_request_tvalid(request_valid),
    .m_request_tready(reference_ready),
    .m_request_tag   (request_tag),
    .m_request_items (request_items),
    .s_answer_valid  (answer_valid),
    .s_answer_tdata  (answers),
    .m_axis_tvalid   (m_axis_tvalid),
    .m_axis_tready   (m_axis_tready),
    .m_axis_tdata    (m_axis_tdata),
    .m_axis_tuser    (m_axis_tuser),
    .m_axis_tlast    (m_axis_tlast),
    .reports         (reports),
    .recomputations  (recomputations),
    .busy_cycles     (busy_cycles),
    .stalled_cycles  (stalled_cycles)
  );

  genvar s;
  genvar k;
  generate
    for (s = 0; s < SEGMENTS; s = s + 1) begin : g_segment
      localparam LANES_HERE = (s == SEGMENTS - 1) ? LAST_LANES : LANES_PER_SEGMENT;
      localparam CODES_HERE = LANES_HERE * CODE_BITS;
      localparam BEAT_BITS  = TAG_BITS + CODES_HERE + TIERED * (LANE_BITS + ITEM_BITS + 3);

      wire [ITEM_BITS-1:0]            passing;
      wire [LANES_HERE*ITEM_BITS-1:0] held;
      wire [2*LANES_HERE-1:0]         verdicts;
      wire [LANES_HERE-1:0]           decided;
      wire                            beat_valid;
      wire                            beat_ready;
      wire [BEAT_BITS-1:0]            beat;
      wire                            beat_last;

      pair_segment #(
        .LANES       (LANES_HERE),
        .LANE_BITS   (LANE_BITS),
        .WORD_BITS   (ITEM_BITS),
        .INDEX_BITS  (INDEX_BITS),
        .LANE_LATENCY(LANE_LATENCY),
        .REPORT      (REPORT),
        .CODE_BITS   (CODE_BITS),
        .COUNT       (COUNT),
        .TIERED      (TIERED),
        .QUEUE_BITS  (QUEUE_BITS)
      ) segment (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_word_tvalid(word_valid[s]),
        .s_word_tready(word_ready[s]),
        .s_word_tdata (words[s*WORD_BITS +: WORD_BITS]),
        .m_word_tvalid(word_valid[s+1]),
        .m_word_tready(word_ready[s+1]),
        .m_word_tdata (words[(s+1)*WORD_BITS +: WORD_BITS]),
        .passing_word (passing),
        .held_words   (held),
        .verdicts     (verdicts),
        .decided      (decided),
        .m_axis_tvalid(beat_valid),
        .m_axis_tready(beat_ready),
        .m_axis_tdata (beat),
        .m_axis_tlast (beat_last)
      );

      if (TIERED == 0) begin : g_no_tier
        assign entry_valid[s]                               = beat_valid;
        assign entries[s*ENTRY_BITS +: TAG_BITS+CODES_HERE] = beat;
        assign entry_last[s]                                = beat_last;
        assign beat_ready                                   = entry_ready[s];
      end else begin : g_tier
        wire [ITEM_BITS-1:0] item_i;
        wire [ITEM_BITS-1:0] item_j;
        wire [1:0]           verdict;
        wire                 tier_decided;
        wire [31:0]          mixed = hash(item_i, item_j);
        wire                 sure  = ({28'h0000000, mixed[11:8]} + 32'd1 > TIER_UNDECIDED);
        wire                 unused_mixed = &{mixed[31:14], mixed[7:0]};

        delay_line #(
          .WIDTH (3),
          .LENGTH(TIER_LATENCY)
        ) lane (
          .aclk(aclk),
          .d   ({sure, sure ? mixed[13:12] : ~mixed[13:12]}),
          .q   ({tier_decided, verdict})
        );

        pair_tier #(
          .LANES       (LANES_HERE),
          .LANE_BITS   (LANE_BITS),
          .WORD_BITS   (ITEM_BITS),
          .INDEX_BITS  (INDEX_BITS),
          .LANE_LATENCY(TIER_LATENCY),
          .REPORT      (REPORT),
          .CODE_BITS   (CODE_BITS),
          .COUNT       (COUNT),
          .QUEUE_BITS  (QUEUE_BITS)
        ) tier (
          .aclk         (aclk),
          .aresetn      (aresetn),
          .s_axis_tvalid(beat_valid),
          .s_axis_tready(beat_ready),
          .s_axis_tdata (beat),
          .s_axis_tlast (beat_last),
          .item_i       (item_i),
          .item_j       (item_j),
          .verdict      (verdict),
          .decided      (tier_decided),
          .m_axis_tvalid(entry_valid[s]),
          .m_axis_tready(entry_ready[s]),
          .m_axis_tdata (entries[s*ENTRY_BITS +: TAG_BITS+CODES_HERE]),
          .m_axis_tlast (entry_last[s])
        );
      end

      if (LANES_HERE < LANES_PER_SEGMENT) begin : g_no_lanes
        assign entries[s*ENTRY_BITS+TAG_BITS+CODES_HERE +: ENTRY_BITS-TAG_BITS-CODES_HERE] =
            {(ENTRY_BITS-TAG_BITS-CODES_HERE){1'b0}};
      end

      for (k = 0; k < LANES_HERE; k = k + 1) begin : g_lane
        wire [31:0] mixed = hash(held[k*ITEM_BITS +: ITEM_BITS], passing);
        wire        sure  = ({28'h0000000, mixed[7:4]} + 32'd1 > UNDECIDED);
        wire        unused_mixed = &{mixed[31:8], mixed[3:2]};

        delay_line #(
          .WIDTH (3),
          .LENGTH(LANE_LATENCY)
        ) lane (
          .aclk(aclk),
          .d   ({sure, sure ? mixed[1:0] : ~mixed[1:0]}),
          .q   ({decided[k], verdicts[2*k +: 2]})
        );
      end
    end

    for (k = 0; k < ANSWERERS; k = k + 1) begin : g_reference
      wire [31:0] mixed =
          hash(request_items[ITEM_BITS-1:0], request_items[2*ITEM_BITS-1:ITEM_BITS]);
      wire        unused_mixed = &mixed[31:2];

      valid_delay_line #(
        .LENGTH(9 + k)
      ) valid (
        .aclk   (aclk),
        .aresetn(aresetn),
        .d      (request_valid[k] && reference_ready[k]),
        .q      (answer_valid[k])
      );

      delay_line #(
        .WIDTH (ANSWER_BITS),
        .LENGTH(9 + k)
      ) answer (
        .aclk(aclk),
        .d   ({request_tag, mixed[1:0]}),
        .q   (answers[k*ANSWER_BITS +: ANSWER_BITS])
      );
    end
  endgenerate

  // A word that has passed the last segment has met every lane.
  assign word_ready[SEGMENTS] = 1'b1;
  wire unused_end = &{word_valid[SEGMENTS], words[SEGMENTS*WORD_BITS +: WORD_BITS]};

endmodule

`default_nettype wire
