// item_memory: the items of one set. Port a writes or reads, port b reads.
// Latency 1; an output holds its word until its port reads again. No reset, so that it becomes
// block RAM with two ports. A read at port b of the address that port a writes in the same cycle
// returns no word: nobody reads so, simulation answers with unknown bits, and the attributes keep
// synthesis from building logic that would answer.
`default_nettype none

module item_memory #(
  parameter WIDTH = 32,
  parameter ADDRESS_BITS = 4
) (
  input  wire                    aclk,
  input  wire                    a_enable,
  input  wire                    a_write,
  input  wire [ADDRESS_BITS-1:0] a_address,
  input  wire [WIDTH-1:0]        a_write_data,
  output wire [WIDTH-1:0]        a_read_data,
  input  wire                    b_enable,
  input  wire [ADDRESS_BITS-1:0] b_address,
  output wire [WIDTH-1:0]        b_read_data
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (WIDTH < 1) begin : g_refused_width
      WIDTH_is_below_1 refused ();
    end
    if (ADDRESS_BITS < 1) begin : g_refused_address_bits
      ADDRESS_BITS_is_below_1 refused ();
    end
    if (ADDRESS_BITS > 30) begin : g_refused_address_shift
      ADDRESS_BITS_is_above_30 refused ();
    end
  endgenerate

  (* no_rw_check, ramstyle = "no_rw_check", rw_addr_collision = "no" *)
  reg [WIDTH-1:0] words [0:(1<<ADDRESS_BITS)-1];
  reg [WIDTH-1:0] a_read_data_q;
  reg [WIDTH-1:0] b_read_data_q;

  always @(posedge aclk) begin
    if (a_enable) begin
      if (a_write) begin
        words[a_address] <= a_write_data;
      end else begin
        a_read_data_q <= words[a_address];
      end
    end
  end

  always @(posedge aclk) begin
    if (b_enable) begin
      b_read_data_q <= words[b_address];
`ifndef SYNTHESIS
      if (a_enable && a_write && (a_address == b_address)) begin
        b_read_data_q <= {WIDTH{1'bx}};
      end
`endif
    end
  end

  assign a_read_data = a_read_data_q;
  assign b_read_data = b_read_data_q;

endmodule

`default_nettype wire
