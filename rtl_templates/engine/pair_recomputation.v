// pair_recomputation: reads the items of undecided pairs from the memory again, hands them to
// REFERENCES references in turn, and gives out the verdicts that are in REPORT (bit v: verdict v).
// A request is the pair's tag {j, i} and its items {item j, item i}, the same for all references,
// one of which it is valid for; the answer is {tag, verdict} and is always taken. 2^OUTSTANDING_BITS
// pairs may be on their way. One pair in two cycles. `memory_read_data` is the word read in the
// cycle before. The beat with tlast leaves when all verdicts before it have.
// Verdicts may leave in any order. Reset forgets all: the references have to be reset, too.
`default_nettype none

module pair_recomputation #(
  parameter REFERENCES = 1,
  parameter ITEM_BITS = 32,
  parameter INDEX_BITS = 10,
  parameter REPORT = 11,
  parameter OUTSTANDING_BITS = 5,
  parameter QUEUE_BITS = 4        // 2^QUEUE_BITS pairs may wait
) (
  input  wire                                   aclk,
  input  wire                                   aresetn,
  input  wire                                   s_pair_tvalid,
  output wire                                   s_pair_tready,
  input  wire [2*INDEX_BITS-1:0]                s_pair_tag,
  input  wire                                   s_pair_tlast,
  output wire                                   memory_enable,
  output wire [INDEX_BITS-1:0]                  memory_address,
  input  wire [ITEM_BITS-1:0]                   memory_read_data,
  output wire [REFERENCES-1:0]                  m_request_tvalid,
  input  wire [REFERENCES-1:0]                  m_request_tready,
  output wire [2*INDEX_BITS-1:0]                m_request_tag,
  output wire [2*ITEM_BITS-1:0]                 m_request_items,
  input  wire [REFERENCES-1:0]                  s_answer_valid,
  input  wire [REFERENCES*(2*INDEX_BITS+2)-1:0] s_answer_tdata,
  output wire                                   m_axis_tvalid,
  input  wire                                   m_axis_tready,
  output wire [2*INDEX_BITS+1:0]                m_axis_tdata,
  output wire                                   m_axis_tlast,
  output wire                                   answered  // a verdict is there, reported or not
);

  localparam TAG_BITS    = 2 * INDEX_BITS;
  localparam ANSWER_BITS = TAG_BITS + 2;
  localparam [REFERENCES-1:0]     FIRST = 1;
  localparam [OUTSTANDING_BITS:0] NONE  = 0;
  localparam [OUTSTANDING_BITS:0] ONE   = 1;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (REFERENCES < 1) begin : g_refused_references
      REFERENCES_is_below_1 refused ();
    end
    if (ITEM_BITS < 1) begin : g_refused_item_bits
      ITEM_BITS_is_below_1 refused ();
    end
    if (INDEX_BITS < 1) begin : g_refused_index_bits
      INDEX_BITS_is_below_1 refused ();
    end
    if ((REPORT >> 4) != 0) begin : g_refused_report
      REPORT_is_not_0_to_15 refused ();
    end
    if (OUTSTANDING_BITS < 1) begin : g_refused_outstanding_bits
      OUTSTANDING_BITS_is_below_1 refused ();
    end
    if (QUEUE_BITS < 1) begin : g_refused_queue_bits
      QUEUE_BITS_is_below_1 refused ();
    end
  endgenerate

  // Pairs that wait.
  wire                  pair_valid;
  wire                  pair_ready;
  wire                  pair_last;
  wire [INDEX_BITS-1:0] index_i;
  wire [INDEX_BITS-1:0] index_j;

  stream_fifo #(
    .WIDTH     (1 + TAG_BITS),
    .DEPTH_BITS(QUEUE_BITS)
  ) pairs (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_pair_tvalid),
    .s_axis_tready(s_pair_tready),
    .s_axis_tdata ({s_pair_tlast, s_pair_tag}),
    .m_axis_tvalid(pair_valid),
    .m_axis_tready(pair_ready),
    .m_axis_tdata ({pair_last, index_j, index_i})
  );

  // Cycle 0 reads item i, cycle 1 item j; item i has come by then, item j comes in cycle 2. All of
  // it waits for as long as the reference whose turn it is does not take what it is offered.
  reg  [OUTSTANDING_BITS:0] outstanding_q;
  reg                       second_q;      // item i was read: now item j
  reg                       i_comes_q;
  reg                       j_comes_q;
  reg                       offered_q;
  reg  [REFERENCES-1:0]     turn_q;        // one bit
  reg  [TAG_BITS-1:0]       coming_tag_q;
  reg  [TAG_BITS-1:0]       tag_q;
  reg  [ITEM_BITS-1:0]      item_i_q;
  reg  [ITEM_BITS-1:0]      item_j_q;

  wire taken   = offered_q && ((turn_q & m_request_tready) != {REFERENCES{1'b0}});
  wire advance = !offered_q || taken;
  wire fetches = pair_valid && !pair_last && !outstanding_q[OUTSTANDING_BITS];
  wire starts  = advance && fetches && second_q;  // the pair is on its way
  wire closes  = pair_valid && pair_last && (outstanding_q == NONE);
  wire closed;

  assign memory_enable  = advance && fetches;
  assign memory_address = second_q ? index_j : index_i;
  assign pair_ready     = starts || closed;

  always @(posedge aclk) begin
    if (!aresetn) begin
      second_q  <= 1'b0;
      i_comes_q <= 1'b0;
      j_comes_q <= 1'b0;
      offered_q <= 1'b0;
      turn_q    <= FIRST;
    end else begin
      if (advance) begin
        second_q  <= fetches && !second_q;
        i_comes_q <= fetches && !second_q;
        j_comes_q <= fetches && second_q;
        offered_q <= j_comes_q;
      end
      if (taken) begin
        turn_q <= (turn_q << 1) | (turn_q >> (REFERENCES - 1));
      end
    end
  end

  always @(posedge aclk) begin
    if (starts) begin
      coming_tag_q <= {index_j, index_i};
    end
    if (advance && i_comes_q) begin
      item_i_q <= memory_read_data;
    end
    if (advance && j_comes_q) begin
      item_j_q <= memory_read_data;
      tag_q    <= coming_tag_q;
    end
  end

  assign m_request_tvalid = turn_q & {REFERENCES{offered_q}};
  assign m_request_tag    = tag_q;
  assign m_request_items  = {item_j_q, item_i_q};

  // Verdicts. The queue of each reference has room for all pairs that are on their way.
  wire [REFERENCES-1:0]             answer_valid;
  wire [REFERENCES-1:0]             answer_ready;
  wire [REFERENCES-1:0]             unused_room;
  wire [REFERENCES*ANSWER_BITS-1:0] answers;
  wire                              verdict_valid;
  wire                              verdict_ready;
  wire [ANSWER_BITS-1:0]            verdict;
  wire [3:0]                        reports = REPORT[3:0];
  wire                              keep    = reports[verdict[1:0]];

  genvar r;
  generate
    for (r = 0; r < REFERENCES; r = r + 1) begin : g_answers
      stream_fifo #(
        .WIDTH     (ANSWER_BITS),
        .DEPTH_BITS(OUTSTANDING_BITS)
      ) queue (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(s_answer_valid[r]),
        .s_axis_tready(unused_room[r]),
        .s_axis_tdata (s_answer_tdata[r*ANSWER_BITS +: ANSWER_BITS]),
        .m_axis_tvalid(answer_valid[r]),
        .m_axis_tready(answer_ready[r]),
        .m_axis_tdata (answers[r*ANSWER_BITS +: ANSWER_BITS])
      );
    end
  endgenerate

  stream_tree #(
    .INPUTS(REFERENCES),
    .WIDTH (ANSWER_BITS)
  ) merge (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(answer_valid),
    .s_axis_tready(answer_ready),
    .s_axis_tdata (answers),
    .m_axis_tvalid(verdict_valid),
    .m_axis_tready(verdict_ready),
    .m_axis_tdata (verdict)
  );

  assign verdict_ready = !keep || m_axis_tready;
  assign answered      = verdict_valid && verdict_ready;
  assign closed        = closes && m_axis_tready;
  assign m_axis_tvalid = (verdict_valid && keep) || closes;
  assign m_axis_tdata  = closes ? {ANSWER_BITS{1'b0}} : verdict;
  assign m_axis_tlast  = closes;

  always @(posedge aclk) begin
    if (!aresetn) begin
      outstanding_q <= NONE;
    end else if (starts && !answered) begin
      outstanding_q <= outstanding_q + ONE;
    end else if (answered && !starts) begin
      outstanding_q <= outstanding_q - ONE;
    end
  end

endmodule

`default_nettype wire
