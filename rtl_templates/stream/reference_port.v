// reference_port: surrounds one free-running reference; requests in, answers out, in order.
// CARRIED = 1: the payload is the operands, every request is taken at once, and its answer leaves
// REFERENCE_LATENCY cycles later. CARRIED = 0: the payload is the tag; it leaves on m_refetch one
// cycle after the request, and REFERENCE_LATENCY cycles after the operands came on s_refetch, the
// answer leaves. 2^OUTSTANDING_BITS + 1 tags may wait for their operands. Initiation interval 1.
// Reset forgets all requests: whoever answers m_refetch must be reset with it.
`default_nettype none

module reference_port #(
  parameter OPERAND_BITS = 128,
  parameter TAG_BITS = 32,
  parameter LANE_BITS = 3,
  parameter SLOT_BITS = 5,
  parameter REFERENCE_LATENCY = 32,
  parameter CARRIED = 1,
  parameter OUTSTANDING_BITS = 4
) (
  input  wire                                                                    aclk,
  input  wire                                                                    aresetn,
  input  wire                                                                    s_request_tvalid,
  output wire                                                                    s_request_tready,
  input  wire [LANE_BITS+SLOT_BITS+(CARRIED != 0 ? OPERAND_BITS : TAG_BITS)-1:0] s_request_tdata,
  output wire [OPERAND_BITS-1:0]                                                 reference_operands,
  input  wire [1:0]                                                              reference_verdict,
  output wire                                                                    m_answer_valid,
  output wire [LANE_BITS+SLOT_BITS+2-1:0]                                        m_answer_tdata,
  output wire                                                                    m_refetch_tvalid,
  input  wire                                                                    m_refetch_tready,
  output wire [TAG_BITS-1:0]                                                     m_refetch_tdata,
  input  wire                                                                    s_refetch_tvalid,
  output wire                                                                    s_refetch_tready,
  input  wire [OPERAND_BITS-1:0]                                                 s_refetch_tdata
);

  localparam PAYLOAD_BITS = (CARRIED != 0) ? OPERAND_BITS : TAG_BITS;
  localparam SENDER_BITS  = LANE_BITS + SLOT_BITS;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (OPERAND_BITS < 1) begin : g_refused_operand_bits
      OPERAND_BITS_is_below_1 refused ();
    end
    if (TAG_BITS < 1) begin : g_refused_tag_bits
      TAG_BITS_is_below_1 refused ();
    end
    if (LANE_BITS < 1) begin : g_refused_lane_bits
      LANE_BITS_is_below_1 refused ();
    end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits
      SLOT_BITS_is_below_1 refused ();
    end
    if (REFERENCE_LATENCY < 0) begin : g_refused_reference_latency
      REFERENCE_LATENCY_is_below_0 refused ();
    end
    if (OUTSTANDING_BITS < 1) begin : g_refused_outstanding_bits
      OUTSTANDING_BITS_is_below_1 refused ();
    end
  endgenerate

  wire [PAYLOAD_BITS-1:0] payload = s_request_tdata[PAYLOAD_BITS-1:0];
  wire [SENDER_BITS-1:0]  sender  = s_request_tdata[PAYLOAD_BITS +: SENDER_BITS];

  // What enters the datapath, and for whom.
  wire                   start_valid;
  wire [SENDER_BITS-1:0] start_sender;
  wire [SENDER_BITS-1:0] answer_sender;

  generate
    if (CARRIED != 0) begin : g_carried
      wire unused_refetch = &{m_refetch_tready, s_refetch_tvalid, s_refetch_tdata};

      assign s_request_tready   = 1'b1;
      assign start_valid        = s_request_tvalid;
      assign start_sender       = sender;
      assign reference_operands = payload;
      assign m_refetch_tvalid   = 1'b0;
      assign m_refetch_tdata    = {TAG_BITS{1'b0}};
      assign s_refetch_tready   = 1'b0;
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
          refetch_tag_q <= payload;
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
        .s_axis_tdata (sender),
        .m_axis_tvalid(sender_waits),
        .m_axis_tready(s_refetch_tvalid),
        .m_axis_tdata (start_sender)
      );

      assign start_valid        = s_refetch_tvalid && sender_waits;
      assign reference_operands = s_refetch_tdata;
      assign m_refetch_tvalid   = refetch_valid_q;
      assign m_refetch_tdata    = refetch_tag_q;
      assign s_refetch_tready   = sender_waits;
    end
  endgenerate

  valid_delay_line #(
    .LENGTH(REFERENCE_LATENCY)
  ) valid_beside_reference (
    .aclk   (aclk),
    .aresetn(aresetn),
    .d      (start_valid),
    .q      (m_answer_valid)
  );

  delay_line #(
    .WIDTH (SENDER_BITS),
    .LENGTH(REFERENCE_LATENCY)
  ) sender_beside_reference (
    .aclk(aclk),
    .d   (start_sender),
    .q   (answer_sender)
  );

  assign m_answer_tdata = {answer_sender, reference_verdict};

endmodule

`default_nettype wire
