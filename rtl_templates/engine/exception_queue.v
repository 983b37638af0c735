// exception_queue: a FIFO behind a pipeline that cannot wait. `room` says that a word may enter the
// pipeline: the FIFO has a place for its beat and for those of all words before it. While
// `on_offer` is 1, a `room` of 1 stays 1: a place is reserved for the word on offer elsewhere, and
// no other word enters meanwhile.
`default_nettype none

module exception_queue #(
  parameter WIDTH = 8,       // bits of a beat, 1 or more
  parameter DEPTH_BITS = 5,  // 1 to 30: the queue holds 2^DEPTH_BITS beats, more than MAY_COME
  // the largest number of words, the admitted one included, whose beats may not have been counted
  // when `room` is decided; 1 or more
  parameter MAY_COME = 11
) (
  input  wire             aclk,
  input  wire             aresetn,
  input  wire             on_offer,
  output wire             room,
  input  wire             push,
  input  wire [WIDTH-1:0] beat,
  output wire             m_axis_tvalid,
  input  wire             m_axis_tready,
  output wire [WIDTH-1:0] m_axis_tdata
);

  localparam MOST_QUEUED = (1 << DEPTH_BITS) - MAY_COME;
  localparam [DEPTH_BITS+1:0] MOST = MOST_QUEUED[DEPTH_BITS+1:0];
  localparam [DEPTH_BITS+1:0] NONE = 0;
  localparam [DEPTH_BITS+1:0] ONE  = 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (MAY_COME < 1) begin : g_refused_may_come MAY_COME_is_below_1 refused (); end
    if ((DEPTH_BITS < 1) || (DEPTH_BITS > 30)) begin : g_refused_depth_bits
      DEPTH_BITS_is_not_1_to_30 refused ();
    end else if ((1 << DEPTH_BITS) <= MAY_COME) begin : g_refused_depth
      DEPTH_BITS_is_too_small_for_MAY_COME refused ();
    end
  endgenerate

  wire pop = m_axis_tvalid && m_axis_tready;
  wire unused_ready;

  stream_fifo #(
    .WIDTH     (WIDTH),
    .DEPTH_BITS(DEPTH_BITS)
  ) beats (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(push),
    .s_axis_tready(unused_ready),
    .s_axis_tdata (beat),
    .m_axis_tvalid(m_axis_tvalid),
    .m_axis_tready(m_axis_tready),
    .m_axis_tdata (m_axis_tdata)
  );

  // A beat that leaves is counted one cycle later, since it is known late in a cycle whether it
  // leaves. A place may count as taken for a cycle too long without harm.
  reg [DEPTH_BITS+1:0] queued_q;
  reg                  popped_q;
  reg                  room_q;

  assign room = room_q;

  always @(posedge aclk) begin
    if (!aresetn) begin
      queued_q <= NONE;
      popped_q <= 1'b0;
      room_q   <= 1'b1;
    end else begin
      popped_q <= pop;
      if (push && !popped_q) begin
        queued_q <= queued_q + ONE;
      end
      if (popped_q && !push) begin
        queued_q <= queued_q - ONE;
      end
      room_q <= (queued_q <= MOST) || on_offer;
    end
  end

endmodule

`default_nettype wire
