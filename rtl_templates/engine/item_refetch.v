// item_refetch: reads both items of a pair from the memory again, for REFERENCES references.
// A request is the pair's tag {j, i}; the answer {item j, item i} goes to the reference that asked,
// in the order of its requests. References take turns. One pair in two cycles; latency 4 from a
// request that waits for nothing. `memory_read_data` is the word read in the cycle before.
// Reset forgets all.
`default_nettype none

module item_refetch #(
  parameter REFERENCES = 1,
  parameter ITEM_BITS = 32,
  parameter INDEX_BITS = 10
) (
  input  wire                               aclk,
  input  wire                               aresetn,
  input  wire [REFERENCES-1:0]              s_refetch_tvalid,
  output wire [REFERENCES-1:0]              s_refetch_tready,
  input  wire [REFERENCES*2*INDEX_BITS-1:0] s_refetch_tdata,
  output wire                               memory_enable,
  output wire [INDEX_BITS-1:0]              memory_address,
  input  wire [ITEM_BITS-1:0]               memory_read_data,
  output wire [REFERENCES-1:0]              m_answer_tvalid,
  input  wire [REFERENCES-1:0]              m_answer_tready,
  output wire [2*ITEM_BITS-1:0]             m_answer_tdata
);

  localparam TAG_BITS     = 2 * INDEX_BITS;
  localparam REQUEST_BITS = REFERENCES + TAG_BITS;
  localparam [REFERENCES-1:0] ONE = 1;

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
  endgenerate

  // One request at a time, with a bit for the reference that asks.
  wire [REFERENCES*REQUEST_BITS-1:0] requests;
  wire                               request_valid;
  wire                               request_ready;
  wire [REFERENCES-1:0]              asking;
  wire [INDEX_BITS-1:0]              index_i;
  wire [INDEX_BITS-1:0]              index_j;

  genvar r;
  generate
    for (r = 0; r < REFERENCES; r = r + 1) begin : g_reference
      wire [REFERENCES-1:0] name = ONE << r;

      assign requests[r*REQUEST_BITS +: REQUEST_BITS] =
          {name, s_refetch_tdata[r*TAG_BITS +: TAG_BITS]};
    end
  endgenerate

  stream_arbiter #(
    .INPUTS(REFERENCES),
    .WIDTH (REQUEST_BITS)
  ) turns (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_refetch_tvalid),
    .s_axis_tready(s_refetch_tready),
    .s_axis_tdata (requests),
    .m_axis_tvalid(request_valid),
    .m_axis_tready(request_ready),
    .m_axis_tdata ({asking, index_j, index_i})
  );

  // Cycle 0 reads item i, cycle 1 item j; item i has come by then, item j comes in cycle 2. All of
  // it waits for as long as an answer is not taken.
  reg                  second_q;    // item i was read: now item j
  reg                  i_comes_q;
  reg                  j_comes_q;
  reg [REFERENCES-1:0] answering_q;
  reg [REFERENCES-1:0] m_valid_q;
  reg [ITEM_BITS-1:0]  item_i_q;
  reg [ITEM_BITS-1:0]  item_j_q;

  wire advance = ((m_valid_q & ~m_answer_tready) == {REFERENCES{1'b0}});

  assign request_ready  = advance && second_q;
  assign memory_enable  = advance && request_valid;
  assign memory_address = second_q ? index_j : index_i;

  always @(posedge aclk) begin
    if (!aresetn) begin
      second_q  <= 1'b0;
      i_comes_q <= 1'b0;
      j_comes_q <= 1'b0;
      m_valid_q <= {REFERENCES{1'b0}};
    end else if (advance) begin
      second_q  <= request_valid && !second_q;
      i_comes_q <= request_valid && !second_q;
      j_comes_q <= request_valid && second_q;
      m_valid_q <= answering_q & {REFERENCES{j_comes_q}};
    end
  end

  always @(posedge aclk) begin
    if (request_ready) begin
      answering_q <= asking;
    end
    if (advance && i_comes_q) begin
      item_i_q <= memory_read_data;
    end
    if (advance && j_comes_q) begin
      item_j_q <= memory_read_data;
    end
  end

  assign m_answer_tvalid = m_valid_q;
  assign m_answer_tdata  = {item_j_q, item_i_q};

endmodule

`default_nettype wire
