// counter_port_tb: counters behind counter_port, in any simulator. A count that the bus reads lies
// between the count of a round ago and the count of now, and is exact when nothing has stepped for
// a round. Low and high words belong together. Writes are refused. Resets come at random. Prints
// PASSED, or FAILED and the first faults.
`default_nettype none

module counter_port_tb #(
  parameter COUNTERS = 5,
  parameter NARROW_BITS = 4,
  parameter WIDTH = 40,
  parameter INDEX_BITS = 3,
  parameter CYCLES = 30000
);

  localparam LAG     = 2 * COUNTERS + 16;  // cycles by which a count may be late
  localparam HISTORY = 4096;               // cycles whose counts are known
  localparam HIGH_BITS = WIDTH - NARROW_BITS;

  reg                             aclk;
  reg                             aresetn;
  reg  [COUNTERS-1:0]             steps;
  wire [COUNTERS*NARROW_BITS-1:0] counts;
  reg  [INDEX_BITS+2:0]           awaddr;
  reg                             awvalid;
  wire                            awready;
  reg                             wvalid;
  wire                            wready;
  wire [1:0]                      bresp;
  wire                            bvalid;
  reg                             bready;
  reg  [INDEX_BITS+2:0]           araddr;
  reg                             arvalid;
  wire                            arready;
  wire [31:0]                     rdata;
  wire [1:0]                      rresp;
  wire                            rvalid;
  reg                             rready;

  counter_port #(
    .COUNTERS   (COUNTERS),
    .NARROW_BITS(NARROW_BITS),
    .WIDTH      (WIDTH),
    .INDEX_BITS (INDEX_BITS)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .counts       (counts),
    .s_axi_awaddr (awaddr),
    .s_axi_awprot (3'd0),
    .s_axi_awvalid(awvalid),
    .s_axi_awready(awready),
    .s_axi_wdata  (32'hffffffff),
    .s_axi_wstrb  (4'hf),
    .s_axi_wvalid (wvalid),
    .s_axi_wready (wready),
    .s_axi_bresp  (bresp),
    .s_axi_bvalid (bvalid),
    .s_axi_bready (bready),
    .s_axi_araddr (araddr),
    .s_axi_arprot (3'd0),
    .s_axi_arvalid(arvalid),
    .s_axi_arready(arready),
    .s_axi_rdata  (rdata),
    .s_axi_rresp  (rresp),
    .s_axi_rvalid (rvalid),
    .s_axi_rready (rready)
  );

  genvar k;
  generate
    for (k = 0; k < COUNTERS; k = k + 1) begin : g_counters
      event_counter #(
        .COUNTER_BITS(NARROW_BITS)
      ) counter (
        .aclk   (aclk),
        .aresetn(aresetn),
        .step   (steps[k]),
        .count  (counts[k*NARROW_BITS +: NARROW_BITS])
      );
    end
  endgenerate

  // The counts since the reset, in this cycle and in the cycles before.
  reg [WIDTH-1:0] counted [0:COUNTERS-1];
  reg [WIDTH-1:0] history [0:HISTORY*COUNTERS-1];

  reg                  reading;     // a read was taken and its word has not left
  reg                  waited;      // its word was offered and not taken
  reg [31:0]           waited_data;
  reg [INDEX_BITS+2:0] address;     // the address of that read
  integer              taken_at;
  reg                  writing;     // a write was taken and its answer has not left
  reg                  answer_waited;
  reg                  low_known;   // the low word of counter low_of was read last
  integer              low_of;
  reg [31:0]           low_word;
  integer              low_taken_at;
  integer              low_left_at;
  integer              cycle;
  integer              reset_at;
  integer              words_read;
  integer              exact_words;
  integer              writes;
  integer              late_reads;   // cycles in which a read has waited to be taken
  integer              failures;
  reg                  quiet;
  reg [31:0]           random;
  reg [7:0]            density;

  task draw;
    begin
      random = random ^ (random << 13);
      random = random ^ (random >> 17);
      random = random ^ (random << 5);
    end
  endtask

  task fail(input [8*48-1:0] what);
    begin
      if (failures < 10) $display("cycle %0d, address %0d: %0s", cycle, address, what);
      failures = failures + 1;
    end
  endtask

  // The count lies between that of LAG cycles before `from` and that of cycle `to`.
  task check_range(input integer index, input [WIDTH-1:0] count, input integer from,
                   input integer to);
    integer         earliest;
    reg [WIDTH-1:0] least;
    reg [WIDTH-1:0] most;
    begin
      earliest = (from - LAG < reset_at) ? reset_at : from - LAG;
      least = history[(earliest%HISTORY)*COUNTERS+index];
      most = history[(to%HISTORY)*COUNTERS+index];
      if ((count - least) > (most - least)) begin  // modulo 2^WIDTH
        fail("a count is not one of the last round");
        $display("  counter %0d: %0d, expected %0d to %0d", index, count, least, most);
      end
      if (least == most) exact_words = exact_words + 1;
    end
  endtask

  task check_word;
    integer    index;
    reg [63:0] joined;
    begin
      index = address >> 3;
      words_read = words_read + 1;
      if (((low_known && (low_of == index)) || !address[2]) && (^rdata === 1'bx)) begin
        fail("an unknown bit in a word");
      end
      if (rresp !== 2'd0) fail("a read is not OKAY");
      if (index >= COUNTERS) begin
        if (rdata !== 32'd0) fail("a word beyond the counters is not zero");
      end else if (!address[2]) begin
        low_known = 1'b1;
        low_of = index;
        low_word = rdata;
        low_taken_at = taken_at;
        low_left_at = cycle;
        if (WIDTH <= 32) check_range(index, rdata[(WIDTH<32?WIDTH:32)-1:0], taken_at, cycle);
      end else if (low_known && (low_of == index)) begin
        joined = {rdata, low_word};
        if (WIDTH > 32) check_range(index, joined[WIDTH-1:0], low_taken_at, low_left_at);
        else if (rdata !== 32'd0) fail("a high word of a narrow count is not zero");
      end
      if ((index >= COUNTERS) && !address[2]) low_known = 1'b0;
    end
  endtask

  // Sets the inputs of a cycle, while aclk is low.
  task drive;
    integer n;
    begin
      draw;
      if (random[9:0] == 10'd0) quiet = !quiet;
      if (random[17:12] == 6'd0) density = random[31:24] | {8{random[23]}};
      for (n = 0; n < COUNTERS; n = n + 1) begin
        draw;
        steps[n] = !quiet && (random[7:0] <= density);
      end
      draw;
      if (!arvalid && !reading) begin
        arvalid = random[1:0] != 2'd0;
        // Half of the reads are of the high word behind the low one.
        if (low_known && random[2]) araddr = {low_of[INDEX_BITS-1:0], 3'b100};
        else araddr = random[8 +: INDEX_BITS+3];
      end
      rready = random[3];
      if (!awvalid && !writing) awvalid = random[6:4] == 3'd0;
      if (!wvalid && !writing) wvalid = random[7:5] == 3'd0;
      awaddr = random[31 -: INDEX_BITS+3];
      bready = random[16];
    end
  endtask

  task sample_read;
    begin
      if (rvalid && !reading) fail("a word without a read");
      if (waited && (!rvalid || (rdata !== waited_data))) fail("a word does not wait");
      waited = rvalid && !rready;
      waited_data = rdata;
      if (rvalid && rready) begin
        check_word;
        reading = 1'b0;
      end
      if (arvalid && arready) begin
        if (reading) fail("a read is taken among another");
        reading = 1'b1;
        address = araddr;
        taken_at = cycle;
      end
      late_reads = (arvalid && !arready) ? late_reads + 1 : 0;
      if (late_reads > LAG + 8) fail("a read is not taken");
      if (reading && !rvalid && (cycle - taken_at > 8)) fail("a read has no word");
    end
  endtask

  task sample_write;
    begin
      if (bvalid && !writing) fail("an answer without a write");
      if (bvalid && (bresp !== 2'd2)) fail("a write is not refused");
      if (answer_waited && !bvalid) fail("an answer does not wait");
      answer_waited = bvalid && !bready;
      if (bvalid && bready) begin
        writing = 1'b0;
        writes = writes + 1;
      end
      if ((awready !== wready) || (awready && !(awvalid && wvalid))) fail("half of a write is taken");
      if (awvalid && awready) begin
        if (writing) fail("a write is taken among another");
        writing = 1'b1;
      end
    end
  endtask

  task clock_cycle;
    integer n;
    reg     read_taken;
    reg     write_taken;
    begin
      #1;
      if (aresetn) drive;
      #1;
      for (n = 0; n < COUNTERS; n = n + 1) history[(cycle%HISTORY)*COUNTERS+n] = counted[n];
      if (^{arready, rvalid, awready, wready, bvalid} === 1'bx) fail("an unknown handshake");
      if (aresetn) begin
        sample_write;
        sample_read;
      end
      read_taken = arvalid && arready;
      write_taken = awvalid && awready;
      aclk = 1'b1;
      #1;
      for (n = 0; n < COUNTERS; n = n + 1) begin
        if (!aresetn) counted[n] = 0;
        else if (steps[n]) counted[n] = counted[n] + 1;
      end
      if (read_taken) arvalid = 1'b0;
      if (write_taken) begin
        awvalid = 1'b0;
        wvalid = 1'b0;
      end
      #1;
      aclk = 1'b0;
      cycle = cycle + 1;
    end
  endtask

  task reset;
    integer n;
    begin
      arvalid = 1'b0;
      awvalid = 1'b0;
      wvalid = 1'b0;
      rready = 1'b0;
      bready = 1'b0;
      reading = 1'b0;
      waited = 1'b0;
      writing = 1'b0;
      answer_waited = 1'b0;
      low_known = 1'b0;
      late_reads = 0;
      aresetn = 1'b0;
      #2 aclk = 1'b1;
      #2 aclk = 1'b0;
      cycle = cycle + 1;
      if (rvalid !== 1'b0 || bvalid !== 1'b0) fail("an answer in reset");
      aresetn = 1'b1;
      reset_at = cycle;
      for (n = 0; n < COUNTERS; n = n + 1) counted[n] = 0;
    end
  endtask

  // Raises the stored digits above the narrow ones, since counting that far would take too long.
  // Nothing may step meanwhile.
  task raise(input [HIGH_BITS-1:0] high);
    integer n;
    integer round;
    begin
      for (round = 0; round < 2 * LAG; round = round + 1) begin
        for (n = 0; n < COUNTERS; n = n + 1) begin
          dut.memory.memory.words[n][WIDTH-1:NARROW_BITS] = high;
        end
        steps = {COUNTERS{1'b0}};
        #2 aclk = 1'b1;
        #2 aclk = 1'b0;
      end
      for (n = 0; n < COUNTERS; n = n + 1) counted[n][WIDTH-1:NARROW_BITS] = high;
      reset_at = cycle;  // from this cycle on the history has these counts
      low_known = 1'b0;
    end
  endtask

  // Waits until everything under way has left, without new steps.
  task settle;
    integer n;
    begin
      arvalid = 1'b0;
      awvalid = 1'b0;
      wvalid = 1'b0;
      rready = 1'b1;
      bready = 1'b1;
      steps = {COUNTERS{1'b0}};
      for (n = 0; n < 2 * LAG; n = n + 1) begin
        #2 aclk = 1'b1;
        #2 aclk = 1'b0;
      end
      reading = 1'b0;
      waited = 1'b0;
      writing = 1'b0;
      answer_waited = 1'b0;
    end
  endtask

  initial begin
    aclk = 1'b0;
    aresetn = 1'b0;
    cycle = 0;
    failures = 0;
    words_read = 0;
    exact_words = 0;
    writes = 0;
    random = 32'h2545f491;
    density = 8'hff;
    quiet = 1'b0;
    address = 0;
    steps = {COUNTERS{1'b0}};
    reset;
    while (cycle < CYCLES) begin
      clock_cycle;
      draw;
      if (random[12:0] == 13'd0) reset;
      if (random[12:0] == 13'd1) begin
        settle;
        // A little below all ones, so that the high words step.
        raise(~{{(HIGH_BITS-1){1'b0}}, 1'b1} << random[14:13]);
      end
    end
    if ((words_read < CYCLES / 100) || (exact_words < CYCLES / 2000) || (writes < CYCLES / 200)) begin
      $display("%0d words, %0d of them exact, %0d writes: too few", words_read, exact_words, writes);
      failures = failures + 1;
    end
    if (failures == 0) $display("PASSED");
    else $display("FAILED: %0d", failures);
    $finish(0);
  end

endmodule

`default_nettype wire
