// Test bench of the pairwise engine @DUT@ that checks itself, in plain Verilog-2001 for any
// simulator.
//
// It sends a set of @ITEMS@ items of the scene's data, four times: at full rate, with idle cycles,
// with backpressure, and with both. Each of the set's pairs must be reported once where its verdict
// asks for it, else not at all, with the verdict and the flags that the golden model of mixcmp
// computed when this file was written; then each stream's closing beat must leave. It prints
//   PASSED: ...   and ends with $finish, or
//   FAILED: ...   after a line for each of the first failures, and ends with $stop.
// Verilog-2001 has no exit code. Verilator makes one of $stop, and Icarus has $fatal.
//
// Arguments of the simulation, all optional:
//   +vectors=FILE  @DUT@_tb.hex in another place than the working folder
//   +waves=FILE    write all signals there ($dumpfile)
//   +seed=N        other idle cycles and other backpressure
//
@PROVENANCE@

`default_nettype none

module @DUT@_tb;

  // The system's signature, @TOP@.json.
  localparam LANES = @LANES@;
  localparam ITEM_BITS = @ITEM_BITS@;
  localparam FIELD_BITS = @FIELD_BITS@;  // of an item's number in m_axis_tdata
  localparam FLAG_BITS = @FLAG_BITS@;  // of a bitmap's beat, bit k about item i + k; 0: a pair a beat
  localparam COUNT_ONLY = @COUNT_ONLY@;  // no report leaves, the closing beats count them
  localparam COUNTER_BITS = @COUNTER_BITS@;
  localparam STREAMS = @STREAMS@;  // m_axis
  localparam TDATA_BITS = @TDATA_BITS@;
  localparam TUSER_BITS = 8;
  localparam BEAT_BITS = TDATA_BITS + TUSER_BITS + 1;
  // Bit v: pairs with verdict v (0 less, 1 equal, 2 greater, 3 unordered) are reported. Undecided
  // pairs always are.
  localparam [3:0] REPORTED_VERDICTS = 4'b@REPORTED_VERDICTS@;

  localparam ITEMS = @ITEMS@;
  localparam TARGETS = @TARGETS@;  // the first items, which meet the others alone; 0: all meet
  localparam PAIRS = (TARGETS > 0) ? TARGETS * (ITEMS - TARGETS) : ITEMS * (ITEMS - 1) / 2;
  localparam VECTORS = ITEMS + PAIRS;  // lines of the file: items, then expected words of pairs
  localparam PASSES = 4;
  localparam MAX_FAILURES = 10;       // so many are described, then the simulation ends
  localparam TIME_OUT_CYCLES = 5000;  // in which no item is taken and no beat leaves

  reg                           aclk;
  reg                           aresetn;
  reg                           s_axis_tvalid;
  wire                          s_axis_tready;
  reg  [ITEM_BITS-1:0]          s_axis_tdata;
  reg                           s_axis_tuser;
  reg                           s_axis_tlast;
  wire [STREAMS-1:0]            m_axis_tvalid;
  reg  [STREAMS-1:0]            m_axis_tready;
  wire [STREAMS*TDATA_BITS-1:0] m_axis_tdata;
  wire [STREAMS*TUSER_BITS-1:0] m_axis_tuser;
  wire [STREAMS-1:0]            m_axis_tlast;
@IF COUNTER_OUTPUTS@
  wire [STREAMS*COUNTER_BITS-1:0] reports;
  wire [COUNTER_BITS-1:0]         recomputations;
@END@
@IF COUNTER_PORT@
@INCLUDE testbench_counter_reader.v@
@END@

  @DUT@ engine (
      .aclk(aclk),
      .aresetn(aresetn),
@IF COUNTER_OUTPUTS@
      .reports(reports),
      .recomputations(recomputations),
      .busy_cycles(),
      .stalled_cycles(),
@END@
@IF COUNTER_PORT@
@INCLUDE testbench_counter_bus.v@
@END@
      .s_axis_tvalid(s_axis_tvalid),
      .s_axis_tready(s_axis_tready),
      .s_axis_tdata(s_axis_tdata),
      .s_axis_tuser(s_axis_tuser),
      .s_axis_tlast(s_axis_tlast),
      .m_axis_tvalid(m_axis_tvalid),
      .m_axis_tready(m_axis_tready),
      .m_axis_tdata(m_axis_tdata),
      .m_axis_tuser(m_axis_tuser),
      .m_axis_tlast(m_axis_tlast)
  );

  reg [ITEM_BITS-1:0]    vectors [0:VECTORS-1];
  reg                    reported [0:PAIRS-1];  // in this pass
  reg [STREAMS-1:0]      waiting;  // a beat waits for tready
  reg [STREAMS*BEAT_BITS-1:0] waiting_beats;
  reg [STREAMS-1:0]      valid_before;  // m_axis_tvalid before tready takes this cycle's value
  reg [8*1024-1:0]       file_name;
  reg [31:0]             random_state;
  reg [8:0]              offer_density;  // of 256 cycles, those with an offer
  reg [8:0]              ready_density;  // of 256 cycles, those with tready high
  reg                    idle_cycles;
  reg                    backpressure;
  reg                    stopped;  // by a time-out, or after so many failures
  reg [STREAMS-1:0]      closed;   // the closing beats of this pass that have left
  integer                next_item;
  integer                set_results;  // pairs reported in this pass
  integer                counted;      // by the closing beats of this pass
  integer                recomputed;   // in all passes, as the golden model says
  integer                beats [0:STREAMS-1];      // reports of this pass
  integer                all_beats [0:STREAMS-1];  // of all passes
  integer                pass;
  integer                cycle;
  integer                last_progress;
  integer                results;
  integer                failures;

@INCLUDE testbench_engine.v@
  function is_pair(input integer i, input integer j);
    is_pair = (j < ITEMS) && ((TARGETS > 0) ? (i < TARGETS) && (j >= TARGETS) : (i < j));
  endfunction

  // The number of the pair (i, j): (0,1), (0,2), ..., (1,2), ...
  function integer pair_of(input integer i, input integer j);
    pair_of = (TARGETS > 0) ? i * (ITEMS - TARGETS) + j - TARGETS
                            : i * (2 * ITEMS - i - 1) / 2 + j - i - 1;
  endfunction

  function [7:0] expected_word(input integer pair);
    expected_word = vectors[ITEMS+pair][7:0];
  endfunction

  function is_due(input [7:0] word);
    is_due = word[3] || REPORTED_VERDICTS[word[1:0]];
  endfunction

@INCLUDE testbench_verdict.v@
  task write_outcome(input [7:0] word);
    begin
      write_word(word);
      if (!is_due(word)) $write(", not reported");
    end
  endtask

  task write_pair(input integer i, input integer j);
    $write("items %0d and %0d, lane %0d, pass %0d, cycle %0d: ", i, j, i % LANES, pass, cycle);
  endtask

  task check_pair(input integer i, input integer j, input [7:0] word);
    reg [7:0] expected;
    reg [7:0] compared_bits;  // the verdict of an undecided pair has no meaning
    begin
      expected = expected_word(pair_of(i, j));
      compared_bits = expected[3] ? 8'hfc : 8'hff;
      if (!is_due(expected) || (((word ^ expected) & compared_bits) !== 8'd0)) begin
        write_pair(i, j);
        $write("expected ");
        write_outcome(expected);
        $write("; got ");
        write_outcome(word);
        $display("");
        count_failure;
      end
    end
  endtask

  task receive_pair(input integer i, input integer j, input [7:0] word);
    begin
      set_results = set_results + 1;
      results = results + 1;
      if (!is_pair(i, j)) begin
        $display("pass %0d, cycle %0d: a report of no pair, items %0d and %0d", pass, cycle, i, j);
        count_failure;
      end else if (reported[pair_of(i, j)]) begin
        write_pair(i, j);
        $display("the pair is reported twice");
        count_failure;
      end else begin
        reported[pair_of(i, j)] = 1'b1;
        check_pair(i, j, word);
      end
    end
  endtask

  task receive_report(input integer s);
    reg [TDATA_BITS+63:0] wide;
    reg [31:0]            i;
    reg [31:0]            j;
    reg [63:0]            flags;
    integer               k;
    begin
      wide = {64'd0, m_axis_tdata[s*TDATA_BITS +: TDATA_BITS]};
      i = wide[31:0] & ((32'd1 << FIELD_BITS) - 32'd1);
      j = wide[FIELD_BITS +: 32] & ((32'd1 << FIELD_BITS) - 32'd1);
      flags = (FLAG_BITS > 0) ? wide[2*FIELD_BITS +: 64] : 64'd1;
      beats[s] = beats[s] + 1;
      all_beats[s] = all_beats[s] + 1;
      if (closed[s] || COUNT_ONLY || (flags == 64'd0)) begin
        $display("pass %0d, cycle %0d: a report that is not due, items %0d and %0d, flags %b",
                 pass, cycle, i, j, flags);
        count_failure;
      end else begin
        for (k = 0; k < 64; k = k + 1) begin
          if (flags[k]) receive_pair(i + k, j, m_axis_tuser[s*TUSER_BITS +: TUSER_BITS]);
        end
      end
    end
  endtask

  task receive_closing_beat(input integer s);
    reg [TDATA_BITS+31:0] wide;
    begin
      wide = {32'd0, m_axis_tdata[s*TDATA_BITS +: TDATA_BITS]};
      if (closed[s] || (m_axis_tuser[s*TUSER_BITS +: TUSER_BITS] != 8'h80) || !m_axis_tlast[s]
          || (!COUNT_ONLY && (wide[31:0] != beats[s]))) begin
        $display("pass %0d, cycle %0d: a wrong closing beat: %0d reports, tuser %h, tlast %b",
                 pass, cycle, wide[31:0], m_axis_tuser[s*TUSER_BITS +: TUSER_BITS],
                 m_axis_tlast[s]);
        $display("  after %0d reports in this pass", beats[s]);
        count_failure;
      end
      counted = counted + wide[31:0];
      closed[s] = 1'b1;
      if (&closed) check_set;
    end
  endtask

  // All closing beats have left: no pair may be missing.
  task check_set;
    integer i;
    integer j;
    integer due;
    begin
      due = 0;
      for (i = 0; i < ITEMS; i = i + 1) begin
        for (j = 0; j < ITEMS; j = j + 1) begin
          if (is_pair(i, j) && is_due(expected_word(pair_of(i, j)))) begin
            due = due + 1;
            if (!COUNT_ONLY && !reported[pair_of(i, j)] && !stopped) begin
              write_pair(i, j);
              $write("expected ");
              write_outcome(expected_word(pair_of(i, j)));
              $display("; the set is closed without it");
              count_failure;
            end
          end
        end
      end
      if (COUNT_ONLY) begin
        results = results + counted;
        if (counted != due) begin
          $display("pass %0d: %0d reports counted, expected %0d", pass, counted, due);
          count_failure;
        end
      end
    end
  endtask

  task drive;
    integer s;
    begin
      draw;
      if (!s_axis_tvalid && (next_item < ITEMS)
          && ({1'b0, random_state[7:0]} < offer_density)) begin
        s_axis_tvalid = 1'b1;
        s_axis_tdata = vectors[next_item];
        s_axis_tuser = (next_item < TARGETS);
        s_axis_tlast = (next_item == ITEMS - 1);
      end
      for (s = 0; s < STREAMS; s = s + 1) begin
        m_axis_tready[s] = {1'b0, random_state[15:8] ^ (s[7:0] << 3)} < ready_density;
      end
    end
  endtask

  task sample;
    integer s;
    begin
      check_held;
      for (s = 0; s < STREAMS; s = s + 1) begin
        if ((m_axis_tvalid[s] === 1'b1) && m_axis_tready[s]) begin
          if (m_axis_tlast[s] === 1'b1) receive_closing_beat(s); else receive_report(s);
          last_progress = cycle;
        end
      end
    end
  endtask

  // Inputs change while aclk is low, and outputs are read before it rises.
  task clock_cycle;
    reg taken;
    begin
      aclk = 1'b0;
      #1;
      valid_before = m_axis_tvalid;
      if (aresetn) drive;
      #1;
      taken = s_axis_tvalid && (s_axis_tready === 1'b1);
      if (aresetn) sample;
      aclk = 1'b1;
      #1;
      if (aresetn && taken) begin
        s_axis_tvalid = 1'b0;
        next_item = next_item + 1;
        last_progress = cycle;
      end
      #1;
      cycle = cycle + 1;
    end
  endtask

  task run_pass;
    integer k;
    begin
      next_item = 0;
      set_results = 0;
      counted = 0;
      closed = {STREAMS{1'b0}};
      last_progress = cycle;
      for (k = 0; k < PAIRS; k = k + 1) reported[k] = 1'b0;
      for (k = 0; k < STREAMS; k = k + 1) beats[k] = 0;
      while (!(&closed) && !stopped) begin
        clock_cycle;
        if (cycle - last_progress > TIME_OUT_CYCLES) begin
          $display("time-out: nothing has moved in %0d cycles of pass %0d", TIME_OUT_CYCLES, pass);
          $display("  %0d of %0d items taken, %0d pairs reported", next_item, ITEMS, set_results);
          count_failure;
          stopped = 1'b1;
        end
      end
      for (k = 0; (k < 64) && !stopped; k = k + 1) clock_cycle;  // in which nothing may leave
    end
  endtask

  task reset;
    begin
      s_axis_tvalid = 1'b0;
      s_axis_tdata = {ITEM_BITS{1'b0}};
      s_axis_tuser = 1'b0;
      s_axis_tlast = 1'b0;
      m_axis_tready = {STREAMS{1'b0}};
      aresetn = 1'b0;
      clock_cycle;
      clock_cycle;
      if (m_axis_tvalid !== {STREAMS{1'b0}}) begin
        $display("cycle %0d: m_axis_tvalid is not low in reset", cycle);
        count_failure;
      end
      aresetn = 1'b1;
    end
  endtask

  // What the references do in all passes.
  task count_recomputations;
    integer   pair;
    reg [7:0] word;
    begin
      recomputed = 0;
      for (pair = 0; pair < PAIRS; pair = pair + 1) begin
        word = expected_word(pair);
        if (word[2]) recomputed = recomputed + PASSES;
      end
      for (pair = 0; pair < STREAMS; pair = pair + 1) all_beats[pair] = 0;
    end
  endtask

@IF COUNTS@
  task check_counters;
    integer k;
    begin
@IF COUNTER_PORT@
      read_counters;
@END@
      for (k = 0; k < STREAMS; k = k + 1) begin
        check_counter("reports", -1, reports[k*COUNTER_BITS +: COUNTER_BITS], all_beats[k]);
      end
      check_counter("recomputations", -1, recomputations, recomputed);
    end
  endtask

@END@
  initial begin
    start;
    count_recomputations;
    reset;
    for (pass = 1; (pass <= PASSES) && !stopped; pass = pass + 1) begin
      idle_cycles = (pass == 2) || (pass == 4);
      backpressure = (pass == 3) || (pass == 4);
      run_pass;
    end
@IF COUNTS@
    if (!stopped) check_counters;
@END@
    if (failures != 0) begin
      $display("FAILED: %0d failure(s)", failures);
      stop;
    end else begin
      $display("PASSED: the engine's %0d pairs (%0d items, %0d times), %0d reported, %0d cycles",
               PASSES * PAIRS, ITEMS, PASSES, results, cycle);
      $finish;
    end
  end

endmodule

`default_nettype wire
@IF COUNTER_PORT@

@INCLUDE counter_reader.v@
@END@
