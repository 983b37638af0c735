// lane_tags: the tags of the comparisons inside a lane, each stored once and read out by its slot.
// A result leaves on m_axis with its tag, latency 1. What is marked `s_result_asks` leaves on
// m_request instead, as {slot, tag}, latency 2, and its tag stays in the memory. Both use the one
// read port, so a result waits while a request does, once two of them are on their way. One in a
// cycle, requests in every second one at most: the request register loads only when empty, so that
// no path leads on from m_request_tready in the same cycle. Reset forgets what was read.
`default_nettype none

module lane_tags #(
  parameter TAG_BITS = 32,
  parameter SLOT_BITS = 5
) (
  input  wire                          aclk,
  input  wire                          aresetn,
  input  wire                          start_valid,
  input  wire [SLOT_BITS-1:0]          start_slot,
  input  wire [TAG_BITS-1:0]           start_tag,
  input  wire                          s_result_valid,
  output wire                          s_result_ready,
  input  wire [SLOT_BITS-1:0]          s_result_slot,
  input  wire                          s_result_asks,
  input  wire [3:0]                    s_result,
  output wire                          m_request_tvalid,
  input  wire                          m_request_tready,
  output wire [SLOT_BITS+TAG_BITS-1:0] m_request_tdata,
  output wire                          m_axis_tvalid,
  input  wire                          m_axis_tready,
  output wire [7:0]                    m_axis_tdata,
  output wire [TAG_BITS-1:0]           m_axis_tuser
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (TAG_BITS < 1) begin : g_refused_tag_bits
      TAG_BITS_is_below_1 refused ();
    end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits
      SLOT_BITS_is_below_1 refused ();
    end
  endgenerate

  // What was read last is a result or asks for recomputation; at most one of the two is high.
  reg                           m_valid_q;
  reg                           ask_valid_q;
  reg  [3:0]                    result_q;
  reg  [SLOT_BITS-1:0]          ask_slot_q;
  wire [TAG_BITS-1:0]           tag;
  reg                           request_valid_q;
  reg  [SLOT_BITS+TAG_BITS-1:0] request_q;

  wire result_waits = m_valid_q && !m_axis_tready;
  wire ask_waits    = ask_valid_q && request_valid_q;
  wire request      = ask_valid_q && !request_valid_q;
  wire room         = !result_waits && !ask_waits;
  wire read         = s_result_valid && room;

  always @(posedge aclk) begin
    if (!aresetn) begin
      m_valid_q       <= 1'b0;
      ask_valid_q     <= 1'b0;
      request_valid_q <= 1'b0;
    end else begin
      m_valid_q       <= (read && !s_result_asks) || result_waits;
      ask_valid_q     <= (read && s_result_asks) || ask_waits;
      request_valid_q <= request || (request_valid_q && !m_request_tready);
    end
  end

  always @(posedge aclk) begin
    if (read) begin
      result_q   <= s_result;
      ask_slot_q <= s_result_slot;
    end
    if (request) begin
      request_q <= {ask_slot_q, tag};
    end
  end

  dual_port_memory #(
    .WIDTH       (TAG_BITS),
    .ADDRESS_BITS(SLOT_BITS)
  ) memory (
    .aclk         (aclk),
    .write_enable (start_valid),
    .write_address(start_slot),
    .write_data   (start_tag),
    .read_enable  (read),
    .read_address (s_result_slot),
    .read_data    (tag)
  );

  assign s_result_ready   = room;
  assign m_request_tvalid = request_valid_q;
  assign m_request_tdata  = request_q;
  assign m_axis_tvalid    = m_valid_q;
  assign m_axis_tdata     = {4'b0000, result_q};
  assign m_axis_tuser     = tag;

endmodule

`default_nettype wire
