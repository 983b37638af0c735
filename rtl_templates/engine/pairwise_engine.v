// pairwise_engine: a pairwise engine without its arithmetic. It loads a set of items once and sends
// their words past the lanes of SEGMENTS segments in lock step, so that every pair i < j of items
// meets in a lane once. It gives out the pairs of interest; see docs/ports.md.
//
// Items come on s_axis, with tlast on the set's last and tuser on targets. A set that begins with
// targets makes only pairs of a target with another item. `item_word`, the part of an item that the
// lanes need, comes WORD_LATENCY cycles behind s_axis_tdata. Full items stay in their own memory,
// from which recomputations read them by number.
//
// Words leave to the first segment on m_word, and each segment's exceptions come back on s_entry;
// pair_segment describes both. The pairs of interest leave on STREAMS streams m_axis. Each stream
// serves its own segments, and the first also the references. Each ends a set with a closing beat,
// and the next set is taken when all have.
//
// The counters count the beats that have left each stream, without closing beats; recomputations;
// the cycles from a set's first item to its last closing beat; and the cycles in which a word was
// offered to the chain and not taken. Reset forgets the set; segments and references have to be
// reset with it.
`default_nettype none

module pairwise_engine #(
  parameter SEGMENTS = 2,           // segments of the chain, 1 or more
  parameter LANES_PER_SEGMENT = 4,  // lanes of the largest segment, 1 or more
  parameter LANES = 8,              // lanes of all segments, 1 or more
  parameter STREAMS = 1,            // streams of reports, 1 to SEGMENTS
  parameter REFERENCES = 1,         // number of references, 0 to 32; 0: undecided pairs leave
  parameter CAPACITY = 1024,        // items of the largest set, 2 to 2^INDEX_BITS
  parameter ITEM_BITS = 32,         // bits of an item, 1 or more
  parameter WORD_BITS = 32,         // bits of an item's word, 1 or more
  parameter WORD_LATENCY = 0,       // latency of the words in cycles, 0 or more
  parameter INDEX_BITS = 10,        // bits of an item's index, 1 to 30
  parameter REPORT = 11,            // 0 to 15: bit v is 1 where verdict v is reported
  parameter CODE_BITS = 3,          // bits of a code: 3, or 2 if at most one verdict is reported
  parameter BITMAP = 0,             // 0 or 1, as in pair_expander; 1 needs CODE_BITS = 2
  parameter COUNT = 0,              // 1: reported pairs are only counted, as in report_output
  parameter EVERY_CYCLE = -1,       // bit r is 1 where reference r takes a request in every cycle
  parameter OUTSTANDING_BITS = 5,   // 1 to 30: 2^OUTSTANDING_BITS pairs may be in progress
  parameter COUNTER_BITS = 32       // bits of a counter, which wraps; 0: no counters
) (
  input  wire                                                       aclk,
  input  wire                                                       aresetn,
  input  wire                                                       s_axis_tvalid,
  output wire                                                       s_axis_tready,
  input  wire [ITEM_BITS-1:0]                                       s_axis_tdata,
  input  wire                                                       s_axis_tuser,
  input  wire                                                       s_axis_tlast,
  input  wire [WORD_BITS-1:0]                                       item_word,
  output wire                                                       m_word_tvalid,
  input  wire                                                       m_word_tready,
  output wire [WORD_BITS+INDEX_BITS+3:0]                            m_word_tdata,
  input  wire [SEGMENTS-1:0]                                        s_entry_tvalid,
  output wire [SEGMENTS-1:0]                                        s_entry_tready,
  input  wire [SEGMENTS*(2*INDEX_BITS+LANES_PER_SEGMENT*CODE_BITS)-1:0] s_entry_tdata,
  input  wire [SEGMENTS-1:0]                                        s_entry_tlast,
  output wire [(REFERENCES > 0 ? REFERENCES : 1)-1:0]               m_request_tvalid,
  input  wire [(REFERENCES > 0 ? REFERENCES : 1)-1:0]               m_request_tready,
  output wire [2*INDEX_BITS-1:0]                                    m_request_tag,
  output wire [2*ITEM_BITS-1:0]                                     m_request_items,
  input  wire [(REFERENCES > 0 ? REFERENCES : 1)-1:0]               s_answer_valid,
  input  wire [(REFERENCES > 0 ? REFERENCES : 1)*(2*INDEX_BITS+2)-1:0] s_answer_tdata,
  output wire [STREAMS-1:0]                                         m_axis_tvalid,
  input  wire [STREAMS-1:0]                                         m_axis_tready,
  output wire [STREAMS*(8*((BITMAP*LANES_PER_SEGMENT+7)/8)+16*((INDEX_BITS+7)/8))-1:0] m_axis_tdata,
  output wire [STREAMS*8-1:0]                                       m_axis_tuser,
  output wire [STREAMS-1:0]                                         m_axis_tlast,
  output wire [STREAMS*(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]   reports,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]           recomputations,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]           busy_cycles,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0]           stalled_cycles
);

  localparam TAG_BITS     = 2 * INDEX_BITS;
  localparam ENTRY_BITS   = TAG_BITS + LANES_PER_SEGMENT * CODE_BITS;
  localparam PAIR_BITS    = TAG_BITS + INDEX_BITS;  // {lane, index j, index base}
  localparam RECOMPUTE    = (REFERENCES > 0) ? 1 : 0;
  localparam IN_CODES     = (COUNT != 0) ? 0 : REPORT;  // verdicts that the segments' codes carry
  localparam FLAG_BITS    = (BITMAP != 0) ? LANES_PER_SEGMENT : 1;
  localparam REPORT_BITS  = FLAG_BITS + 4 + TAG_BITS;
  localparam OUTPUT_FLAGS = (BITMAP != 0) ? LANES_PER_SEGMENT : 0;
  localparam TDATA_BITS   = 8 * ((OUTPUT_FLAGS + 7) / 8) + 16 * ((INDEX_BITS + 7) / 8);
  localparam COUNT_BITS   = (COUNT != 0) ? TAG_BITS : 0;
  localparam COUNTER_PORT = (COUNTER_BITS > 0) ? COUNTER_BITS : 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (SEGMENTS < 1) begin : g_refused_segments
      SEGMENTS_is_below_1 refused ();
    end else if (STREAMS < 1) begin : g_refused_streams
      STREAMS_is_below_1 refused ();
    end else if (STREAMS > SEGMENTS) begin : g_refused_idle_streams
      STREAMS_is_above_SEGMENTS refused ();
    end
    if (REFERENCES < 0) begin : g_refused_references REFERENCES_is_below_0 refused (); end
    if ((BITMAP != 0) && (BITMAP != 1))
      begin : g_refused_bitmap BITMAP_is_not_0_or_1 refused (); end
    if (COUNTER_BITS < 0) begin : g_refused_counter_bits COUNTER_BITS_is_below_0 refused (); end
  endgenerate

  // The set: items are counted as they come, and words are written WORD_LATENCY cycles later.
  wire                  kept;
  wire [INDEX_BITS-1:0] kept_index;
  wire                  place_free;
  wire                  ended;
  wire                  set_closed;
  wire                  busy;
  wire                  overrun;
  wire                  fetch_enable;

  item_loader #(
    .CAPACITY  (CAPACITY),
    .INDEX_BITS(INDEX_BITS)
  ) loader (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_axis_tvalid),
    .s_axis_tready(s_axis_tready),
    .s_axis_tlast (s_axis_tlast),
    .write_ready  (!fetch_enable),
    .kept         (kept),
    .kept_index   (kept_index),
    .place_free   (place_free),
    .ended        (ended),
    .set_closed   (set_closed),
    .busy         (busy),
    .overrun      (overrun)
  );

  wire                  stored;
  wire                  stored_end;
  wire                  stored_target;
  wire [INDEX_BITS-1:0] stored_index;

  valid_delay_line #(
    .LENGTH(WORD_LATENCY)
  ) kept_beside_word (
    .aclk   (aclk),
    .aresetn(aresetn),
    .d      (kept),
    .q      (stored)
  );

  valid_delay_line #(
    .LENGTH(WORD_LATENCY)
  ) ended_beside_word (
    .aclk   (aclk),
    .aresetn(aresetn),
    .d      (ended),
    .q      (stored_end)
  );

  delay_line #(
    .WIDTH (INDEX_BITS + 1),
    .LENGTH(WORD_LATENCY)
  ) index_beside_word (
    .aclk(aclk),
    .d   ({s_axis_tuser, kept_index}),
    .q   ({stored_target, stored_index})
  );

  // Words enter the chain.
  wire                  read_enable;
  wire [INDEX_BITS-1:0] read_address;
  wire [WORD_BITS-1:0]  read_word;
  wire                  word_close;
  wire                  word_first;
  wire                  word_stays;
  wire                  word_meets;
  wire [INDEX_BITS-1:0] word_index;

  dual_port_memory #(
    .WIDTH       (WORD_BITS),
    .ADDRESS_BITS(INDEX_BITS)
  ) word_memory (
    .aclk         (aclk),
    .write_enable (stored),
    .write_address(stored_index),
    .write_data   (item_word),
    .read_enable  (read_enable),
    .read_address (read_address),
    .read_data    (read_word)
  );

  pair_walker #(
    .LANES     (LANES),
    .CAPACITY  (CAPACITY),
    .INDEX_BITS(INDEX_BITS)
  ) walker (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .stored       (stored),
    .stored_target(stored_target),
    .ended        (stored_end),
    .set_closed   (set_closed),
    .read_enable  (read_enable),
    .read_address (read_address),
    .m_word_tvalid(m_word_tvalid),
    .m_word_tready(m_word_tready),
    .m_word_close (word_close),
    .m_word_first (word_first),
    .m_word_stays (word_stays),
    .m_word_meets (word_meets),
    .m_word_index (word_index)
  );

  assign m_word_tdata = {word_close, word_first, word_stays, word_meets, word_index, read_word};

  // The exceptions of each stream's segments become pairs, one after the other.
  wire [STREAMS-1:0]             report_valid;
  wire [STREAMS-1:0]             report_ready;
  wire [STREAMS*REPORT_BITS-1:0] report_data;
  wire [STREAMS-1:0]             report_last;
  wire [STREAMS-1:0]             undecided_valid;
  wire [STREAMS-1:0]             undecided_ready;
  wire [STREAMS*PAIR_BITS-1:0]   undecided_pair;
  wire [STREAMS-1:0]             undecided_last;

  genvar s;
  generate
    for (s = 0; s < STREAMS; s = s + 1) begin : g_stream
      localparam FIRST = (s * SEGMENTS) / STREAMS;
      localparam INPUTS = ((s + 1) * SEGMENTS) / STREAMS - FIRST;

      wire                  merged_valid;
      wire                  merged_ready;
      wire [ENTRY_BITS-1:0] merged;
      wire                  merged_last;
      wire                  entry_valid;
      wire                  entry_ready;
      wire [ENTRY_BITS-1:0] entry;
      wire                  entry_last;
      wire [TAG_BITS-1:0]   tag;
      wire [INDEX_BITS-1:0] lane;
      wire [TAG_BITS-1:0]   undecided_tag;
      wire [INDEX_BITS-1:0] undecided_lane;
      wire [FLAG_BITS-1:0]  flags;
      wire [1:0]            verdict;
      wire                  undecided;
      wire                  told_valid;
      wire                  told_ready;
      wire                  told_last;

      closing_tree #(
        .INPUTS    (INPUTS),
        .WIDTH     (ENTRY_BITS),
        .COUNT_BITS(COUNT_BITS)
      ) merge (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(s_entry_tvalid[FIRST +: INPUTS]),
        .s_axis_tready(s_entry_tready[FIRST +: INPUTS]),
        .s_axis_tdata (s_entry_tdata[FIRST*ENTRY_BITS +: INPUTS*ENTRY_BITS]),
        .s_axis_tlast (s_entry_tlast[FIRST +: INPUTS]),
        .m_axis_tvalid(merged_valid),
        .m_axis_tready(merged_ready),
        .m_axis_tdata (merged),
        .m_axis_tlast (merged_last)
      );

      // Registers cut the path of tready from the report port to the segments.
      stream_fifo #(
        .WIDTH     (ENTRY_BITS + 1),
        .DEPTH_BITS(1)
      ) entries (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(merged_valid),
        .s_axis_tready(merged_ready),
        .s_axis_tdata ({merged_last, merged}),
        .m_axis_tvalid(entry_valid),
        .m_axis_tready(entry_ready),
        .m_axis_tdata ({entry_last, entry})
      );

      pair_expander #(
        .LANES     (LANES_PER_SEGMENT),
        .INDEX_BITS(INDEX_BITS),
        .REPORT    (IN_CODES),
        .CODE_BITS (CODE_BITS),
        .BITMAP    (BITMAP),
        .RECOMPUTE (RECOMPUTE)
      ) expander (
        .aclk              (aclk),
        .aresetn           (aresetn),
        .s_axis_tvalid     (entry_valid),
        .s_axis_tready     (entry_ready),
        .s_axis_tdata      (entry),
        .s_axis_tlast      (entry_last),
        .m_report_tvalid   (told_valid),
        .m_report_tready   (told_ready),
        .m_report_tag      (tag),
        .m_report_lane     (lane),
        .m_report_flags    (flags),
        .m_report_verdict  (verdict),
        .m_report_undecided(undecided),
        .m_report_tlast    (told_last),
        .m_pair_tvalid     (undecided_valid[s]),
        .m_pair_tready     (undecided_ready[s]),
        .m_pair_tag        (undecided_tag),
        .m_pair_lane       (undecided_lane),
        .m_pair_tlast      (undecided_last[s])
      );

      assign undecided_pair[s*PAIR_BITS +: PAIR_BITS] = {undecided_lane, undecided_tag};

      // A verdict's arrival has no effect on the expander in the same cycle. Index i is added up
      // behind the queue. Both hold because the expander takes most of a cycle.
      wire [FLAG_BITS+3:0]  report_kind;
      wire [INDEX_BITS-1:0] report_lane;
      wire [INDEX_BITS-1:0] report_j;
      wire [INDEX_BITS-1:0] report_base;
      wire [INDEX_BITS-1:0] report_i = report_base + report_lane;

      stream_fifo #(
        .WIDTH     (1 + FLAG_BITS + 4 + PAIR_BITS),
        .DEPTH_BITS(1)
      ) told (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(told_valid),
        .s_axis_tready(told_ready),
        .s_axis_tdata ({told_last, flags, undecided, 1'b0, verdict, lane, tag}),
        .m_axis_tvalid(report_valid[s]),
        .m_axis_tready(report_ready[s]),
        .m_axis_tdata ({report_last[s], report_kind, report_lane, report_j, report_base})
      );

      assign report_data[s*REPORT_BITS +: REPORT_BITS] = {report_kind, report_j, report_i};
    end
  endgenerate

  // Undecided pairs go to the references; their verdicts leave with the reports of stream 0.
  wire                   first_valid;
  wire                   first_ready;
  wire [REPORT_BITS-1:0] first_data;
  wire                   first_last;
  wire                   recomputed;

  generate
    if (REFERENCES == 0) begin : g_no_references
      wire unused_inputs = &{undecided_valid, undecided_pair, undecided_last, m_request_tready,
                             s_answer_valid, s_answer_tdata, s_axis_tdata, place_free};

      assign undecided_ready  = {STREAMS{1'b1}};
      assign m_request_tvalid = 1'b0;
      assign m_request_tag    = {TAG_BITS{1'b0}};
      assign m_request_items  = {(2*ITEM_BITS){1'b0}};
      assign fetch_enable     = 1'b0;
      assign recomputed       = 1'b0;
      assign first_valid      = report_valid[0];
      assign first_data       = report_data[REPORT_BITS-1:0];
      assign first_last       = report_last[0];
      assign report_ready[0]  = first_ready;
    end else begin : g_references
      localparam [FLAG_BITS-1:0] ONE_FLAG = 1;

      wire                 pair_valid;
      wire                 pair_ready;
      wire [INDEX_BITS-1:0] pair_lane;
      wire [INDEX_BITS-1:0] pair_j;
      wire [INDEX_BITS-1:0] pair_base;
      wire [INDEX_BITS-1:0] pair_i = pair_base + pair_lane;
      wire                 pair_last;
      wire                 verdict_valid;
      wire                 verdict_ready;
      wire [TAG_BITS+1:0]  verdict;
      wire                 verdict_last;
      wire [TAG_BITS-1:0]    fetch_addresses;
      wire [2*ITEM_BITS-1:0] fetched_items;
      wire [REPORT_BITS-1:0] verdict_data =
          {ONE_FLAG, 2'b01, verdict[1:0], verdict[2 +: TAG_BITS]};

      // In every cycle that does not read, the first free place is written with whatever is
      // offered. The last write is the item that takes the place. So the memory does not depend on
      // s_axis_tready.
      item_memory #(
        .WIDTH       (ITEM_BITS),
        .ADDRESS_BITS(INDEX_BITS)
      ) items (
        .aclk        (aclk),
        .i_enable    (fetch_enable || place_free),
        .i_write     (!fetch_enable),
        .i_address   (fetch_enable ? fetch_addresses[INDEX_BITS-1:0] : kept_index),
        .i_write_data(s_axis_tdata),
        .i_read_data (fetched_items[ITEM_BITS-1:0]),
        .j_enable    (fetch_enable),
        .j_address   (fetch_addresses[INDEX_BITS +: INDEX_BITS]),
        .j_read_data (fetched_items[ITEM_BITS +: ITEM_BITS])
      );

      // The choice among the streams' pairs has no effect on the expanders in the same cycle.
      wire [STREAMS-1:0]           queued_valid;
      wire [STREAMS-1:0]           queued_ready;
      wire [STREAMS*PAIR_BITS-1:0] queued_pair;
      wire [STREAMS-1:0]           queued_last;

      for (s = 0; s < STREAMS; s = s + 1) begin : g_queued
        stream_fifo #(
          .WIDTH     (1 + PAIR_BITS),
          .DEPTH_BITS(1)
        ) queued (
          .aclk         (aclk),
          .aresetn      (aresetn),
          .s_axis_tvalid(undecided_valid[s]),
          .s_axis_tready(undecided_ready[s]),
          .s_axis_tdata ({undecided_last[s], undecided_pair[s*PAIR_BITS +: PAIR_BITS]}),
          .m_axis_tvalid(queued_valid[s]),
          .m_axis_tready(queued_ready[s]),
          .m_axis_tdata ({queued_last[s], queued_pair[s*PAIR_BITS +: PAIR_BITS]})
        );
      end

      closing_tree #(
        .INPUTS(STREAMS),
        .WIDTH (PAIR_BITS)
      ) merge_undecided (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(queued_valid),
        .s_axis_tready(queued_ready),
        .s_axis_tdata (queued_pair),
        .s_axis_tlast (queued_last),
        .m_axis_tvalid(pair_valid),
        .m_axis_tready(pair_ready),
        .m_axis_tdata ({pair_lane, pair_j, pair_base}),
        .m_axis_tlast (pair_last)
      );

      pair_recomputation #(
        .REFERENCES      (REFERENCES),
        .ITEM_BITS       (ITEM_BITS),
        .INDEX_BITS      (INDEX_BITS),
        .REPORT          (REPORT),
        .EVERY_CYCLE     (EVERY_CYCLE),
        .OUTSTANDING_BITS(OUTSTANDING_BITS)
      ) recomputation (
        .aclk            (aclk),
        .aresetn         (aresetn),
        .s_pair_tvalid   (pair_valid),
        .s_pair_tready   (pair_ready),
        .s_pair_tag      ({pair_j, pair_i}),
        .s_pair_tlast    (pair_last),
        .memory_enable   (fetch_enable),
        .memory_addresses(fetch_addresses),
        .memory_items    (fetched_items),
        .m_request_tvalid(m_request_tvalid),
        .m_request_tready(m_request_tready),
        .m_request_tag   (m_request_tag),
        .m_request_items (m_request_items),
        .s_answer_valid  (s_answer_valid),
        .s_answer_tdata  (s_answer_tdata),
        .m_axis_tvalid   (verdict_valid),
        .m_axis_tready   (verdict_ready),
        .m_axis_tdata    (verdict),
        .m_axis_tlast    (verdict_last),
        .answered        (recomputed)
      );

      closing_tree #(
        .INPUTS    (2),
        .WIDTH     (REPORT_BITS),
        .COUNT_BITS(COUNT_BITS)
      ) merge_verdicts (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid({verdict_valid, report_valid[0]}),
        .s_axis_tready({verdict_ready, report_ready[0]}),
        .s_axis_tdata ({verdict_data, report_data[REPORT_BITS-1:0]}),
        .s_axis_tlast ({verdict_last, report_last[0]}),
        .m_axis_tvalid(first_valid),
        .m_axis_tready(first_ready),
        .m_axis_tdata (first_data),
        .m_axis_tlast (first_last)
      );
    end
  endgenerate

  // The output. The set is over when every stream has given its closing beat.
  reg  [STREAMS-1:0] closed_q;
  wire [STREAMS-1:0] closes = m_axis_tvalid & m_axis_tready & m_axis_tlast;

  assign set_closed = ((closed_q | closes) == {STREAMS{1'b1}});

  always @(posedge aclk) begin
    if (!aresetn || set_closed) begin
      closed_q <= {STREAMS{1'b0}};
    end else begin
      closed_q <= closed_q | closes;
    end
  end

  generate
    for (s = 0; s < STREAMS; s = s + 1) begin : g_output
      wire                   out_valid;
      wire                   out_ready;
      wire [REPORT_BITS-1:0] out_data;
      wire                   out_last;

      if (s == 0) begin : g_first
        assign out_valid   = first_valid;
        assign out_data    = first_data;
        assign out_last    = first_last;
        assign first_ready = out_ready;
      end else begin : g_other
        assign out_valid       = report_valid[s];
        assign out_data        = report_data[s*REPORT_BITS +: REPORT_BITS];
        assign out_last        = report_last[s];
        assign report_ready[s] = out_ready;
      end

      report_output #(
        .INDEX_BITS(INDEX_BITS),
        .FLAG_BITS (OUTPUT_FLAGS),
        .COUNT     (COUNT)
      ) out (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(out_valid),
        .s_axis_tready(out_ready),
        .s_axis_tdata (out_data),
        .s_axis_tlast (out_last),
        .overrun      (overrun),
        .m_axis_tvalid(m_axis_tvalid[s]),
        .m_axis_tready(m_axis_tready[s]),
        .m_axis_tdata (m_axis_tdata[s*TDATA_BITS +: TDATA_BITS]),
        .m_axis_tuser (m_axis_tuser[s*8 +: 8]),
        .m_axis_tlast (m_axis_tlast[s])
      );

      event_counter #(
        .COUNTER_BITS(COUNTER_BITS)
      ) report_counter (
        .aclk   (aclk),
        .aresetn(aresetn),
        .step   (m_axis_tvalid[s] && m_axis_tready[s] && !m_axis_tlast[s]),
        .count  (reports[s*COUNTER_PORT +: COUNTER_PORT])
      );
    end
  endgenerate

  event_counter #(
    .COUNTER_BITS(COUNTER_BITS)
  ) recomputation_counter (
    .aclk   (aclk),
    .aresetn(aresetn),
    .step   (recomputed),
    .count  (recomputations)
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
    .step   (m_word_tvalid && !m_word_tready),
    .count  (stalled_cycles)
  );

endmodule

`default_nettype wire
