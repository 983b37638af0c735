// exception_queue_proof: no push meets a full FIFO in exception_queue; `room` stays while a word is
// on offer, and comes back once the queue is empty. The FIFO's own proof covers that beats leave
// once, in order and unchanged. A pipeline that cannot wait stands in front of the queue. A word
// enters it only if there is room, and may be pushed MAY_COME - 2 cycles later.
`default_nettype none

module exception_queue_proof #(
  parameter DEPTH_BITS = 2,
  parameter MAY_COME = 3
) (
  input wire aclk,
  input wire aresetn_later,
  input wire enters,
  input wire on_offer,
  input wire tells,  // the word that arrives at the queue makes a beat
  input wire m_ready
);

  localparam DEPTH = 1 << DEPTH_BITS;
  localparam [DEPTH_BITS+1:0] NONE = 0;
  localparam [DEPTH_BITS+1:0] ONE  = 1;
  localparam [DEPTH_BITS+1:0] FULL = DEPTH[DEPTH_BITS+1:0];

  reg  started = 1'b0;
  wire aresetn = started && aresetn_later;
  wire room;
  wire arrives;
  wire push    = arrives && tells;
  wire m_valid;
  wire m_beat;

  valid_delay_line #(
    .LENGTH(MAY_COME - 2)
  ) pipeline (
    .aclk   (aclk),
    .aresetn(aresetn),
    .d      (enters),
    .q      (arrives)
  );

  exception_queue #(
    .WIDTH     (1),
    .DEPTH_BITS(DEPTH_BITS),
    .MAY_COME  (MAY_COME)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .on_offer     (on_offer),
    .room         (room),
    .push         (push),
    .beat         (1'b0),
    .m_axis_tvalid(m_valid),
    .m_axis_tready(m_ready),
    .m_axis_tdata (m_beat)
  );

  wire                  pop     = m_valid && m_ready;
  reg  [DEPTH_BITS+1:0] queued  = NONE;  // beats in the FIFO's memory and its output register
  wire [DEPTH_BITS+1:0] stored  = queued - {{(DEPTH_BITS+1){1'b0}}, m_valid};
  reg                   offered = 1'b0;  // a word was on offer in the cycle before
  reg                   held    = 1'b0;
  reg  [1:0]            quiet   = 2'd0;  // cycles with neither a beat nor room

  always @(posedge aclk) begin
    started <= 1'b1;
    offered <= aresetn && on_offer;
    held    <= aresetn && m_valid && !m_ready;
    if (!aresetn) begin
      queued <= NONE;
      quiet  <= 2'd0;
    end else begin
      queued <= queued + {{(DEPTH_BITS+1){1'b0}}, push} - {{(DEPTH_BITS+1){1'b0}}, pop};
      quiet  <= (m_valid || room) ? 2'd0 : quiet + 2'd1;
    end
  end

  always @* begin
    enters_where_room_is: assume(!enters || room);
    on_offer_where_room_is: assume(!on_offer || (room && !enters));
    if (!aresetn) begin
      assume(!enters && !on_offer);
    end
    if (started && aresetn) begin
      never_full: assert(!push || (stored != FULL));
      never_empty: assert(!m_valid || (queued != NONE));
      room_stays: assert(!offered || room);
      keeps_moving: assert(quiet < 2'd2);
      offer_holds: assert(!held || m_valid);
      can_fill: cover(queued == FULL);
      can_lack_room: cover(!room && m_valid && !m_ready);
      can_offer_long: cover(offered && (queued > FULL - MAY_COME + 1));
      can_empty: cover(pop && !push && (queued == ONE) && !room);
    end
  end

endmodule

`default_nettype wire
