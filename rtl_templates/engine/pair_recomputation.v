// pair_recomputation: reads the items of undecided pairs from the memory again, passes each pair to
// the next of REFERENCES references that is ready, and gives out the verdicts that are in REPORT.
//
// A request is the pair's tag {j, i} and its items {item j, item i}. All references see the same
// request, and it is valid for one of them. The answer is {tag, verdict} and is always taken.
//
// Interval 1. `memory_items` are the words {item j, item i} that were read in the previous cycle.
// The beat with tlast leaves when all verdicts before it have left. Verdicts may leave in any
// order. Reset forgets all: the references have to be reset with it.
`default_nettype none

module pair_recomputation #(
  parameter REFERENCES = 1,        // number of references, 1 to 32
  parameter ITEM_BITS = 32,        // bits of an item, 1 or more
  parameter INDEX_BITS = 10,       // bits of an item's index, 1 or more
  parameter REPORT = 11,           // 0 to 15: bit v is 1 where verdict v is reported
  parameter EVERY_CYCLE = -1,      // bit r is 1 where reference r takes a request in every cycle
  parameter OUTSTANDING_BITS = 5,  // 1 to 30: 2^OUTSTANDING_BITS pairs may be in progress
  parameter QUEUE_BITS = 4         // 1 to 30: 2^QUEUE_BITS pairs may wait
) (
  input  wire                                   aclk,
  input  wire                                   aresetn,
  input  wire                                   s_pair_tvalid,
  output wire                                   s_pair_tready,
  input  wire [2*INDEX_BITS-1:0]                s_pair_tag,
  input  wire                                   s_pair_tlast,
  output wire                                   memory_enable,
  output wire [2*INDEX_BITS-1:0]                memory_addresses,  // {j, i}
  input  wire [2*ITEM_BITS-1:0]                 memory_items,
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
  output wire                                   answered  // a verdict has come, reported or not
);

  localparam TAG_BITS    = 2 * INDEX_BITS;
  localparam ANSWER_BITS = TAG_BITS + 2;
  localparam [REFERENCES-1:0]     FIRST = 1;
  localparam [OUTSTANDING_BITS:0] NONE  = 0;
  localparam [OUTSTANDING_BITS:0] ONE   = 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (REFERENCES < 1) begin : g_refused_references
      REFERENCES_is_below_1 refused ();
    end else if (REFERENCES > 32) begin : g_refused_many_references
      REFERENCES_is_above_32 refused ();
    end
    if (ITEM_BITS < 1) begin : g_refused_item_bits ITEM_BITS_is_below_1 refused (); end
    if (INDEX_BITS < 1) begin : g_refused_index_bits INDEX_BITS_is_below_1 refused (); end
    if ((REPORT >> 4) != 0) begin : g_refused_report REPORT_is_not_0_to_15 refused (); end
    if (OUTSTANDING_BITS < 1)
      begin : g_refused_outstanding_bits OUTSTANDING_BITS_is_below_1 refused (); end
    if (QUEUE_BITS < 1) begin : g_refused_queue_bits QUEUE_BITS_is_below_1 refused (); end
  endgenerate

  // The queue of pairs that wait.
  wire                pair_valid;
  wire                pair_ready;
  wire                pair_last;
  wire [TAG_BITS-1:0] pair_tag;

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
    .m_axis_tdata ({pair_last, pair_tag})
  );

  // Cycle 0 reads the items, which arrive in cycle 1 and are offered from cycle 2 on. Both cycles
  // stall while the chosen reference does not take the request.
  reg  [OUTSTANDING_BITS:0] outstanding_q;
  reg                       comes_q;
  reg                       offered_q;
  reg                       closes_q;      // only the closing beat is left
  reg  [REFERENCES-1:0]     turn_q;        // one-hot: the reference chosen last
  reg  [TAG_BITS-1:0]       coming_tag_q;
  reg  [TAG_BITS-1:0]       tag_q;
  reg  [2*ITEM_BITS-1:0]    items_q;

  wire taken   = offered_q && ((turn_q & m_request_tready) != {REFERENCES{1'b0}});
  wire advance = !offered_q || taken;
  wire fetches = pair_valid && !pair_last && !outstanding_q[OUTSTANDING_BITS];
  wire starts  = advance && fetches;  // the pair is in progress
  wire ends    = pair_valid && pair_last && (outstanding_q == NONE);
  wire closed;

  // The next reference, after the last one, that is ready and stays so; if none is, the next one.
  wire [REFERENCES-1:0] busy   =
      turn_q & ~EVERY_CYCLE[REFERENCES-1:0] & {REFERENCES{offered_q}};
  wire [REFERENCES-1:0] free   = m_request_tready & ~busy;
  wire [REFERENCES-1:0] behind = free & ~((turn_q << 1) - FIRST);
  wire [REFERENCES-1:0] choice = (behind != {REFERENCES{1'b0}}) ? behind : free;
  wire [REFERENCES-1:0] after  = (turn_q << 1) | (turn_q >> (REFERENCES - 1));
  wire [REFERENCES-1:0] next   =
      (choice != {REFERENCES{1'b0}}) ? (choice & (~choice + FIRST)) : after;

  assign memory_enable    = starts;
  assign memory_addresses = pair_tag;
  assign pair_ready       = starts || closed;

  always @(posedge aclk) begin
    if (!aresetn) begin
      comes_q   <= 1'b0;
      offered_q <= 1'b0;
      closes_q  <= 1'b0;
      turn_q    <= FIRST;
    end else begin
      closes_q <= ends && !closed;
      if (advance) begin
        comes_q   <= fetches;
        offered_q <= comes_q;
      end
      if (advance && comes_q) begin
        turn_q <= next;
      end
    end
  end

  always @(posedge aclk) begin
    if (starts) begin
      coming_tag_q <= pair_tag;
    end
    if (advance && comes_q) begin
      items_q <= memory_items;
      tag_q   <= coming_tag_q;
    end
  end

  assign m_request_tvalid = turn_q & {REFERENCES{offered_q}};
  assign m_request_tag    = tag_q;
  assign m_request_items  = items_q;

  // The verdicts. Each reference has a queue for its verdicts, with room for all pairs in progress.
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
  assign closed        = closes_q && m_axis_tready;
  assign m_axis_tvalid = (verdict_valid && keep) || closes_q;
  assign m_axis_tdata  = closes_q ? {ANSWER_BITS{1'b0}} : verdict;
  assign m_axis_tlast  = closes_q;

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
