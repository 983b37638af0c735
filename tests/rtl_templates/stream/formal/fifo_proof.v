// fifo_proof: word number k to leave stream_fifo is word number k that entered, for every k.
`default_nettype none

module fifo_proof #(
  parameter DEPTH_BITS = 1
) (
  input wire       aclk,
  input wire       s_valid,
  input wire [1:0] s_data,
  input wire       m_ready,
  input wire [4:0] watched
);

  localparam CAPACITY = (1 << DEPTH_BITS) + 1;

  wire       s_ready;
  wire       m_valid;
  wire [1:0] m_data;

  reg        aresetn = 1'b0;
  reg  [4:0] last_watched;
  reg  [4:0] entered = 5'd0;
  reg  [4:0] left    = 5'd0;
  reg  [1:0] watched_word;
  reg        held    = 1'b0;
  reg  [1:0] held_data;

  stream_fifo #(
    .WIDTH     (2),
    .DEPTH_BITS(DEPTH_BITS)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_valid && aresetn),
    .s_axis_tready(s_ready),
    .s_axis_tdata (s_data),
    .m_axis_tvalid(m_valid),
    .m_axis_tready(m_ready),
    .m_axis_tdata (m_data)
  );

  wire enter = aresetn && s_valid && s_ready;
  wire leave = aresetn && m_valid && m_ready;

  always @(posedge aclk) begin
    aresetn <= 1'b1;
    last_watched <= watched;
    entered <= entered + {4'd0, enter};
    left    <= left + {4'd0, leave};
    held    <= aresetn && m_valid && !m_ready;
    if (enter && (entered == watched)) begin
      watched_word <= s_data;
    end
    held_data <= m_data;
  end

  always @* begin
    if (aresetn) begin
      watched_is_constant: assume(watched == last_watched);
      no_overflow: assert(entered - left <= CAPACITY);
      no_underflow: assert(!m_valid || (entered != left));
      full_only_at_capacity: assert(s_ready || (entered - left >= CAPACITY - 1));
      if (m_valid && (left == watched)) begin
        same_word: assert(m_data == watched_word);
      end
      if (held) begin
        holds_until_taken: assert(m_valid && (m_data == held_data));
      end
      can_fill: cover(!s_ready && m_valid);
      can_drain: cover((left == 5'd4) && (entered == left));
      can_hold: cover(held);
    end
  end

endmodule

`default_nettype wire
