// stream_upsizer: joins each packet of words into one wide word, the first one lowest. The wide
// word has the s_axis_tuser of the packet's last word. It leaves one cycle after that word came.
// While it waits, the words of the next packet are taken except the last, which may come in the
// cycle in which the wide word leaves. Reset forgets all.
`default_nettype none

module stream_upsizer #(
  parameter WIDTH = 8,      // bits of a word, 1 or more
  parameter USER_BITS = 4,  // bits of tuser, 1 or more
  parameter BEAT_BITS = 2   // 0 to 8: a packet has 2^BEAT_BITS words; 0: wires
) (
  input  wire                          aclk,
  input  wire                          aresetn,
  input  wire                          s_axis_tvalid,
  output wire                          s_axis_tready,
  input  wire [WIDTH-1:0]              s_axis_tdata,
  input  wire [USER_BITS-1:0]          s_axis_tuser,
  output wire                          m_axis_tvalid,
  input  wire                          m_axis_tready,
  output wire [(WIDTH<<BEAT_BITS)-1:0] m_axis_tdata,
  output wire [USER_BITS-1:0]          m_axis_tuser
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if (USER_BITS < 1) begin : g_refused_user_bits USER_BITS_is_below_1 refused (); end
    if ((BEAT_BITS < 0) || (BEAT_BITS > 8))
      begin : g_refused_beat_bits BEAT_BITS_is_not_0_to_8 refused (); end
  endgenerate

  generate
    if (BEAT_BITS == 0) begin : g_wires
      wire unused_clock = aclk && aresetn;

      assign s_axis_tready = m_axis_tready;
      assign m_axis_tvalid = s_axis_tvalid;
      assign m_axis_tdata  = s_axis_tdata;
      assign m_axis_tuser  = s_axis_tuser;
    end else begin : g_join
      localparam EARLIER_BITS = (WIDTH << BEAT_BITS) - WIDTH;
      localparam [BEAT_BITS-1:0] ONE = 1;

      reg  [BEAT_BITS-1:0]            beat_q;     // the number of the next word
      reg  [EARLIER_BITS-1:0]         earlier_q;  // the packet's words so far, the last one highest
      reg                             m_valid_q;
      reg  [EARLIER_BITS+WIDTH-1:0]   m_data_q;
      reg  [USER_BITS-1:0]            m_user_q;
      wire [EARLIER_BITS+WIDTH-1:0]   joined = {s_axis_tdata, earlier_q};
      wire                            last   = &beat_q;
      wire                            take   = s_axis_tvalid && s_axis_tready;
      wire                            load   = take && last;

      always @(posedge aclk) begin
        if (!aresetn) begin
          beat_q    <= {BEAT_BITS{1'b0}};
          m_valid_q <= 1'b0;
        end else begin
          if (take) begin
            beat_q <= beat_q + ONE;
          end
          m_valid_q <= load || (m_valid_q && !m_axis_tready);
        end
      end

      always @(posedge aclk) begin
        if (take) begin
          earlier_q <= joined[WIDTH +: EARLIER_BITS];
        end
        if (load) begin
          m_data_q <= joined;
          m_user_q <= s_axis_tuser;
        end
      end

      assign s_axis_tready = !last || !m_valid_q || m_axis_tready;
      assign m_axis_tvalid = m_valid_q;
      assign m_axis_tdata  = m_data_q;
      assign m_axis_tuser  = m_user_q;
    end
  endgenerate

endmodule

`default_nettype wire
