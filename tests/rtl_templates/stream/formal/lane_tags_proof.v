// lane_tags_proof: each result leaves lane_tags once, in order, with the tag stored in its slot
// last. Each lane that asks in a word leaves once as a request, in order, with the word's slot and
// that tag plus the lane's number. An offer stays, and words do leave. One result and one lane of a
// word that asks are watched, chosen by the solver, and those ahead of them counted.
`default_nettype none

module lane_tags_proof #(
  parameter LANES = 2  // 1 or 2
) (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       start,
  input wire       start_slot,
  input wire [1:0] start_tag,
  input wire       s_valid,
  input wire       s_slot,
  input wire [1:0] s_asks,
  input wire [1:0] s_result,  // the verdict of lane 0
  input wire       request_ready,
  input wire       m_ready,
  input wire       choose  // the word that enters is watched from now on, if no other of its kind is
);

  localparam [2:0] NONE = 0;
  localparam [2:0] ONE  = 1;

  (* anyconst *) reg watched;  // a slot
  (* anyconst *) reg watched_lane;

  wire               s_ready;
  wire [1:0]         asks = (LANES == 1) ? {1'b0, s_asks[0]} : s_asks;
  wire               request_valid;
  wire               request_slot;
  wire [1:0]         request_tag;
  wire               m_valid;
  wire [8*LANES-1:0] m_result;
  wire [1:0]         m_tag;
  wire [4*LANES-1:0] result;

  reg                started = 1'b0;
  wire               aresetn = started && aresetn_later;

  assign result[2*LANES-1:0]       = s_result;  // with LANES = 2, zeros above
  assign result[4*LANES-1:2*LANES] = 0;

  lane_tags #(
    .LANES    (LANES),
    .TAG_BITS (2),
    .SLOT_BITS(1)
  ) dut (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .start_valid     (start),
    .start_slot      (start_slot),
    .start_tag       (start_tag),
    .s_result_valid  (s_valid),
    .s_result_ready  (s_ready),
    .s_result_slot   (s_slot),
    .s_result_asks   (asks[LANES-1:0]),
    .s_result        (result),
    .m_request_tvalid(request_valid),
    .m_request_tready(request_ready),
    .m_request_tdata ({request_slot, request_tag}),
    .m_axis_tvalid   (m_valid),
    .m_axis_tready   (m_ready),
    .m_axis_tdata    (m_result),
    .m_axis_tuser    (m_tag)
  );

  reg  [1:0] tag;               // the tag that is stored in the watched slot
  reg        stored   = 1'b0;   // a tag is stored in the watched slot
  reg  [2:0] results  = NONE;   // results inside
  reg  [2:0] requests = NONE;   // requests that will leave
  reg        watching = 1'b0;   // a result is watched
  reg  [2:0] ahead    = NONE;
  reg  [1:0] its_tag;
  reg  [1:0] its_result;
  reg        asking   = 1'b0;   // a lane of a word is watched
  reg  [2:0] asks_ahead = NONE;
  reg  [1:0] asked_tag;
  reg        held     = 1'b0;
  reg  [3:0] held_result;
  reg        kept     = 1'b0;
  reg  [2:0] kept_request;
  reg  [2:0] quiet    = NONE;   // cycles without a request although one will leave

  wire       enter     = s_valid && s_ready;
  wire       is_result = enter && (asks == 2'd0);
  wire [1:0] more      = enter ? {1'b0, asks[0]} + {1'b0, asks[1]} : 2'd0;
  wire       leave     = m_valid && m_ready;
  wire       sent      = request_valid && request_ready;
  wire       mine      = enter && (s_slot == watched) && stored && choose;

  always @(posedge aclk) begin
    started      <= 1'b1;
    held         <= aresetn && m_valid && !m_ready;
    held_result  <= {m_result[1:0], m_tag};
    kept         <= aresetn && request_valid && !request_ready;
    kept_request <= {request_slot, request_tag};
    if (start && (start_slot == watched)) begin
      tag    <= start_tag;
      stored <= 1'b1;
    end
    if (!aresetn) begin
      results  <= NONE;
      requests <= NONE;
      watching <= 1'b0;
      asking   <= 1'b0;
      quiet    <= NONE;
    end else begin
      results  <= results + {2'd0, is_result} - {2'd0, leave};
      requests <= requests + {1'b0, more} - {2'd0, sent};
      quiet    <= ((requests != NONE) && !request_valid) ? quiet + ONE : NONE;
      if (watching && leave) begin
        ahead    <= ahead - ONE;
        watching <= (ahead != NONE);
      end
      if (mine && is_result && !watching) begin
        watching   <= 1'b1;
        ahead      <= results - {2'd0, leave};
        its_tag    <= tag;
        its_result <= s_result;
      end
      if (asking && sent) begin
        asks_ahead <= asks_ahead - ONE;
        asking     <= (asks_ahead != NONE);
      end
      if (mine && asks[watched_lane] && !asking) begin
        asking     <= 1'b1;
        asks_ahead <= requests - {2'd0, sent} + {2'd0, watched_lane && asks[0]};
        asked_tag  <= tag + {1'b0, watched_lane};
      end
    end
  end

  always @* begin
    if (!aresetn) begin
      assume(!start && !s_valid);
    end
    not_while_read: assume(!start || !enter || (start_slot != s_slot));
    if (started && aresetn) begin
      no_result_made_up: assert(!m_valid || (results != NONE));
      no_request_made_up: assert(!request_valid || (requests != NONE));
      same_result: assert(!m_valid || !watching || (ahead != NONE) ||
                          ({m_tag, m_result[1:0]} == {its_tag, its_result}));
      same_request: assert(!request_valid || !asking || (asks_ahead != NONE) ||
                           ({request_slot, request_tag} == {watched, asked_tag}));
      result_leaves_at_once: assert((results == NONE) || m_valid);
      request_leaves_soon: assert(quiet < ((LANES == 1) ? 3'd2 : 3'd4));
      result_holds: assert(!held || (m_valid && ({m_result[1:0], m_tag} == held_result)));
      request_holds: assert(!kept || (request_valid && ({request_slot, request_tag} == kept_request)));
      can_leave: cover(watching && (ahead == NONE) && leave && (its_tag == 2'd2));
      can_ask: cover(asking && (asks_ahead == NONE) && sent && (watched_lane == (LANES == 2)) &&
                     (asked_tag == 2'd0));
      can_ask_for_two_words: cover(requests > LANES);
      can_hold: cover(held && kept);
    end
  end

endmodule

`default_nettype wire
