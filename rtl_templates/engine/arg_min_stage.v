// arg_min_stage: link STAGE of the chain that finds the candidate of least cost: candidate STAGE
// against the best of those before, in one lane that returns its verdicts in order.
// Only the best one's index travels with a row: its operands are read from a memory, as are those
// of every candidate before STAGE. On `greater` candidate STAGE becomes the best; any other verdict
// keeps it. Candidates enter at the last stage, in the order of their indices, and move towards
// stage 1; each stage hands them on until candidate STAGE arrives, which it keeps. So all stages
// are complete in the same cycle, 1 after the last word left candidate_loader. Interval 1; latency
// 1 and the lane's. Reset empties it, but for the candidates.
`default_nettype none

module arg_min_stage #(
  parameter STAGE = 2,            // 1 and up
  parameter CANDIDATE_BITS = 32,
  parameter ROW_BITS = 32,
  parameter PAYLOAD_BITS = 41,    // {what stays with the row, row}
  parameter INDEX_BITS = 2,
  parameter BEST_BITS = 1,        // to name a candidate before STAGE
  parameter SLOT_BITS = 5         // 2^SLOT_BITS + 1 rows may be inside the lane
) (
  input  wire                      aclk,
  input  wire                      aresetn,
  input  wire                      s_word_valid,
  input  wire [INDEX_BITS-1:0]     s_word_index,
  input  wire [CANDIDATE_BITS-1:0] s_word_data,
  output wire                      m_word_valid,
  output wire [INDEX_BITS-1:0]     m_word_index,
  output wire [CANDIDATE_BITS-1:0] m_word_data,
  input  wire                      s_row_tvalid,
  output wire                      s_row_tready,
  input  wire [PAYLOAD_BITS-1:0]   s_row_tdata,
  input  wire [INDEX_BITS-1:0]     s_row_best,
  output wire                      m_row_tvalid,
  input  wire                      m_row_tready,
  output wire [PAYLOAD_BITS-1:0]   m_row_tdata,
  output wire [INDEX_BITS-1:0]     m_row_best,
  output wire                      pair_tvalid,
  input  wire                      pair_tready,
  output wire [ROW_BITS-1:0]       pair_row,
  output wire [CANDIDATE_BITS-1:0] pair_best,
  output wire [CANDIDATE_BITS-1:0] pair_own,
  input  wire                      result_tvalid,
  output wire                      result_tready,
  input  wire [1:0]                result_verdict
);

  localparam [INDEX_BITS-1:0] OWN     = STAGE[INDEX_BITS-1:0];
  localparam [1:0]            GREATER = 2'b10;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (STAGE < 1) begin : g_refused_stage
      STAGE_is_below_1 refused ();
    end
    if (CANDIDATE_BITS < 1) begin : g_refused_candidate_bits
      CANDIDATE_BITS_is_below_1 refused ();
    end
    if (ROW_BITS < 1) begin : g_refused_row_bits
      ROW_BITS_is_below_1 refused ();
    end
    if (PAYLOAD_BITS < ROW_BITS) begin : g_refused_payload_bits
      PAYLOAD_BITS_is_below_ROW_BITS refused ();
    end
    if (INDEX_BITS > 30) begin : g_refused_index_shift
      INDEX_BITS_is_above_30 refused ();
    end
    if ((STAGE >>> INDEX_BITS) > 0) begin : g_refused_own_index
      INDEX_BITS_is_too_small_for_STAGE refused ();
    end
    if (BEST_BITS < 1) begin : g_refused_best_bits
      BEST_BITS_is_below_1 refused ();
    end
    if (((STAGE - 1) >>> BEST_BITS) > 0) begin : g_refused_best_index
      BEST_BITS_is_too_small_for_STAGE refused ();
    end
    if (BEST_BITS > INDEX_BITS) begin : g_refused_longer_best
      BEST_BITS_is_above_INDEX_BITS refused ();
    end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits
      SLOT_BITS_is_below_1 refused ();
    end
  endgenerate

  // Candidates.
  reg                       moving_q;  // a word came in the cycle before
  reg  [INDEX_BITS-1:0]     index_q;
  reg  [CANDIDATE_BITS-1:0] candidate_q;
  wire                      passes = moving_q && (index_q != OWN);

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
      candidate_q <= s_word_data;
    end
  end

  assign m_word_valid = passes;
  assign m_word_index = index_q;
  assign m_word_data  = candidate_q;

  // The row at hand, and the operands of its best candidate.
  reg                     row_valid_q;
  reg  [PAYLOAD_BITS-1:0] row_q;
  reg  [BEST_BITS-1:0]    best_q;
  wire                    queue_ready;
  wire                    leave = queue_ready && pair_tready;
  wire                    load  = s_row_tvalid && s_row_tready;

  assign s_row_tready = !row_valid_q || leave;

  always @(posedge aclk) begin
    if (!aresetn) begin
      row_valid_q <= 1'b0;
    end else begin
      row_valid_q <= load || (row_valid_q && !leave);
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
      reg [CANDIDATE_BITS-1:0] candidate_0_q;

      always @(posedge aclk) begin
        if (passes) begin
          candidate_0_q <= candidate_q;
        end
      end

      assign pair_best = candidate_0_q;
    end else begin : g_inner
      dual_port_memory #(
        .WIDTH       (CANDIDATE_BITS),
        .ADDRESS_BITS(BEST_BITS)
      ) candidates (
        .aclk         (aclk),
        .write_enable (passes),
        .write_address(index_q[BEST_BITS-1:0]),
        .write_data   (candidate_q),
        .read_enable  (load),
        .read_address (s_row_best[BEST_BITS-1:0]),
        .read_data    (pair_best)
      );
    end

    if (INDEX_BITS > BEST_BITS) begin : g_short_index
      wire unused_index = &s_row_best[INDEX_BITS-1:BEST_BITS];
    end
  endgenerate

  assign pair_tvalid = row_valid_q && queue_ready;
  assign pair_row    = row_q[ROW_BITS-1:0];
  assign pair_own    = candidate_q;

  // Rows whose verdict is awaited.
  wire                  queue_valid;
  wire [BEST_BITS-1:0]  queue_best;
  wire [INDEX_BITS-1:0] kept;
  wire                  is_greater = (result_verdict == GREATER);

  stream_fifo #(
    .WIDTH     (BEST_BITS + PAYLOAD_BITS),
    .DEPTH_BITS(SLOT_BITS)
  ) queue (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(row_valid_q && pair_tready),
    .s_axis_tready(queue_ready),
    .s_axis_tdata ({best_q, row_q}),
    .m_axis_tvalid(queue_valid),
    .m_axis_tready(result_tvalid && m_row_tready),
    .m_axis_tdata ({queue_best, m_row_tdata})
  );

  generate
    if (INDEX_BITS > BEST_BITS) begin : g_longer_index
      assign kept = {{(INDEX_BITS-BEST_BITS){1'b0}}, queue_best};
    end else begin : g_same_index
      assign kept = queue_best;
    end
  endgenerate

  assign m_row_tvalid  = queue_valid && result_tvalid;
  assign m_row_best    = is_greater ? OWN : kept;
  assign result_tready = queue_valid && m_row_tready;

endmodule

`default_nettype wire
