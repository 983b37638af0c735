// arg_min_engine: finds the candidate that costs least, for each row of a stream, by a chain of
// lanes.
//
// Candidates are loaded once, one per beat, with tlast on the last: CANDIDATES of them, from number
// 0. If fewer arrive, the last one is repeated. Surplus ones are accepted but not used, and
// `overrun` is 1 until the next load. Then rows enter, each with a tag and tlast, and leave in
// their order as {index of the candidate, tag, tlast}.
//
// Lane k - 1 compares candidate k with the best of candidates 0 to k - 1. It must return one result
// {6'b0, verdict} for each pair, in order and with the pair's tag, and must decide all pairs. Lanes
// see words, which the conversion outside this module makes: `candidate_word` and `row_word` come
// WORD_LATENCY cycles behind `candidate` and s_axis_tdata.
//
// Full candidates and rows stay in memories. References ask the memories for a pair by the low bits
// of the pair's tag, {index of its own candidate, index of the best, place of the row}. Without
// references there are no such memories, and the ports are those of one reference, unused.
//
// The next load is taken when no row is inside; while it is offered, no row enters. Interval 1. The
// latency is WORD_LATENCY + 2, plus the latency of each of the CANDIDATES - 1 lanes and one cycle
// for each lane. Rows enter 2 cycles after the last candidate or later.
//
// Two counters: `rows` that have left, and `stalled_cycles`, in which a row was offered and not
// taken although the candidates were complete and no load was on offer. Reset forgets all; lanes
// and references have to be reset with it.
`default_nettype none

module arg_min_engine #(
  parameter CANDIDATES = 3,       // candidates of a load, 2 to 2^INDEX_BITS
  parameter CANDIDATE_BITS = 32,  // bits of a candidate, 1 or more
  parameter ROW_BITS = 32,        // bits of a row, 1 or more
  parameter WORD_BITS = 32,       // bits of a candidate's word, 1 or more
  parameter ROW_WORD_BITS = 32,   // bits of a row's word, 1 or more
  parameter WORD_LATENCY = 0,     // latency of the words in cycles, 0 or more
  parameter TAG_BITS = 8,         // bits of a tag (m_axis_tuser), 1 or more
  parameter INDEX_BITS = 2,       // bits of a candidate's index, 1 to 30
  parameter PLACE_BITS = 6,       // bits of a row's place, 1 to 30: 2^PLACE_BITS rows may be inside
  parameter REFERENCES = 1,       // number of references, 0 or more; 0: the lanes decide all pairs
  parameter COUNTER_BITS = 32     // bits of a counter, which wraps; 0: no counters
) (
  input  wire                                                               aclk,
  input  wire                                                               aresetn,
  input  wire                                                               s_candidate_tvalid,
  output wire                                                               s_candidate_tready,
  input  wire [CANDIDATE_BITS-1:0]                                          s_candidate_tdata,
  input  wire                                                               s_candidate_tlast,
  output wire [CANDIDATE_BITS-1:0]                                          candidate,
  input  wire [WORD_BITS-1:0]                                               candidate_word,
  input  wire                                                               s_axis_tvalid,
  output wire                                                               s_axis_tready,
  input  wire [ROW_BITS-1:0]                                                s_axis_tdata,
  input  wire [TAG_BITS-1:0]                                                s_axis_tuser,
  input  wire                                                               s_axis_tlast,
  input  wire [ROW_WORD_BITS-1:0]                                           row_word,
  output wire [CANDIDATES-2:0]                                              pair_tvalid,
  input  wire [CANDIDATES-2:0]                                              pair_tready,
  output wire [(CANDIDATES-1)*WORD_BITS-1:0]                                pair_best,
  output wire [(CANDIDATES-1)*WORD_BITS-1:0]                                pair_own,
  output wire [(CANDIDATES-1)*(ROW_WORD_BITS+2*INDEX_BITS+PLACE_BITS)-1:0]  pair_tag,  // row's word on top
  input  wire [CANDIDATES-2:0]                                              result_tvalid,
  output wire [CANDIDATES-2:0]                                              result_tready,
  input  wire [(CANDIDATES-1)*8-1:0]                                        result_tdata,
  input  wire [(CANDIDATES-1)*(ROW_WORD_BITS+2*INDEX_BITS+PLACE_BITS)-1:0]  result_tag,
  input  wire [(REFERENCES > 0 ? REFERENCES : 1)-1:0]                       refetch_tvalid,
  output wire [(REFERENCES > 0 ? REFERENCES : 1)-1:0]                       refetch_tready,
  input  wire [(REFERENCES > 0 ? REFERENCES : 1)*(2*INDEX_BITS+PLACE_BITS)-1:0] refetch_tdata,
  output wire [(REFERENCES > 0 ? REFERENCES : 1)-1:0]                       refetched_tvalid,
  input  wire [(REFERENCES > 0 ? REFERENCES : 1)-1:0]                       refetched_tready,
  output wire [(REFERENCES > 0 ? REFERENCES : 1)*(2*CANDIDATE_BITS+ROW_BITS)-1:0] refetched_tdata,  // {own, best, row}
  output wire                                                               m_axis_tvalid,
  input  wire                                                               m_axis_tready,
  output wire [8*((INDEX_BITS+7)/8)-1:0]                                    m_axis_tdata,
  output wire [TAG_BITS-1:0]                                                m_axis_tuser,
  output wire                                                               m_axis_tlast,
  output wire                                                               overrun,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]                   rows,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]                   stalled_cycles
);

  localparam STAGES        = CANDIDATES - 1;
  localparam FIELD_BITS    = 8 * ((INDEX_BITS + 7) / 8);
  localparam ROW_LINK_BITS = ROW_WORD_BITS + PLACE_BITS;
  localparam PAIR_BITS     = ROW_WORD_BITS + 2 * INDEX_BITS + PLACE_BITS;
  localparam [PLACE_BITS:0]   ONE_ROW   = 1;
  localparam [PLACE_BITS-1:0] ONE_PLACE = 1;

  // The rows that may be inside the conversion when their queue has no more room, and some to
  // spare.
  localparam MAY_COME   = WORD_LATENCY + 2;
  localparam QUEUE_BITS = bits_for(MAY_COME + 4);

  function integer bits_for;  // bits that name one of `count`
    input integer count;
    begin
      bits_for = 1;
      while ((1 << bits_for) < count) begin
        bits_for = bits_for + 1;
      end
    end
  endfunction

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (CANDIDATES < 2) begin : g_refused_candidates CANDIDATES_is_below_2 refused (); end
    if (CANDIDATE_BITS < 1)
      begin : g_refused_candidate_bits CANDIDATE_BITS_is_below_1 refused (); end
    if (ROW_BITS < 1) begin : g_refused_row_bits ROW_BITS_is_below_1 refused (); end
    if (WORD_BITS < 1) begin : g_refused_word_bits WORD_BITS_is_below_1 refused (); end
    if (ROW_WORD_BITS < 1) begin : g_refused_row_word_bits ROW_WORD_BITS_is_below_1 refused (); end
    if (WORD_LATENCY < 0) begin : g_refused_word_latency WORD_LATENCY_is_below_0 refused (); end
    if (TAG_BITS < 1) begin : g_refused_tag_bits TAG_BITS_is_below_1 refused (); end
    if (INDEX_BITS < 1) begin : g_refused_index_bits INDEX_BITS_is_below_1 refused (); end
    if (INDEX_BITS > 30) begin : g_refused_index_shift INDEX_BITS_is_above_30 refused (); end
    if (((CANDIDATES - 1) >>> INDEX_BITS) > 0)
      begin : g_refused_last_candidate INDEX_BITS_is_too_small_for_CANDIDATES refused (); end
    if (PLACE_BITS < 1) begin : g_refused_place_bits PLACE_BITS_is_below_1 refused (); end
    if (REFERENCES < 0) begin : g_refused_references REFERENCES_is_below_0 refused (); end
    if (COUNTER_BITS < 0) begin : g_refused_counter_bits COUNTER_BITS_is_below_0 refused (); end
  endgenerate

  // Words go from the last stage to the first, rows from the first to the last. For both, link k is
  // in front of stage k + 1.
  wire [STAGES:0]                     word_valid;
  wire [CANDIDATES*INDEX_BITS-1:0]    word_index;
  wire [CANDIDATES*WORD_BITS-1:0]     word_data;
  wire [STAGES:0]                     row_valid;
  wire [STAGES:0]                     row_ready;
  wire [CANDIDATES*ROW_LINK_BITS-1:0] row_data;
  wire [CANDIDATES*INDEX_BITS-1:0]    row_best;

  // Candidates enter the memory as they are and the chain as words.
  wire                  loaded_valid;
  wire [INDEX_BITS-1:0] loaded_index;
  wire                  complete;
  wire                  waiting;
  wire                  idle;
  wire                  open = complete && !waiting;

  candidate_loader #(
    .CANDIDATES    (CANDIDATES),
    .CANDIDATE_BITS(CANDIDATE_BITS),
    .INDEX_BITS    (INDEX_BITS)
  ) loader (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_candidate_tvalid),
    .s_axis_tready(s_candidate_tready),
    .s_axis_tdata (s_candidate_tdata),
    .s_axis_tlast (s_candidate_tlast),
    .m_word_valid (loaded_valid),
    .m_word_index (loaded_index),
    .m_word_data  (candidate),
    .idle         (idle),
    .complete     (complete),
    .waiting      (waiting),
    .overrun      (overrun)
  );

  valid_delay_line #(
    .LENGTH(WORD_LATENCY)
  ) loaded_beside_word (
    .aclk   (aclk),
    .aresetn(aresetn),
    .d      (loaded_valid),
    .q      (word_valid[STAGES])
  );

  delay_line #(
    .WIDTH (INDEX_BITS),
    .LENGTH(WORD_LATENCY)
  ) index_beside_word (
    .aclk(aclk),
    .d   (loaded_index),
    .q   (word_index[STAGES*INDEX_BITS +: INDEX_BITS])
  );

  assign word_data[STAGES*WORD_BITS +: WORD_BITS] = candidate_word;

  // Each row inside has a place of its own. Rows leave in their order, so places are taken and
  // freed in turn.
  wire                  enters = s_axis_tvalid && s_axis_tready;
  wire                  leaves = m_axis_tvalid && m_axis_tready;
  reg  [PLACE_BITS:0]   inside_q;
  reg  [PLACE_BITS-1:0] free_place_q;
  wire                  full   = inside_q[PLACE_BITS];
  wire                  room;

  assign idle          = (inside_q == {(PLACE_BITS+1){1'b0}});
  assign s_axis_tready = open && room && !full;

  always @(posedge aclk) begin
    if (!aresetn) begin
      inside_q     <= {(PLACE_BITS+1){1'b0}};
      free_place_q <= {PLACE_BITS{1'b0}};
    end else begin
      if (enters && !leaves) begin
        inside_q <= inside_q + ONE_ROW;
      end else if (leaves && !enters) begin
        inside_q <= inside_q - ONE_ROW;
      end
      if (enters) begin
        free_place_q <= free_place_q + ONE_PLACE;
      end
    end
  end

  // In every cycle the next free place is written with whatever is offered. The last write is the
  // row that takes the place.
  generate
    if (REFERENCES == 0) begin : g_no_references
      wire unused_inputs = &{s_axis_tdata, refetch_tvalid, refetch_tdata, refetched_tready};

      assign refetch_tready   = 1'b0;
      assign refetched_tvalid = 1'b0;
      assign refetched_tdata  = {(2*CANDIDATE_BITS+ROW_BITS){1'b0}};
    end else begin : g_references
      operand_memory #(
        .REFERENCES    (REFERENCES),
        .CANDIDATE_BITS(CANDIDATE_BITS),
        .ROW_BITS      (ROW_BITS),
        .INDEX_BITS    (INDEX_BITS),
        .PLACE_BITS    (PLACE_BITS)
      ) operands (
        .aclk           (aclk),
        .aresetn        (aresetn),
        .row_write      (!full),
        .row_place      (free_place_q),
        .row            (s_axis_tdata),
        .candidate_write(loaded_valid),
        .candidate_index(loaded_index),
        .candidate      (candidate),
        .s_ask_tvalid   (refetch_tvalid),
        .s_ask_tready   (refetch_tready),
        .s_ask_tdata    (refetch_tdata),
        .m_answer_tvalid(refetched_tvalid),
        .m_answer_tready(refetched_tready),
        .m_answer_tdata (refetched_tdata)
      );
    end
  endgenerate

  // The conversion of rows cannot wait, so a queue follows it.
  wire                     converted;
  reg  [PLACE_BITS-1:0]    next_place_q;  // the place of the row that the chain takes next
  wire [ROW_WORD_BITS-1:0] next_word;

  valid_delay_line #(
    .LENGTH(WORD_LATENCY)
  ) row_beside_word (
    .aclk   (aclk),
    .aresetn(aresetn),
    .d      (enters),
    .q      (converted)
  );

  exception_queue #(
    .WIDTH     (ROW_WORD_BITS),
    .DEPTH_BITS(QUEUE_BITS),
    .MAY_COME  (MAY_COME)
  ) converted_rows (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .on_offer     (1'b0),
    .room         (room),
    .push         (converted),
    .beat         (row_word),
    .m_axis_tvalid(row_valid[0]),
    .m_axis_tready(row_ready[0]),
    .m_axis_tdata (next_word)
  );

  always @(posedge aclk) begin
    if (!aresetn) begin
      next_place_q <= {PLACE_BITS{1'b0}};
    end else if (row_valid[0] && row_ready[0]) begin
      next_place_q <= next_place_q + ONE_PLACE;
    end
  end

  assign row_data[ROW_LINK_BITS-1:0] = {next_word, next_place_q};
  assign row_best[INDEX_BITS-1:0]    = {INDEX_BITS{1'b0}};

  genvar k;
  generate
    for (k = 0; k < STAGES; k = k + 1) begin : g_stage
      wire unused_flags = &result_tdata[k*8+2 +: 6];

      arg_min_stage #(
        .STAGE        (k + 1),
        .WORD_BITS    (WORD_BITS),
        .ROW_WORD_BITS(ROW_WORD_BITS),
        .PLACE_BITS   (PLACE_BITS),
        .INDEX_BITS   (INDEX_BITS),
        .BEST_BITS    (bits_for(k + 1))
      ) stage (
        .aclk          (aclk),
        .aresetn       (aresetn),
        .s_word_valid  (word_valid[k+1]),
        .s_word_index  (word_index[(k+1)*INDEX_BITS +: INDEX_BITS]),
        .s_word_data   (word_data[(k+1)*WORD_BITS +: WORD_BITS]),
        .m_word_valid  (word_valid[k]),
        .m_word_index  (word_index[k*INDEX_BITS +: INDEX_BITS]),
        .m_word_data   (word_data[k*WORD_BITS +: WORD_BITS]),
        .s_row_tvalid  (row_valid[k]),
        .s_row_tready  (row_ready[k]),
        .s_row_tdata   (row_data[k*ROW_LINK_BITS +: ROW_LINK_BITS]),
        .s_row_best    (row_best[k*INDEX_BITS +: INDEX_BITS]),
        .m_row_tvalid  (row_valid[k+1]),
        .m_row_tready  (row_ready[k+1]),
        .m_row_tdata   (row_data[(k+1)*ROW_LINK_BITS +: ROW_LINK_BITS]),
        .m_row_best    (row_best[(k+1)*INDEX_BITS +: INDEX_BITS]),
        .pair_tvalid   (pair_tvalid[k]),
        .pair_tready   (pair_tready[k]),
        .pair_best     (pair_best[k*WORD_BITS +: WORD_BITS]),
        .pair_own      (pair_own[k*WORD_BITS +: WORD_BITS]),
        .pair_tag      (pair_tag[k*PAIR_BITS +: PAIR_BITS]),
        .result_tvalid (result_tvalid[k]),
        .result_tready (result_tready[k]),
        .result_verdict(result_tdata[k*8 +: 2]),
        .result_tag    (result_tag[k*PAIR_BITS +: PAIR_BITS])
      );
    end
  endgenerate

  // The word of candidate 0, and that of a row behind the last stage, are not used.
  wire unused_word = &{word_valid[0], word_index[INDEX_BITS-1:0], word_data[WORD_BITS-1:0]};
  wire unused_row  = &row_data[STAGES*ROW_LINK_BITS +: ROW_LINK_BITS];

  // The output. A row's tag waits here for the row.
  wire                  unused_tag_ready;
  wire                  unused_tag_valid;
  reg  [FIELD_BITS-1:0] tdata;

  stream_fifo #(
    .WIDTH     (1 + TAG_BITS),
    .DEPTH_BITS(PLACE_BITS)
  ) tags (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(enters),
    .s_axis_tready(unused_tag_ready),
    .s_axis_tdata ({s_axis_tlast, s_axis_tuser}),
    .m_axis_tvalid(unused_tag_valid),
    .m_axis_tready(leaves),
    .m_axis_tdata ({m_axis_tlast, m_axis_tuser})
  );

  always @* begin
    tdata = {FIELD_BITS{1'b0}};
    tdata[INDEX_BITS-1:0] = row_best[STAGES*INDEX_BITS +: INDEX_BITS];
  end

  assign m_axis_tvalid     = row_valid[STAGES];
  assign row_ready[STAGES] = m_axis_tready;
  assign m_axis_tdata      = tdata;

  event_counter #(
    .COUNTER_BITS(COUNTER_BITS)
  ) row_counter (
    .aclk   (aclk),
    .aresetn(aresetn),
    .step   (leaves),
    .count  (rows)
  );

  event_counter #(
    .COUNTER_BITS(COUNTER_BITS)
  ) stall_counter (
    .aclk   (aclk),
    .aresetn(aresetn),
    .step   (s_axis_tvalid && open && !s_axis_tready),
    .count  (stalled_cycles)
  );

endmodule

`default_nettype wire
