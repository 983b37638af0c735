// A system of the generated kind, as small as one can be, for the tests of the testbench itself.
// It compares two positive finite binary16 numbers a and b; encodings closer than GUARD are sent
// to a reference. +fault=N names one defect, which strikes in lane 0,
// or 13 and 14 in the last stream of refetches; 0 is a good system.
`default_nettype none

module fake_system (
    aclk, aresetn,
    s_axis_tvalid, s_axis_tready, s_axis_tdata, s_axis_tuser,
    m_axis_tvalid, m_axis_tready, m_axis_tdata, m_axis_tuser,
`ifdef REFETCHED
    m_refetch_tvalid, m_refetch_tready, m_refetch_tdata,
    s_refetch_tvalid, s_refetch_tready, s_refetch_tdata,
`endif
    comparisons, recomputations, stalls
);

  parameter LANES = 2;
  parameter TAG_BITS = 12;
  parameter SLOTS = 8;
  parameter COUNTER_BITS = 16;
  parameter GUARD = 4;
  parameter ROUTE = 0;  // of undecided ones: 0 a reference, 1 in order, 2 none

  localparam TAG_BYTE_BITS = ((TAG_BITS + 7) / 8) * 8;

  input  wire                             aclk;
  input  wire                             aresetn;
  input  wire [LANES-1:0]                 s_axis_tvalid;
  output wire [LANES-1:0]                 s_axis_tready;
  input  wire [LANES*32-1:0]              s_axis_tdata;
  input  wire [LANES*TAG_BITS-1:0]        s_axis_tuser;
  output wire [LANES-1:0]                 m_axis_tvalid;
  input  wire [LANES-1:0]                 m_axis_tready;
  output wire [LANES*8-1:0]               m_axis_tdata;
  output wire [LANES*TAG_BITS-1:0]        m_axis_tuser;
  output wire [LANES*COUNTER_BITS-1:0]    comparisons;
  output wire [LANES*COUNTER_BITS-1:0]    recomputations;
  output wire [LANES*COUNTER_BITS-1:0]    stalls;
  reg [7:0] fault;
  initial begin
    if (!$value$plusargs("fault=%d", fault)) fault = 8'd0;
  end

  wire [LANES-1:0]               m_refetch_valid;
  wire [LANES-1:0]               m_refetch_ready;
  wire [LANES*TAG_BYTE_BITS-1:0] m_refetch_data;
  wire [LANES-1:0]               s_refetch_valid;
  wire [LANES-1:0]               s_refetch_ready;
  wire [LANES*32-1:0]            s_refetch_data;

`ifdef REFETCHED
  output wire [LANES-1:0]               m_refetch_tvalid;
  input  wire [LANES-1:0]               m_refetch_tready;
  output wire [LANES*TAG_BYTE_BITS-1:0] m_refetch_tdata;
  input  wire [LANES-1:0]               s_refetch_tvalid;
  output wire [LANES-1:0]               s_refetch_tready;
  input  wire [LANES*32-1:0]            s_refetch_tdata;
  localparam REFETCHED = 1;
  // Defects that a simulator of two values does not see: x where no transfer is.
  localparam [7:0] UNKNOWN_REQUEST = 8'd13;
  localparam [7:0] UNKNOWN_REFETCH_READY = 8'd14;
  localparam [LANES-1:0] LAST = {1'b1, {LANES-1{1'b0}}};
  localparam [LANES-1:0] NONE = {LANES{1'b0}};
  wire [LANES-1:0] unknown_request = (fault == UNKNOWN_REQUEST) ? LAST & {LANES{1'bx}} : NONE;
  wire [LANES-1:0] unknown_ready = (fault == UNKNOWN_REFETCH_READY) ? LAST & {LANES{1'bx}} : NONE;
  assign m_refetch_tvalid = m_refetch_valid | (unknown_request & ~m_refetch_tready);
  assign m_refetch_ready  = m_refetch_tready;
  assign m_refetch_tdata  = m_refetch_data;
  assign s_refetch_valid  = s_refetch_tvalid;
  assign s_refetch_tready = s_refetch_ready & ~(unknown_ready & ~s_refetch_tvalid);
  assign s_refetch_data   = s_refetch_tdata;
`else
  localparam REFETCHED = 0;
  assign m_refetch_ready = {LANES{1'b1}};
  assign s_refetch_valid = {LANES{1'b0}};
  assign s_refetch_data  = {LANES*32{1'b0}};
`endif

  genvar lane;
  generate
    for (lane = 0; lane < LANES; lane = lane + 1) begin : lane_channel
      wire                request_valid;
      wire                request_ready;
      wire [TAG_BITS-1:0] request_tag;
      wire [31:0]         request_operands;
      wire                answer_valid;
      wire [TAG_BITS-1:0] answer_tag;
      wire [1:0]          answer_verdict;

      fake_channel #(
          .TAG_BITS(TAG_BITS),
          .SLOTS(SLOTS),
          .COUNTER_BITS(COUNTER_BITS),
          .GUARD(GUARD),
          .ROUTE(ROUTE)
      ) channel (
          .aclk(aclk),
          .aresetn(aresetn),
          .fault((lane == 0) ? fault : 8'd0),
          .s_axis_tvalid(s_axis_tvalid[lane]),
          .s_axis_tready(s_axis_tready[lane]),
          .s_axis_tdata(s_axis_tdata[lane*32 +: 32]),
          .s_axis_tuser(s_axis_tuser[lane*TAG_BITS +: TAG_BITS]),
          .m_axis_tvalid(m_axis_tvalid[lane]),
          .m_axis_tready(m_axis_tready[lane]),
          .m_axis_tdata(m_axis_tdata[lane*8 +: 8]),
          .m_axis_tuser(m_axis_tuser[lane*TAG_BITS +: TAG_BITS]),
          .comparisons(comparisons[lane*COUNTER_BITS +: COUNTER_BITS]),
          .recomputations(recomputations[lane*COUNTER_BITS +: COUNTER_BITS]),
          .stalls(stalls[lane*COUNTER_BITS +: COUNTER_BITS]),
          .request_valid(request_valid),
          .request_ready(request_ready),
          .request_tag(request_tag),
          .request_operands(request_operands),
          .answer_valid(answer_valid),
          .answer_tag(answer_tag),
          .answer_verdict(answer_verdict)
      );

      fake_reference #(
          .TAG_BITS(TAG_BITS),
          .TAG_BYTE_BITS(TAG_BYTE_BITS),
          .SLOTS(SLOTS),
          .REFETCHED(REFETCHED)
      ) reference (
          .aclk(aclk),
          .aresetn(aresetn),
          .request_valid(request_valid),
          .request_ready(request_ready),
          .request_tag(request_tag),
          .request_operands(request_operands),
          .m_refetch_tvalid(m_refetch_valid[lane]),
          .m_refetch_tready(m_refetch_ready[lane]),
          .m_refetch_tdata(m_refetch_data[lane*TAG_BYTE_BITS +: TAG_BYTE_BITS]),
          .s_refetch_tvalid(s_refetch_valid[lane]),
          .s_refetch_tready(s_refetch_ready[lane]),
          .s_refetch_tdata(s_refetch_data[lane*32 +: 32]),
          .answer_valid(answer_valid),
          .answer_tag(answer_tag),
          .answer_verdict(answer_verdict)
      );
    end
  endgenerate

endmodule

`default_nettype wire
