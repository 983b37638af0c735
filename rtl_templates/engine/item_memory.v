// item_memory: the items of one set. Port i writes or reads, port j reads, so both items of a pair
// are read at once. Latency 1; an output holds its word until its port's next read. There is no
// reset, so that synthesis can use block RAM. A read on port j of the address that is written in
// the same cycle returns no word. No module here makes that read, and simulation answers it with
// unknown bits. Attributes stop the synthesis tool from building logic that would answer (Yosys:
// no_rw_check, Quartus: ramstyle, Vivado: rw_addr_collision).
`default_nettype none

module item_memory #(
  parameter WIDTH = 32,       // bits of a word, 1 or more
  parameter ADDRESS_BITS = 4  // 1 to 30: the memory has 2^ADDRESS_BITS words
) (
  input  wire                    aclk,
  input  wire                    i_enable,
  input  wire                    i_write,
  input  wire [ADDRESS_BITS-1:0] i_address,
  input  wire [WIDTH-1:0]        i_write_data,
  output wire [WIDTH-1:0]        i_read_data,
  input  wire                    j_enable,
  input  wire [ADDRESS_BITS-1:0] j_address,
  output wire [WIDTH-1:0]        j_read_data
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if (ADDRESS_BITS < 1) begin : g_refused_address_bits ADDRESS_BITS_is_below_1 refused (); end
    if (ADDRESS_BITS > 30) begin : g_refused_address_shift ADDRESS_BITS_is_above_30 refused (); end
  endgenerate

  (* no_rw_check, ramstyle = "no_rw_check", rw_addr_collision = "no" *)
  reg [WIDTH-1:0] words [0:(1<<ADDRESS_BITS)-1];
  reg [WIDTH-1:0] i_read_data_q;
  reg [WIDTH-1:0] j_read_data_q;

  always @(posedge aclk) begin
    if (i_enable) begin
      if (i_write) begin
        words[i_address] <= i_write_data;
      end else begin
        i_read_data_q <= words[i_address];
      end
    end
  end

  always @(posedge aclk) begin
    if (j_enable) begin
      j_read_data_q <= words[j_address];
`ifndef SYNTHESIS
      if (i_enable && i_write && (i_address == j_address)) begin
        j_read_data_q <= {WIDTH{1'bx}};
      end
`endif
    end
  end

  assign i_read_data = i_read_data_q;
  assign j_read_data = j_read_data_q;

endmodule

`default_nettype wire
