// pair_expander: turns the beats of segments into pairs, one a cycle: first the reported pairs of a
// beat, to m_report, then the undecided ones, to m_pair. A beat is {codes, index j, index base}, as
// pair_segment makes it; lane k's code belongs to the pair (base + k, j). A pair leaves as the tag
// {j, base} and the lane k. The adder that computes i is behind the next register, since the choice
// of the lane takes most of a cycle.
//
// The beat with tlast leaves on both streams, for lane 0. Interval 1 for each pair, latency 1.
// Reset empties it.
`default_nettype none

module pair_expander #(
  parameter LANES = 8,        // lanes in lock step, 1 or more
  parameter INDEX_BITS = 10,  // bits of an item's index, 1 or more
  // 0 to 15: bit v is 1 where verdict v is reported; 0 promises that none is
  parameter REPORT = 11,
  parameter CODE_BITS = 3,    // bits of a code: 3, or 2 if at most one verdict is reported
  // 0 or 1; 1 needs CODE_BITS = 2. 1: all reported pairs of a beat leave together, as {flags, j,
  // base} of lane 0, with one flag per lane. 0: one by one.
  parameter BITMAP = 0,
  // 0: undecided pairs leave as reports, one by one, with the flag `undecided`; 1: on m_pair
  parameter RECOMPUTE = 1
) (
  input  wire                                    aclk,
  input  wire                                    aresetn,
  input  wire                                    s_axis_tvalid,
  output wire                                    s_axis_tready,
  input  wire [2*INDEX_BITS+LANES*CODE_BITS-1:0] s_axis_tdata,
  input  wire                                    s_axis_tlast,
  output wire                                    m_report_tvalid,
  input  wire                                    m_report_tready,
  output wire [2*INDEX_BITS-1:0]                 m_report_tag,
  output wire [INDEX_BITS-1:0]                   m_report_lane,
  output wire [(BITMAP != 0 ? LANES : 1)-1:0]    m_report_flags,
  output wire [1:0]                              m_report_verdict,
  output wire                                    m_report_undecided,
  output wire                                    m_report_tlast,
  output wire                                    m_pair_tvalid,
  input  wire                                    m_pair_tready,
  output wire [2*INDEX_BITS-1:0]                 m_pair_tag,
  output wire [INDEX_BITS-1:0]                   m_pair_lane,
  output wire                                    m_pair_tlast
);

  localparam FLAG_BITS  = (BITMAP != 0) ? LANES : 1;
  localparam [FLAG_BITS-1:0] ONE_FLAG = 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (LANES < 1) begin : g_refused_lanes LANES_is_below_1 refused (); end
    if (INDEX_BITS < 1) begin : g_refused_index_bits INDEX_BITS_is_below_1 refused (); end
    if ((REPORT >> 4) != 0) begin : g_refused_report REPORT_is_not_0_to_15 refused (); end
    if ((CODE_BITS != 3) && ((CODE_BITS != 2) || ((REPORT & (REPORT - 1)) != 0)))
    begin : g_refused_code_bits
      CODE_BITS_is_not_3_nor_2_for_one_verdict refused ();
    end
    if ((BITMAP != 0) && (CODE_BITS != 2))
      begin : g_refused_bitmap BITMAP_is_for_one_verdict refused (); end
  endgenerate

  // The current beat, with the codes of the lanes that have not left.
  reg                        valid_q;
  reg                        last_q;
  reg                        report_sent_q;  // the beat with tlast has left on m_report
  reg                        pair_sent_q;    // the beat with tlast has left on m_pair
  reg  [LANES*CODE_BITS-1:0] codes_q;
  reg  [INDEX_BITS-1:0]      base_q;
  reg  [INDEX_BITS-1:0]      index_j_q;

  wire [LANES-1:0]           reported;
  wire [LANES-1:0]           undecided;
  wire                       reports = (reported != {LANES{1'b0}});

  // The lowest lane with a reported pair, and the lowest with an undecided one. Both are found
  // before it is known which kind leaves.
  reg  [INDEX_BITS-1:0] lane_reported;
  reg  [INDEX_BITS-1:0] lane_undecided;
  integer               l;

  always @* begin
    lane_reported  = {INDEX_BITS{1'b0}};
    lane_undecided = {INDEX_BITS{1'b0}};
    for (l = LANES - 1; l >= 0; l = l - 1) begin
      if (reported[l]) begin
        lane_reported = l[INDEX_BITS-1:0];
      end
      if (undecided[l]) begin
        lane_undecided = l[INDEX_BITS-1:0];
      end
    end
  end

  localparam [LANES-1:0] ONE_LANE = 1;
  wire [LANES-1:0]      waiting = reports ? reported : undecided;
  wire [LANES-1:0]      lowest  = waiting & (~waiting + ONE_LANE);
  wire [INDEX_BITS-1:0] lane    = reports ? lane_reported : lane_undecided;
  reg  [1:0]            verdict;

  wire [LANES-1:0]      leaving = (reports && (BITMAP != 0)) ? reported : lowest;
  wire                  is_report = reports || (RECOMPUTE == 0);
  wire                  left = is_report ? m_report_tready : m_pair_tready;
  wire                  final_one = ((reported | undecided) == leaving);
  wire                  last_left = (report_sent_q || m_report_tready) &&
                                    (pair_sent_q || m_pair_tready);
  wire                  together = reports && (BITMAP != 0);

  assign s_axis_tready = !valid_q || (last_q ? last_left : (left && final_one));

  genvar k;
  generate
    for (k = 0; k < LANES; k = k + 1) begin : g_lane
      wire [CODE_BITS-1:0] code = codes_q[k*CODE_BITS +: CODE_BITS];

      assign reported[k]  = code[CODE_BITS-1] && (REPORT != 0);
      assign undecided[k] = !code[CODE_BITS-1] && code[0];
    end
  endgenerate

  generate
    if (CODE_BITS == 2) begin : g_one_verdict
      wire [1:0] only = REPORT[3] ? 2'd3 : (REPORT[2] ? 2'd2 : {1'b0, REPORT[1]});

      always @* begin
        verdict = only;
      end
    end else begin : g_any_verdict
      integer v;

      always @* begin
        verdict = 2'b00;
        for (v = 0; v < LANES; v = v + 1) begin
          if (lowest[v]) begin
            verdict = codes_q[v*CODE_BITS +: 2];
          end
        end
      end
    end
  endgenerate

  always @(posedge aclk) begin
    if (!aresetn) begin
      valid_q       <= 1'b0;
      report_sent_q <= 1'b0;
      pair_sent_q   <= 1'b0;
    end else begin
      if (s_axis_tready) begin
        valid_q <= s_axis_tvalid;
      end
      report_sent_q <= valid_q && last_q && !s_axis_tready && (report_sent_q || m_report_tready);
      pair_sent_q   <= valid_q && last_q && !s_axis_tready && (pair_sent_q || m_pair_tready);
    end
  end

  integer c;

  always @(posedge aclk) begin
    if (s_axis_tready) begin
      {codes_q, index_j_q, base_q} <= s_axis_tdata;
      last_q                       <= s_axis_tlast;
    end else if (left && !last_q) begin
      for (c = 0; c < LANES; c = c + 1) begin
        if (leaving[c]) begin
          codes_q[c*CODE_BITS +: CODE_BITS] <= {CODE_BITS{1'b0}};
        end
      end
    end
  end

  assign m_report_tvalid    = valid_q && (last_q ? !report_sent_q : is_report);
  assign m_report_tlast     = last_q;
  assign m_report_tag       = {index_j_q, base_q};
  assign m_report_lane      = (last_q || together) ? {INDEX_BITS{1'b0}} : lane;
  assign m_report_verdict   = reports ? verdict : 2'b00;
  assign m_report_undecided = !reports;
  assign m_pair_tvalid      = valid_q && (last_q ? !pair_sent_q : !is_report);
  assign m_pair_tlast       = last_q;
  assign m_pair_tag         = {index_j_q, base_q};
  assign m_pair_lane        = last_q ? {INDEX_BITS{1'b0}} : lane_undecided;

  generate
    if (BITMAP != 0) begin : g_flags
      assign m_report_flags = reports ? reported : ONE_FLAG;
    end else begin : g_pairs
      assign m_report_flags = ONE_FLAG;
    end
  endgenerate

endmodule

`default_nettype wire
