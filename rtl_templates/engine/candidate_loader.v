// candidate_loader: numbers the candidates of one load and sends them on, one a cycle.
// Exactly CANDIDATES words leave for a load. If fewer come, the last one is repeated; it ties with
// itself, so it never wins. Surplus ones are accepted but not sent, and raise `overrun`, which the
// next load clears. `complete` says that all words have left. The next load enters once nothing is
// inside; while it waits, `waiting` keeps rows out. Latency 1. Reset forgets the load.
`default_nettype none

module candidate_loader #(
  parameter CANDIDATES = 3,       // candidates of a load, 2 to 2^INDEX_BITS
  parameter CANDIDATE_BITS = 32,  // bits of a candidate, 1 or more
  parameter INDEX_BITS = 2        // bits of a candidate's index, 1 to 30
) (
  input  wire                      aclk,
  input  wire                      aresetn,
  input  wire                      s_axis_tvalid,
  output wire                      s_axis_tready,
  input  wire [CANDIDATE_BITS-1:0] s_axis_tdata,
  input  wire                      s_axis_tlast,
  output wire                      m_word_valid,
  output wire [INDEX_BITS-1:0]     m_word_index,
  output wire [CANDIDATE_BITS-1:0] m_word_data,
  input  wire                      idle,
  output wire                      complete,
  output wire                      waiting,
  output wire                      overrun
);

  localparam [INDEX_BITS:0] ONE = 1;
  localparam [INDEX_BITS:0] ALL = CANDIDATES[INDEX_BITS:0];

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (CANDIDATES < 2) begin : g_refused_candidates CANDIDATES_is_below_2 refused (); end
    if (CANDIDATE_BITS < 1)
      begin : g_refused_candidate_bits CANDIDATE_BITS_is_below_1 refused (); end
    if (INDEX_BITS < 1) begin : g_refused_index_bits INDEX_BITS_is_below_1 refused (); end
    if (INDEX_BITS > 30) begin : g_refused_index_shift INDEX_BITS_is_above_30 refused (); end
    if (((CANDIDATES - 1) >>> INDEX_BITS) > 0)
      begin : g_refused_last_candidate INDEX_BITS_is_too_small_for_CANDIDATES refused (); end
  endgenerate

  reg  [INDEX_BITS:0] sent_q;      // words of this load
  reg                 ended_q;     // the load's last candidate has come
  reg                 complete_q;
  reg                 waiting_q;
  reg                 overrun_q;
  wire                all_sent = (sent_q == ALL);
  wire                accept   = s_axis_tvalid && !ended_q;
  wire                keep     = accept && !all_sent;
  wire                repeated = ended_q && !all_sent;
  wire                send     = keep || repeated;

  // In the cycle that finds the chain idle no row may enter, so the chain stays idle.
  wire                restart  = !aresetn || (complete_q && waiting_q && idle);

  always @(posedge aclk) begin
    if (restart) begin
      sent_q     <= {(INDEX_BITS+1){1'b0}};
      ended_q    <= 1'b0;
      complete_q <= 1'b0;
      waiting_q  <= 1'b0;
      overrun_q  <= 1'b0;
    end else begin
      if (send) begin
        sent_q <= sent_q + ONE;
      end
      ended_q    <= ended_q || (accept && s_axis_tlast);
      complete_q <= ended_q && all_sent;
      waiting_q  <= ended_q && s_axis_tvalid;
      overrun_q  <= overrun_q || (accept && all_sent);
    end
  end

  reg                      word_valid_q;
  reg [INDEX_BITS-1:0]     word_index_q;
  reg [CANDIDATE_BITS-1:0] word_data_q;  // keeps its value while it is repeated

  always @(posedge aclk) begin
    if (!aresetn) begin
      word_valid_q <= 1'b0;
    end else begin
      word_valid_q <= send;
    end
  end

  always @(posedge aclk) begin
    word_index_q <= sent_q[INDEX_BITS-1:0];
    if (keep) begin
      word_data_q <= s_axis_tdata;
    end
  end

  assign s_axis_tready = !ended_q;
  assign m_word_valid  = word_valid_q;
  assign m_word_index  = word_index_q;
  assign m_word_data   = word_data_q;
  assign complete      = complete_q;
  assign waiting       = waiting_q;
  assign overrun       = overrun_q;

endmodule

`default_nettype wire
