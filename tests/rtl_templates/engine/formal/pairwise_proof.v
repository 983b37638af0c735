// pairwise_proof: whatever stalls, any one pair of items meets in a lane once, and leaves once if its
// verdict is of a reported kind; the closing beat comes behind all reports and counts them. One pair,
// chosen by the solver, is watched; LANES lanes hold one pair each for as long as they like.
`default_nettype none

module pairwise_proof #(
  parameter LANES = 2,
  parameter CAPACITY = 4,
  parameter INDEX_BITS = 2,
  parameter RADIX = 1
) (
  input wire             aclk,
  input wire             aresetn_later,
  input wire             s_valid,
  input wire             s_last,
  input wire             s_data,
  input wire             m_ready,
  input wire [LANES-1:0] willing,    // a lane without a pair takes one
  input wire [LANES-1:0] finishing,  // a lane with a pair offers its result
  input wire [LANES-1:0] reporting   // and this verdict is reported
);

  localparam TAG_BITS = 2 * INDEX_BITS;
  localparam [INDEX_BITS:0] FULL = CAPACITY[INDEX_BITS:0];

  // The pair that is watched.
  (* anyconst *) reg [INDEX_BITS-1:0] watched_i;
  (* anyconst *) reg [INDEX_BITS-1:0] watched_j;

  wire                      s_ready;
  wire [LANES-1:0]          pair_valid;
  wire [LANES-1:0]          pair_ready;
  wire [LANES*2-1:0]        pair_items;
  wire [LANES*TAG_BITS-1:0] pair_tag;
  wire [LANES-1:0]          result_valid;
  wire [LANES-1:0]          result_ready;
  wire [LANES*8-1:0]        result_data;
  wire [LANES*TAG_BITS-1:0] result_tag;
  wire                      m_valid;
  wire [15:0]               m_data;
  wire [7:0]                m_user;
  wire                      m_last;

  reg                       started = 1'b0;
  wire                      aresetn = started && aresetn_later;

  pairwise_engine #(
    .LANES       (LANES),
    .REFERENCES  (0),
    .CAPACITY    (CAPACITY),
    .ITEM_BITS   (1),
    .INDEX_BITS  (INDEX_BITS),
    .SLOT_BITS   (1),
    .REPORT      (1),
    .COUNTER_BITS(0),
    .RADIX       (RADIX)
  ) dut (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .s_axis_tvalid   (s_valid),
    .s_axis_tready   (s_ready),
    .s_axis_tdata    (s_data),
    .s_axis_tlast    (s_last),
    .pair_tvalid     (pair_valid),
    .pair_tready     (pair_ready),
    .pair_items      (pair_items),
    .pair_tag        (pair_tag),
    .result_tvalid   (result_valid),
    .result_tready   (result_ready),
    .result_tdata    (result_data),
    .result_tag      (result_tag),
    .s_refetch_tvalid(1'b0),
    .s_refetch_tready(),
    .s_refetch_tdata ({TAG_BITS{1'b0}}),
    .m_answer_tvalid (),
    .m_answer_tready (1'b0),
    .m_answer_tdata  (),
    .m_axis_tvalid   (m_valid),
    .m_axis_tready   (m_ready),
    .m_axis_tdata    (m_data),
    .m_axis_tuser    (m_user),
    .m_axis_tlast    (m_last),
    .reports         (),
    .busy_cycles     (),
    .stalled_cycles  ()
  );

  // The set as it was offered.
  reg  [INDEX_BITS:0] loaded   = {(INDEX_BITS+1){1'b0}};
  reg                 complete = 1'b0;
  reg                 too_many = 1'b0;
  reg                 item_i;
  reg                 item_j;
  reg                 met      = 1'b0;
  reg                 due      = 1'b0;  // met, and its verdict is reported
  reg                 told     = 1'b0;
  reg  [3:0]          count    = 4'd0;  // reports that left
  wire                accept   = s_valid && s_ready;
  wire                report   = m_valid && m_ready && !m_last;
  wire                closes   = m_valid && m_ready && m_last;
  wire                of_watched = (m_data == {{(8-INDEX_BITS){1'b0}}, watched_j,
                                               {(8-INDEX_BITS){1'b0}}, watched_i});

  always @(posedge aclk) begin
    started <= 1'b1;
    if (!aresetn || closes) begin
      loaded   <= {(INDEX_BITS+1){1'b0}};
      complete <= 1'b0;
      too_many <= 1'b0;
      count    <= 4'd0;
      told     <= 1'b0;
    end else begin
      if (accept && (loaded != FULL)) begin
        loaded <= loaded + 1'b1;
      end
      complete <= complete || (accept && s_last);
      too_many <= too_many || (accept && (loaded == FULL));
      count    <= count + {3'b000, report};
      told     <= told || (report && of_watched);
    end
    if (accept && (loaded == {1'b0, watched_i})) begin
      item_i <= s_data;
    end
    if (accept && (loaded == {1'b0, watched_j})) begin
      item_j <= s_data;
    end
  end

  // Lanes.
  wire [LANES-1:0] meets;
  wire [LANES-1:0] meets_due;
  reg  [LANES-1:0] holds = {LANES{1'b0}};

  genvar k;
  generate
    for (k = 0; k < LANES; k = k + 1) begin : g_lane
      reg                 offered = 1'b0;
      reg  [TAG_BITS-1:0] tag;
      reg                 verdict;
      wire                takes   = pair_valid[k] && pair_ready[k];
      wire                watched = (pair_tag[k*TAG_BITS +: TAG_BITS] == {watched_j, watched_i});

      assign pair_ready[k]                      = willing[k] && !holds[k];
      assign result_valid[k]                    = offered;
      assign result_data[k*8 +: 8]              = {7'b0000000, verdict};  // 0 is reported, 1 is not
      assign result_tag[k*TAG_BITS +: TAG_BITS] = tag;
      assign meets[k]                           = takes && watched;
      assign meets_due[k]                       = takes && watched && reporting[k];

      always @(posedge aclk) begin
        if (!aresetn) begin
          holds[k] <= 1'b0;
          offered  <= 1'b0;
        end else begin
          holds[k] <= takes || (holds[k] && !(offered && result_ready[k]));
          offered  <= (offered && !result_ready[k]) || (holds[k] && !offered && finishing[k]);
        end
        if (takes) begin
          tag     <= pair_tag[k*TAG_BITS +: TAG_BITS];
          verdict <= !reporting[k];
        end
      end

      always @* begin
        if (started && aresetn && pair_valid[k]) begin
          assert(pair_tag[k*TAG_BITS +: INDEX_BITS] < pair_tag[k*TAG_BITS+INDEX_BITS +: INDEX_BITS]);
          assert({1'b0, pair_tag[k*TAG_BITS+INDEX_BITS +: INDEX_BITS]} < loaded);
          assert(!watched || (pair_items[2*k +: 2] == {item_j, item_i}));
        end
      end
    end
  endgenerate

  always @(posedge aclk) begin
    if (!aresetn || closes) begin
      met <= 1'b0;
      due <= 1'b0;
    end else begin
      met <= met || |meets;
      due <= due || |meets_due;
    end
  end

  wire exists = (watched_i < watched_j) && ({1'b0, watched_j} < loaded);

  always @* begin
    if (!aresetn) begin
      assume(!s_valid);
    end
    if (started && aresetn) begin
      meets_once: assert(!met || (meets == {LANES{1'b0}}));
      meets_in_one: assert((meets & (meets - 1'b1)) == {LANES{1'b0}});
      told_once: assert(!(report && of_watched) || (due && !told));
      all_met: assert(!closes || (met == exists));
      all_told: assert(!closes || (told == due));
      counted: assert(!closes || (m_data == {12'd0, count}));
      overrun_told: assert(!closes || (m_user == {1'b1, too_many, 6'd0}));
      nothing_before_the_end: assert(!closes || (complete && (holds == {LANES{1'b0}})));
      no_item_between: assert(!accept || !complete);
      can_close_all: cover(closes && (loaded == FULL) && told);
      can_overrun: cover(closes && too_many);
      can_take_another: cover(closes && (loaded == 1));
    end
  end

endmodule

`default_nettype wire
