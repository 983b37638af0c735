// item_memory: the items of one set, behind one port that writes or reads.
// Latency 1; the output holds its word until the next read. No reset, so that it becomes block RAM.
`default_nettype none

module item_memory #(
  parameter WIDTH = 32,
  parameter ADDRESS_BITS = 4
) (
  input  wire                    aclk,
  input  wire                    enable,
  input  wire                    write,
  input  wire [ADDRESS_BITS-1:0] address,
  input  wire [WIDTH-1:0]        write_data,
  output wire [WIDTH-1:0]        read_data
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

  reg [WIDTH-1:0] words [0:(1<<ADDRESS_BITS)-1];
  reg [WIDTH-1:0] read_data_q;

  always @(posedge aclk) begin
    if (enable) begin
      if (write) begin
        words[address] <= write_data;
      end else begin
        read_data_q <= words[address];
      end
    end
  end

  assign read_data = read_data_q;

endmodule

`default_nettype wire
