// arg_min_engine: for each row of a stream the candidate that costs it least, by a chain of lanes.
// Candidates are loaded once, a beat each, tlast with the last: CANDIDATES of them, from number 0.
// Fewer are as good as the last one repeated; those beyond are accepted and left out, and `overrun`
// says so until the next load. Then rows come in, each with a tag and tlast, and leave in their
// order as {index of the candidate, tag, tlast}. Lane k - 1 compares candidate k with the best of
// candidates 0 to k - 1: it must return one result {6'b0, verdict} for each pair, in order, and
// decide all.
// A load that follows is taken when no row is inside; while it is offered no row comes in.
// Interval 1; latency CANDIDATES - 1 times that of a lane plus one. Rows come in 2 cycles
// after the last candidate at the earliest. Counters wrap: rows that have left, cycles in which
// a row was offered to complete candidates, none on offer, and not taken. Reset forgets all.
`default_nettype none

module arg_min_engine #(
  parameter CANDIDATES = 3,       // 2 .. 2^INDEX_BITS
  parameter CANDIDATE_BITS = 32,
  parameter ROW_BITS = 32,
  parameter TAG_BITS = 8,
  parameter INDEX_BITS = 2,
  parameter SLOT_BITS = 5,        // 2^SLOT_BITS + 1 rows may be inside one lane
  parameter COUNTER_BITS = 32
) (
  input  wire                                             aclk,
  input  wire                                             aresetn,
  input  wire                                             s_candidate_tvalid,
  output wire                                             s_candidate_tready,
  input  wire [CANDIDATE_BITS-1:0]                        s_candidate_tdata,
  input  wire                                             s_candidate_tlast,
  input  wire                                             s_axis_tvalid,
  output wire                                             s_axis_tready,
  input  wire [ROW_BITS-1:0]                              s_axis_tdata,
  input  wire [TAG_BITS-1:0]                              s_axis_tuser,
  input  wire                                             s_axis_tlast,
  output wire [CANDIDATES-2:0]                            pair_tvalid,
  input  wire [CANDIDATES-2:0]                            pair_tready,
  output wire [(CANDIDATES-1)*ROW_BITS-1:0]               pair_row,
  output wire [(CANDIDATES-1)*CANDIDATE_BITS-1:0]         pair_best,
  output wire [(CANDIDATES-1)*CANDIDATE_BITS-1:0]         pair_own,
  input  wire [CANDIDATES-2:0]                            result_tvalid,
  output wire [CANDIDATES-2:0]                            result_tready,
  input  wire [(CANDIDATES-1)*8-1:0]                      result_tdata,
  output wire                                             m_axis_tvalid,
  input  wire                                             m_axis_tready,
  output wire [8*((INDEX_BITS+7)/8)-1:0]                  m_axis_tdata,
  output wire [TAG_BITS-1:0]                              m_axis_tuser,
  output wire                                             m_axis_tlast,
  output wire                                             overrun,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0] rows,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0] stalled_cycles
);

  localparam STAGES       = CANDIDATES - 1;
  localparam FIELD_BITS   = 8 * ((INDEX_BITS + 7) / 8);
  localparam PAYLOAD_BITS = 1 + TAG_BITS + ROW_BITS;
  localparam INSIDE_BITS  = SLOT_BITS + INDEX_BITS + 1;  // 2^SLOT_BITS + 2 rows in each stage
  localparam [INSIDE_BITS-1:0] ONE = 1;

  function integer bits_for;  // to name one of `count`
    input integer count;
    begin
      bits_for = 1;
      while ((1 << bits_for) < count) begin
        bits_for = bits_for + 1;
      end
    end
  endfunction

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (CANDIDATES < 2) begin : g_refused_candidates
      CANDIDATES_is_below_2 refused ();
    end
    if (CANDIDATE_BITS < 1) begin : g_refused_candidate_bits
      CANDIDATE_BITS_is_below_1 refused ();
    end
    if (ROW_BITS < 1) begin : g_refused_row_bits
      ROW_BITS_is_below_1 refused ();
    end
    if (TAG_BITS < 1) begin : g_refused_tag_bits
      TAG_BITS_is_below_1 refused ();
    end
    if (INDEX_BITS < 1) begin : g_refused_index_bits
      INDEX_BITS_is_below_1 refused ();
    end
    if (INDEX_BITS > 30) begin : g_refused_index_shift
      INDEX_BITS_is_above_30 refused ();
    end
    if (((CANDIDATES - 1) >>> INDEX_BITS) > 0) begin : g_refused_last_candidate
      INDEX_BITS_is_too_small_for_CANDIDATES refused ();
    end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits
      SLOT_BITS_is_below_1 refused ();
    end
    if (COUNTER_BITS < 0) begin : g_refused_counter_bits
      COUNTER_BITS_is_below_0 refused ();
    end
  endgenerate

  // Words go from the last stage to the first, rows from the first to the last: link k of either
  // is before stage k + 1.
  wire [STAGES:0]                      word_valid;
  wire [CANDIDATES*INDEX_BITS-1:0]     word_index;
  wire [CANDIDATES*CANDIDATE_BITS-1:0] word_data;
  wire [STAGES:0]                      row_valid;
  wire [STAGES:0]                      row_ready;
  wire [CANDIDATES*PAYLOAD_BITS-1:0]   row_data;
  wire [CANDIDATES*INDEX_BITS-1:0]     row_best;

  wire                                 complete;
  wire                                 waiting;
  wire                                 idle;
  wire                                 open = complete && !waiting;

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
    .m_word_valid (word_valid[STAGES]),
    .m_word_index (word_index[STAGES*INDEX_BITS +: INDEX_BITS]),
    .m_word_data  (word_data[STAGES*CANDIDATE_BITS +: CANDIDATE_BITS]),
    .idle         (idle),
    .complete     (complete),
    .waiting      (waiting),
    .overrun      (overrun)
  );

  assign row_valid[0]               = s_axis_tvalid && open;
  assign row_data[PAYLOAD_BITS-1:0] = {s_axis_tlast, s_axis_tuser, s_axis_tdata};
  assign row_best[INDEX_BITS-1:0]   = {INDEX_BITS{1'b0}};
  assign s_axis_tready              = row_ready[0] && open;

  genvar k;
  generate
    for (k = 0; k < STAGES; k = k + 1) begin : g_stage
      wire unused_flags = &result_tdata[k*8+2 +: 6];

      arg_min_stage #(
        .STAGE         (k + 1),
        .CANDIDATE_BITS(CANDIDATE_BITS),
        .ROW_BITS      (ROW_BITS),
        .PAYLOAD_BITS  (PAYLOAD_BITS),
        .INDEX_BITS    (INDEX_BITS),
        .BEST_BITS     (bits_for(k + 1)),
        .SLOT_BITS     (SLOT_BITS)
      ) stage (
        .aclk          (aclk),
        .aresetn       (aresetn),
        .s_word_valid  (word_valid[k+1]),
        .s_word_index  (word_index[(k+1)*INDEX_BITS +: INDEX_BITS]),
        .s_word_data   (word_data[(k+1)*CANDIDATE_BITS +: CANDIDATE_BITS]),
        .m_word_valid  (word_valid[k]),
        .m_word_index  (word_index[k*INDEX_BITS +: INDEX_BITS]),
        .m_word_data   (word_data[k*CANDIDATE_BITS +: CANDIDATE_BITS]),
        .s_row_tvalid  (row_valid[k]),
        .s_row_tready  (row_ready[k]),
        .s_row_tdata   (row_data[k*PAYLOAD_BITS +: PAYLOAD_BITS]),
        .s_row_best    (row_best[k*INDEX_BITS +: INDEX_BITS]),
        .m_row_tvalid  (row_valid[k+1]),
        .m_row_tready  (row_ready[k+1]),
        .m_row_tdata   (row_data[(k+1)*PAYLOAD_BITS +: PAYLOAD_BITS]),
        .m_row_best    (row_best[(k+1)*INDEX_BITS +: INDEX_BITS]),
        .pair_tvalid   (pair_tvalid[k]),
        .pair_tready   (pair_tready[k]),
        .pair_row      (pair_row[k*ROW_BITS +: ROW_BITS]),
        .pair_best     (pair_best[k*CANDIDATE_BITS +: CANDIDATE_BITS]),
        .pair_own      (pair_own[k*CANDIDATE_BITS +: CANDIDATE_BITS]),
        .result_tvalid (result_tvalid[k]),
        .result_tready (result_tready[k]),
        .result_verdict(result_tdata[k*8 +: 2])
      );
    end
  endgenerate

  // Candidate 0 stays in the memories.
  wire unused_word = &{word_valid[0], word_index[INDEX_BITS-1:0], word_data[CANDIDATE_BITS-1:0]};

  // Out.
  wire                  unused_row = &row_data[STAGES*PAYLOAD_BITS +: ROW_BITS];
  reg  [FIELD_BITS-1:0] tdata;

  always @* begin
    tdata = {FIELD_BITS{1'b0}};
    tdata[INDEX_BITS-1:0] = row_best[STAGES*INDEX_BITS +: INDEX_BITS];
  end

  assign m_axis_tvalid     = row_valid[STAGES];
  assign row_ready[STAGES] = m_axis_tready;
  assign m_axis_tdata      = tdata;
  assign m_axis_tuser      = row_data[STAGES*PAYLOAD_BITS+ROW_BITS +: TAG_BITS];
  assign m_axis_tlast      = row_data[CANDIDATES*PAYLOAD_BITS-1];

  // Rows inside.
  wire                   enters = s_axis_tvalid && s_axis_tready;
  wire                   leaves = m_axis_tvalid && m_axis_tready;
  reg  [INSIDE_BITS-1:0] inside_q;

  assign idle = (inside_q == {INSIDE_BITS{1'b0}});

  always @(posedge aclk) begin
    if (!aresetn) begin
      inside_q <= {INSIDE_BITS{1'b0}};
    end else if (enters && !leaves) begin
      inside_q <= inside_q + ONE;
    end else if (leaves && !enters) begin
      inside_q <= inside_q - ONE;
    end
  end

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
    .step   (row_valid[0] && !row_ready[0]),
    .count  (stalled_cycles)
  );

endmodule

`default_nettype wire
