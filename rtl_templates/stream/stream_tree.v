// stream_tree: merges INPUTS streams into one through a tree of arbiters of RADIX inputs each.
// Every node is fair, and keeps the words of a packet together. Latency: one cycle per level,
// ceil(log_RADIX(INPUTS)), at least 1. One word per cycle, but at most one in two from the same
// subtree of the root. Only the root runs at full rate, so no path from a tready to a tready
// crosses the tree. Reset empties it.
`default_nettype none

module stream_tree #(
  parameter INPUTS = 8,    // streams that are merged, 1 or more
  parameter WIDTH = 8,     // bits of a word, 1 or more
  parameter RADIX = 4,     // inputs of an arbiter, 2 or more
  parameter BEAT_BITS = 0  // 0 to 8: a packet has 2^BEAT_BITS words
) (
  input  wire                    aclk,
  input  wire                    aresetn,
  input  wire [INPUTS-1:0]       s_axis_tvalid,
  output wire [INPUTS-1:0]       s_axis_tready,
  input  wire [INPUTS*WIDTH-1:0] s_axis_tdata,
  output wire                    m_axis_tvalid,
  input  wire                    m_axis_tready,
  output wire [WIDTH-1:0]        m_axis_tdata
);

  function integer streams_after;  // streams that are left after `levels` levels of arbiters
    input integer levels;
    integer k;
    begin
      streams_after = INPUTS;
      for (k = 0; k < levels; k = k + 1) begin
        streams_after = (streams_after + RADIX - 1) / RADIX;
      end
    end
  endfunction

  function integer levels_of_tree;
    input integer inputs;
    integer streams;
    begin
      levels_of_tree = 1;
      streams = (inputs + RADIX - 1) / RADIX;
      while ((RADIX > 1) && (streams > 1)) begin
        streams = (streams + RADIX - 1) / RADIX;
        levels_of_tree = levels_of_tree + 1;
      end
    end
  endfunction

  localparam LEVELS = levels_of_tree(INPUTS);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (INPUTS < 1) begin : g_refused_inputs INPUTS_is_below_1 refused (); end
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if (RADIX < 2) begin : g_refused_radix RADIX_is_below_2 refused (); end
    if ((BEAT_BITS < 0) || (BEAT_BITS > 8))
      begin : g_refused_beat_bits BEAT_BITS_is_not_0_to_8 refused (); end
  endgenerate

  genvar level;
  genvar node;
  generate
    for (level = 0; level < LEVELS; level = level + 1) begin : g_level
      localparam STREAMS = streams_after(level);
      localparam NODES   = streams_after(level + 1);

      wire [STREAMS-1:0]       in_valid;
      wire [STREAMS-1:0]       in_ready;
      wire [STREAMS*WIDTH-1:0] in_data;
      wire [NODES-1:0]         out_valid;
      wire [NODES-1:0]         out_ready;
      wire [NODES*WIDTH-1:0]   out_data;

      if (level == 0) begin : g_leaves
        assign in_valid      = s_axis_tvalid;
        assign in_data       = s_axis_tdata;
        assign s_axis_tready = in_ready;
      end else begin : g_inner
        assign in_valid                   = g_level[level-1].out_valid;
        assign in_data                    = g_level[level-1].out_data;
        assign g_level[level-1].out_ready = in_ready;
      end

      for (node = 0; node < NODES; node = node + 1) begin : g_node
        localparam FIRST  = (node * STREAMS) / NODES;
        localparam FAN_IN = ((node + 1) * STREAMS) / NODES - FIRST;

        stream_arbiter #(
          .INPUTS   (FAN_IN),
          .WIDTH    (WIDTH),
          .HALF_RATE(level < LEVELS - 1),
          .BEAT_BITS(BEAT_BITS)
        ) arbiter (
          .aclk         (aclk),
          .aresetn      (aresetn),
          .s_axis_tvalid(in_valid[FIRST +: FAN_IN]),
          .s_axis_tready(in_ready[FIRST +: FAN_IN]),
          .s_axis_tdata (in_data[FIRST*WIDTH +: FAN_IN*WIDTH]),
          .m_axis_tvalid(out_valid[node]),
          .m_axis_tready(out_ready[node]),
          .m_axis_tdata (out_data[node*WIDTH +: WIDTH])
        );
      end
    end
  endgenerate

  assign m_axis_tvalid               = g_level[LEVELS-1].out_valid;
  assign m_axis_tdata                = g_level[LEVELS-1].out_data;
  assign g_level[LEVELS-1].out_ready = m_axis_tready;

endmodule

`default_nettype wire
