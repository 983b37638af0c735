// report_stream: merges the reports of all lanes into one stream and closes each set with a beat.
// A report is {undecided, recomputed, verdict, j, i}: tdata {j, i}, each padded to bytes, tuser
// {4'b0, undecided, recomputed, verdict}. `close` says that no more reports will enter and how many
// the set had; once so many have left, a beat leaves with tlast, this number in tdata, and tuser
// {1'b1, overrun, 6'b0}; `close_ready` is its departure. Reset forgets all.
`default_nettype none

module report_stream #(
  parameter LANES = 8,
  parameter INDEX_BITS = 10
) (
  input  wire                              aclk,
  input  wire                              aresetn,
  input  wire [LANES-1:0]                  report_tvalid,
  output wire [LANES-1:0]                  report_tready,
  input  wire [LANES*(2*INDEX_BITS+4)-1:0] report_tdata,
  input  wire                              close_valid,
  output wire                              close_ready,
  input  wire [2*INDEX_BITS-1:0]           close_count,
  input  wire                              overrun,
  output wire                              m_axis_tvalid,
  input  wire                              m_axis_tready,
  output wire [16*((INDEX_BITS+7)/8)-1:0]  m_axis_tdata,
  output wire [7:0]                        m_axis_tuser,
  output wire                              m_axis_tlast
);

  localparam FIELD_BITS = 8 * ((INDEX_BITS + 7) / 8);
  localparam [2*INDEX_BITS-1:0] ONE = 1;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (LANES < 1) begin : g_refused_lanes
      LANES_is_below_1 refused ();
    end
    if (INDEX_BITS < 1) begin : g_refused_index_bits
      INDEX_BITS_is_below_1 refused ();
    end
  endgenerate

  wire                  tree_valid;
  wire [3:0]            result;
  wire [INDEX_BITS-1:0] index_i;
  wire [INDEX_BITS-1:0] index_j;

  stream_tree #(
    .INPUTS(LANES),
    .WIDTH (2 * INDEX_BITS + 4)
  ) merge (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(report_tvalid),
    .s_axis_tready(report_tready),
    .s_axis_tdata (report_tdata),
    .m_axis_tvalid(tree_valid),
    .m_axis_tready(m_axis_tready),
    .m_axis_tdata ({result, index_j, index_i})
  );

  // Once all have left nothing is in the tree, so that the closing beat meets no report.
  reg  [2*INDEX_BITS-1:0] left_q;     // reports of this set that have left
  reg                     closing_q;  // the closing beat is offered
  wire                    all_left = (left_q == close_count);

  assign close_ready = closing_q && m_axis_tready;

  always @(posedge aclk) begin
    if (!aresetn) begin
      left_q    <= {(2*INDEX_BITS){1'b0}};
      closing_q <= 1'b0;
    end else if (closing_q) begin
      if (m_axis_tready) begin
        left_q    <= {(2*INDEX_BITS){1'b0}};
        closing_q <= 1'b0;
      end
    end else begin
      if (tree_valid && m_axis_tready) begin
        left_q <= left_q + ONE;
      end
      closing_q <= close_valid && all_left;
    end
  end

  reg [2*FIELD_BITS-1:0] tdata;

  always @* begin
    tdata = {(2*FIELD_BITS){1'b0}};
    if (closing_q) begin
      tdata[2*INDEX_BITS-1:0] = close_count;
    end else begin
      tdata[INDEX_BITS-1:0]           = index_i;
      tdata[FIELD_BITS +: INDEX_BITS] = index_j;
    end
  end

  assign m_axis_tvalid = tree_valid || closing_q;
  assign m_axis_tdata  = tdata;
  assign m_axis_tuser  = closing_q ? {1'b1, overrun, 6'b000000} : {4'b0000, result};
  assign m_axis_tlast  = closing_q;

endmodule

`default_nettype wire
