// stream_crossbar: connects LANES request streams to REFERENCES references, and answers to lanes.
// Reference i mod REFERENCES serves lane i, round-robin; a reference without lanes idles. Requests
// are packets of beats {slot, payload}, which stay together: latency ceil(log_RADIX(lanes of the
// reference)), at least 1. A reference gets one beat per cycle, at most one in two from the same
// lane. Answers: latency 2, never refused, in the order of the lane's requests if the reference
// keeps order. Reset empties it.
`default_nettype none

module stream_crossbar #(
  parameter LANES = 8,           // lanes with a request stream, 1 or more
  parameter REFERENCES = 1,      // number of references, 1 or more
  parameter LANE_BITS = 3,       // bits of a lane's number, 1 to 30; 2^LANE_BITS >= LANES
  parameter SLOT_BITS = 5,       // bits of a slot, 1 or more
  parameter PAYLOAD_BITS = 128,  // bits of a beat without its slot, 1 or more
  parameter RADIX = 4,           // inputs of an arbiter, 2 or more
  parameter BEAT_BITS = 0        // 0 to 8: a packet has 2^BEAT_BITS beats
) (
  input  wire                                                     aclk,
  input  wire                                                     aresetn,
  input  wire [LANES-1:0]                                         s_request_tvalid,
  output wire [LANES-1:0]                                         s_request_tready,
  input  wire [LANES*(SLOT_BITS+PAYLOAD_BITS)-1:0]                s_request_tdata,
  output wire [REFERENCES-1:0]                                    m_request_tvalid,
  input  wire [REFERENCES-1:0]                                    m_request_tready,
  output wire [REFERENCES*(LANE_BITS+SLOT_BITS+PAYLOAD_BITS)-1:0] m_request_tdata,
  input  wire [REFERENCES-1:0]                                    s_answer_valid,
  input  wire [REFERENCES*(LANE_BITS+SLOT_BITS+2)-1:0]            s_answer_tdata,
  output wire [LANES-1:0]                                         m_answer_valid,
  output wire [LANES*SLOT_BITS-1:0]                               m_answer_slot,
  output wire [LANES*2-1:0]                                       m_answer_verdict
);

  localparam REQUEST_BITS = SLOT_BITS + PAYLOAD_BITS;
  localparam NAMED_BITS   = LANE_BITS + REQUEST_BITS;  // a request with its lane's number
  localparam ANSWER_BITS  = LANE_BITS + SLOT_BITS + 2;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (LANES < 1) begin : g_refused_lanes LANES_is_below_1 refused (); end
    if (REFERENCES < 1) begin : g_refused_references REFERENCES_is_below_1 refused (); end
    if (LANE_BITS < 1) begin : g_refused_lane_bits LANE_BITS_is_below_1 refused (); end
    if (LANE_BITS > 30) begin : g_refused_lane_shift LANE_BITS_is_above_30 refused (); end
    if (((LANES - 1) >>> LANE_BITS) > 0)
      begin : g_refused_last_lane LANE_BITS_is_too_small_for_LANES refused (); end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits SLOT_BITS_is_below_1 refused (); end
    if (PAYLOAD_BITS < 1) begin : g_refused_payload_bits PAYLOAD_BITS_is_below_1 refused (); end
    if (RADIX < 2) begin : g_refused_radix RADIX_is_below_2 refused (); end
    if ((BEAT_BITS < 0) || (BEAT_BITS > 8))
      begin : g_refused_beat_bits BEAT_BITS_is_not_0_to_8 refused (); end
  endgenerate

  genvar r;
  genvar k;
  generate
    for (r = 0; r < REFERENCES; r = r + 1) begin : g_reference
      if (r >= LANES) begin : g_idle
        wire unused_inputs = &{m_request_tready[r], s_answer_valid[r],
                               s_answer_tdata[r*ANSWER_BITS +: ANSWER_BITS]};

        assign m_request_tvalid[r]                         = 1'b0;
        assign m_request_tdata[r*NAMED_BITS +: NAMED_BITS] = {NAMED_BITS{1'b0}};
      end else begin : g_served
        localparam SERVED = (LANES - r + REFERENCES - 1) / REFERENCES;

        wire [SERVED-1:0]            request_valid;
        wire [SERVED-1:0]            request_ready;
        wire [SERVED*NAMED_BITS-1:0] request_data;

        stream_tree #(
          .INPUTS   (SERVED),
          .WIDTH    (NAMED_BITS),
          .RADIX    (RADIX),
          .BEAT_BITS(BEAT_BITS)
        ) requests (
          .aclk         (aclk),
          .aresetn      (aresetn),
          .s_axis_tvalid(request_valid),
          .s_axis_tready(request_ready),
          .s_axis_tdata (request_data),
          .m_axis_tvalid(m_request_tvalid[r]),
          .m_axis_tready(m_request_tready[r]),
          .m_axis_tdata (m_request_tdata[r*NAMED_BITS +: NAMED_BITS])
        );

        // Answers: one register near the reference, and one near each lane.
        reg                   answer_valid_q;
        reg [ANSWER_BITS-1:0] answer_q;
        wire [LANE_BITS-1:0]  answer_lane    = answer_q[SLOT_BITS+2 +: LANE_BITS];
        wire [SLOT_BITS-1:0]  answer_slot    = answer_q[2 +: SLOT_BITS];
        wire [1:0]            answer_verdict = answer_q[1:0];

        always @(posedge aclk) begin
          if (!aresetn) begin
            answer_valid_q <= 1'b0;
          end else begin
            answer_valid_q <= s_answer_valid[r];
          end
        end

        always @(posedge aclk) begin
          answer_q <= s_answer_tdata[r*ANSWER_BITS +: ANSWER_BITS];
        end

        for (k = 0; k < SERVED; k = k + 1) begin : g_lane
          localparam LANE = r + k * REFERENCES;

          wire [LANE_BITS-1:0] name = LANE[LANE_BITS-1:0];
          reg                  lane_valid_q;
          reg  [SLOT_BITS-1:0] lane_slot_q;
          reg  [1:0]           lane_verdict_q;

          assign request_valid[k]       = s_request_tvalid[LANE];
          assign s_request_tready[LANE] = request_ready[k];
          assign request_data[k*NAMED_BITS +: NAMED_BITS] =
              {name, s_request_tdata[LANE*REQUEST_BITS +: REQUEST_BITS]};

          always @(posedge aclk) begin
            if (!aresetn) begin
              lane_valid_q <= 1'b0;
            end else begin
              lane_valid_q <= answer_valid_q && (answer_lane == name);
            end
          end

          always @(posedge aclk) begin
            lane_slot_q    <= answer_slot;
            lane_verdict_q <= answer_verdict;
          end

          assign m_answer_valid[LANE]                       = lane_valid_q;
          assign m_answer_slot[LANE*SLOT_BITS +: SLOT_BITS] = lane_slot_q;
          assign m_answer_verdict[LANE*2 +: 2]              = lane_verdict_q;
        end
      end
    end
  endgenerate

endmodule

`default_nettype wire
