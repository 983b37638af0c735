// counter_reader: software at the AXI4-Lite port of a system's counters, for test benches. When
// `start` rises it waits until the port has seen the last count, tries a write, which has to be
// refused, and reads all counters. Then `done` is high, with counter k in `counts`, until `start`
// falls. `broken`: an answer was wrong, or none came. Nothing may count meanwhile.
`default_nettype none

module counter_reader #(
  parameter COUNTERS = 1,
  parameter COUNTER_BITS = 32,
  parameter ADDRESS_BITS = 4
) (
  input  wire                             aclk,
  input  wire                             start,
  output reg                              done,
  output reg                              broken,
  output reg  [COUNTERS*COUNTER_BITS-1:0] counts,
  output wire [ADDRESS_BITS-1:0]          s_axi_awaddr,
  output wire [2:0]                       s_axi_awprot,
  output reg                              s_axi_awvalid,
  input  wire                             s_axi_awready,
  output wire [31:0]                      s_axi_wdata,
  output wire [3:0]                       s_axi_wstrb,
  output reg                              s_axi_wvalid,
  input  wire                             s_axi_wready,
  input  wire [1:0]                       s_axi_bresp,
  input  wire                             s_axi_bvalid,
  output reg                              s_axi_bready,
  output wire [ADDRESS_BITS-1:0]          s_axi_araddr,
  output wire [2:0]                       s_axi_arprot,
  output reg                              s_axi_arvalid,
  input  wire                             s_axi_arready,
  input  wire [31:0]                      s_axi_rdata,
  input  wire [1:0]                       s_axi_rresp,
  input  wire                             s_axi_rvalid,
  output reg                              s_axi_rready
);

  localparam [2:0] IDLE = 3'd0;
  localparam [2:0] WAITING = 3'd1;
  localparam [2:0] WRITING = 3'd2;
  localparam [2:0] ASKING = 3'd3;
  localparam [2:0] READING = 3'd4;
  localparam [2:0] DONE = 3'd5;
  // The port looks at each counter once in a round of two cycles for each.
  localparam QUIET_CYCLES = 2 * COUNTERS + 32;
  localparam MOST_CYCLES = 100;

  reg [2:0]  state;
  integer    counter;  // which is read
  reg        high;     // its upper word
  reg [31:0] low_word;
  reg [63:0] count;
  integer    cycles;   // in this state, or since the last word

  assign s_axi_awaddr = {ADDRESS_BITS{1'b0}};
  assign s_axi_awprot = 3'd0;
  assign s_axi_wdata = 32'hffffffff;
  assign s_axi_wstrb = 4'hf;
  assign s_axi_arprot = 3'd0;

  wire [31:0] offset = 8 * counter + (high ? 4 : 0);
  assign s_axi_araddr = offset[ADDRESS_BITS-1:0];

  initial begin
    state = IDLE;
    counter = 0;
    high = 1'b0;
    cycles = 0;
    done = 1'b0;
    broken = 1'b0;
    counts = {COUNTERS*COUNTER_BITS{1'b0}};
    s_axi_awvalid = 1'b0;
    s_axi_wvalid = 1'b0;
    s_axi_bready = 1'b0;
    s_axi_arvalid = 1'b0;
    s_axi_rready = 1'b0;
  end

  task next_word;
    begin
      high <= !high;
      if (high) counter <= counter + 1;
      s_axi_arvalid <= !high || (counter < COUNTERS - 1);
      s_axi_rready <= 1'b0;
      state <= (high && (counter == COUNTERS - 1)) ? DONE : ASKING;
      cycles <= 0;
    end
  endtask

  always @(posedge aclk) begin
    cycles <= cycles + 1;
    case (state)
      IDLE: begin
        cycles <= 0;
        if (start) state <= WAITING;
      end
      WAITING: begin
        if (cycles == QUIET_CYCLES) begin
          s_axi_awvalid <= 1'b1;
          s_axi_wvalid <= 1'b1;
          state <= WRITING;
          cycles <= 0;
        end
      end
      WRITING: begin
        if (s_axi_awready) s_axi_awvalid <= 1'b0;
        if (s_axi_wready) s_axi_wvalid <= 1'b0;
        s_axi_bready <= s_axi_bvalid && !s_axi_bready;
        if (s_axi_bvalid && s_axi_bready) begin
          if (s_axi_bresp !== 2'd2) broken <= 1'b1;
          counter <= 0;
          high <= 1'b0;
          s_axi_arvalid <= 1'b1;
          state <= ASKING;
          cycles <= 0;
        end
      end
      ASKING: begin
        if (s_axi_arready) begin
          s_axi_arvalid <= 1'b0;
          state <= READING;
        end
      end
      READING: begin
        s_axi_rready <= s_axi_rvalid;
        if (s_axi_rvalid && s_axi_rready) begin
          if (s_axi_rresp !== 2'd0) broken <= 1'b1;
          if (high) begin
            count = {s_axi_rdata, low_word};
            counts[counter*COUNTER_BITS +: COUNTER_BITS] <= count[COUNTER_BITS-1:0];
          end
          low_word <= s_axi_rdata;
          next_word;
        end
      end
      default: begin
        done <= start;
        if (!start) state <= IDLE;
      end
    endcase
    if ((state != IDLE) && (state != DONE) && (cycles > QUIET_CYCLES + MOST_CYCLES)) begin
      broken <= 1'b1;
      state <= DONE;
    end
  end

endmodule

`default_nettype wire
