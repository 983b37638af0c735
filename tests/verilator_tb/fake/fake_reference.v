// The reference of the fake system: compares after a few cycles, or after a refetch.
`default_nettype none

module fake_reference (
    aclk, aresetn,
    request_valid, request_ready, request_tag, request_operands,
    m_refetch_tvalid, m_refetch_tready, m_refetch_tdata,
    s_refetch_tvalid, s_refetch_tready, s_refetch_tdata,
    answer_valid, answer_tag, answer_verdict
);

  parameter TAG_BITS = 12;
  parameter TAG_BYTE_BITS = 16;
  parameter SLOTS = 8;
  parameter REFETCHED = 0;

  input  wire                     aclk;
  input  wire                     aresetn;
  input  wire                     request_valid;
  output wire                     request_ready;
  input  wire [TAG_BITS-1:0]      request_tag;
  input  wire [31:0]              request_operands;
  output wire                     m_refetch_tvalid;
  input  wire                     m_refetch_tready;
  output wire [TAG_BYTE_BITS-1:0] m_refetch_tdata;
  input  wire                     s_refetch_tvalid;
  output wire                     s_refetch_tready;
  input  wire [31:0]              s_refetch_tdata;
  output reg                      answer_valid;
  output reg  [TAG_BITS-1:0]      answer_tag;
  output reg  [1:0]               answer_verdict;

  // Refetched operands come back in the order of their tags. SLOTS bounds the requests under way.
  reg [TAG_BITS-1:0] tags [0:15];
  reg [3:0]          asked;
  reg [3:0]          answered;
  wire [TAG_BITS-1:0] first_tag = tags[answered];

  assign m_refetch_tvalid = request_valid && (REFETCHED != 0);
  assign m_refetch_tdata = {{TAG_BYTE_BITS-TAG_BITS{1'b0}}, request_tag};
  assign request_ready = (REFETCHED == 0) || m_refetch_tready;
  assign s_refetch_tready = 1'b1;

  wire        valid = (REFETCHED == 0) ? request_valid : s_refetch_tvalid;
  wire [31:0] operands = (REFETCHED == 0) ? request_operands : s_refetch_tdata;
  wire [1:0]  order = (operands[15:0] < operands[31:16]) ? 2'd0 : 2'd1;

  always @(posedge aclk) begin
    if (request_valid && request_ready) tags[asked] <= request_tag;
    answer_tag <= (REFETCHED == 0) ? request_tag : first_tag;
    answer_verdict <= (operands[15:0] > operands[31:16]) ? 2'd2 : order;
    if (!aresetn) begin
      asked <= 0;
      answered <= 0;
      answer_valid <= 1'b0;
    end else begin
      if (request_valid && request_ready) asked <= asked + 1'b1;
      if (s_refetch_tvalid) answered <= answered + 1'b1;
      answer_valid <= valid;
    end
  end

endmodule

`default_nettype wire
