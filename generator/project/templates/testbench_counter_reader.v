  // Software at the port on which the counters are read.
  localparam COUNTERS = @COUNTERS@;
  localparam ADDRESS_BITS = @COUNTER_ADDRESS_BITS@;
  wire [ADDRESS_BITS-1:0]          s_axi_awaddr;
  wire [2:0]                       s_axi_awprot;
  wire                             s_axi_awvalid;
  wire                             s_axi_awready;
  wire [31:0]                      s_axi_wdata;
  wire [3:0]                       s_axi_wstrb;
  wire                             s_axi_wvalid;
  wire                             s_axi_wready;
  wire [1:0]                       s_axi_bresp;
  wire                             s_axi_bvalid;
  wire                             s_axi_bready;
  wire [ADDRESS_BITS-1:0]          s_axi_araddr;
  wire [2:0]                       s_axi_arprot;
  wire                             s_axi_arvalid;
  wire                             s_axi_arready;
  wire [31:0]                      s_axi_rdata;
  wire [1:0]                       s_axi_rresp;
  wire                             s_axi_rvalid;
  wire                             s_axi_rready;
  wire [COUNTERS*COUNTER_BITS-1:0] counts;
  reg                              start_reading;
  wire                             reading_done;
  wire                             reading_broken;

  initial start_reading = 1'b0;

  counter_reader #(
      .COUNTERS(COUNTERS),
      .COUNTER_BITS(COUNTER_BITS),
      .ADDRESS_BITS(ADDRESS_BITS)
  ) reader (
      .aclk(aclk),
      .start(start_reading),
      .done(reading_done),
      .broken(reading_broken),
@INCLUDE testbench_counter_bus.v@
      .counts(counts)
  );

@COUNTER_WIRES@
  task read_counters;
    begin
      start_reading = 1'b1;
      while (!reading_done) clock_cycle;
      start_reading = 1'b0;
      last_progress = cycle;
      while (reading_done) clock_cycle;
      if (reading_broken) begin
        $display("the port of the counters broke a rule of AXI4-Lite");
        count_failure;
      end
    end
  endtask

