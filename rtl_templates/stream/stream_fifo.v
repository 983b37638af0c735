// stream_fifo: first in, first out; a memory, and an output register for one word more. Latency 2,
// one word per cycle. tready comes from registers, so the FIFO also cuts the path from
// m_axis_tready to s_axis_tready. Reset empties it.
`default_nettype none

module stream_fifo #(
  parameter WIDTH = 8,      // bits of a word, 1 or more
  parameter DEPTH_BITS = 4  // 1 to 30: the memory holds 2^DEPTH_BITS words
) (
  input  wire             aclk,
  input  wire             aresetn,
  input  wire             s_axis_tvalid,
  output wire             s_axis_tready,
  input  wire [WIDTH-1:0] s_axis_tdata,
  output wire             m_axis_tvalid,
  input  wire             m_axis_tready,
  output wire [WIDTH-1:0] m_axis_tdata
);

  localparam [DEPTH_BITS:0] ONE = 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if (DEPTH_BITS < 1) begin : g_refused_depth_bits DEPTH_BITS_is_below_1 refused (); end
  endgenerate

  // One bit more than an address: equal pointers mean empty; if only that bit differs, full.
  reg  [DEPTH_BITS:0] write_q;
  reg  [DEPTH_BITS:0] read_q;
  reg                 m_valid_q;

  wire same_address = (write_q[DEPTH_BITS-1:0] == read_q[DEPTH_BITS-1:0]);
  wire same_lap     = (write_q[DEPTH_BITS] == read_q[DEPTH_BITS]);
  wire empty        = same_address && same_lap;
  wire full         = same_address && !same_lap;
  wire write        = s_axis_tvalid && !full;
  wire read         = !empty && (!m_valid_q || m_axis_tready);

  always @(posedge aclk) begin
    if (!aresetn) begin
      write_q   <= {(DEPTH_BITS+1){1'b0}};
      read_q    <= {(DEPTH_BITS+1){1'b0}};
      m_valid_q <= 1'b0;
    end else begin
      if (write) begin
        write_q <= write_q + ONE;
      end
      if (read) begin
        read_q <= read_q + ONE;
      end
      m_valid_q <= read || (m_valid_q && !m_axis_tready);
    end
  end

  dual_port_memory #(
    .WIDTH       (WIDTH),
    .ADDRESS_BITS(DEPTH_BITS)
  ) memory (
    .aclk         (aclk),
    .write_enable (write),
    .write_address(write_q[DEPTH_BITS-1:0]),
    .write_data   (s_axis_tdata),
    .read_enable  (read),
    .read_address (read_q[DEPTH_BITS-1:0]),
    .read_data    (m_axis_tdata)
  );

  assign s_axis_tready = !full;
  assign m_axis_tvalid = m_valid_q;

endmodule

`default_nettype wire
