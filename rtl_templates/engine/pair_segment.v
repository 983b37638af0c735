// pair_segment: a link of the chain that carries items past the lanes; it feeds LANES lanes by the
// ports pair_* and collects their results at result_*.
// Of a block's words the first LANES stay, one in each lane; every word behind meets those that its
// lanes hold, and from then on is passed to the next segment, where the same happens. So lane k of
// the chain holds item base + k and meets each later one once, and no pair needs a counter. A word
// goes on once all lanes that it meets have taken their pair; whoever is ready early takes it early.
// Results whose verdict is in REPORT (bit v: verdict v) and all undecided ones leave as reports;
// the others end here. A word that says `close` waits until nothing is inside, and takes the number
// of reports with it: its payload is their sum. Interval 1, latency 2. Reset empties it.
`default_nettype none

module pair_segment #(
  parameter LANES = 4,
  parameter ITEM_BITS = 32,
  parameter INDEX_BITS = 10,
  parameter PAYLOAD_BITS = 42,     // of a word: {item, index}, or a count of 2 * INDEX_BITS
  parameter IN_FLIGHT_BITS = 10,   // to count the pairs that may be inside
  parameter REPORT = 11,
  parameter REPORT_DEPTH_BITS = 3
) (
  input  wire                              aclk,
  input  wire                              aresetn,
  input  wire                              s_word_tvalid,
  output wire                              s_word_tready,
  input  wire [PAYLOAD_BITS+1:0]           s_word_tdata,
  output wire                              m_word_tvalid,
  input  wire                              m_word_tready,
  output wire [PAYLOAD_BITS+1:0]           m_word_tdata,
  output wire [LANES-1:0]                  pair_tvalid,
  input  wire [LANES-1:0]                  pair_tready,
  output wire [LANES*2*ITEM_BITS-1:0]      pair_items,
  output wire [LANES*2*INDEX_BITS-1:0]     pair_tag,
  input  wire [LANES-1:0]                  result_tvalid,
  output wire [LANES-1:0]                  result_tready,
  input  wire [LANES*4-1:0]                result_tdata,
  input  wire [LANES*2*INDEX_BITS-1:0]     result_tag,
  output wire [LANES-1:0]                  report_tvalid,
  input  wire [LANES-1:0]                  report_tready,
  output wire [LANES*(2*INDEX_BITS+4)-1:0] report_tdata
);

  localparam TAG_BITS        = 2 * INDEX_BITS;
  localparam WAITING_REPORTS = LANES * ((1 << REPORT_DEPTH_BITS) + 1);  // in the lanes' FIFOs

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (LANES < 1) begin : g_refused_lanes
      LANES_is_below_1 refused ();
    end
    if (ITEM_BITS < 1) begin : g_refused_item_bits
      ITEM_BITS_is_below_1 refused ();
    end
    if (INDEX_BITS < 1) begin : g_refused_index_bits
      INDEX_BITS_is_below_1 refused ();
    end
    if (PAYLOAD_BITS < INDEX_BITS + ITEM_BITS) begin : g_refused_item
      PAYLOAD_BITS_is_too_small_for_an_item refused ();
    end
    if (PAYLOAD_BITS < 2 * INDEX_BITS) begin : g_refused_count
      PAYLOAD_BITS_is_too_small_for_a_count refused ();
    end
    if (IN_FLIGHT_BITS < 1) begin : g_refused_in_flight_bits
      IN_FLIGHT_BITS_is_below_1 refused ();
    end
    if ((WAITING_REPORTS >>> IN_FLIGHT_BITS) > 0) begin : g_refused_waiting_reports
      IN_FLIGHT_BITS_is_too_small_for_the_reports refused ();
    end
    if ((REPORT >> 4) != 0) begin : g_refused_report
      REPORT_is_not_0_to_15 refused ();
    end
    if (REPORT_DEPTH_BITS < 1) begin : g_refused_report_depth_bits
      REPORT_DEPTH_BITS_is_below_1 refused ();
    end
  endgenerate

  // The word at hand: {close, first of its block, payload}.
  wire                    word_valid;
  wire                    word_close;
  wire                    word_first;
  wire [PAYLOAD_BITS-1:0] payload;
  wire [INDEX_BITS-1:0]   word_index = payload[INDEX_BITS-1:0];
  wire [ITEM_BITS-1:0]    word_item  = payload[INDEX_BITS +: ITEM_BITS];
  wire                    step;

  stream_fifo #(
    .WIDTH     (PAYLOAD_BITS + 2),
    .DEPTH_BITS(1)
  ) link (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_word_tvalid),
    .s_axis_tready(s_word_tready),
    .s_axis_tdata (s_word_tdata),
    .m_axis_tvalid(word_valid),
    .m_axis_tready(step),
    .m_axis_tdata ({word_close, word_first, payload})
  );

  // Lanes hold items from the lowest up. Once all do, words are passed on.
  reg  [LANES-1:0] holds_q;
  reg  [LANES-1:0] taken_q;        // lanes that have taken the word at hand
  reg              sent_q;         // the next segment has taken it, too
  reg              passed_q;       // a word of this block was sent to the next segment
  wire             is_item = word_valid && !word_close;
  wire [LANES-1:0] holds   = holds_q & {LANES{!word_first}};
  wire [LANES:0]   filled  = {holds, 1'b1};  // bit k: all lanes below k hold an item
  wire             idle;
  wire             passes  = word_close ? idle : filled[LANES];
  wire [LANES-1:0] late    = pair_tvalid & ~pair_tready;
  wire             gone    = sent_q || m_word_tready;

  assign pair_tvalid   = holds & ~taken_q & {LANES{is_item}};
  assign m_word_tvalid = word_valid && passes && !sent_q;
  assign step = word_valid && (late == {LANES{1'b0}}) && (passes ? gone : !word_close);

  always @(posedge aclk) begin
    if (!aresetn) begin
      holds_q  <= {LANES{1'b0}};
      taken_q  <= {LANES{1'b0}};
      sent_q   <= 1'b0;
      passed_q <= 1'b0;
    end else if (step) begin
      holds_q  <= filled[LANES-1:0];
      taken_q  <= {LANES{1'b0}};
      sent_q   <= 1'b0;
      passed_q <= passes;
    end else begin
      taken_q <= taken_q | (pair_tvalid & pair_tready);
      sent_q  <= sent_q || (m_word_tvalid && m_word_tready);
    end
  end

  // Pairs out, results back.
  wire [LANES-1:0] dropped;

  genvar k;
  generate
    for (k = 0; k < LANES; k = k + 1) begin : g_lane
      reg  [ITEM_BITS-1:0]  own_item_q;
      reg  [INDEX_BITS-1:0] own_index_q;

      always @(posedge aclk) begin
        if (is_item && filled[k] && !holds[k]) begin
          own_item_q  <= word_item;
          own_index_q <= word_index;
        end
      end

      assign pair_items[k*2*ITEM_BITS +: 2*ITEM_BITS] = {word_item, own_item_q};
      assign pair_tag[k*TAG_BITS +: TAG_BITS]         = {word_index, own_index_q};

      wire [3:0]          reported = REPORT[3:0];
      wire [3:0]          result   = result_tdata[k*4 +: 4];
      wire [TAG_BITS-1:0] tag      = result_tag[k*TAG_BITS +: TAG_BITS];
      wire                keep     = reported[result[1:0]] || result[3];
      wire                fifo_ready;

      stream_fifo #(
        .WIDTH     (TAG_BITS + 4),
        .DEPTH_BITS(REPORT_DEPTH_BITS)
      ) reports (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(result_tvalid[k] && keep),
        .s_axis_tready(fifo_ready),
        .s_axis_tdata ({result, tag}),
        .m_axis_tvalid(report_tvalid[k]),
        .m_axis_tready(report_tready[k]),
        .m_axis_tdata (report_tdata[k*(TAG_BITS+4) +: TAG_BITS+4])
      );

      assign result_tready[k] = fifo_ready || !keep;
      assign dropped[k]       = result_tvalid[k] && !keep;
    end
  endgenerate

  // Pairs inside, from the lane's entry to the end of the result or the departure of the report.
  // The counter is a cycle late: it adds registered events.
  reg  [LANES-1:0]          entered_q;
  reg  [LANES-1:0]          dropped_q;
  reg  [LANES-1:0]          left_q;
  reg  [IN_FLIGHT_BITS-1:0] in_flight_q;
  reg  [TAG_BITS-1:0]       reports_q;  // that have left since the last close

  reg  [IN_FLIGHT_BITS-1:0] entered;
  reg  [IN_FLIGHT_BITS-1:0] ended;
  reg  [TAG_BITS-1:0]       left;
  integer                   lane;

  assign idle = (in_flight_q == {IN_FLIGHT_BITS{1'b0}}) && (entered_q == {LANES{1'b0}});

  always @* begin
    entered = {IN_FLIGHT_BITS{1'b0}};
    ended   = {IN_FLIGHT_BITS{1'b0}};
    left    = {TAG_BITS{1'b0}};
    for (lane = 0; lane < LANES; lane = lane + 1) begin
      entered = entered + {{(IN_FLIGHT_BITS-1){1'b0}}, entered_q[lane]};
      ended   = ended + {{(IN_FLIGHT_BITS-1){1'b0}}, dropped_q[lane]};
      ended   = ended + {{(IN_FLIGHT_BITS-1){1'b0}}, left_q[lane]};
      left    = left + {{(TAG_BITS-1){1'b0}}, left_q[lane]};
    end
  end

  always @(posedge aclk) begin
    if (!aresetn) begin
      entered_q   <= {LANES{1'b0}};
      dropped_q   <= {LANES{1'b0}};
      left_q      <= {LANES{1'b0}};
      in_flight_q <= {IN_FLIGHT_BITS{1'b0}};
    end else begin
      entered_q   <= pair_tvalid & pair_tready;
      dropped_q   <= dropped;
      left_q      <= report_tvalid & report_tready;
      in_flight_q <= in_flight_q + entered - ended;
    end
  end

  always @(posedge aclk) begin
    if (!aresetn || (step && word_close)) begin
      reports_q <= {TAG_BITS{1'b0}};
    end else begin
      reports_q <= reports_q + left;
    end
  end

  // On to the next segment.
  reg [PAYLOAD_BITS-1:0] passed_payload;

  always @* begin
    passed_payload = payload;
    if (word_close) begin
      passed_payload[TAG_BITS-1:0] = payload[TAG_BITS-1:0] + reports_q;
    end
  end

  assign m_word_tdata = {word_close, !passed_q, passed_payload};

endmodule

`default_nettype wire
