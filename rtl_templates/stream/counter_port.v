// counter_port: counters that software reads on an AXI4-Lite port of 32 bits, which refuses writes.
// `counts` are narrow counters that wrap, the first one lowest. Each is stored with more bits, as
// in counter_memory. A count lags behind by 2 COUNTERS cycles and a few more at most.
//
// Counter k is at address 8 k: its low word there, bits 32 and up in the word above. The high word
// belongs to the counter whose low word was read last, and was stored at that time, so both make
// one count. Other addresses read zero. Reset clears the counters. No read is taken for 2 COUNTERS
// cycles and a few more after it.
`default_nettype none

module counter_port #(
  parameter COUNTERS = 4,     // counters on the port, 2 or more
  parameter NARROW_BITS = 8,  // bits of a narrow counter, 1 to 30; 2^NARROW_BITS > 2 COUNTERS + 1
  parameter WIDTH = 32,       // bits of a stored count, more than NARROW_BITS and at most 64
  parameter INDEX_BITS = 2    // bits of a counter's number, 1 to 30; 2^INDEX_BITS >= COUNTERS
) (
  input  wire                            aclk,
  input  wire                            aresetn,
  input  wire [COUNTERS*NARROW_BITS-1:0] counts,
  input  wire [INDEX_BITS+2:0]           s_axi_awaddr,
  input  wire [2:0]                      s_axi_awprot,
  input  wire                            s_axi_awvalid,
  output wire                            s_axi_awready,
  input  wire [31:0]                     s_axi_wdata,
  input  wire [3:0]                      s_axi_wstrb,
  input  wire                            s_axi_wvalid,
  output wire                            s_axi_wready,
  output wire [1:0]                      s_axi_bresp,
  output wire                            s_axi_bvalid,
  input  wire                            s_axi_bready,
  input  wire [INDEX_BITS+2:0]           s_axi_araddr,
  input  wire [2:0]                      s_axi_arprot,
  input  wire                            s_axi_arvalid,
  output wire                            s_axi_arready,
  output wire [31:0]                     s_axi_rdata,
  output wire [1:0]                      s_axi_rresp,
  output wire                            s_axi_rvalid,
  input  wire                            s_axi_rready
);

  localparam ADDRESS_BITS = INDEX_BITS + 3;
  localparam LAST         = COUNTERS - 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((WIDTH < 1) || (WIDTH > 64)) begin : g_refused_width WIDTH_is_not_1_to_64 refused (); end
  endgenerate

  wire                    readable;
  wire                    read_start;
  wire [ADDRESS_BITS-1:0] read_address;
  wire                    read_done;
  wire [WIDTH-1:0]        read_count;
  reg  [31:0]             word;
  wire [INDEX_BITS-1:0]   index         = read_address[ADDRESS_BITS-1:3];
  wire                    reads_high    = read_address[2];
  wire                    unused_offset = &read_address[1:0];

  axi_lite_reads #(
    .ADDRESS_BITS(ADDRESS_BITS)
  ) bus (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axi_awaddr (s_axi_awaddr),
    .s_axi_awprot (s_axi_awprot),
    .s_axi_awvalid(s_axi_awvalid),
    .s_axi_awready(s_axi_awready),
    .s_axi_wdata  (s_axi_wdata),
    .s_axi_wstrb  (s_axi_wstrb),
    .s_axi_wvalid (s_axi_wvalid),
    .s_axi_wready (s_axi_wready),
    .s_axi_bresp  (s_axi_bresp),
    .s_axi_bvalid (s_axi_bvalid),
    .s_axi_bready (s_axi_bready),
    .s_axi_araddr (s_axi_araddr),
    .s_axi_arprot (s_axi_arprot),
    .s_axi_arvalid(s_axi_arvalid),
    .s_axi_arready(s_axi_arready),
    .s_axi_rdata  (s_axi_rdata),
    .s_axi_rresp  (s_axi_rresp),
    .s_axi_rvalid (s_axi_rvalid),
    .s_axi_rready (s_axi_rready),
    .readable     (readable),
    .read_start   (read_start),
    .read_address (read_address),
    .read_done    (read_done),
    .read_word    (word)
  );

  counter_memory #(
    .COUNTERS   (COUNTERS),
    .NARROW_BITS(NARROW_BITS),
    .WIDTH      (WIDTH),
    .INDEX_BITS (INDEX_BITS)
  ) memory (
    .aclk      (aclk),
    .aresetn   (aresetn),
    .counts    (counts),
    .ready     (readable),
    .read_start(read_start),
    .read_index(index),
    .read_done (read_done),
    .read_count(read_count)
  );

  // The word that is read. Reading a low word stores the bits above it.
  wire        is_counter = ({1'b0, index} <= LAST[INDEX_BITS:0]);
  wire [31:0] low_word;
  wire [31:0] high_word;

  generate
    if (WIDTH > 32) begin : g_two_words
      reg [WIDTH-33:0] high_q;

      always @(posedge aclk) begin
        if (read_done && !reads_high) begin
          high_q <= read_count[WIDTH-1:32];
        end
      end

      assign low_word = read_count[31:0];

      if (WIDTH == 64) begin : g_whole
        assign high_word = high_q;
      end else begin : g_padded
        assign high_word = {{(64-WIDTH){1'b0}}, high_q};
      end
    end else begin : g_one_word
      assign high_word = 32'd0;

      if (WIDTH == 32) begin : g_whole
        assign low_word = read_count;
      end else begin : g_padded
        assign low_word = {{(32-WIDTH){1'b0}}, read_count};
      end
    end
  endgenerate

  always @* begin
    word = 32'd0;
    if (is_counter) begin
      word = reads_high ? high_word : low_word;
    end
  end

endmodule

`default_nettype wire
