// Test bench of @DUT@ that checks itself, in plain Verilog-2001 for any simulator.
//
// It sends @COUNT@ comparisons through the system, four times: at full rate, with idle cycles, with
// backpressure, and with both. They are of the scene's data, the last ones with zeros, NaNs,
// infinities or ends of the format's range in the place of operands. Comparison k goes to lane k
// modulo @LANES@.
@IF GROUPED@
// Lanes are in groups of @LANES_PER_GROUP@ in lock step. Comparisons enter a group in words, one
// for each of its lanes.
@END@
// Each result must leave once, on its lane, with its tag, and with the verdict and the flags that
// the golden model of mixcmp computed when this file was written. It prints
//   PASSED: ...   and ends with $finish, or
//   FAILED: ...   after a line for each of the first failures, and ends with $stop.
// Verilog-2001 has no exit code. Verilator makes one of $stop, and Icarus has $fatal.
//
// Arguments of the simulation, all optional:
//   +vectors=FILE  @DUT@_tb.hex in another place than the working folder
//   +waves=FILE    write all signals there ($dumpfile)
//   +seed=N        other idle cycles and other backpressure; N from 0 to 2147483647
//
@PROVENANCE@

`default_nettype none

module @DUT@_tb;

  // The system's signature, @DUT@.json.
  localparam LANES = @LANES@;
@IF GROUPED@
  localparam LANES_PER_GROUP = @LANES_PER_GROUP@;
  localparam GROUPS = LANES / LANES_PER_GROUP;
@END@
  localparam REFETCH_STREAMS = @REFETCH_STREAMS@;
  localparam TDATA_BITS = @TDATA_BITS@;
  localparam TAG_BITS = @TAG_BITS@;
  localparam COUNTER_BITS = @COUNTER_BITS@;
  localparam IN_ORDER = @IN_ORDER@;

  localparam COUNT = @COUNT@;  // comparisons in the file of vectors
  localparam VECTORS = COUNT;  // its lines
  localparam PASSES = 4;
  localparam MAX_FAILURES = 10;       // so many are described, then the simulation ends
  localparam TIME_OUT_CYCLES = 5000;  // in which no lane takes or returns a comparison

@IF UNGROUPED@
  // Comparison k has the tag k; a tag of more than 30 bits has ones above.
@END@
@IF GROUPED@
  // Comparison k has the tag k / COMPARISONS_PER_TAG; a tag of more than 30 bits has ones above.
  // The tag of a word is that of its first comparison.
  localparam COMPARISONS_PER_TAG = @COMPARISONS_PER_TAG@;
@END@
  localparam INDEX_BITS = (TAG_BITS < 30) ? TAG_BITS : 30;
  localparam [31:0] TAG_LIMIT = 32'd1 << INDEX_BITS;

  reg                         aclk;
  reg                         aresetn;
  reg  [LANES-1:0]            s_axis_tvalid;
  wire [LANES-1:0]            s_axis_tready;
  reg  [LANES*TDATA_BITS-1:0] s_axis_tdata;
  reg  [LANES*TAG_BITS-1:0]   s_axis_tuser;
  wire [LANES-1:0]            m_axis_tvalid;
  reg  [LANES-1:0]            m_axis_tready;
  wire [LANES*8-1:0]          m_axis_tdata;
  wire [LANES*TAG_BITS-1:0]   m_axis_tuser;
@IF COUNTER_OUTPUTS@
  wire [@COUNTED@*COUNTER_BITS-1:0] comparisons;
  wire [@COUNTED@*COUNTER_BITS-1:0] recomputations;
  wire [@COUNTED@*COUNTER_BITS-1:0] stalls;
@END@
@IF COUNTER_PORT@
@INCLUDE testbench_counter_reader.v@
@END@
@IF REFETCHED@
  localparam TAG_FIELD = 8 * ((TAG_BITS + 7) / 8);
  wire [REFETCH_STREAMS-1:0]            m_refetch_tvalid;
  wire [REFETCH_STREAMS-1:0]            m_refetch_tready;
  wire [REFETCH_STREAMS*TAG_FIELD-1:0]  m_refetch_tdata;
  wire [REFETCH_STREAMS-1:0]            s_refetch_tvalid;
  wire [REFETCH_STREAMS-1:0]            s_refetch_tready;
  wire [REFETCH_STREAMS*TDATA_BITS-1:0] s_refetch_tdata;
@END@

  @DUT@ system (
      .aclk(aclk),
      .aresetn(aresetn),
@IF COUNTER_OUTPUTS@
      .comparisons(comparisons),
      .recomputations(recomputations),
      .stalls(stalls),
@END@
@IF COUNTED_ANSWERS@
      .answers(),
@END@
@IF COUNTER_PORT@
@INCLUDE testbench_counter_bus.v@
@END@
@IF REFETCHED@
      .m_refetch_tvalid(m_refetch_tvalid),
      .m_refetch_tready(m_refetch_tready),
      .m_refetch_tdata(m_refetch_tdata),
      .s_refetch_tvalid(s_refetch_tvalid),
      .s_refetch_tready(s_refetch_tready),
      .s_refetch_tdata(s_refetch_tdata),
@END@
      .s_axis_tvalid(@GROUP_PREFIX@s_axis_tvalid),
      .s_axis_tready(@GROUP_PREFIX@s_axis_tready),
      .s_axis_tdata(s_axis_tdata),
      .s_axis_tuser(@GROUP_PREFIX@s_axis_tuser),
      .m_axis_tvalid(@GROUP_PREFIX@m_axis_tvalid),
      .m_axis_tready(@GROUP_PREFIX@m_axis_tready),
      .m_axis_tdata(m_axis_tdata),
      .m_axis_tuser(@GROUP_PREFIX@m_axis_tuser)
  );

  localparam [1:0] WAITING = 2'd0;
  localparam [1:0] INSIDE = 2'd1;
  localparam [1:0] LEFT = 2'd2;

  // A line of the file: the result that is expected, 8 bits, above the operands.
  reg [TDATA_BITS+7:0] vectors [0:VECTORS-1];
  reg [1:0]            status [0:COUNT-1];

  integer              next_offer [0:LANES-1];   // the lane's next comparison, or the offered one
  integer              next_result [0:LANES-1];  // its next one to leave, if they leave in order
  reg                  offering [0:LANES-1];
  reg                  waiting [0:LANES-1];      // a result of the lane waits for tready
  reg [7:0]            waiting_tdata [0:LANES-1];
  reg [TAG_BITS-1:0]   waiting_tag [0:LANES-1];
  reg [31:0]           accepted [0:LANES-1];
  reg [31:0]           recomputed [0:LANES-1];
  reg [31:0]           stalled [0:LANES-1];
  // Of 256 cycles, those with an offer and those with tready high; drawn anew every 64 cycles.
  reg [8:0]            offer_density [0:LANES-1];
  reg [8:0]            ready_density [0:LANES-1];

  reg [LANES-1:0]  valid_before;  // m_axis_tvalid before tready takes this cycle's value
  reg [8*1024-1:0] file_name;
  reg [31:0]       random_state;
  reg              idle_cycles;
  reg              backpressure;
  reg              pausing;     // no lane is offered another comparison until all have left
  reg              has_paused;  // in this pass
  reg              stopped;  // by a time-out, or after so many failures
  integer          pass;
  integer          cycle;
  integer          last_progress;
  integer          oldest;      // all comparisons before it have left
  integer          taken_count;  // in this pass
  integer          left_count;   // in this pass
  integer          results;
  integer          recomputed_count;
  integer          failures;

@INCLUDE testbench_common.v@
@IF GROUPED@
@INCLUDE testbench_groups.v@
@END@
  function [TAG_BITS-1:0] tag_of(input integer index);
    reg [TAG_BITS+29:0] wide;
@IF GROUPED@
    integer             number;
@END@
    begin
@IF UNGROUPED@
      wide = {{TAG_BITS{1'b1}}, index[29:0]};
@END@
@IF GROUPED@
      number = index / COMPARISONS_PER_TAG;
      wide = {{TAG_BITS{1'b1}}, number[29:0]};
@END@
      tag_of = wide[TAG_BITS-1:0];
    end
  endfunction

@IF UNGROUPED@
  // The comparison with this tag, or -1. Those inside are fewer than TAG_LIMIT after the oldest.
@END@
@IF GROUPED@
  // The first comparison with this tag, or -1. Tags inside are fewer than TAG_LIMIT after the
  // oldest.
@END@
  function integer index_of(input [TAG_BITS-1:0] tag);
    reg [TAG_BITS+31:0] wide;
    begin
      wide = {32'd0, tag};
@IF UNGROUPED@
      index_of = oldest + ((wide[31:0] - oldest) & (TAG_LIMIT - 32'd1));
@END@
@IF GROUPED@
      index_of = oldest / COMPARISONS_PER_TAG;
      index_of = index_of + ((wide[31:0] - index_of) & (TAG_LIMIT - 32'd1));
      index_of = index_of * COMPARISONS_PER_TAG;
@END@
      if (index_of >= COUNT) index_of = -1;
      else if (tag_of(index_of) !== tag) index_of = -1;
    end
  endfunction

  task draw;
    begin
      random_state = next_random(random_state);
    end
  endtask

@INCLUDE testbench_verdict.v@
  task check_result(input integer index, input integer lane, input [7:0] tdata);
    reg [7:0] expected;
    reg [7:0] compared;  // the verdict of an undecided comparison has no meaning
    begin
      expected = vectors[index][TDATA_BITS +: 8];
      compared = expected[3] ? 8'hfc : 8'hff;
      if (((tdata ^ expected) & compared) !== 8'd0) begin
        $write("comparison %0d, lane %0d, pass %0d, cycle %0d: expected ",
               index, lane, pass, cycle);
        write_word(expected);
        $write("; got ");
        write_word(tdata);
        $display("; operands %h", vectors[index][TDATA_BITS-1:0]);
        count_failure;
      end
    end
  endtask

  task receive(input integer lane, input [TAG_BITS-1:0] tag, input [7:0] tdata);
    integer index;
    begin
      index = index_of(tag);
@IF GROUPED@
      if (index >= 0) index = index + lane % LANES_PER_GROUP;
@END@
      if (index < 0) begin
        $display("lane %0d, pass %0d, cycle %0d: a result with the unknown tag %h",
                 lane, pass, cycle, tag);
        count_failure;
      end else if ((status[index] != INSIDE) || (index % LANES != lane)) begin
        $display("lane %0d, pass %0d, cycle %0d: a result of comparison %0d, which is not inside",
                 lane, pass, cycle, index);
        count_failure;
      end else begin
        if ((IN_ORDER != 0) && (index != next_result[lane])) begin
          $display("lane %0d, pass %0d, cycle %0d: comparison %0d overtook comparison %0d",
                   lane, pass, cycle, index, next_result[lane]);
          count_failure;
        end
        next_result[lane] = index + LANES;
        status[index] = LEFT;
        left_count = left_count + 1;
        results = results + 1;
        last_progress = cycle;
        if (tdata[3:2] != 2'b00) begin
          recomputed[lane] = recomputed[lane] + 32'd1;
          recomputed_count = recomputed_count + 1;
        end
        check_result(index, lane, tdata);
      end
    end
  endtask

  task sample_offer(input integer lane);
    begin
      if (s_axis_tready[lane] === 1'b1) begin
        status[next_offer[lane]] = INSIDE;
        next_offer[lane] = next_offer[lane] + LANES;
        offering[lane] = 1'b0;
        accepted[lane] = accepted[lane] + 32'd1;
        taken_count = taken_count + 1;
        last_progress = cycle;
      end else begin
        stalled[lane] = stalled[lane] + 32'd1;
      end
    end
  endtask

  task sample_result(input integer lane);
    reg                valid;
    reg [7:0]          tdata;
    reg [TAG_BITS-1:0] tag;
    begin
      valid = m_axis_tvalid[lane];
      tdata = m_axis_tdata[lane*8 +: 8];
      tag = m_axis_tuser[lane*TAG_BITS +: TAG_BITS];
      if ((^{valid, s_axis_tready[lane]} === 1'bx) || (valid && (^{tdata, tag} === 1'bx))) begin
        $display("lane %0d, pass %0d, cycle %0d: x or z on a handshake or on a result",
                 lane, pass, cycle);
        count_failure;
      end else if (waiting[lane] && (!valid || ({tdata, tag} != {waiting_tdata[lane],
                                                                waiting_tag[lane]}))) begin
        $display("lane %0d, pass %0d, cycle %0d: a result changed before tready rose",
                 lane, pass, cycle);
        count_failure;
      end
      if ((valid === 1'b1) && m_axis_tready[lane]) receive(lane, tag, tdata);
      waiting[lane] = (valid === 1'b1) && !m_axis_tready[lane];
      waiting_tdata[lane] = tdata;
      waiting_tag[lane] = tag;
    end
  endtask

  task drive_lane(input integer lane);
    begin
      if (cycle % 64 == 0) begin
        draw;
        offer_density[lane] = idle_cycles ? {1'b0, random_state[7:0]} : 9'd256;
        ready_density[lane] = backpressure ? {1'b0, random_state[15:8]} : 9'd256;
      end
      draw;
      if (!offering[lane] && !pausing && (next_offer[lane] < COUNT)
@IF UNGROUPED@
          && (next_offer[lane] - oldest < TAG_LIMIT)
@END@
@IF GROUPED@
          && tags_are_free(next_offer[lane])
@END@
          && ({1'b0, random_state[7:0]} < offer_density[lane])) begin
        offering[lane] = 1'b1;
        s_axis_tdata[lane*TDATA_BITS +: TDATA_BITS] = vectors[next_offer[lane]][TDATA_BITS-1:0];
        s_axis_tuser[lane*TAG_BITS +: TAG_BITS] = tag_of(next_offer[lane]);
      end
      s_axis_tvalid[lane] = offering[lane];
      m_axis_tready[lane] = {1'b0, random_state[15:8]} < ready_density[lane];
    end
  endtask

  // Inputs change while aclk is low, and outputs are read before it rises.
  task clock_cycle;
    integer k;
    begin
      aclk = 1'b0;
      #1;
      valid_before = m_axis_tvalid;
@IF UNGROUPED@
      if (aresetn) for (k = 0; k < LANES; k = k + 1) drive_lane(k);
@END@
@IF GROUPED@
      if (aresetn) for (k = 0; k < LANES; k = k + 1) begin
        if (k % LANES_PER_GROUP == 0) drive_lane(k);
        else drive_with(k, k - k % LANES_PER_GROUP);
      end
@END@
      #1;
      if (aresetn) begin
        if (m_axis_tvalid !== valid_before) begin
          $display("pass %0d, cycle %0d: m_axis_tvalid follows m_axis_tready", pass, cycle);
          count_failure;
        end
        for (k = 0; k < LANES; k = k + 1) begin
          if (offering[k]) sample_offer(k);
          sample_result(k);
        end
        while ((oldest < COUNT) && (status[oldest] == LEFT)) oldest = oldest + 1;
      end
      aclk = 1'b1;
      #2;
      cycle = cycle + 1;
    end
  endtask

  task report_time_out;
    integer k;
    begin
      $display("time-out: nothing has moved in %0d cycles of pass %0d", TIME_OUT_CYCLES, pass);
      stopped = 1'b1;
      failures = failures + 1;
      for (k = 0; k < COUNT; k = k + 1) begin
        if ((status[k] == INSIDE) && (failures < MAX_FAILURES)) begin
          $display("comparison %0d, lane %0d, pass %0d: the result has not left",
                   k, k % LANES, pass);
          failures = failures + 1;
        end
      end
      for (k = 0; k < LANES; k = k + 1) begin
        if (offering[k] && (failures < MAX_FAILURES)) begin
          $display("comparison %0d, lane %0d, pass %0d: not accepted", next_offer[k], k, pass);
          failures = failures + 1;
        end
      end
    end
  endtask

  task run_pass;
    integer k;
    begin
      oldest = 0;
      taken_count = 0;
      left_count = 0;
      pausing = 1'b0;
      has_paused = 1'b0;
      last_progress = cycle;
      for (k = 0; k < COUNT; k = k + 1) status[k] = WAITING;
      for (k = 0; k < LANES; k = k + 1) begin
        next_offer[k] = k;
        next_result[k] = k;
        offer_density[k] = 9'd256;
        ready_density[k] = 9'd256;
      end
      while ((left_count < COUNT) && !stopped) begin
        clock_cycle;
        if (cycle - last_progress > TIME_OUT_CYCLES) report_time_out;
@IF COUNTS@
        // Half way, lanes with idle cycles have taken different numbers of comparisons.
        if (!has_paused && (left_count >= COUNT / 2)) pausing = 1'b1;
        if (pausing && (left_count == taken_count) && !stopped) begin
          check_counters;
          pausing = 1'b0;
          has_paused = 1'b1;
        end
@END@
      end
      for (k = 0; (k < 64) && !stopped; k = k + 1) clock_cycle;  // in which nothing may leave
    end
  endtask

  task reset;
    integer k;
    begin
      for (k = 0; k < LANES; k = k + 1) begin
        offering[k] = 1'b0;
        waiting[k] = 1'b0;
        accepted[k] = 32'd0;
        recomputed[k] = 32'd0;
        stalled[k] = 32'd0;
      end
      s_axis_tvalid = {LANES{1'b0}};
      s_axis_tdata = {(LANES*TDATA_BITS){1'b0}};
      s_axis_tuser = {(LANES*TAG_BITS){1'b0}};
      m_axis_tready = {LANES{1'b0}};
      aresetn = 1'b0;
      clock_cycle;
      clock_cycle;
      if (m_axis_tvalid !== {LANES{1'b0}}) begin
        $display("cycle %0d: m_axis_tvalid is not low in reset", cycle);
        count_failure;
      end
      aresetn = 1'b1;
    end
  endtask

@IF COUNTS@
  task check_counters;
    integer k;
    begin
@IF COUNTER_PORT@
      read_counters;
@END@
@IF UNGROUPED@
      for (k = 0; k < LANES; k = k + 1) begin
        check_counter("comparisons", k, comparisons[k*COUNTER_BITS +: COUNTER_BITS], accepted[k]);
        check_counter("recomputations", k, recomputations[k*COUNTER_BITS +: COUNTER_BITS],
                      recomputed[k]);
        check_counter("stalls", k, stalls[k*COUNTER_BITS +: COUNTER_BITS], stalled[k]);
      end
@END@
@IF GROUPED@
      clock_cycle;  // several undecided results of one cycle are counted a cycle later
      for (k = 0; k < GROUPS; k = k + 1) begin
        check_counter("comparisons", k, comparisons[k*COUNTER_BITS +: COUNTER_BITS],
                      accepted[k*LANES_PER_GROUP]);
        check_counter("recomputations", k, recomputations[k*COUNTER_BITS +: COUNTER_BITS],
                      recomputed_in_group(k));
        check_counter("stalls", k, stalls[k*COUNTER_BITS +: COUNTER_BITS],
                      stalled[k*LANES_PER_GROUP]);
      end
@END@
    end
  endtask

@END@
@IF REFETCHED@
@INCLUDE testbench_refetch.v@
@END@
  task finish;
    begin
      if (failures == 0) begin
        $write("PASSED: %0d comparisons (%0d, %0d times)", results, COUNT, PASSES);
        $display(", %0d recomputed or undecided, %0d cycles", recomputed_count, cycle);
        $finish;
      end else begin
        $display("FAILED: %0d failure(s), %0d of %0d comparisons have left",
                 failures, results, PASSES * COUNT);
        stop;
      end
    end
  endtask

  initial begin
    aclk = 1'b1;
    pass = 0;
    cycle = 0;
    results = 0;
    recomputed_count = 0;
    failures = 0;
    stopped = 1'b0;
    oldest = 0;
    read_arguments;
    idle_cycles = 1'b0;
    backpressure = 1'b0;
    reset;
    for (pass = 1; (pass <= PASSES) && !stopped; pass = pass + 1) begin
      idle_cycles = (pass == 2) || (pass == 4);
      backpressure = (pass == 3) || (pass == 4);
      run_pass;
    end
@IF COUNTS@
    if (!stopped) check_counters;
@END@
    finish;
  end

endmodule

`default_nettype wire
@IF COUNTER_PORT@

@INCLUDE counter_reader.v@
@END@
