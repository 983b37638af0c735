// fifo_proof: words leave stream_fifo once, unchanged and in the order in which they entered, whenever
// it is reset. One word at a time is watched, chosen by the solver, and the words ahead of it counted.
`default_nettype none

module fifo_proof #(
  parameter DEPTH_BITS = 1
) (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       s_valid,
  input wire [1:0] s_data,
  input wire       m_ready,
  input wire       choose  // the word that enters is watched from now on, if no other is
);

  localparam CAPACITY = (1 << DEPTH_BITS) + 1;
  localparam [DEPTH_BITS+1:0] NONE = 0;
  localparam [DEPTH_BITS+1:0] FULL = CAPACITY[DEPTH_BITS+1:0];

  wire       s_ready;
  wire       m_valid;
  wire [1:0] m_data;

  reg        started = 1'b0;
  wire       aresetn = started && aresetn_later;

  stream_fifo #(
    .WIDTH     (2),
    .DEPTH_BITS(DEPTH_BITS)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_valid),
    .s_axis_tready(s_ready),
    .s_axis_tdata (s_data),
    .m_axis_tvalid(m_valid),
    .m_axis_tready(m_ready),
    .m_axis_tdata (m_data)
  );

  wire                  enter = s_valid && s_ready;
  wire                  leave = m_valid && m_ready;
  reg  [DEPTH_BITS+1:0] inside   = NONE;
  reg  [DEPTH_BITS+1:0] ahead    = NONE;  // words inside that are ahead of the watched word
  reg                   watching = 1'b0;
  reg  [1:0]            watched_word;
  wire                  watched_leaves = watching && leave && (ahead == NONE);
  reg                   held     = 1'b0;
  reg  [1:0]            held_data;
  reg                   waited   = 1'b0;  // a word was inside in the cycle before, and none was offered

  always @(posedge aclk) begin
    started   <= 1'b1;
    held      <= aresetn && m_valid && !m_ready;
    held_data <= m_data;
    waited    <= aresetn && (inside != NONE) && !m_valid;
    if (!aresetn) begin
      inside   <= NONE;
      watching <= 1'b0;
    end else begin
      inside <= inside + {{(DEPTH_BITS+1){1'b0}}, enter} - {{(DEPTH_BITS+1){1'b0}}, leave};
      if (watched_leaves) begin
        watching <= 1'b0;
      end
      if (watching && leave) begin
        ahead <= ahead - 1'b1;
      end
      if (enter && choose && !watching) begin
        watching     <= 1'b1;
        watched_word <= s_data;
        ahead        <= inside - {{(DEPTH_BITS+1){1'b0}}, leave};
      end
    end
  end

  always @* begin
    if (!aresetn) begin
      assume(!s_valid);
    end
    if (started && aresetn) begin
      no_overflow: assert(inside <= FULL);
      no_underflow: assert(!m_valid || (inside != NONE));
      full_only_at_capacity: assert(s_ready || (inside >= FULL - 1'b1));
      same_word: assert(!m_valid || !watching || (ahead != NONE) || (m_data == watched_word));
      watched_is_inside: assert(!watching || (ahead < inside));
      comes_in_two_cycles: assert(!waited || m_valid);
      holds_until_taken: assert(!held || (m_valid && (m_data == held_data)));
      can_fill: cover(inside == FULL);
      can_refuse: cover(!s_ready);
      can_wait_behind_all: cover(watching && (ahead == FULL - 1'b1));
      can_leave: cover(watched_leaves && (watched_word == 2'd2));
      can_drain: cover(waited && leave && (inside == 1));
      can_hold: cover(held);
    end
  end

endmodule

`default_nettype wire
