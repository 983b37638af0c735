// counter_memory: COUNTERS counts in one memory, kept up to date by narrow counters that wrap.
//
// A narrow counter steps by at most one per cycle, and is sampled once in a round of 2 COUNTERS
// cycles. So it wraps at most once in between. It has wrapped if it is smaller than before, and
// then the digits above it go up by one. A count lags behind its narrow counter by a round and a
// few cycles at most. Reset clears the counts: the first round after it ignores the stored ones.
// `ready` is low until that round ends.
//
// Reading: `read_start` is high for a cycle, while `ready` is high. `read_done` is high for a
// cycle, 1 or 2 cycles later, with the count on `read_count`. Hold `read_index` from the former
// cycle until the latter. The count of an index of COUNTERS or more is undefined.
`default_nettype none

module counter_memory #(
  parameter COUNTERS = 4,     // counts in the memory, 2 or more
  parameter NARROW_BITS = 8,  // bits of a narrow counter, 1 to 30; 2^NARROW_BITS > 2 COUNTERS + 1
  parameter WIDTH = 32,       // bits of a count, more than NARROW_BITS
  parameter INDEX_BITS = 2    // bits of a counter's number, 1 to 30; 2^INDEX_BITS >= COUNTERS
) (
  input  wire                            aclk,
  input  wire                            aresetn,
  input  wire [COUNTERS*NARROW_BITS-1:0] counts,
  output wire                            ready,
  input  wire                            read_start,
  input  wire [INDEX_BITS-1:0]           read_index,
  output wire                            read_done,
  output wire [WIDTH-1:0]                read_count
);

  localparam HIGH_BITS = WIDTH - NARROW_BITS;
  localparam LAST      = COUNTERS - 1;

  localparam [HIGH_BITS-1:0] ONE = 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (COUNTERS < 2) begin : g_refused_counters COUNTERS_is_below_2 refused (); end
    if ((NARROW_BITS < 1) || (NARROW_BITS > 30)) begin : g_refused_narrow_bits
      NARROW_BITS_is_not_1_to_30 refused ();
    end else if (((2 * COUNTERS + 1) >>> NARROW_BITS) > 0) begin : g_refused_round
      NARROW_BITS_is_too_small_for_COUNTERS refused ();
    end
    if (WIDTH <= NARROW_BITS) begin : g_refused_width WIDTH_is_not_above_NARROW_BITS refused (); end
  endgenerate

  // Stage 0: a narrow count arrives, and the memory reads the stored count. In the next cycle the
  // memory reads for `read_index`.
  wire                   s0_valid;
  wire [INDEX_BITS-1:0]  s0_index;
  wire [NARROW_BITS-1:0] s0_narrow;

  counter_scan #(
    .COUNTERS  (COUNTERS),
    .WIDTH     (NARROW_BITS),
    .INDEX_BITS(INDEX_BITS)
  ) scan (
    .aclk   (aclk),
    .aresetn(aresetn),
    .counts (counts),
    .valid  (s0_valid),
    .index  (s0_index),
    .count  (s0_narrow)
  );

  // Stage 1: the narrow counter has wrapped if it is below the stored digits. In the first round
  // after a reset nothing is stored yet.
  reg                    s1_valid_q;
  reg  [INDEX_BITS-1:0]  s1_index_q;
  reg  [NARROW_BITS-1:0] s1_narrow_q;
  reg                    s1_stored_q;
  wire [WIDTH-1:0]       s1_count;
  wire                   s1_wrapped = s1_stored_q && (s1_narrow_q < s1_count[NARROW_BITS-1:0]);

  always @(posedge aclk) begin
    if (!aresetn) begin
      s1_valid_q <= 1'b0;
    end else begin
      s1_valid_q <= s0_valid;
    end
  end

  always @(posedge aclk) begin
    s1_index_q  <= s0_index;
    s1_narrow_q <= s0_narrow;
  end

  always @(posedge aclk) begin
    if (!aresetn) begin
      s1_stored_q <= 1'b0;
    end else if (s1_valid_q && (s1_index_q == LAST[INDEX_BITS-1:0])) begin
      s1_stored_q <= 1'b1;
    end
  end

  // Stage 2: the count is stored while the next one is read.
  reg                    s2_valid_q;
  reg  [INDEX_BITS-1:0]  s2_index_q;
  reg  [NARROW_BITS-1:0] s2_narrow_q;
  reg                    s2_wrapped_q;
  reg  [HIGH_BITS-1:0]   s2_high_q;
  wire [HIGH_BITS-1:0]   s2_high = s2_wrapped_q ? s2_high_q + ONE : s2_high_q;

  always @(posedge aclk) begin
    if (!aresetn) begin
      s2_valid_q <= 1'b0;
    end else begin
      s2_valid_q <= s1_valid_q;
    end
  end

  always @(posedge aclk) begin
    s2_index_q   <= s1_index_q;
    s2_narrow_q  <= s1_narrow_q;
    s2_wrapped_q <= s1_wrapped;
    s2_high_q    <= s1_count[WIDTH-1:NARROW_BITS] & {HIGH_BITS{s1_stored_q}};
  end

  dual_port_memory #(
    .WIDTH       (WIDTH),
    .ADDRESS_BITS(INDEX_BITS)
  ) memory (
    .aclk         (aclk),
    .write_enable (s2_valid_q),
    .write_address(s2_index_q),
    .write_data   ({s2_high, s2_narrow_q}),
    .read_enable  (1'b1),
    .read_address (s0_valid ? s0_index : read_index),
    .read_data    (s1_count)
  );

  // A read waits for a cycle in which stage 1 is valid, which is every second one. Stage 0 is not
  // valid then, and the scan does not read the memory.
  reg  waiting_q;
  reg  done_q;
  wire reads = (read_start || waiting_q) && s1_valid_q;

  always @(posedge aclk) begin
    if (!aresetn) begin
      waiting_q <= 1'b0;
      done_q    <= 1'b0;
    end else begin
      waiting_q <= (read_start || waiting_q) && !s1_valid_q;
      done_q    <= reads;
    end
  end

  assign ready      = s1_stored_q;
  assign read_done  = done_q;
  assign read_count = s1_count;

endmodule

`default_nettype wire
