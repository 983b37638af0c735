// upsizer_proof: stream_upsizer gives out each packet once, in order, with all of its words in
// their places and the sideband that came beside the last. At any time it takes all words of a
// packet except the last, and its offers stay until they are taken. One packet at a time is
// watched, chosen by the solver.
`default_nettype none

module upsizer_proof #(
  parameter BEAT_BITS = 2
) (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       s_valid,
  input wire       s_data,
  input wire       s_user,
  input wire       m_ready,
  input wire       choose  // the packet that begins is watched, if no other is
);

  localparam BEATS = 1 << BEAT_BITS;
  localparam [3:0] FIRST = 0;
  localparam [3:0] LAST  = BEATS - 1;

  wire             s_ready;
  wire             m_valid;
  wire [BEATS-1:0] m_data;
  wire             m_user;
  wire             m_watched;

  reg              started = 1'b0;
  wire             aresetn = started && aresetn_later;

  reg  [3:0]       beat     = FIRST;  // the number of the word that comes next
  reg              chosen   = 1'b0;   // the packet that comes in is watched
  reg              watching = 1'b0;   // a watched packet has come in and has not left
  reg              full     = 1'b0;   // a packet has come in and has not left
  reg  [BEATS-1:0] expected;
  reg              expected_user;
  reg              held     = 1'b0;
  reg  [BEATS+1:0] held_word;

  wire             enter       = s_valid && s_ready;
  wire             now_chosen  = (beat == FIRST) ? choose && !watching : chosen;
  wire             completes   = enter && (beat == LAST);
  wire             leave       = m_valid && m_ready;

  stream_upsizer #(
    .WIDTH    (1),
    .USER_BITS(2),
    .BEAT_BITS(BEAT_BITS)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_valid),
    .s_axis_tready(s_ready),
    .s_axis_tdata (s_data),
    .s_axis_tuser ({now_chosen, s_user}),
    .m_axis_tvalid(m_valid),
    .m_axis_tready(m_ready),
    .m_axis_tdata (m_data),
    .m_axis_tuser ({m_watched, m_user})
  );

  always @(posedge aclk) begin
    started   <= 1'b1;
    held      <= aresetn && m_valid && !m_ready;
    held_word <= {m_watched, m_user, m_data};
    if (!aresetn) begin
      beat     <= FIRST;
      chosen   <= 1'b0;
      watching <= 1'b0;
      full     <= 1'b0;
    end else begin
      full     <= completes || (full && !leave);
      watching <= (completes && now_chosen) || (watching && !leave);
      if (enter) begin
        beat   <= (beat == LAST) ? FIRST : beat + 4'd1;
        chosen <= now_chosen && (beat != LAST);
      end
    end
    if (enter && now_chosen) begin
      expected[beat] <= s_data;
      expected_user  <= s_user;
    end
  end

  always @* begin
    if (!aresetn) begin
      assume(!s_valid);
    end
    if (started && aresetn) begin
      leaves_once_and_soon: assert(m_valid == full);
      leaves_in_order: assert(!m_valid || (m_watched == watching));
      leaves_unchanged: assert(!m_valid || !m_watched || ({m_user, m_data} == {expected_user, expected}));
      takes_all_but_the_last: assert(s_ready || ((beat == LAST) && m_valid && !m_ready));
      holds_until_taken: assert(!held || (m_valid && ({m_watched, m_user, m_data} == held_word)));
      can_leave: cover(leave && m_watched && m_user && !(&m_data) && |m_data);
      can_refuse: cover(!s_ready);
      can_hold: cover(held);
      can_follow_at_once: cover(completes && leave);
    end
  end

endmodule

`default_nettype wire
