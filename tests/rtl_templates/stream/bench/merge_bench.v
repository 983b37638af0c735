// merge_bench: one of the blocks that take INPUTS streams in and give one out.
// KIND 0: stream_fifo of 2^DEPTH_BITS + 1 words (one input). KIND 1: stream_arbiter.
// KIND 2: stream_tree. Words are 32 bits; the ports have room for 32 inputs.
`default_nettype none

module merge_bench #(
  parameter KIND = 0,
  parameter INPUTS = 1,
  parameter DEPTH_BITS = 2,
  parameter HALF_RATE = 0,
  parameter RADIX = 4
) (
  input  wire          aclk,
  input  wire          aresetn,
  input  wire [31:0]   s_valid,
  output wire [31:0]   s_ready,
  input  wire [1023:0] s_data,
  output wire          m_valid,
  input  wire          m_ready,
  output wire [31:0]   m_data
);

  wire unused_inputs = &{s_valid, s_data};

  generate
    if (INPUTS < 32) begin : g_absent
      assign s_ready[31:INPUTS] = {(32-INPUTS){1'b0}};
    end
    if (KIND == 0) begin : g_fifo
      stream_fifo #(
        .WIDTH     (32),
        .DEPTH_BITS(DEPTH_BITS)
      ) dut (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(s_valid[0]),
        .s_axis_tready(s_ready[0]),
        .s_axis_tdata (s_data[31:0]),
        .m_axis_tvalid(m_valid),
        .m_axis_tready(m_ready),
        .m_axis_tdata (m_data)
      );
    end else if (KIND == 1) begin : g_arbiter
      stream_arbiter #(
        .INPUTS   (INPUTS),
        .WIDTH    (32),
        .HALF_RATE(HALF_RATE)
      ) dut (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(s_valid[INPUTS-1:0]),
        .s_axis_tready(s_ready[INPUTS-1:0]),
        .s_axis_tdata (s_data[32*INPUTS-1:0]),
        .m_axis_tvalid(m_valid),
        .m_axis_tready(m_ready),
        .m_axis_tdata (m_data)
      );
    end else begin : g_tree
      stream_tree #(
        .INPUTS(INPUTS),
        .WIDTH (32),
        .RADIX (RADIX)
      ) dut (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(s_valid[INPUTS-1:0]),
        .s_axis_tready(s_ready[INPUTS-1:0]),
        .s_axis_tdata (s_data[32*INPUTS-1:0]),
        .m_axis_tvalid(m_valid),
        .m_axis_tready(m_ready),
        .m_axis_tdata (m_data)
      );
    end
  endgenerate

endmodule

`default_nettype wire
