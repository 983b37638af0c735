// reference_port_proof: every request that reference_port takes is answered once, in order, to its
// sender, with the verdict about its own operands; a folded datapath sees them unchanged until they
// are taken. One request at a time is watched, chosen by the solver, and those ahead of it are
// counted. A sender is {free bit, watched}. The datapath's verdict is the operands; refetched
// operands are the complement of the tag, and come after any delay. With BEAT_BITS = 1 a request
// comes in two beats of a bit each, and is inside from the second on.
`default_nettype none

module reference_port_proof #(
  parameter CARRIED = 1,
  parameter LATENCY = 2,
  parameter INTERVAL = 1,
  parameter LAST_PHASE = 0,
  parameter BEAT_BITS = 0
) (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       s_valid,
  input wire       s_lane,
  input wire [1:0] s_payload,
  input wire       choose,       // the request that enters is watched, if no other is
  input wire       refetch_ready,
  input wire       fetched_now
);

  localparam [3:0] NONE = 0;
  localparam [3:0] ONE  = 1;
  localparam [1:0] RESET_PHASE = INTERVAL - 1;
  localparam MOST_QUIET = LATENCY + 2 * INTERVAL + 6;
  localparam PART_BITS  = 2 >> BEAT_BITS;

  wire       s_ready;
  wire [1:0] phase;
  wire [1:0] operands;
  wire [1:0] verdict;
  wire       answer_valid;
  wire       answer_lane;
  wire       answer_watched;
  wire [1:0] answer_verdict;
  wire       refetch_valid;
  wire [1:0] refetch_tag;
  wire       queue_ready;
  wire       fetched_valid;
  wire       fetched_ready;
  wire [1:0] fetched_tag;
  reg        granted = 1'b0;
  wire       grant   = fetched_now || granted;

  reg        started = 1'b0;
  wire       aresetn = started && aresetn_later;
  reg        second  = 1'b0;  // the next beat is the second of its request
  reg        first_bit;       // its first beat
  wire       last    = (BEAT_BITS == 0) || second;
  wire       enter   = s_valid && s_ready && last;
  reg        watching = 1'b0;
  wire       chosen  = choose && !watching;

  reference_port #(
    .OPERAND_BITS       (2),
    .TAG_BITS           (2),
    .LANE_BITS          (1),
    .SLOT_BITS          (1),
    .REFERENCE_LATENCY  (LATENCY),
    .INITIATION_INTERVAL(INTERVAL),
    .LAST_OPERAND_PHASE (LAST_PHASE),
    .PHASE_BITS         (2),
    .CARRIED            (CARRIED),
    .BEAT_BITS          (BEAT_BITS),
    .OUTSTANDING_BITS   (1)
  ) dut (
    .aclk              (aclk),
    .aresetn           (aresetn),
    .s_request_tvalid  (s_valid),
    .s_request_tready  (s_ready),
    .s_request_tdata   ({s_lane, chosen, s_payload[PART_BITS-1:0]}),
    .reset_phase       (RESET_PHASE),
    .reference_phase   (phase),
    .reference_operands(operands),
    .reference_verdict (verdict),
    .m_answer_valid    (answer_valid),
    .m_answer_tdata    ({answer_lane, answer_watched, answer_verdict}),
    .m_refetch_tvalid  (refetch_valid),
    .m_refetch_tready  (refetch_ready && queue_ready),
    .m_refetch_tdata   (refetch_tag),
    .s_refetch_tvalid  (fetched_valid && grant),
    .s_refetch_tready  (fetched_ready),
    .s_refetch_tdata   (~fetched_tag)
  );

  delay_line #(
    .WIDTH (2),
    .LENGTH(LATENCY)
  ) datapath (
    .aclk(aclk),
    .d   (operands),
    .q   (verdict)
  );

  // The operands in the phase in which they are read last.
  wire [1:0] late_verdict;

  delay_line #(
    .WIDTH (2),
    .LENGTH(LATENCY - LAST_PHASE)
  ) late_datapath (
    .aclk(aclk),
    .d   (operands),
    .q   (late_verdict)
  );

  stream_fifo #(
    .WIDTH     (2),
    .DEPTH_BITS(1)
  ) fetching (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(refetch_valid && refetch_ready),
    .s_axis_tready(queue_ready),
    .s_axis_tdata (refetch_tag),
    .m_axis_tvalid(fetched_valid),
    .m_axis_tready(fetched_ready && grant),
    .m_axis_tdata (fetched_tag)
  );

  // The requests inside.
  wire       takes_operands = (CARRIED != 0) ? enter && (BEAT_BITS == 0)
                                             : fetched_valid && grant && fetched_ready;
  reg  [3:0] inside  = NONE;
  reg  [3:0] ahead   = NONE;
  reg        lane;
  reg  [1:0] expected;
  reg  [4:0] quiet   = 5'd0;
  reg  [1:0] first_operands;  // the operands at the start of the interval
  reg        held    = 1'b0;
  reg  [1:0] held_tag;
  reg        offered = 1'b0;
  reg  [3:0] offered_request;
  reg        busy    = 1'b0;  // an answer left in the cycle before

  always @(posedge aclk) begin
    started         <= 1'b1;
    granted         <= aresetn && fetched_valid && grant && !fetched_ready;
    held            <= aresetn && refetch_valid && !(refetch_ready && queue_ready);
    held_tag        <= refetch_tag;
    offered         <= aresetn && s_valid && !s_ready;
    offered_request <= {s_lane, chosen, s_payload};
    busy            <= aresetn && answer_valid;
    second          <= aresetn && ((s_valid && s_ready) ? !last : second);
    if (s_valid && s_ready) begin
      first_bit <= s_payload[0];
    end
    if (phase == 2'd0) begin
      first_operands <= operands;
    end
    if (!aresetn) begin
      inside   <= NONE;
      watching <= 1'b0;
      quiet    <= 5'd0;
    end else begin
      inside <= inside + {3'b000, enter} - {3'b000, answer_valid};
      quiet  <= ((inside != NONE) && !answer_valid && refetch_ready && grant) ? quiet + 5'd1
                                                                                  : 5'd0;
      if (answer_valid && watching) begin
        ahead    <= ahead - ONE;
        watching <= (ahead != NONE);
      end
      if (enter && chosen) begin
        watching <= 1'b1;
        ahead    <= inside - {3'b000, answer_valid};
        lane     <= s_lane;
        expected <= (BEAT_BITS != 0) ? {s_payload[0], first_bit}
                    : (CARRIED != 0) ? s_payload : ~s_payload;
      end
    end
  end

  always @* begin
    if (offered) begin
      assume(s_valid && ({s_lane, chosen, s_payload} == offered_request));
    end
    if (!aresetn) begin
      assume(!s_valid);
    end
    if (started && aresetn) begin
      nothing_made_up: assert(!answer_valid || (inside != NONE));
      answers_once_in_order: assert(!answer_valid ||
                                    (answer_watched == (watching && (ahead == NONE))));
      answers_right: assert(!answer_valid || !answer_watched ||
                            ({answer_lane, answer_verdict} == {lane, expected}));
      operands_stay: assert(!answer_valid || !answer_watched || (late_verdict == expected));
      few_inside: assert(inside < 4'd12);
      takes_in_its_phase: assert(!takes_operands || (phase == LAST_PHASE));
      operands_hold: assert(!takes_operands || (LAST_PHASE == 0) || (operands == first_operands));
      keeps_moving: assert(quiet < MOST_QUIET);
      refetch_holds: assert(!held || (refetch_valid && (refetch_tag == held_tag)));
      can_answer: cover(answer_valid && answer_watched && answer_lane && (answer_verdict == 2'd2));
      can_answer_behind_others: cover(watching && (ahead != NONE) && answer_valid);
      can_answer_at_once_again: cover((busy || (INTERVAL > 1) || (BEAT_BITS > 0)) && answer_valid);
      can_hold: cover(held || (CARRIED != 0));
      can_wait: cover(offered || ((CARRIED != 0) && (INTERVAL == 1)));
      can_join: cover((enter && second && first_bit && !s_payload[0]) || (BEAT_BITS == 0));
    end
  end

endmodule

`default_nettype wire
