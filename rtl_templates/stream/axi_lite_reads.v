// axi_lite_reads: an AXI4-Lite slave that can only be read. One read is in progress at a time.
// Writes are taken and answered with SLVERR; they change nothing.
//
// `read_start` is high in one cycle with the address of a read. The address stays on `read_address`
// until `read_done` is high in one later cycle, with the word on `read_word`. No read is taken from
// the bus in the cycle after one in which `readable` is low. Every output of the bus is a register
// or a constant. Reset forgets a read in progress.
`default_nettype none

module axi_lite_reads #(
  parameter ADDRESS_BITS = 12  // bits of an address, 1 or more
) (
  input  wire                    aclk,
  input  wire                    aresetn,
  input  wire [ADDRESS_BITS-1:0] s_axi_awaddr,
  input  wire [2:0]              s_axi_awprot,
  input  wire                    s_axi_awvalid,
  output wire                    s_axi_awready,
  input  wire [31:0]             s_axi_wdata,
  input  wire [3:0]              s_axi_wstrb,
  input  wire                    s_axi_wvalid,
  output wire                    s_axi_wready,
  output wire [1:0]              s_axi_bresp,
  output wire                    s_axi_bvalid,
  input  wire                    s_axi_bready,
  input  wire [ADDRESS_BITS-1:0] s_axi_araddr,
  input  wire [2:0]              s_axi_arprot,
  input  wire                    s_axi_arvalid,
  output wire                    s_axi_arready,
  output wire [31:0]             s_axi_rdata,
  output wire [1:0]              s_axi_rresp,
  output wire                    s_axi_rvalid,
  input  wire                    s_axi_rready,
  input  wire                    readable,
  output wire                    read_start,
  output wire [ADDRESS_BITS-1:0] read_address,
  input  wire                    read_done,
  input  wire [31:0]             read_word
);

  localparam [1:0] OKAY   = 2'd0;
  localparam [1:0] SLVERR = 2'd2;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (ADDRESS_BITS < 1) begin : g_refused_address_bits ADDRESS_BITS_is_below_1 refused (); end
  endgenerate

  wire unused_inputs = &{s_axi_awaddr, s_axi_awprot, s_axi_wdata, s_axi_wstrb, s_axi_arprot};

  // A write is taken when its address and data are both there and the previous answer has left.
  reg  write_ready_q;
  reg  answer_valid_q;
  wire answer_stays = answer_valid_q && !s_axi_bready;

  always @(posedge aclk) begin
    if (!aresetn) begin
      write_ready_q  <= 1'b0;
      answer_valid_q <= 1'b0;
    end else begin
      write_ready_q  <= s_axi_awvalid && s_axi_wvalid && !write_ready_q && !answer_stays;
      answer_valid_q <= write_ready_q || answer_stays;
    end
  end

  assign s_axi_awready = write_ready_q;
  assign s_axi_wready  = write_ready_q;
  assign s_axi_bvalid  = answer_valid_q;
  assign s_axi_bresp   = SLVERR;

  // A read is taken when no other is in progress.
  reg                     read_ready_q;
  reg                     busy_q;
  reg                     start_q;
  reg                     word_valid_q;
  reg  [ADDRESS_BITS-1:0] address_q;
  reg  [31:0]             word_q;
  wire                    taken = s_axi_arvalid && read_ready_q;
  wire                    leaves = word_valid_q && s_axi_rready;

  always @(posedge aclk) begin
    if (!aresetn) begin
      read_ready_q <= 1'b0;
      busy_q       <= 1'b0;
      start_q      <= 1'b0;
      word_valid_q <= 1'b0;
    end else begin
      read_ready_q <= readable && !taken && (!busy_q || leaves);
      busy_q       <= taken || (busy_q && !leaves);
      start_q      <= taken;
      word_valid_q <= read_done || (word_valid_q && !s_axi_rready);
    end
  end

  always @(posedge aclk) begin
    if (taken) begin
      address_q <= s_axi_araddr;
    end
    if (read_done) begin
      word_q <= read_word;
    end
  end

  assign read_start    = start_q;
  assign read_address  = address_q;
  assign s_axi_arready = read_ready_q;
  assign s_axi_rvalid  = word_valid_q;
  assign s_axi_rdata   = word_q;
  assign s_axi_rresp   = OKAY;

endmodule

`default_nettype wire
