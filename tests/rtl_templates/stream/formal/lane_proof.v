// lane_proof: of comparisons with a watched tag, accepted once, exactly one result leaves, it is the
// right one, and it does leave; after a reset it never does. For lane_scoreboard and lane_reorder
// around a lane of one rank, with a reference that answers when it likes, in order.
// Operands: {verdict, decided}; the reference's verdict is the complement of the lane's.
`default_nettype none

module lane_proof #(
  parameter IN_ORDER = 0,
  parameter RECOMPUTE = 1,
  parameter CARRIED = 1,
  parameter QUIET = 8,  // from this step on nothing is reset or stalled
  parameter LEFT_BY = 22
) (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       s_valid,
  input wire [2:0] s_operands,
  input wire [1:0] s_tag,
  input wire       m_ready,
  input wire       request_ready,
  input wire       answer_now,
  input wire [1:0] watched,
  input wire [1:0] follower
);

  localparam SLOT_BITS    = 1;
  localparam PAYLOAD_BITS = (CARRIED != 0) ? 3 : 2;


  reg  [3:0] last_watched;
  reg  [5:0] step    = 6'd0;
  wire       aresetn = (step != 6'd0) && aresetn_later;

  wire                              s_ready;
  wire [2:0]                        lane_operands;
  reg  [2:0]                        lane_q;
  wire                              request_valid;
  wire [SLOT_BITS+PAYLOAD_BITS-1:0] request;
  wire                              m_valid;
  wire [7:0]                        m_result;
  wire [1:0]                        m_tag;
  wire [3:0]                        comparisons;
  wire [3:0]                        recomputations;
  wire [3:0]                        stalls;

  // The reference: one request at a time.
  reg                    asked = 1'b0;
  reg  [SLOT_BITS-1:0]   asked_slot;
  reg  [2:0]             asked_operands;
  wire                   take_request = request_valid && request_ready && !asked;
  wire                   answer       = asked && answer_now;

  generate
    if (IN_ORDER != 0) begin : g_reorder
      lane_reorder #(
        .OPERAND_BITS(3), .TAG_BITS(2), .SLOT_BITS(SLOT_BITS), .LANE_LATENCY(1),
        .COUNTER_BITS(4), .RECOMPUTE(RECOMPUTE), .CARRIED(CARRIED)
      ) dut (
        .aclk(aclk), .aresetn(aresetn),
        .s_axis_tvalid(s_valid), .s_axis_tready(s_ready),
        .s_axis_tdata(s_operands), .s_axis_tuser(s_tag),
        .lane_operands(lane_operands), .lane_verdict(lane_q[2:1]), .lane_decided(lane_q[0]),
        .m_request_tvalid(request_valid), .m_request_tready(request_ready && !asked),
        .m_request_tdata(request),
        .s_answer_valid(answer), .s_answer_slot(asked_slot),
        .s_answer_verdict(~asked_operands[2:1]),
        .m_axis_tvalid(m_valid), .m_axis_tready(m_ready),
        .m_axis_tdata(m_result), .m_axis_tuser(m_tag),
        .comparisons(comparisons), .recomputations(recomputations), .stalls(stalls)
      );
    end else begin : g_scoreboard
      lane_scoreboard #(
        .OPERAND_BITS(3), .TAG_BITS(2), .SLOT_BITS(SLOT_BITS), .LANE_LATENCY(1),
        .COUNTER_BITS(4), .RECOMPUTE(RECOMPUTE), .CARRIED(CARRIED)
      ) dut (
        .aclk(aclk), .aresetn(aresetn),
        .s_axis_tvalid(s_valid), .s_axis_tready(s_ready),
        .s_axis_tdata(s_operands), .s_axis_tuser(s_tag),
        .lane_operands(lane_operands), .lane_verdict(lane_q[2:1]), .lane_decided(lane_q[0]),
        .m_request_tvalid(request_valid), .m_request_tready(request_ready && !asked),
        .m_request_tdata(request),
        .s_answer_valid(answer), .s_answer_slot(asked_slot),
        .s_answer_verdict(~asked_operands[2:1]),
        .m_axis_tvalid(m_valid), .m_axis_tready(m_ready),
        .m_axis_tdata(m_result), .m_axis_tuser(m_tag),
        .comparisons(comparisons), .recomputations(recomputations), .stalls(stalls)
      );
    end
  endgenerate

  wire accept = aresetn && s_valid && s_ready;
  wire leave  = aresetn && m_valid && m_ready;

  reg        used      = 1'b0;  // the watched tag was accepted, before or after a reset
  reg        inside    = 1'b0;  // and has neither left nor been reset away
  reg  [2:0] operands;
  reg  [5:0] accepted_at;
  reg        follows   = 1'b0;  // the follower was accepted while the watched tag was inside
  reg        follower_used = 1'b0;
  reg        held      = 1'b0;
  reg  [9:0] held_result;

  wire       undecided      = !operands[0];
  wire       recomputed     = undecided && (RECOMPUTE != 0);
  wire [1:0] verdict        = recomputed ? ~operands[2:1] : operands[2:1];
  wire [7:0] expected       = {4'd0, undecided && !recomputed, recomputed, verdict};

  // With the refetched form the reference gets the tag and looks the operands up.
  wire [2:0] looked_up = (request[1:0] == watched) ? operands : 3'd0;
  wire [2:0] request_operands;
  generate
    if (CARRIED != 0) begin : g_carried
      assign request_operands = request[2:0];
    end else begin : g_refetched
      assign request_operands = looked_up;
    end
  endgenerate

  always @(posedge aclk) begin
    step   <= step + 6'd1;
    last_watched <= {watched, follower};
    lane_q <= lane_operands;
    asked  <= aresetn && (take_request || (asked && !answer));
    if (take_request) begin
      asked_slot     <= request[PAYLOAD_BITS +: SLOT_BITS];
      asked_operands <= request_operands;
    end
    if (accept && (s_tag == watched)) begin
      used        <= 1'b1;
      operands    <= s_operands;
      accepted_at <= step;
    end
    if (accept && (s_tag == follower)) begin
      follower_used <= 1'b1;
    end
    inside  <= aresetn && ((accept && (s_tag == watched)) || (inside && !(leave && (m_tag == watched))));
    follows <= aresetn && (follows || (inside && accept && (s_tag == follower)));
    held    <= aresetn && m_valid && !m_ready;
    held_result <= {m_tag, m_result};
  end

  always @* begin
    assume(watched != follower);
    if (step != 6'd0) begin
      constants: assume({watched, follower} == last_watched);
    end
    if (!aresetn) begin
      assume(!s_valid);
    end
    if (s_valid && (s_tag == watched)) begin
      assume(!used);
    end
    if (s_valid && (s_tag == follower)) begin
      assume(!follower_used);
    end
    if (step >= QUIET) begin
      assume(aresetn_later && m_ready && request_ready && answer_now);
    end
    if (aresetn) begin
      if (m_valid && (m_tag == watched)) begin
        only_once: assert(inside);
        right_result: assert(m_result == expected);
      end
      if ((IN_ORDER != 0) && m_valid && (m_tag == follower) && follows) begin
        in_order: assert(!inside);
      end
      if (held) begin
        holds_until_taken: assert(m_valid && ({m_tag, m_result} == held_result));
      end
      if ((step >= LEFT_BY) && used) begin
        not_lost: assert(!inside || (accepted_at > QUIET));
      end
      can_leave_decided: cover(leave && (m_tag == watched) && operands[0]);
      can_leave_undecided: cover(leave && (m_tag == watched) && !operands[0]);
      can_be_reset_away: cover(used && !inside && leave && (accepted_at > 6'd3) && (m_tag == follower)
                               && (comparisons == 4'd1));
      can_hold: cover(held);
      can_be_followed: cover(follows && leave && (m_tag == follower));
    end
  end

endmodule

`default_nettype wire
