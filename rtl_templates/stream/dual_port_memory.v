// dual_port_memory: one write port, one synchronous read port with an enable.
// Latency 1. There is no reset, so that synthesis can use LUT RAM or block RAM. A read of the
// address that is written in the same cycle returns no word. No module here makes that read, and
// simulation answers it with unknown bits. Attributes keep synthesis from building logic that would
// answer (Yosys: no_rw_check, Quartus: ramstyle, Vivado: rw_addr_collision).
`default_nettype none

module dual_port_memory #(
  parameter WIDTH = 8,        // bits of a word, 1 or more
  parameter ADDRESS_BITS = 4  // 1 to 30: the memory has 2^ADDRESS_BITS words
) (
  input  wire                    aclk,
  input  wire                    write_enable,
  input  wire [ADDRESS_BITS-1:0] write_address,
  input  wire [WIDTH-1:0]        write_data,
  input  wire                    read_enable,
  input  wire [ADDRESS_BITS-1:0] read_address,
  output wire [WIDTH-1:0]        read_data
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if (ADDRESS_BITS < 1) begin : g_refused_address_bits ADDRESS_BITS_is_below_1 refused (); end
    if (ADDRESS_BITS > 30) begin : g_refused_address_shift ADDRESS_BITS_is_above_30 refused (); end
  endgenerate

  (* no_rw_check, ramstyle = "no_rw_check", rw_addr_collision = "no" *)
  reg [WIDTH-1:0] words [0:(1<<ADDRESS_BITS)-1];
  reg [WIDTH-1:0] read_data_q;

  always @(posedge aclk) begin
    if (write_enable) begin
      words[write_address] <= write_data;
    end
    if (read_enable) begin
      read_data_q <= words[read_address];
`ifndef SYNTHESIS
      if (write_enable && (write_address == read_address)) begin
        read_data_q <= {WIDTH{1'bx}};
      end
`endif
    end
  end

  assign read_data = read_data_q;

endmodule

`default_nettype wire
