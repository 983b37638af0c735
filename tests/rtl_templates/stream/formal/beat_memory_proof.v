// beat_memory_proof: a beat that is read is that of the word written last at its address, and it
// stays until the next read. One address is watched, chosen by the solver. No word is read in the
// cycle that writes it.
`default_nettype none

module beat_memory_proof #(
  parameter BEAT_BITS = 1,
  parameter BLOCK = 0
) (
  input wire                           aclk,
  input wire                           write,
  input wire [1:0]                     write_address,
  input wire [(2<<BEAT_BITS)-1:0]      write_data,
  input wire                           read,
  input wire [2+BEAT_BITS-1:0]         read_address
);

  (* anyconst *) reg [2+BEAT_BITS-1:0] watched;

  wire [1:0] word = watched[BEAT_BITS +: 2];
  wire [1:0] read_data;
  reg        written = 1'b0;
  reg  [1:0] stored;           // the watched beat
  reg        shown   = 1'b0;   // the watched beat was read last
  reg  [1:0] expected;
  wire [1:0] beat_written;

  beat_memory #(
    .WIDTH       (2),
    .BEAT_BITS   (BEAT_BITS),
    .ADDRESS_BITS(2),
    .BLOCK       (BLOCK)
  ) dut (
    .aclk         (aclk),
    .write_enable (write),
    .write_address(write_address),
    .write_data   (write_data),
    .read_enable  (read),
    .read_address (read_address),
    .read_data    (read_data)
  );

  generate
    if (BEAT_BITS == 0) begin : g_one
      assign beat_written = write_data;
    end else begin : g_several
      assign beat_written = write_data[2*watched[BEAT_BITS-1:0] +: 2];
    end
  endgenerate

  always @(posedge aclk) begin
    if (write && (write_address == word)) begin
      written <= 1'b1;
      stored  <= beat_written;
    end
    if (read) begin
      shown    <= written && (read_address == watched);
      expected <= stored;
    end
  end

  always @* begin
    assume(!read || !write || (write_address != read_address[BEAT_BITS +: 2]));
    right_beat: assert(!shown || (read_data == expected));
    can_show: cover(shown && (read_data == 2'd2) && (&watched));
    can_stay: cover(shown && !read && write && (write_address == word));
  end

endmodule

`default_nettype wire
