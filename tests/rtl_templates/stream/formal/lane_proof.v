// lane_proof: each comparison with a watched tag, one inside at a time, has exactly one result. The
// result is the right one. It leaves after at most MOST_CALM cycles in which nobody stalls. A
// comparison that a reset forgets does not leave. The proof is for lane_scoreboard and lane_reorder
// around a lane of one rank, with a reference that answers at any time, in order. With IN_ORDER = 1
// a follower is watched as well. The asserts lemma_* of scoreboard_inside and reorder_inside make
// all but not_lost hold by induction over one cycle, and not_lost over MOST_CALM of them. Operands:
// {verdict, decided}; the reference's verdict is the complement of the lane's.
`default_nettype none

module lane_proof #(
  parameter IN_ORDER = 0,
  parameter RECOMPUTE = 1,
  parameter CARRIED = 1,
  parameter MOST_CALM = 14
) (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       s_valid,
  input wire [2:0] s_operands,
  input wire [1:0] s_tag,
  input wire       m_ready,
  input wire       request_ready,
  input wire       answer_now
);

  localparam SLOT_BITS    = 2;
  localparam PAYLOAD_BITS = (CARRIED != 0) ? 3 : 2;

  (* anyconst *) reg [1:0] watched;
  (* anyconst *) reg [1:0] follower;

  reg        started = 1'b0;
  wire       aresetn = started && aresetn_later;

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

  reg        inside        = 1'b0;  // the watched comparison was accepted and has not left
  reg  [2:0] operands;
  reg        follower_in   = 1'b0;
  reg        follows       = 1'b0;  // the follower inside was accepted behind the watched one inside
  reg  [5:0] calm          = 6'd0;  // cycles that the watched one has been inside, all of them calm
  reg        was_reset     = 1'b0;  // a reset came while it was inside
  reg        held          = 1'b0;
  reg  [9:0] held_result;

  wire       undecided      = !operands[0];
  wire       recomputed     = undecided && (RECOMPUTE != 0);
  wire [1:0] verdict        = recomputed ? ~operands[2:1] : operands[2:1];
  wire [7:0] expected       = {4'd0, undecided && !recomputed, recomputed, verdict};

  generate
    if (IN_ORDER != 0) begin : g_reorder
      reorder_inside #(
        .RECOMPUTE(RECOMPUTE), .CARRIED(CARRIED), .PAYLOAD_BITS(PAYLOAD_BITS)
      ) dut (
        .aclk(aclk), .aresetn(aresetn),
        .s_valid(s_valid), .s_ready(s_ready), .s_operands(s_operands), .s_tag(s_tag),
        .lane_operands(lane_operands), .lane_q(lane_q),
        .request_valid(request_valid), .request_ready(request_ready && !asked), .request(request),
        .answer(answer),
        .m_valid(m_valid), .m_ready(m_ready), .m_result(m_result), .m_tag(m_tag),
        .comparisons(comparisons),
        .started(started), .asked(asked), .asked_slot(asked_slot), .asked_operands(asked_operands),
        .watched(watched), .inside(inside), .operands(operands), .expected(expected),
        .follower(follower), .follower_in(follower_in), .follows(follows)
      );
    end else begin : g_scoreboard
      scoreboard_inside #(
        .RECOMPUTE(RECOMPUTE), .CARRIED(CARRIED), .PAYLOAD_BITS(PAYLOAD_BITS)
      ) dut (
        .aclk(aclk), .aresetn(aresetn),
        .s_valid(s_valid), .s_ready(s_ready), .s_operands(s_operands), .s_tag(s_tag),
        .lane_operands(lane_operands), .lane_q(lane_q),
        .request_valid(request_valid), .request_ready(request_ready && !asked), .request(request),
        .answer(answer),
        .m_valid(m_valid), .m_ready(m_ready), .m_result(m_result), .m_tag(m_tag),
        .comparisons(comparisons),
        .started(started), .asked(asked), .asked_slot(asked_slot), .asked_operands(asked_operands),
        .watched(watched), .inside(inside), .operands(operands), .expected(expected)
      );
    end
  endgenerate

  wire accept = aresetn && s_valid && s_ready;
  wire leave  = aresetn && m_valid && m_ready;

  wire       watched_enters = accept && (s_tag == watched);
  wire       watched_leaves = leave && (m_tag == watched);
  wire       is_calm        = m_ready && request_ready && (answer_now || !asked);

  // In the refetched form the reference gets the tag and looks up the operands.
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
    started <= 1'b1;
    lane_q  <= lane_operands;
    asked   <= aresetn && (take_request || (asked && !answer));
    if (take_request) begin
      asked_slot     <= request[PAYLOAD_BITS +: SLOT_BITS];
      asked_operands <= request_operands;
    end
    if (watched_enters) begin
      operands <= s_operands;
    end
    inside      <= aresetn && (watched_enters || (inside && !watched_leaves));
    follower_in <= aresetn && ((accept && (s_tag == follower)) ||
                               (follower_in && !(leave && (m_tag == follower))));
    follows     <= aresetn && !watched_leaves &&
                   (follows || (inside && accept && (s_tag == follower)));
    calm        <= (aresetn && inside && !watched_leaves && is_calm) ? calm + 6'd1 : 6'd0;
    was_reset   <= (inside && !aresetn) || (was_reset && !watched_enters);
    held        <= aresetn && m_valid && !m_ready;
    held_result <= {m_tag, m_result};
  end

  always @* begin
    assume(watched != follower);
    if (!aresetn) begin
      assume(!s_valid);
    end
    one_at_a_time: assume(!s_valid || (s_tag != watched) || !inside);
    one_follower: assume(!s_valid || (s_tag != follower) || !follower_in);
    if (started && aresetn) begin
      only_once: assert(!m_valid || (m_tag != watched) || inside);
      right_result: assert(!m_valid || (m_tag != watched) || (m_result == expected));
      in_order: assert((IN_ORDER == 0) || !m_valid || (m_tag != follower) || !follows);
      holds_until_taken: assert(!held || (m_valid && ({m_tag, m_result} == held_result)));
      not_lost: assert(calm < MOST_CALM);
      can_leave_decided: cover(watched_leaves && operands[0]);
      can_leave_undecided: cover(watched_leaves && !operands[0]);
      can_be_reset_away: cover(was_reset && !inside && leave && (comparisons == 4'd1));
      can_take_long: cover(calm > 6'd3);
      can_hold: cover(held);
      can_be_followed: cover(follows && watched_leaves);
    end
  end

endmodule

`default_nettype wire
