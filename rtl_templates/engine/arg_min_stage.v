// arg_min_stage: link STAGE of the chain that finds the candidate of least cost. One lane, which
// returns its verdicts in order, compares candidate STAGE with the best candidate before it.
//
// A row carries only the best candidate's index. That candidate's word is read from a memory, which
// holds the words of all candidates before STAGE. The lane carries the row: it returns the tag
// {word of the row, STAGE, index of the best, place of the row} with the verdict. On `greater`
// candidate STAGE becomes the best; any other verdict keeps the best.
//
// Candidates enter at the last stage, in the order of their indices, and move towards stage 1. Each
// stage passes them on until candidate STAGE arrives, which it keeps. So all stages are complete in
// the same cycle, one cycle after the last word entered the last stage. Interval 1; the latency is
// the lane's plus 1. Reset empties the stage but keeps the candidates.
`default_nettype none

module arg_min_stage #(
  parameter STAGE = 2,           // index of the stage's own candidate, 1 to 2^INDEX_BITS - 1
  parameter WORD_BITS = 32,      // bits of a candidate's word, 1 or more
  parameter ROW_WORD_BITS = 32,  // bits of a row's word, 1 or more
  parameter PLACE_BITS = 6,      // bits of a row's place, 1 or more
  parameter INDEX_BITS = 2,      // bits of a candidate's index, 1 to 30
  parameter BEST_BITS = 1        // 1 to INDEX_BITS: bits that hold an index below STAGE
) (
  input  wire                                             aclk,
  input  wire                                             aresetn,
  input  wire                                             s_word_valid,
  input  wire [INDEX_BITS-1:0]                            s_word_index,
  input  wire [WORD_BITS-1:0]                             s_word_data,
  output wire                                             m_word_valid,
  output wire [INDEX_BITS-1:0]                            m_word_index,
  output wire [WORD_BITS-1:0]                             m_word_data,
  input  wire                                             s_row_tvalid,
  output wire                                             s_row_tready,
  input  wire [ROW_WORD_BITS+PLACE_BITS-1:0]              s_row_tdata,  // {word, place}
  input  wire [INDEX_BITS-1:0]                            s_row_best,
  output wire                                             m_row_tvalid,
  input  wire                                             m_row_tready,
  output wire [ROW_WORD_BITS+PLACE_BITS-1:0]              m_row_tdata,
  output wire [INDEX_BITS-1:0]                            m_row_best,
  output wire                                             pair_tvalid,
  input  wire                                             pair_tready,
  output wire [WORD_BITS-1:0]                             pair_best,
  output wire [WORD_BITS-1:0]                             pair_own,
  output wire [ROW_WORD_BITS+2*INDEX_BITS+PLACE_BITS-1:0] pair_tag,
  input  wire                                             result_tvalid,
  output wire                                             result_tready,
  input  wire [1:0]                                       result_verdict,
  input  wire [ROW_WORD_BITS+2*INDEX_BITS+PLACE_BITS-1:0] result_tag
);

  localparam ROW_BITS = ROW_WORD_BITS + PLACE_BITS;
  localparam ASK_BITS = 2 * INDEX_BITS + PLACE_BITS;  // bits that name a pair
  localparam [INDEX_BITS-1:0] OWN     = STAGE[INDEX_BITS-1:0];
  localparam [1:0]            GREATER = 2'b10;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (STAGE < 1) begin : g_refused_stage STAGE_is_below_1 refused (); end
    if (WORD_BITS < 1) begin : g_refused_word_bits WORD_BITS_is_below_1 refused (); end
    if (ROW_WORD_BITS < 1) begin : g_refused_row_word_bits ROW_WORD_BITS_is_below_1 refused (); end
    if (PLACE_BITS < 1) begin : g_refused_place_bits PLACE_BITS_is_below_1 refused (); end
    if (INDEX_BITS > 30) begin : g_refused_index_shift INDEX_BITS_is_above_30 refused (); end
    if ((STAGE >>> INDEX_BITS) > 0)
      begin : g_refused_own_index INDEX_BITS_is_too_small_for_STAGE refused (); end
    if (BEST_BITS < 1) begin : g_refused_best_bits BEST_BITS_is_below_1 refused (); end
    if (((STAGE - 1) >>> BEST_BITS) > 0)
      begin : g_refused_best_index BEST_BITS_is_too_small_for_STAGE refused (); end
    if (BEST_BITS > INDEX_BITS)
      begin : g_refused_longer_best BEST_BITS_is_above_INDEX_BITS refused (); end
  endgenerate

  // The candidates: those on their way, and the one that stays here.
  reg                   moving_q;  // a word came in the previous cycle
  reg  [INDEX_BITS-1:0] index_q;
  reg  [WORD_BITS-1:0]  word_q;
  wire                  passes = moving_q && (index_q != OWN);

  always @(posedge aclk) begin
    if (!aresetn) begin
      moving_q <= 1'b0;
    end else begin
      moving_q <= s_word_valid;
    end
  end

  always @(posedge aclk) begin
    if (s_word_valid) begin
      index_q <= s_word_index;
      word_q  <= s_word_data;
    end
  end

  assign m_word_valid = passes;
  assign m_word_index = index_q;
  assign m_word_data  = word_q;

  // The current row, and the word of its best candidate.
  reg                  row_valid_q;
  reg  [ROW_BITS-1:0]  row_q;
  reg  [BEST_BITS-1:0] best_q;
  wire                 load = s_row_tvalid && s_row_tready;

  assign s_row_tready = !row_valid_q || pair_tready;

  always @(posedge aclk) begin
    if (!aresetn) begin
      row_valid_q <= 1'b0;
    end else begin
      row_valid_q <= load || (row_valid_q && !pair_tready);
    end
  end

  always @(posedge aclk) begin
    if (load) begin
      row_q  <= s_row_tdata;
      best_q <= s_row_best[BEST_BITS-1:0];
    end
  end

  generate
    if (STAGE == 1) begin : g_first
      reg [WORD_BITS-1:0] word_0_q;

      always @(posedge aclk) begin
        if (passes) begin
          word_0_q <= word_q;
        end
      end

      assign pair_best = word_0_q;
    end else begin : g_inner
      dual_port_memory #(
        .WIDTH       (WORD_BITS),
        .ADDRESS_BITS(BEST_BITS)
      ) words_before (
        .aclk         (aclk),
        .write_enable (passes),
        .write_address(index_q[BEST_BITS-1:0]),
        .write_data   (word_q),
        .read_enable  (load),
        .read_address (s_row_best[BEST_BITS-1:0]),
        .read_data    (pair_best)
      );
    end
  endgenerate

  wire [INDEX_BITS-1:0] best;

  generate
    if (INDEX_BITS > BEST_BITS) begin : g_short_index
      wire unused_index = &s_row_best[INDEX_BITS-1:BEST_BITS];

      assign best = {{(INDEX_BITS-BEST_BITS){1'b0}}, best_q};
    end else begin : g_whole_index
      assign best = best_q;
    end
  endgenerate

  assign pair_tvalid = row_valid_q;
  assign pair_own    = word_q;
  assign pair_tag    = {row_q[PLACE_BITS +: ROW_WORD_BITS], OWN, best, row_q[PLACE_BITS-1:0]};

  // The result goes on to the next stage.
  wire unused_own    = &result_tag[PLACE_BITS+INDEX_BITS +: INDEX_BITS];
  wire own_is_better = (result_verdict == GREATER);

  assign m_row_tvalid  = result_tvalid;
  assign m_row_tdata   = {result_tag[ASK_BITS +: ROW_WORD_BITS], result_tag[PLACE_BITS-1:0]};
  assign m_row_best    = own_is_better ? OWN : result_tag[PLACE_BITS +: INDEX_BITS];
  assign result_tready = m_row_tready;

endmodule

`default_nettype wire
