// marked_lanes_proof: the numbers of each word's marked lanes leave marked_lanes once each, the
// lowest first; the word is taken with the last of them, and they do leave.
`default_nettype none

module marked_lanes_proof #(
  parameter LANES = 3
) (
  input wire             aclk,
  input wire             aresetn_later,
  input wire             s_valid,
  input wire [LANES-1:0] s_lanes,
  input wire             m_ready
);

  wire       s_ready;
  wire       m_valid;
  wire [5:0] m_lane;

  reg        started = 1'b0;
  wire       aresetn = started && aresetn_later;

  marked_lanes #(
    .LANES(LANES)
  ) dut (
    .aclk        (aclk),
    .aresetn     (aresetn),
    .s_word_valid(s_valid),
    .s_word_ready(s_ready),
    .s_word_lanes(s_lanes),
    .m_lane_valid(m_valid),
    .m_lane_ready(m_ready),
    .m_lane      (m_lane)
  );

  reg  [LANES-1:0] taken = 0;  // lanes of the word on offer whose numbers have left
  reg              offered = 1'b0;
  reg  [LANES-1:0] offered_lanes;
  reg              held = 1'b0;
  reg  [5:0]       held_lane;
  reg              waited = 1'b0;
  wire [LANES-1:0] left    = s_lanes & ~taken;
  wire [LANES-1:0] lowest  = left & (~left + 1'b1);
  wire [LANES-1:0] named   = {{(LANES-1){1'b0}}, 1'b1} << m_lane;
  wire             leaves  = m_valid && m_ready;

  always @(posedge aclk) begin
    started       <= 1'b1;
    offered       <= aresetn && s_valid && !s_ready;
    offered_lanes <= s_lanes;
    held          <= aresetn && m_valid && !m_ready;
    held_lane     <= m_lane;
    waited        <= aresetn && s_valid && !m_valid;
    if (!aresetn || (s_valid && s_ready)) begin
      taken <= 0;
    end else if (leaves) begin
      taken <= taken | named;
    end
  end

  always @* begin
    if (!aresetn) begin
      assume(!s_valid);
    end
    assume(!s_valid || (s_lanes != 0));
    assume(!offered || !aresetn || (s_valid && (s_lanes == offered_lanes)));
    if (started && aresetn) begin
      of_a_word: assert(!m_valid || s_valid);
      lowest_first: assert(!m_valid || (named == lowest));
      taken_with_the_last: assert(!s_valid || (s_ready == (leaves && (left == lowest))));
      holds_until_taken: assert(!held || (m_valid && (m_lane == held_lane)));
      comes_in_one_cycle: assert(!waited || m_valid);
      can_name_all: cover(s_valid && s_ready && (&s_lanes));
      can_name_the_last_alone: cover(s_valid && s_ready && (s_lanes == named) && named[LANES-1]);
      can_follow_at_once: cover(leaves && (taken != 0));
    end
  end

endmodule

`default_nettype wire
