// Test bench of the arg-min engine @DUT@ that checks itself, in plain Verilog-2001 for any
// simulator.
//
// It loads @CANDIDATES@ candidates of the scene's data and sends @ROWS@ rows, four times: at full
// rate, with idle cycles, with backpressure, and with both. Each row must leave once, in order, with
// its tag and with the candidate that the golden model of mixcmp chose when this file was written.
// At the end the lanes' counters must agree with the model's. It prints
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
  localparam CANDIDATE_BITS = @ITEM_BITS@;
  localparam ROW_BITS = @ROW_BITS@;
  localparam TAG_BITS = @TAG_BITS@;
  localparam CHOICE_BITS = @FIELD_BITS@;  // of a candidate's number in m_axis_tdata
  localparam COUNTER_BITS = @COUNTER_BITS@;
  localparam STREAMS = 1;  // m_axis
  localparam TDATA_BITS = CHOICE_BITS;
  localparam TUSER_BITS = TAG_BITS;
  localparam BEAT_BITS = TDATA_BITS + TUSER_BITS + 1;

  localparam CANDIDATES = @CANDIDATES@;
  localparam ROWS = @ROWS@;
  // A line of the file is a candidate, or a row: which lanes recompute, the choice, the operands.
  localparam VECTORS = CANDIDATES + ROWS;
  localparam LINE_BITS = @LINE_BITS@;
  localparam PASSES = 4;
  localparam MAX_FAILURES = 10;       // so many are described, then the simulation ends
  localparam TIME_OUT_CYCLES = 5000;  // in which no candidate or row is taken and none leaves

  reg                      aclk;
  reg                      aresetn;
  reg                      s_candidate_tvalid;
  wire                     s_candidate_tready;
  reg [CANDIDATE_BITS-1:0] s_candidate_tdata;
  reg                      s_candidate_tlast;
  reg                      s_axis_tvalid;
  wire                     s_axis_tready;
  reg  [ROW_BITS-1:0]      s_axis_tdata;
  reg  [TAG_BITS-1:0]      s_axis_tuser;
  reg                      s_axis_tlast;
  wire [STREAMS-1:0]       m_axis_tvalid;
  reg  [STREAMS-1:0]       m_axis_tready;
  wire [CHOICE_BITS-1:0]   m_axis_tdata;
  wire [TAG_BITS-1:0]      m_axis_tuser;
  wire [STREAMS-1:0]       m_axis_tlast;
  wire                     overrun;
@IF COUNTER_OUTPUTS@
  wire [LANES*COUNTER_BITS-1:0] comparisons;
  wire [LANES*COUNTER_BITS-1:0] recomputations;
  wire [COUNTER_BITS-1:0]       rows;
@END@
@IF COUNTER_PORT@
@INCLUDE testbench_counter_reader.v@
@END@

  @DUT@ engine (
      .aclk(aclk),
      .aresetn(aresetn),
@IF COUNTER_OUTPUTS@
      .comparisons(comparisons),
      .recomputations(recomputations),
      .rows(rows),
      .stalls(),
      .stalled_cycles(),
@END@
@IF COUNTER_PORT@
@INCLUDE testbench_counter_bus.v@
@END@
      .s_candidate_tvalid(s_candidate_tvalid),
      .s_candidate_tready(s_candidate_tready),
      .s_candidate_tdata(s_candidate_tdata),
      .s_candidate_tlast(s_candidate_tlast),
      .s_axis_tvalid(s_axis_tvalid),
      .s_axis_tready(s_axis_tready),
      .s_axis_tdata(s_axis_tdata),
      .s_axis_tuser(s_axis_tuser),
      .s_axis_tlast(s_axis_tlast),
      .m_axis_tvalid(m_axis_tvalid),
      .m_axis_tready(m_axis_tready),
      .m_axis_tdata(m_axis_tdata),
      .m_axis_tuser(m_axis_tuser),
      .m_axis_tlast(m_axis_tlast),
      .overrun(overrun)
  );

  reg [LINE_BITS-1:0]          vectors [0:VECTORS-1];
  reg [31:0]                   compared [0:LANES-1];
  reg [31:0]                   recomputed [0:LANES-1];
  reg [STREAMS-1:0]            waiting;  // a row waits for tready
  reg [STREAMS*BEAT_BITS-1:0]  waiting_beats;
  reg [STREAMS-1:0]            valid_before;  // m_axis_tvalid before tready takes its value
  reg [8*1024-1:0]             file_name;
  reg [31:0]                   random_state;
  reg [8:0]                    offer_density;  // of 256 cycles, those with an offer
  reg [8:0]                    ready_density;  // of 256 cycles, those with tready high
  reg                          idle_cycles;
  reg                          backpressure;
  reg                          stopped;  // by a time-out, or after so many failures
  integer                      next_candidate;
  integer                      next_row;
  integer                      left_count;  // in this pass
  integer                      pass;
  integer                      cycle;
  integer                      last_progress;
  integer                      results;
  integer                      failures;

@INCLUDE testbench_engine.v@
  // The low bits of a row's number, which is its tag.
  function [TAG_BITS-1:0] tag_of(input integer row);
    reg [TAG_BITS+31:0] wide;
    begin
      wide = {{TAG_BITS{1'b0}}, row[31:0]};
      tag_of = wide[TAG_BITS-1:0];
    end
  endfunction

  // tlast of a row means nothing to the engine, and leaves with it.
  function last_of(input integer row);
    last_of = (row % 5 == 4) || (row == ROWS - 1);
  endfunction

  task receive;
    reg [31:0] expected;
    begin
      if (left_count >= ROWS) begin
        $display("pass %0d, cycle %0d: a row too many", pass, cycle);
        count_failure;
      end else begin
        expected = vectors[CANDIDATES+left_count][ROW_BITS +: 32];
        if ((m_axis_tuser !== tag_of(left_count)) || (m_axis_tlast !== last_of(left_count))) begin
          $display("row %0d, pass %0d, cycle %0d: expected tag %h, tlast %b; got tag %h, tlast %b",
                   left_count, pass, cycle, tag_of(left_count), last_of(left_count),
                   m_axis_tuser, m_axis_tlast);
          count_failure;
        end
        if (m_axis_tdata !== expected[CHOICE_BITS-1:0]) begin
          $display("row %0d, pass %0d, cycle %0d: expected candidate %0d; got %0d; operands %h",
                   left_count, pass, cycle, expected, m_axis_tdata,
                   vectors[CANDIDATES+left_count][ROW_BITS-1:0]);
          count_failure;
        end
      end
      left_count = left_count + 1;
      results = results + 1;
      last_progress = cycle;
    end
  endtask

  task drive;
    begin
      draw;
      if (!s_candidate_tvalid && (next_candidate < CANDIDATES)
          && ({1'b0, random_state[7:0]} < offer_density)) begin
        s_candidate_tvalid = 1'b1;
        s_candidate_tdata = vectors[next_candidate][CANDIDATE_BITS-1:0];
        s_candidate_tlast = (next_candidate == CANDIDATES - 1);
      end
      // Rows that are offered before the load has ended would meet the candidates of the one before.
      if (!s_axis_tvalid && (next_candidate == CANDIDATES) && (next_row < ROWS)
          && ({1'b0, random_state[23:16]} < offer_density)) begin
        s_axis_tvalid = 1'b1;
        s_axis_tdata = vectors[CANDIDATES+next_row][ROW_BITS-1:0];
        s_axis_tuser = tag_of(next_row);
        s_axis_tlast = last_of(next_row);
      end
      m_axis_tready = {1'b0, random_state[15:8]} < ready_density;
    end
  endtask

  // Inputs change while aclk is low, and outputs are read before it rises.
  task clock_cycle;
    reg candidate_taken;
    reg row_taken;
    begin
      aclk = 1'b0;
      #1;
      valid_before = m_axis_tvalid;
      if (aresetn) drive;
      #1;
      candidate_taken = s_candidate_tvalid && (s_candidate_tready === 1'b1);
      row_taken = s_axis_tvalid && (s_axis_tready === 1'b1);
      if (aresetn) begin
        check_held;
        if ((m_axis_tvalid === 1'b1) && m_axis_tready) receive;
        if (overrun !== 1'b0) begin
          $display("pass %0d, cycle %0d: overrun is not low", pass, cycle);
          count_failure;
        end
      end
      aclk = 1'b1;
      #1;
      if (aresetn && candidate_taken) begin
        s_candidate_tvalid = 1'b0;
        next_candidate = next_candidate + 1;
        last_progress = cycle;
      end
      if (aresetn && row_taken) begin
        s_axis_tvalid = 1'b0;
        next_row = next_row + 1;
        last_progress = cycle;
      end
      #1;
      cycle = cycle + 1;
    end
  endtask

  task run_pass;
    integer k;
    begin
      next_candidate = 0;
      next_row = 0;
      left_count = 0;
      last_progress = cycle;
      while ((left_count < ROWS) && !stopped) begin
        clock_cycle;
        if (cycle - last_progress > TIME_OUT_CYCLES) begin
          $display("time-out: nothing has moved in %0d cycles of pass %0d", TIME_OUT_CYCLES, pass);
          $display("  %0d of %0d rows taken, %0d have left", next_row, ROWS, left_count);
          count_failure;
          stopped = 1'b1;
        end
      end
      for (k = 0; (k < 64) && !stopped; k = k + 1) clock_cycle;  // in which nothing may leave
    end
  endtask

  task reset;
    begin
      s_candidate_tvalid = 1'b0;
      s_candidate_tdata = {CANDIDATE_BITS{1'b0}};
      s_candidate_tlast = 1'b0;
      s_axis_tvalid = 1'b0;
      s_axis_tdata = {ROW_BITS{1'b0}};
      s_axis_tuser = {TAG_BITS{1'b0}};
      s_axis_tlast = 1'b0;
      m_axis_tready = 1'b0;
      aresetn = 1'b0;
      clock_cycle;
      clock_cycle;
      if (m_axis_tvalid !== 1'b0) begin
        $display("cycle %0d: m_axis_tvalid is not low in reset", cycle);
        count_failure;
      end
      aresetn = 1'b1;
    end
  endtask

  // What each lane does in all passes: one comparison for each row.
  task count_comparisons;
    integer lane;
    integer row;
    begin
      for (lane = 0; lane < LANES; lane = lane + 1) begin
        compared[lane] = PASSES * ROWS;
        recomputed[lane] = 32'd0;
        for (row = 0; row < ROWS; row = row + 1) begin
          if (vectors[CANDIDATES+row][ROW_BITS+32+lane]) begin
            recomputed[lane] = recomputed[lane] + PASSES;
          end
        end
      end
    end
  endtask

@IF COUNTS@
  task check_counters;
    integer k;
    begin
@IF COUNTER_PORT@
      read_counters;
@END@
      for (k = 0; k < LANES; k = k + 1) begin
        check_counter("comparisons", k, comparisons[k*COUNTER_BITS +: COUNTER_BITS], compared[k]);
        check_counter("recomputations", k, recomputations[k*COUNTER_BITS +: COUNTER_BITS],
                      recomputed[k]);
      end
      check_counter("rows", -1, rows, results);
    end
  endtask

@END@
  initial begin
    start;
    count_comparisons;
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
      $display("PASSED: the engine's %0d rows (%0d, %0d times), %0d candidates, %0d cycles",
               results, ROWS, PASSES, CANDIDATES, cycle);
      $finish;
    end
  end

endmodule

`default_nettype wire
@IF COUNTER_PORT@

@INCLUDE counter_reader.v@
@END@
