// requested_operands: the operands of each request, in order, with the number of its sender.
// CARRIED = 1: a request is a packet of beats, whose payloads are the operands, the lowest part
// first. With more than one beat, the operands are there one cycle after the last beat, and the
// next packet enters while they wait. CARRIED = 0: the payload is the tag. It leaves on m_refetch
// one cycle after the request, and the operands come on s_refetch. Reset forgets all requests: the
// unit that answers m_refetch must be reset with it.
`default_nettype none

module requested_operands #(
  parameter OPERAND_BITS = 128,   // bits of a comparison's operands, 1 or more
  parameter TAG_BITS = 32,        // bits of a tag (m_refetch_tdata), 1 or more
  parameter SENDER_BITS = 8,      // bits of a sender's number, 1 or more
  parameter CARRIED = 1,          // 1: a request carries the operands; 0: the tag
  parameter BEAT_BITS = 0,        // 0 to 8: a packet has 2^BEAT_BITS beats
  parameter OUTSTANDING_BITS = 4  // 1 to 30: 2^OUTSTANDING_BITS + 1 tags may wait for operands
) (
  input  wire                                                               aclk,
  input  wire                                                               aresetn,
  input  wire                                                               s_request_tvalid,
  output wire                                                               s_request_tready,
  input  wire [(CARRIED != 0 ? (OPERAND_BITS-1)>>BEAT_BITS : TAG_BITS-1):0] s_request_tdata,
  input  wire [SENDER_BITS-1:0]                                             s_request_tuser,
  output wire                                                               m_refetch_tvalid,
  input  wire                                                               m_refetch_tready,
  output wire [TAG_BITS-1:0]                                                m_refetch_tdata,
  input  wire                                                               s_refetch_tvalid,
  output wire                                                               s_refetch_tready,
  input  wire [OPERAND_BITS-1:0]                                            s_refetch_tdata,
  output wire                                                               m_axis_tvalid,
  input  wire                                                               m_axis_tready,
  output wire [OPERAND_BITS-1:0]                                            m_axis_tdata,
  output wire [SENDER_BITS-1:0]                                             m_axis_tuser
);

  localparam PART_BITS = ((OPERAND_BITS - 1) >> BEAT_BITS) + 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (OPERAND_BITS < 1) begin : g_refused_operand_bits OPERAND_BITS_is_below_1 refused (); end
    if (TAG_BITS < 1) begin : g_refused_tag_bits TAG_BITS_is_below_1 refused (); end
    if (SENDER_BITS < 1) begin : g_refused_sender_bits SENDER_BITS_is_below_1 refused (); end
    if ((BEAT_BITS < 0) || (BEAT_BITS > 8))
      begin : g_refused_beat_bits BEAT_BITS_is_not_0_to_8 refused (); end
    if (OUTSTANDING_BITS < 1)
      begin : g_refused_outstanding_bits OUTSTANDING_BITS_is_below_1 refused (); end
  endgenerate

  generate
    if (CARRIED != 0) begin : g_carried
      wire [(PART_BITS<<BEAT_BITS)-1:0] joined;  // the operands, and zeros above them
      wire unused_joined  = &joined;
      wire unused_refetch = &{m_refetch_tready, s_refetch_tvalid, s_refetch_tdata};

      stream_upsizer #(
        .WIDTH    (PART_BITS),
        .USER_BITS(SENDER_BITS),
        .BEAT_BITS(BEAT_BITS)
      ) parts (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(s_request_tvalid),
        .s_axis_tready(s_request_tready),
        .s_axis_tdata (s_request_tdata),
        .s_axis_tuser (s_request_tuser),
        .m_axis_tvalid(m_axis_tvalid),
        .m_axis_tready(m_axis_tready),
        .m_axis_tdata (joined),
        .m_axis_tuser (m_axis_tuser)
      );

      assign m_axis_tdata     = joined[OPERAND_BITS-1:0];
      assign m_refetch_tvalid = 1'b0;
      assign m_refetch_tdata  = {TAG_BITS{1'b0}};
      assign s_refetch_tready = 1'b0;
    end else begin : g_refetched
      wire accept = s_request_tvalid && s_request_tready;
      wire room_for_sender;
      wire sender_waits;

      reg                refetch_valid_q;
      reg [TAG_BITS-1:0] refetch_tag_q;

      assign s_request_tready = room_for_sender && (!refetch_valid_q || m_refetch_tready);

      always @(posedge aclk) begin
        if (!aresetn) begin
          refetch_valid_q <= 1'b0;
        end else begin
          refetch_valid_q <= accept || (refetch_valid_q && !m_refetch_tready);
        end
      end

      always @(posedge aclk) begin
        if (accept) begin
          refetch_tag_q <= s_request_tdata;
        end
      end

      stream_fifo #(
        .WIDTH     (SENDER_BITS),
        .DEPTH_BITS(OUTSTANDING_BITS)
      ) waiting_senders (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(accept),
        .s_axis_tready(room_for_sender),
        .s_axis_tdata (s_request_tuser),
        .m_axis_tvalid(sender_waits),
        .m_axis_tready(s_refetch_tvalid && m_axis_tready),
        .m_axis_tdata (m_axis_tuser)
      );

      assign m_axis_tvalid    = s_refetch_tvalid && sender_waits;
      assign m_axis_tdata     = s_refetch_tdata;
      assign m_refetch_tvalid = refetch_valid_q;
      assign m_refetch_tdata  = refetch_tag_q;
      assign s_refetch_tready = sender_waits && m_axis_tready;
    end
  endgenerate

endmodule

`default_nettype wire
