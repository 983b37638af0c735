// lane_tags: the tags of the comparisons inside a lane or a group of lanes, each stored once and
// read out by its slot. A result leaves on m_axis with its tag, latency 1, as a byte for each lane.
// If `s_result_asks` marks a lane, the word leaves on m_request instead, as {slot, tag + lane} for
// each marked lane, latency 2 (with LANES > 1: 4), and its tag stays in the memory.
//
// Results and requests share the one read port. While requests are not taken, the second word that
// asks (with LANES > 1: the third) waits at the port, and results wait behind it. At most one word
// leaves in a cycle, and one request in two: the request register loads only when empty, so no path
// leads on from m_request_tready in the same cycle. Reset forgets the words that were read.
`default_nettype none

module lane_tags #(
  parameter LANES = 1,      // lanes in lock step, 1 to 64
  parameter TAG_BITS = 32,  // bits of a tag (m_axis_tuser), 1 or more
  parameter SLOT_BITS = 5   // 1 to 30: 2^SLOT_BITS comparisons may be in flight
) (
  input  wire                          aclk,
  input  wire                          aresetn,
  input  wire                          start_valid,
  input  wire [SLOT_BITS-1:0]          start_slot,
  input  wire [TAG_BITS-1:0]           start_tag,
  input  wire                          s_result_valid,
  output wire                          s_result_ready,
  input  wire [SLOT_BITS-1:0]          s_result_slot,
  input  wire [LANES-1:0]              s_result_asks,
  input  wire [4*LANES-1:0]            s_result,
  output wire                          m_request_tvalid,
  input  wire                          m_request_tready,
  output wire [SLOT_BITS+TAG_BITS-1:0] m_request_tdata,
  output wire                          m_axis_tvalid,
  input  wire                          m_axis_tready,
  output wire [8*LANES-1:0]            m_axis_tdata,
  output wire [TAG_BITS-1:0]           m_axis_tuser
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((LANES < 1) || (LANES > 64)) begin : g_refused_lanes LANES_is_not_1_to_64 refused (); end
    if (TAG_BITS < 1) begin : g_refused_tag_bits TAG_BITS_is_below_1 refused (); end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits SLOT_BITS_is_below_1 refused (); end
  endgenerate

  // The word read last is a result or asks for recomputation. At most one of the two flags is high.
  reg                           m_valid_q;
  reg                           ask_valid_q;
  reg  [4*LANES-1:0]            result_q;
  reg  [SLOT_BITS-1:0]          ask_slot_q;
  reg  [LANES-1:0]              ask_lanes_q;
  wire                          ask_leaves;
  wire [TAG_BITS-1:0]           tag;
  wire                          next_valid;  // the request that is sent next
  wire [SLOT_BITS+TAG_BITS-1:0] next_request;
  reg                           request_valid_q;
  reg  [SLOT_BITS+TAG_BITS-1:0] request_q;

  wire result_waits = m_valid_q && !m_axis_tready;
  wire ask_waits    = ask_valid_q && !ask_leaves;
  wire request      = next_valid && !request_valid_q;
  wire room         = !result_waits && !ask_waits;
  wire read         = s_result_valid && room;
  wire asks         = |s_result_asks;

  genvar k;
  generate
    if (LANES == 1) begin : g_one_lane
      wire unused_lanes = &ask_lanes_q;

      assign next_valid   = ask_valid_q;
      assign next_request = {ask_slot_q, tag};
      assign ask_leaves   = request;
    end else begin : g_group
      // A word that asks leaves the read port at once. Its lanes then ask one after the other.
      reg                 word_valid_q;
      reg [SLOT_BITS-1:0] word_slot_q;
      reg [TAG_BITS-1:0]  word_tag_q;
      reg [LANES-1:0]     word_lanes_q;
      wire                word_leaves;
      wire [5:0]          lane;
      wire [TAG_BITS+5:0] lane_tag        = {6'd0, word_tag_q} + {{TAG_BITS{1'b0}}, lane};
      wire                unused_lane_tag = &lane_tag;

      assign ask_leaves   = ask_valid_q && (!word_valid_q || word_leaves);
      assign next_request = {word_slot_q, lane_tag[TAG_BITS-1:0]};

      always @(posedge aclk) begin
        if (!aresetn) begin
          word_valid_q <= 1'b0;
        end else begin
          word_valid_q <= ask_leaves || (word_valid_q && !word_leaves);
        end
      end

      always @(posedge aclk) begin
        if (ask_leaves) begin
          word_slot_q  <= ask_slot_q;
          word_tag_q   <= tag;
          word_lanes_q <= ask_lanes_q;
        end
      end

      marked_lanes #(
        .LANES(LANES)
      ) asking_lanes (
        .aclk        (aclk),
        .aresetn     (aresetn),
        .s_word_valid(word_valid_q),
        .s_word_ready(word_leaves),
        .s_word_lanes(word_lanes_q),
        .m_lane_valid(next_valid),
        .m_lane_ready(!request_valid_q),
        .m_lane      (lane)
      );
    end
    for (k = 0; k < LANES; k = k + 1) begin : g_lane
      assign m_axis_tdata[8*k +: 8] = {4'b0000, result_q[3*LANES+k], result_q[2*LANES+k],
                                       result_q[2*k +: 2]};
    end
  endgenerate

  always @(posedge aclk) begin
    if (!aresetn) begin
      m_valid_q       <= 1'b0;
      ask_valid_q     <= 1'b0;
      request_valid_q <= 1'b0;
    end else begin
      m_valid_q       <= (read && !asks) || result_waits;
      ask_valid_q     <= (read && asks) || ask_waits;
      request_valid_q <= request || (request_valid_q && !m_request_tready);
    end
  end

  always @(posedge aclk) begin
    if (read) begin
      result_q    <= s_result;
      ask_slot_q  <= s_result_slot;
      ask_lanes_q <= s_result_asks;
    end
    if (request) begin
      request_q <= next_request;
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
  assign m_axis_tuser     = tag;

endmodule

`default_nettype wire
