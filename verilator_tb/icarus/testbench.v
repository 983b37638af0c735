// Drives a generated system in an event-driven simulator on stimulus.hex and writes results.txt; the
// host judges. The macros SYSTEM (the top's name), COUNTERS, COUNTER_PORT and REFETCHED say which
// ports there are: with COUNTER_PORT counter_reader reads the counters on a bus;
// the parameters are the system's signature. See verilator_tb/harness/protocol.hpp, whose numbers
// for faults and states are used here, and verilator_tb/icarus.cpp, which reads the lines. In a system
// of groups of lanes, a lane is here a group, and a comparison a word of one for each of its lanes.
`default_nettype none

module testbench;

  parameter LANES = 1;
  parameter GROUP = 1;      // lanes of a group
  parameter NAME_BITS = 0;  // of a tag, in which the lanes of a group differ
  parameter REFERENCES = 1;
  parameter REFETCH_STREAMS = 1;  // streams of operands that are fetched again
  parameter TDATA_BYTES = 4;
  parameter TAG_BITS = 12;
  parameter COUNTER_BITS = 16;
  parameter SLOTS = 8;
  parameter IN_ORDER = 0;
  parameter COUNT = 1;
  parameter RESETS = 0;
  parameter STRESSED = 0;
  parameter SEED = 1;
  parameter HANG_CYCLES = 50000;
  // The number of counters on the bus, and the number of the first one of each kind.
  parameter MAPPED_COUNTERS = 1;
  parameter COUNTER_ADDRESS_BITS = 4;
  parameter FIRST_COMPARISONS = 0;
  parameter FIRST_RECOMPUTATIONS = 0;
  parameter FIRST_STALLS = 0;
  parameter FIRST_ANSWERS = 0;

  localparam VALID_DROPPED = 0;
  localparam PAYLOAD_CHANGED = 1;
  localparam UNKNOWN_TAG = 2;
  localparam DUPLICATE_TAG = 3;
  localparam STALE_AFTER_RESET = 4;
  localparam VALID_IN_RESET = 5;
  localparam ORDER_BROKEN = 6;
  localparam LOST = 7;
  localparam HUNG = 8;
  localparam UNKNOWN_REFETCH = 9;
  localparam UNKNOWN_VALUE = 10;
  localparam BROKEN_COUNTER_PORT = 14;
  localparam MAX_VIOLATIONS = 64;

  localparam RUNNING = 0;
  localparam DRAINED = 1;
  localparam STOPPED = 2;

  localparam TDATA_BITS = 8 * TDATA_BYTES;
  localparam WORD_BITS = GROUP * TDATA_BITS;
  // Wider tags have their upper bits set.
  localparam INDEX_BITS = 30;
  localparam NUMBER_BITS = (TAG_BITS < INDEX_BITS) ? TAG_BITS : INDEX_BITS;
  localparam TAG_LIMIT = 1 << (NUMBER_BITS - NAME_BITS);
  localparam FIRST_TAG = (NAME_BITS > 0) ? 1 : 0;  // odd, so that the sum with a lane's number carries
  localparam STREAMS = 2 * LANES + 2 * REFETCH_STREAMS;

  reg                       aclk;
  reg                       aresetn;
  reg  [LANES-1:0]            s_axis_tvalid;
  wire [LANES-1:0]            s_axis_tready;
  reg  [LANES*WORD_BITS-1:0]  s_axis_tdata;
  reg  [LANES*TAG_BITS-1:0]   s_axis_tuser;
  wire [LANES-1:0]            m_axis_tvalid;
  reg  [LANES-1:0]            m_axis_tready;
  wire [LANES*GROUP*8-1:0]    m_axis_tdata;
  wire [LANES*TAG_BITS-1:0]   m_axis_tuser;
`ifdef COUNTERS
  wire [LANES*COUNTER_BITS-1:0] comparisons;
  wire [LANES*COUNTER_BITS-1:0] recomputations;
  wire [LANES*COUNTER_BITS-1:0] stalls;
`endif
`ifdef COUNTER_PORT
  wire [COUNTER_ADDRESS_BITS-1:0]              s_axi_awaddr;
  wire [2:0]                                   s_axi_awprot;
  wire                                         s_axi_awvalid;
  wire                                         s_axi_awready;
  wire [31:0]                                  s_axi_wdata;
  wire [3:0]                                   s_axi_wstrb;
  wire                                         s_axi_wvalid;
  wire                                         s_axi_wready;
  wire [1:0]                                   s_axi_bresp;
  wire                                         s_axi_bvalid;
  wire                                         s_axi_bready;
  wire [COUNTER_ADDRESS_BITS-1:0]              s_axi_araddr;
  wire [2:0]                                   s_axi_arprot;
  wire                                         s_axi_arvalid;
  wire                                         s_axi_arready;
  wire [31:0]                                  s_axi_rdata;
  wire [1:0]                                   s_axi_rresp;
  wire                                         s_axi_rvalid;
  wire                                         s_axi_rready;
  reg                                          start_reading;
  wire                                         reading_done;
  wire                                         reading_broken;
  wire [MAPPED_COUNTERS*COUNTER_BITS-1:0]      counts;

  counter_reader #(
      .COUNTERS(MAPPED_COUNTERS),
      .COUNTER_BITS(COUNTER_BITS),
      .ADDRESS_BITS(COUNTER_ADDRESS_BITS)
  ) reader (
      .aclk(aclk),
      .start(start_reading),
      .done(reading_done),
      .broken(reading_broken),
      .s_axi_awaddr(s_axi_awaddr),
      .s_axi_awprot(s_axi_awprot),
      .s_axi_awvalid(s_axi_awvalid),
      .s_axi_awready(s_axi_awready),
      .s_axi_wdata(s_axi_wdata),
      .s_axi_wstrb(s_axi_wstrb),
      .s_axi_wvalid(s_axi_wvalid),
      .s_axi_wready(s_axi_wready),
      .s_axi_bresp(s_axi_bresp),
      .s_axi_bvalid(s_axi_bvalid),
      .s_axi_bready(s_axi_bready),
      .s_axi_araddr(s_axi_araddr),
      .s_axi_arprot(s_axi_arprot),
      .s_axi_arvalid(s_axi_arvalid),
      .s_axi_arready(s_axi_arready),
      .s_axi_rdata(s_axi_rdata),
      .s_axi_rresp(s_axi_rresp),
      .s_axi_rvalid(s_axi_rvalid),
      .s_axi_rready(s_axi_rready),
      .counts(counts)
  );

  assign comparisons = counts[FIRST_COMPARISONS*COUNTER_BITS +: LANES*COUNTER_BITS];
  assign recomputations = counts[FIRST_RECOMPUTATIONS*COUNTER_BITS +: LANES*COUNTER_BITS];
  assign stalls = counts[FIRST_STALLS*COUNTER_BITS +: LANES*COUNTER_BITS];
`endif
`ifdef REFETCHED
  localparam TAG_FIELD = 8 * ((TAG_BITS + 7) / 8);
  localparam QUEUE = 4096;
  wire [REFETCH_STREAMS-1:0]            m_refetch_tvalid;
  reg  [REFETCH_STREAMS-1:0]            m_refetch_tready;
  wire [REFETCH_STREAMS*TAG_FIELD-1:0]  m_refetch_tdata;
  reg  [REFETCH_STREAMS-1:0]            s_refetch_tvalid;
  wire [REFETCH_STREAMS-1:0]            s_refetch_tready;
  reg  [REFETCH_STREAMS*TDATA_BITS-1:0] s_refetch_tdata;
  integer queue_index [0:REFETCH_STREAMS*QUEUE-1];
  integer queue_lane [0:REFETCH_STREAMS*QUEUE-1];  // of the group
  integer queue_cycle [0:REFETCH_STREAMS*QUEUE-1];
  integer queue_head [0:REFETCH_STREAMS-1];
  integer queue_tail [0:REFETCH_STREAMS-1];
`endif

  `SYSTEM system (
      .aclk(aclk),
      .aresetn(aresetn),
      .s_axis_tvalid(s_axis_tvalid),
      .s_axis_tready(s_axis_tready),
      .s_axis_tdata(s_axis_tdata),
      .s_axis_tuser(s_axis_tuser),
      .m_axis_tvalid(m_axis_tvalid),
      .m_axis_tready(m_axis_tready),
      .m_axis_tdata(m_axis_tdata),
`ifdef COUNTER_PORT
      .s_axi_awaddr(s_axi_awaddr),
      .s_axi_awprot(s_axi_awprot),
      .s_axi_awvalid(s_axi_awvalid),
      .s_axi_awready(s_axi_awready),
      .s_axi_wdata(s_axi_wdata),
      .s_axi_wstrb(s_axi_wstrb),
      .s_axi_wvalid(s_axi_wvalid),
      .s_axi_wready(s_axi_wready),
      .s_axi_bresp(s_axi_bresp),
      .s_axi_bvalid(s_axi_bvalid),
      .s_axi_bready(s_axi_bready),
      .s_axi_araddr(s_axi_araddr),
      .s_axi_arprot(s_axi_arprot),
      .s_axi_arvalid(s_axi_arvalid),
      .s_axi_arready(s_axi_arready),
      .s_axi_rdata(s_axi_rdata),
      .s_axi_rresp(s_axi_rresp),
      .s_axi_rvalid(s_axi_rvalid),
      .s_axi_rready(s_axi_rready),
`elsif COUNTERS
      .comparisons(comparisons),
      .recomputations(recomputations),
      .stalls(stalls),
`endif
`ifdef REFETCHED
      .m_refetch_tvalid(m_refetch_tvalid),
      .m_refetch_tready(m_refetch_tready),
      .m_refetch_tdata(m_refetch_tdata),
      .s_refetch_tvalid(s_refetch_tvalid),
      .s_refetch_tready(s_refetch_tready),
      .s_refetch_tdata(s_refetch_tdata),
`endif
      .m_axis_tuser(m_axis_tuser)
  );

  // One entry for each comparison. WAITING includes those that a reset threw out.
  localparam [1:0] WAITING = 2'd0;
  localparam [1:0] OFFERED = 2'd1;
  localparam [1:0] INSIDE = 2'd2;
  localparam [1:0] LEFT = 2'd3;

  reg [WORD_BITS-1:0]  operands [0:COUNT-1];
  reg [1:0]            status [0:COUNT-1];
  reg                  discarded [0:COUNT-1];
  integer              lane_of [0:COUNT-1];
  integer              since [0:COUNT-1];  // the cycle of the offer, then of the acceptance
  integer              sequence_of [0:COUNT-1];
  reg [31:0]           resets [0:RESETS];

  // One for each lane.
  integer              offered [0:LANES-1];  // index, or -1
  reg                  waiting [0:LANES-1];  // its result waits for tready
  reg [8*GROUP-1:0]    waiting_tdata [0:LANES-1];
  reg [TAG_BITS-1:0]   waiting_tag [0:LANES-1];
  integer              last_left [0:LANES-1];
  integer              seen_comparisons [0:LANES-1];
  integer              seen_recomputations [0:LANES-1];
  integer              seen_stalls [0:LANES-1];

  integer density [0:STREAMS-1];
  integer random_state;
  integer results;
  integer cycle;
  integer first_cycle;
  integer last_cycle;
  integer next;     // no comparison before it is waiting
  integer oldest;   // all before it have left
  integer highest;  // the last one offered so far
  integer sequence;
  integer left_count;
  integer violations;
  integer reset_number;
  integer state;

  function willing(input integer stream);
    willing = (STRESSED == 0) || (($random(random_state) & 255) < density[stream]);
  endfunction

  function [TAG_BITS-1:0] tag_of(input integer index);
    tag_of = (({TAG_BITS{1'b1}} << INDEX_BITS) | (index << NAME_BITS)) + FIRST_TAG;
  endfunction

  // The comparison that carries a tag, or -1. Those inside lie within TAG_LIMIT of each other.
  function integer index_of(input [TAG_BITS-1:0] tag);
    integer low;
    begin
      low = ((tag - FIRST_TAG) & ((1 << NUMBER_BITS) - 1)) >> NAME_BITS;
      index_of = highest - ((highest - low) & (TAG_LIMIT - 1));
      if ((index_of < 0) || (tag_of(index_of) !== tag)) index_of = -1;
    end
  endfunction

  task violate(input integer fault, input integer lane, input integer index,
               input [TAG_BITS-1:0] tag);
    begin
      if (violations < MAX_VIOLATIONS) begin
        $fdisplay(results, "violation %0d %0d %0d %h %0d", fault, lane, index, tag, cycle);
      end
      violations = violations + 1;
      if (violations >= MAX_VIOLATIONS) state = STOPPED;
    end
  endtask

  task offer(input integer lane);
    begin
      while ((next < COUNT) && (status[next] != WAITING)) next = next + 1;
      while ((oldest < COUNT) && (status[oldest] == LEFT)) oldest = oldest + 1;
      if ((next < COUNT) && (next - oldest < TAG_LIMIT)) begin
        if (next > highest) highest = next;
        status[next] = OFFERED;
        since[next] = cycle;
        lane_of[next] = lane;
        offered[lane] = next;
        s_axis_tdata[lane*WORD_BITS +: WORD_BITS] = operands[next];
        s_axis_tuser[lane*TAG_BITS +: TAG_BITS] = tag_of(next);
      end
    end
  endtask

  task drive;
    integer k;
    begin
      if (cycle % 64 == 0) begin
        for (k = 0; k < STREAMS; k = k + 1) density[k] = ($random(random_state) & 7) * 36;
      end
      for (k = 0; k < LANES; k = k + 1) begin
        if ((offered[k] < 0) && willing(k)) offer(k);
        s_axis_tvalid[k] = offered[k] >= 0;
        m_axis_tready[k] = willing(LANES + k);
      end
`ifdef REFETCHED
      for (k = 0; k < REFETCH_STREAMS; k = k + 1) drive_refetch(k);
`endif
    end
  endtask

  task sample_offer(input integer lane);
    integer index;
    begin
      index = offered[lane];
      if (s_axis_tready[lane] === 1'b1) begin
        sequence = sequence + 1;
        status[index] = INSIDE;
        since[index] = cycle;
        sequence_of[index] = sequence;
        offered[lane] = -1;
        seen_comparisons[lane] = seen_comparisons[lane] + 1;
      end else begin
        seen_stalls[lane] = seen_stalls[lane] + 1;
      end
    end
  endtask

  task deliver(input integer lane, input [TAG_BITS-1:0] tag, input [8*GROUP-1:0] tdata);
    integer index;
    integer k;
    begin
      index = index_of(tag);
      if (index < 0) begin
        violate(UNKNOWN_TAG, lane, index, tag);
      end else if (status[index] == LEFT) begin
        violate(DUPLICATE_TAG, lane, index, tag);
      end else if ((status[index] != INSIDE) && discarded[index]) begin
        violate(STALE_AFTER_RESET, lane, index, tag);
      end else if ((status[index] != INSIDE) || (lane_of[index] != lane)) begin
        violate(UNKNOWN_TAG, lane, index, tag);
      end else begin
        for (k = (IN_ORDER != 0) ? oldest : index; k < highest + 1; k = k + 1) begin
          if ((IN_ORDER != 0) && (status[k] == INSIDE) && (lane_of[k] == lane)
              && (sequence_of[k] < sequence_of[index])) begin
            violate(ORDER_BROKEN, lane, index, tag);
          end
        end
        status[index] = LEFT;
        left_count = left_count + 1;
        last_left[lane] = sequence_of[index];
        last_cycle = cycle;
        $fwrite(results, "result %0d %0d %0d %0d", lane, index, since[index], cycle);
        for (k = 0; k < GROUP; k = k + 1) begin
          if (tdata[8*k+2 +: 2] != 2'b00) seen_recomputations[lane] = seen_recomputations[lane] + 1;
          $fwrite(results, " %h", tdata[8*k +: 8]);
        end
        $fdisplay(results);
      end
    end
  endtask

  task sample_result(input integer lane);
    reg                valid;
    reg [8*GROUP-1:0]  tdata;
    reg [TAG_BITS-1:0] tag;
    begin
      valid = m_axis_tvalid[lane];
      tdata = m_axis_tdata[lane*8*GROUP +: 8*GROUP];
      tag = m_axis_tuser[lane*TAG_BITS +: TAG_BITS];
      if ((^{valid, s_axis_tready[lane]} === 1'bx) || ((valid === 1'b1) && (^{tdata, tag} === 1'bx)))
        violate(UNKNOWN_VALUE, lane, -1, {TAG_BITS{1'b0}});
      else if (waiting[lane] && !valid) violate(VALID_DROPPED, lane, -1, tag);
      else if (waiting[lane] && ({tdata, tag} != {waiting_tdata[lane], waiting_tag[lane]}))
        violate(PAYLOAD_CHANGED, lane, -1, tag);
      waiting[lane] = (valid === 1'b1) && !m_axis_tready[lane];
      waiting_tdata[lane] = tdata;
      waiting_tag[lane] = tag;
      if ((valid === 1'b1) && m_axis_tready[lane] && (^{tdata, tag} !== 1'bx))
        deliver(lane, tag, tdata);
    end
  endtask

`ifdef REFETCHED
  task drive_refetch(input integer reference);
    integer slot;
    begin
      m_refetch_tready[reference] = willing(2 * LANES + reference);
      slot = reference * QUEUE + (queue_head[reference] % QUEUE);
      s_refetch_tvalid[reference] = (queue_head[reference] != queue_tail[reference])
                                    && (queue_cycle[slot] <= cycle);
      s_refetch_tdata[reference*TDATA_BITS +: TDATA_BITS] =
          operands[queue_index[slot]] >> (queue_lane[slot] * TDATA_BITS);
    end
  endtask

  task sample_refetch(input integer reference);
    integer index;
    integer slot;
    integer number;
    reg     unknown;
    reg [TAG_BITS-1:0] tag;
    begin
      tag = m_refetch_tdata[reference*TAG_FIELD +: TAG_BITS];
      unknown = (^{m_refetch_tvalid[reference], s_refetch_tready[reference]} === 1'bx)
                || ((m_refetch_tvalid[reference] === 1'b1) && (^tag === 1'bx));
      // The violation names the first lane, or group, that the stream serves: it has its number.
      if (unknown) violate(UNKNOWN_VALUE, reference, -1, {TAG_BITS{1'b0}});
      if (s_refetch_tvalid[reference] && (s_refetch_tready[reference] === 1'b1))
        queue_head[reference] = queue_head[reference] + 1;
      if (!unknown && m_refetch_tvalid[reference] && m_refetch_tready[reference]) begin
        number = (tag - FIRST_TAG) & ((1 << NAME_BITS) - 1);
        index = index_of(tag - number);
        if ((index < 0) || (status[(index < 0) ? 0 : index] != INSIDE) || (number >= GROUP)) begin
          violate(UNKNOWN_REFETCH, reference, index, tag);
          index = 0;
        end
        slot = reference * QUEUE + (queue_tail[reference] % QUEUE);
        queue_index[slot] = index;
        queue_lane[slot] = number;
        queue_cycle[slot] = cycle + 4 + ((STRESSED != 0) ? ($random(random_state) & 31) : 0);
        queue_tail[reference] = queue_tail[reference] + 1;
      end
    end
  endtask
`endif

  task sample;
    integer k;
    begin
      for (k = 0; k < LANES; k = k + 1) begin
        if (offered[k] >= 0) sample_offer(k);
        sample_result(k);
      end
`ifdef REFETCHED
      for (k = 0; k < REFETCH_STREAMS; k = k + 1) sample_refetch(k);
`endif
    end
  endtask

  task check_overdue;
    integer k;
    reg     goes_on;
    begin
      for (k = oldest; k <= highest; k = k + 1) begin
        if (((status[k] == OFFERED) || (status[k] == INSIDE)) && (cycle - since[k] > HANG_CYCLES))
        begin
          goes_on = (status[k] == INSIDE) && ((last_left[lane_of[k]] > sequence_of[k])
                                              || s_axis_tready[lane_of[k]]);
          violate(goes_on ? LOST : HUNG, lane_of[k], k, tag_of(k));
          status[k] = LEFT;
          left_count = left_count + 1;
          if (!goes_on) state = STOPPED;
        end
      end
    end
  endtask

  task clock_cycle;
    begin
      aclk = 1'b0;
      #2;
      if (aresetn) sample;
      aclk = 1'b1;
      #2;
      cycle = cycle + 1;
    end
  endtask

  task reset;
    integer k;
    begin
      for (k = 0; k <= highest; k = k + 1) begin
        if ((status[k] == OFFERED) || (status[k] == INSIDE)) begin
          status[k] = WAITING;
          discarded[k] = 1'b1;
        end
      end
      for (k = 0; k < LANES; k = k + 1) begin
        offered[k] = -1;
        waiting[k] = 1'b0;
        seen_comparisons[k] = 0;
        seen_recomputations[k] = 0;
        seen_stalls[k] = 0;
      end
`ifdef REFETCHED
      for (k = 0; k < REFETCH_STREAMS; k = k + 1) queue_head[k] = queue_tail[k];
      s_refetch_tvalid = {REFETCH_STREAMS{1'b0}};
      m_refetch_tready = {REFETCH_STREAMS{1'b0}};
`endif
      next = 0;
      s_axis_tvalid = {LANES{1'b0}};
      m_axis_tready = {LANES{1'b0}};
      aresetn = 1'b0;
      clock_cycle;
      clock_cycle;
      for (k = 0; k < LANES; k = k + 1) begin
        if (m_axis_tvalid[k] !== 1'b0) violate(VALID_IN_RESET, k, -1, {TAG_BITS{1'b0}});
      end
      aresetn = 1'b1;
    end
  endtask

  task start;
    integer k;
    begin
      $readmemh("stimulus.hex", operands);
      $readmemh("resets.hex", resets);
      results = $fopen("results.txt", "w");
      random_state = SEED;
      cycle = 0;
      last_cycle = 0;
      oldest = 0;
      highest = -1;
      sequence = 0;
      left_count = 0;
      violations = 0;
      reset_number = 0;
      state = RUNNING;
      for (k = 0; k < COUNT; k = k + 1) begin
        status[k] = WAITING;
        discarded[k] = 1'b0;
      end
      for (k = 0; k < LANES; k = k + 1) last_left[k] = 0;
`ifdef REFETCHED
      for (k = 0; k < REFETCH_STREAMS; k = k + 1) begin
        queue_tail[k] = 0;
        queue_index[k * QUEUE] = 0;
        queue_lane[k * QUEUE] = 0;
      end
`endif
      reset;
      first_cycle = cycle;
    end
  endtask

`ifdef COUNTER_PORT
  task read_counters;
    begin
      start_reading = 1'b1;
      while (!reading_done) clock_cycle;
      start_reading = 1'b0;
      if (reading_broken) violate(BROKEN_COUNTER_PORT, 0, -1, {TAG_BITS{1'b0}});
    end
  endtask
`endif

  task write_end;
    integer k;
    begin
`ifdef COUNTER_PORT
      read_counters;
      for (k = 0; k < REFERENCES; k = k + 1) begin
        $fdisplay(results, "answers %0d",
                  counts[(FIRST_ANSWERS+k)*COUNTER_BITS +: COUNTER_BITS]);
      end
`endif
`ifdef COUNTERS
      for (k = 0; k < LANES; k = k + 1) begin
        $fdisplay(results, "end %0d %0d %0d %0d %0d %0d",
                  comparisons[k*COUNTER_BITS +: COUNTER_BITS], seen_comparisons[k],
                  recomputations[k*COUNTER_BITS +: COUNTER_BITS], seen_recomputations[k],
                  stalls[k*COUNTER_BITS +: COUNTER_BITS], seen_stalls[k]);
      end
`endif
    end
  endtask

  reg [8*1024-1:0] waves;
  integer          idle;

  initial begin
`ifdef COUNTER_PORT
    start_reading = 1'b0;
`endif
    if ($value$plusargs("waves=%s", waves)) begin
      $dumpfile(waves);
      $dumpvars(0, system);
    end
    start;
    idle = 0;
    while ((state == RUNNING) && (idle < 4 * SLOTS)) begin
      if ((reset_number < RESETS) && (highest + 1 >= resets[reset_number])) begin
        reset_number = reset_number + 1;
        reset;
      end
      drive;
      clock_cycle;
      if (cycle % 256 == 0) check_overdue;
      idle = (left_count == COUNT) ? idle + 1 : 0;
    end
    if (state == RUNNING) begin
      state = DRAINED;
      write_end;
    end
    if (last_cycle < first_cycle) last_cycle = first_cycle - 1;  // nothing was decided
    $fdisplay(results, "state %0d %0d", state, last_cycle + 1 - first_cycle);
    $fclose(results);
    $finish;
  end

endmodule

`default_nettype wire
