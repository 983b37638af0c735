// expander_proof: each pair of each beat leaves pair_expander once, on its stream and with its
// verdict, reported pairs first; the closing beat leaves once on both streams. A beat has at least
// one pair, as the beats of pair_segment have.
`default_nettype none

module expander_proof #(
  parameter LANES = 3,
  parameter REPORT = 11,
  parameter CODE_BITS = 3,
  parameter BITMAP = 0,
  parameter RECOMPUTE = 1
) (
  input wire                       aclk,
  input wire                       aresetn_later,
  input wire                       s_valid,
  input wire                       s_last,
  input wire [LANES*CODE_BITS-1:0] s_codes,
  input wire [1:0]                 s_index,
  input wire [1:0]                 s_base,
  input wire                       report_ready,
  input wire                       pair_ready
);

  localparam FLAG_BITS = (BITMAP != 0) ? LANES : 1;
  localparam [1:0] ONLY = REPORT[3] ? 2'd3 : (REPORT[2] ? 2'd2 : {1'b0, REPORT[1]});
  localparam [FLAG_BITS-1:0] ONE_FLAG = 1;

  wire                 s_ready;
  wire                 report_valid;
  wire [1:0]           report_base;
  wire [1:0]           report_lane;
  wire [1:0]           report_j;
  wire [FLAG_BITS-1:0] report_flags;
  wire [1:0]           report_verdict;
  wire                 report_undecided;
  wire                 report_last;
  wire                 pair_valid;
  wire [1:0]           pair_base;
  wire [1:0]           pair_lane;
  wire [1:0]           pair_j;
  wire                 pair_last;

  reg                  started = 1'b0;
  wire                 aresetn = started && aresetn_later;

  pair_expander #(
    .LANES     (LANES),
    .INDEX_BITS(2),
    .REPORT    (REPORT),
    .CODE_BITS (CODE_BITS),
    .BITMAP    (BITMAP),
    .RECOMPUTE (RECOMPUTE)
  ) dut (
    .aclk              (aclk),
    .aresetn           (aresetn),
    .s_axis_tvalid     (s_valid),
    .s_axis_tready     (s_ready),
    .s_axis_tdata      ({s_codes, s_index, s_base}),
    .s_axis_tlast      (s_last),
    .m_report_tvalid   (report_valid),
    .m_report_tready   (report_ready),
    .m_report_tag      ({report_j, report_base}),
    .m_report_lane     (report_lane),
    .m_report_flags    (report_flags),
    .m_report_verdict  (report_verdict),
    .m_report_undecided(report_undecided),
    .m_report_tlast    (report_last),
    .m_pair_tvalid     (pair_valid),
    .m_pair_tready     (pair_ready),
    .m_pair_tag        ({pair_j, pair_base}),
    .m_pair_lane       (pair_lane),
    .m_pair_tlast      (pair_last)
  );

  // The reports that were taken and have not left.
  reg  [LANES-1:0]   reported     = {LANES{1'b0}};
  reg  [LANES-1:0]   undecided    = {LANES{1'b0}};
  reg                report_close = 1'b0;
  reg                pair_close   = 1'b0;
  reg  [2*LANES-1:0] verdicts;
  reg  [1:0]         index;
  reg  [1:0]         base;
  reg                held_report  = 1'b0;
  reg  [FLAG_BITS+9:0] held_report_beat;
  reg                held_pair    = 1'b0;
  reg  [6:0]         held_pair_beat;

  wire               take    = s_valid && s_ready;
  wire               reports = report_valid && report_ready;
  wire               pairs   = pair_valid && pair_ready;
  wire [LANES-1:0]   report_only = 1'b1 << report_lane;
  wire [LANES-1:0]   pair_only   = 1'b1 << pair_lane;
  wire               together    = (BITMAP != 0) && !report_undecided;
  wire [LANES-1:0]   told        = together ? report_flags : report_only;
  wire               nothing     = ((reported | undecided) == {LANES{1'b0}}) && !report_close && !pair_close;
  wire               in_hand     = started && aresetn && !nothing;
  integer            k;

  always @(posedge aclk) begin
    started          <= 1'b1;
    held_report      <= aresetn && report_valid && !report_ready;
    held_report_beat <= {report_flags, report_undecided, report_last, report_verdict, report_j, report_base,
                         report_lane};
    held_pair        <= aresetn && pair_valid && !pair_ready;
    held_pair_beat   <= {pair_last, pair_j, pair_base, pair_lane};
    if (!aresetn) begin
      reported     <= {LANES{1'b0}};
      undecided    <= {LANES{1'b0}};
      report_close <= 1'b0;
      pair_close   <= 1'b0;
    end else begin
      if (reports && report_last) begin
        report_close <= 1'b0;
      end else if (reports && report_undecided) begin
        undecided <= undecided & ~told;
      end else if (reports) begin
        reported <= reported & ~told;
      end
      if (pairs && pair_last) begin
        pair_close <= 1'b0;
      end else if (pairs) begin
        undecided <= undecided & ~pair_only;
      end
      if (take) begin
        index        <= s_index;
        base         <= s_base;
        report_close <= s_last;
        pair_close   <= s_last;
        for (k = 0; k < LANES; k = k + 1) begin
          reported[k]         <= !s_last && s_codes[k*CODE_BITS + CODE_BITS - 1];
          undecided[k]        <= !s_last && !s_codes[k*CODE_BITS + CODE_BITS - 1] && s_codes[k*CODE_BITS];
          verdicts[2*k +: 2]  <= (CODE_BITS == 3) ? s_codes[k*CODE_BITS +: 2] : ONLY;
        end
      end
    end
  end

  reg tells;

  always @* begin
    tells = 1'b0;
    for (k = 0; k < LANES; k = k + 1) begin
      tells = tells || s_codes[k*CODE_BITS + CODE_BITS - 1] || s_codes[k*CODE_BITS];
    end
    assume(!s_valid || s_last || tells);
    if (!aresetn) begin
      assume(!s_valid);
    end
    if (started && aresetn) begin
      takes_behind_all: assert(!take || nothing || reports || pairs);
      nothing_left_behind: assert(!take || (((reported & ~(told & {LANES{reports}})) == {LANES{1'b0}}) &&
                                            (!report_close || reports) && (!pair_close || pairs)));
      nothing_made_up: assert(!nothing || (!report_valid && !pair_valid));
      takes_the_next: assert(!nothing || s_ready);
      always_on_offer: assert(nothing || report_valid || pair_valid);
      each_on_its_stream: assert((RECOMPUTE != 0) || !pair_valid || pair_last);
      undecided_told_apart: assert(!report_valid || report_last || !report_undecided || (RECOMPUTE == 0));
      holds_report: assert(!held_report || (report_valid && (held_report_beat ==
          {report_flags, report_undecided, report_last, report_verdict, report_j, report_base,
           report_lane})));
      holds_pair: assert(!held_pair || (pair_valid && (held_pair_beat ==
          {pair_last, pair_j, pair_base, pair_lane})));
      can_tell_apart: cover(reports && !report_last && pair_ready && (undecided != {LANES{1'b0}}));
      can_close_one_by_one: cover(report_close && !pair_close && (index == 2'd1));
      can_close_other_first: cover(!report_close && pair_close);
      can_hold_report: cover(held_report);
      can_hold_pair: cover(held_pair);
      can_tell_undecided: cover((pairs && !pair_last) || (reports && !report_last && report_undecided));
    end
    if (in_hand && report_valid) begin
      report_of_this_word: assert((report_j == index) && (report_base == base));
      closes_once: assert(report_last == report_close);
      close_has_no_lane: assert(!report_last || (report_lane == 2'd0));
      report_is_due: assert(report_last || ((told != {LANES{1'b0}}) && ((told &
                            ~(report_undecided ? undecided : reported)) == {LANES{1'b0}})));
      reports_first: assert(report_last || !report_undecided || (reported == {LANES{1'b0}}));
      all_flags: assert((BITMAP == 0) || report_last || report_undecided ||
                        ((report_flags == reported) && (report_lane == 2'd0)));
      one_flag: assert(((BITMAP != 0) && !report_undecided) || (report_flags == ONE_FLAG));
      verdict_told: assert(report_last || report_undecided || together ||
                           (report_verdict == verdicts[2*report_lane +: 2]));
    end
    if (in_hand && pair_valid) begin
      pair_of_this_word: assert((pair_j == index) && (pair_base == base));
      pair_closes_once: assert(pair_last == pair_close);
      pair_is_due: assert(pair_last || ((pair_only & undecided) != {LANES{1'b0}}));
      pairs_behind_reports: assert(pair_last || (reported == {LANES{1'b0}}));
    end
  end

endmodule

`default_nettype wire
