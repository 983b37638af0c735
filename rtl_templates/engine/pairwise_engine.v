// pairwise_engine: loads N items once and sends every pair i < j of them through LANES lanes.
// Items come on s_axis, tlast with the set's last; the reports of a set leave on m_axis, a closing
// beat behind them (report_stream tells their fields), and then the next set is taken. Lane k meets
// the items i with i mod LANES = k, each with all later ones: {item j, item i} with the tag {j, i}
// on pair_*, the verdicts back with that tag on result_*. A set takes about N^2 / (2 LANES) + N / 2
// cycles.
// A chain of segments of RADIX lanes carries the items past the lanes; a lane that is not ready
// holds up its segment, and those behind it only once the words between them are used up.
// References read items again by tag on s_refetch_*, two cycles a pair; a set's items stay until
// its closing beat. REFERENCES = 0: nobody does. Counters wrap: reports that have left, cycles
// between a set's first item and its closing beat, and those of them in which the chain took no
// word. Reset forgets the set.
`default_nettype none

module pairwise_engine #(
  parameter LANES = 8,
  parameter REFERENCES = 1,
  parameter CAPACITY = 1024,
  parameter ITEM_BITS = 32,
  parameter INDEX_BITS = 10,
  parameter SLOT_BITS = 5,      // 2^SLOT_BITS + 1 pairs may be inside one lane
  parameter REPORT = 11,        // bit v: verdict v leaves
  parameter COUNTER_BITS = 32,
  parameter RADIX = 4
) (
  input  wire                                                                aclk,
  input  wire                                                                aresetn,
  input  wire                                                                s_axis_tvalid,
  output wire                                                                s_axis_tready,
  input  wire [ITEM_BITS-1:0]                                                s_axis_tdata,
  input  wire                                                                s_axis_tlast,
  output wire [LANES-1:0]                                                    pair_tvalid,
  input  wire [LANES-1:0]                                                    pair_tready,
  output wire [LANES*2*ITEM_BITS-1:0]                                        pair_items,
  output wire [LANES*2*INDEX_BITS-1:0]                                       pair_tag,
  input  wire [LANES-1:0]                                                    result_tvalid,
  output wire [LANES-1:0]                                                    result_tready,
  input  wire [LANES*8-1:0]                                                  result_tdata,
  input  wire [LANES*2*INDEX_BITS-1:0]                                       result_tag,
  input  wire [(REFERENCES > 0 ? REFERENCES : 1)-1:0]                        s_refetch_tvalid,
  output wire [(REFERENCES > 0 ? REFERENCES : 1)-1:0]                        s_refetch_tready,
  input  wire [(REFERENCES > 0 ? REFERENCES : 1)*2*INDEX_BITS-1:0]           s_refetch_tdata,
  output wire [(REFERENCES > 0 ? REFERENCES : 1)-1:0]                        m_answer_tvalid,
  input  wire [(REFERENCES > 0 ? REFERENCES : 1)-1:0]                        m_answer_tready,
  output wire [2*ITEM_BITS-1:0]                                              m_answer_tdata,
  output wire                                                                m_axis_tvalid,
  input  wire                                                                m_axis_tready,
  output wire [16*((INDEX_BITS+7)/8)-1:0]                                    m_axis_tdata,
  output wire [7:0]                                                          m_axis_tuser,
  output wire                                                                m_axis_tlast,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]                    reports,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]                    busy_cycles,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]                    stalled_cycles
);

  localparam TAG_BITS       = 2 * INDEX_BITS;
  localparam SEGMENTS       = (RADIX > 0) ? (LANES + RADIX - 1) / RADIX : 1;
  localparam PAYLOAD_BITS   = INDEX_BITS + ((ITEM_BITS > INDEX_BITS) ? ITEM_BITS : INDEX_BITS);
  localparam WORD_BITS      = PAYLOAD_BITS + 2;
  localparam REPORT_BITS    = TAG_BITS + 4;
  localparam FIFO_BITS      = 3;  // 2^FIFO_BITS + 1 reports may wait behind a lane
  localparam IN_FLIGHT_BITS = SLOT_BITS + FIFO_BITS + RADIX;  // for RADIX lanes and their FIFOs

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (LANES < 1) begin : g_refused_lanes
      LANES_is_below_1 refused ();
    end
    if (REFERENCES < 0) begin : g_refused_references
      REFERENCES_is_below_0 refused ();
    end
    if (CAPACITY < 2) begin : g_refused_capacity
      CAPACITY_is_below_2 refused ();
    end
    if (ITEM_BITS < 1) begin : g_refused_item_bits
      ITEM_BITS_is_below_1 refused ();
    end
    if (INDEX_BITS < 1) begin : g_refused_index_bits
      INDEX_BITS_is_below_1 refused ();
    end
    if (INDEX_BITS > 30) begin : g_refused_index_shift
      INDEX_BITS_is_above_30 refused ();
    end
    if (((CAPACITY - 1) >>> INDEX_BITS) > 0) begin : g_refused_last_item
      INDEX_BITS_is_too_small_for_CAPACITY refused ();
    end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits
      SLOT_BITS_is_below_1 refused ();
    end
    if ((REPORT >> 4) != 0) begin : g_refused_report
      REPORT_is_not_0_to_15 refused ();
    end
    if (COUNTER_BITS < 0) begin : g_refused_counter_bits
      COUNTER_BITS_is_below_0 refused ();
    end
    if (RADIX < 1) begin : g_refused_radix
      RADIX_is_below_1 refused ();
    end
  endgenerate

  // The memory: written and refetched through port a, streamed through port b.
  wire                  write_enable;
  wire [INDEX_BITS-1:0] write_address;
  wire                  refetch_enable;
  wire [INDEX_BITS-1:0] refetch_address;
  wire [ITEM_BITS-1:0]  refetched_item;
  wire                  read_enable;
  wire [INDEX_BITS-1:0] read_address;
  wire [ITEM_BITS-1:0]  read_item;

  item_memory #(
    .WIDTH       (ITEM_BITS),
    .ADDRESS_BITS(INDEX_BITS)
  ) items (
    .aclk        (aclk),
    .a_enable    (refetch_enable || write_enable),
    .a_write     (!refetch_enable),
    .a_address   (refetch_enable ? refetch_address : write_address),
    .a_write_data(s_axis_tdata),
    .a_read_data (refetched_item),
    .b_enable    (read_enable),
    .b_address   (read_address),
    .b_read_data (read_item)
  );

  // Words into the chain.
  wire                  set_closed;
  wire                  busy;
  wire                  overrun;
  wire                  word_valid;
  wire                  word_ready;
  wire                  word_first;
  wire                  word_close;
  wire [INDEX_BITS-1:0] word_index;

  block_reader #(
    .LANES     (LANES),
    .CAPACITY  (CAPACITY),
    .INDEX_BITS(INDEX_BITS)
  ) reader (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_axis_tvalid),
    .s_axis_tready(s_axis_tready),
    .s_axis_tlast (s_axis_tlast),
    .write_enable (write_enable),
    .write_ready  (!refetch_enable),
    .write_address(write_address),
    .read_enable  (read_enable),
    .read_address (read_address),
    .m_word_tvalid(word_valid),
    .m_word_tready(word_ready),
    .m_word_first (word_first),
    .m_word_close (word_close),
    .m_word_index (word_index),
    .set_closed   (set_closed),
    .busy         (busy),
    .overrun      (overrun)
  );

  reg [PAYLOAD_BITS-1:0] word_payload;  // of the closing word the count so far, none

  always @* begin
    word_payload = {PAYLOAD_BITS{1'b0}};
    if (!word_close) begin
      word_payload[INDEX_BITS+ITEM_BITS-1:0] = {read_item, word_index};
    end
  end

  // The chain.
  wire [SEGMENTS:0]                 chain_valid;
  wire [SEGMENTS:0]                 chain_ready;
  wire [(SEGMENTS+1)*WORD_BITS-1:0] chain_data;
  wire [LANES-1:0]                  report_valid;
  wire [LANES-1:0]                  report_ready;
  wire [LANES*REPORT_BITS-1:0]      report_data;
  wire [LANES*4-1:0]                result_flags;

  assign chain_valid[0]            = word_valid;
  assign chain_data[WORD_BITS-1:0] = {word_close, word_first, word_payload};
  assign word_ready                = chain_ready[0];

  genvar lane;
  genvar s;
  generate
    for (lane = 0; lane < LANES; lane = lane + 1) begin : g_result
      wire unused_zeros = &result_tdata[lane*8+4 +: 4];

      assign result_flags[lane*4 +: 4] = result_tdata[lane*8 +: 4];
    end

    for (s = 0; s < SEGMENTS; s = s + 1) begin : g_segment
      localparam FIRST = (s * LANES) / SEGMENTS;
      localparam COUNT = ((s + 1) * LANES) / SEGMENTS - FIRST;

      pair_segment #(
        .LANES            (COUNT),
        .ITEM_BITS        (ITEM_BITS),
        .INDEX_BITS       (INDEX_BITS),
        .PAYLOAD_BITS     (PAYLOAD_BITS),
        .IN_FLIGHT_BITS   (IN_FLIGHT_BITS),
        .REPORT           (REPORT),
        .REPORT_DEPTH_BITS(FIFO_BITS)
      ) segment (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_word_tvalid(chain_valid[s]),
        .s_word_tready(chain_ready[s]),
        .s_word_tdata (chain_data[s*WORD_BITS +: WORD_BITS]),
        .m_word_tvalid(chain_valid[s+1]),
        .m_word_tready(chain_ready[s+1]),
        .m_word_tdata (chain_data[(s+1)*WORD_BITS +: WORD_BITS]),
        .pair_tvalid  (pair_tvalid[FIRST +: COUNT]),
        .pair_tready  (pair_tready[FIRST +: COUNT]),
        .pair_items   (pair_items[FIRST*2*ITEM_BITS +: COUNT*2*ITEM_BITS]),
        .pair_tag     (pair_tag[FIRST*TAG_BITS +: COUNT*TAG_BITS]),
        .result_tvalid(result_tvalid[FIRST +: COUNT]),
        .result_tready(result_tready[FIRST +: COUNT]),
        .result_tdata (result_flags[FIRST*4 +: COUNT*4]),
        .result_tag   (result_tag[FIRST*TAG_BITS +: COUNT*TAG_BITS]),
        .report_tvalid(report_valid[FIRST +: COUNT]),
        .report_tready(report_ready[FIRST +: COUNT]),
        .report_tdata (report_data[FIRST*REPORT_BITS +: COUNT*REPORT_BITS])
      );
    end
  endgenerate

  // What leaves the chain has met every lane; only the closing word still says something.
  wire                 end_valid = chain_valid[SEGMENTS];
  wire [WORD_BITS-1:0] end_word  = chain_data[SEGMENTS*WORD_BITS +: WORD_BITS];
  wire                 end_close = end_word[WORD_BITS-1];
  wire                 unused_end_word = &end_word[WORD_BITS-2:TAG_BITS];

  assign chain_ready[SEGMENTS] = !end_close || set_closed;

  report_stream #(
    .LANES     (LANES),
    .INDEX_BITS(INDEX_BITS)
  ) out (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .report_tvalid(report_valid),
    .report_tready(report_ready),
    .report_tdata (report_data),
    .close_valid  (end_valid && end_close),
    .close_ready  (set_closed),
    .close_count  (end_word[TAG_BITS-1:0]),
    .overrun      (overrun),
    .m_axis_tvalid(m_axis_tvalid),
    .m_axis_tready(m_axis_tready),
    .m_axis_tdata (m_axis_tdata),
    .m_axis_tuser (m_axis_tuser),
    .m_axis_tlast (m_axis_tlast)
  );

  generate
    if (REFERENCES == 0) begin : g_no_references
      wire unused_inputs = &{s_refetch_tvalid, s_refetch_tdata, m_answer_tready, refetched_item};

      assign s_refetch_tready = 1'b0;
      assign m_answer_tvalid  = 1'b0;
      assign m_answer_tdata   = {(2*ITEM_BITS){1'b0}};
      assign refetch_enable   = 1'b0;
      assign refetch_address  = {INDEX_BITS{1'b0}};
    end else begin : g_references
      item_refetch #(
        .REFERENCES(REFERENCES),
        .ITEM_BITS (ITEM_BITS),
        .INDEX_BITS(INDEX_BITS)
      ) refetch (
        .aclk            (aclk),
        .aresetn         (aresetn),
        .s_refetch_tvalid(s_refetch_tvalid),
        .s_refetch_tready(s_refetch_tready),
        .s_refetch_tdata (s_refetch_tdata),
        .memory_enable   (refetch_enable),
        .memory_address  (refetch_address),
        .memory_read_data(refetched_item),
        .m_answer_tvalid (m_answer_tvalid),
        .m_answer_tready (m_answer_tready),
        .m_answer_tdata  (m_answer_tdata)
      );
    end
  endgenerate

  event_counter #(
    .COUNTER_BITS(COUNTER_BITS)
  ) report_counter (
    .aclk   (aclk),
    .aresetn(aresetn),
    .step   (m_axis_tvalid && m_axis_tready && !m_axis_tlast),
    .count  (reports)
  );

  event_counter #(
    .COUNTER_BITS(COUNTER_BITS)
  ) busy_counter (
    .aclk   (aclk),
    .aresetn(aresetn),
    .step   (busy),
    .count  (busy_cycles)
  );

  event_counter #(
    .COUNTER_BITS(COUNTER_BITS)
  ) stall_counter (
    .aclk   (aclk),
    .aresetn(aresetn),
    .step   (word_valid && !word_ready),
    .count  (stalled_cycles)
  );

endmodule

`default_nettype wire
