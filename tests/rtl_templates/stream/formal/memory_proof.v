// memory_proof: a word that is read is the one written last at its address, and stays until the next
// read. One address is watched, chosen by the solver. A read in the cycle that writes the address may
// give anything: the covers reach the old word, the new one and a third. The proofs of templates with
// such a memory inside rest on it.
`default_nettype none

module memory_proof (
  input wire       aclk,
  input wire       write,
  input wire [1:0] write_address,
  input wire [1:0] write_data,
  input wire       read,
  input wire [1:0] read_address
);

  (* anyconst *) reg [1:0] watched;

  wire [1:0] read_data;
  reg        written = 1'b0;
  reg  [1:0] stored;            // the watched word
  reg        shown    = 1'b0;   // the word that was read last is the watched one
  reg        collided = 1'b0;   // as it was written
  reg  [1:0] old_word;
  reg  [1:0] new_word;

  dual_port_memory #(
    .WIDTH       (2),
    .ADDRESS_BITS(2)
  ) dut (
    .aclk         (aclk),
    .write_enable (write),
    .write_address(write_address),
    .write_data   (write_data),
    .read_enable  (read),
    .read_address (read_address),
    .read_data    (read_data)
  );

  always @(posedge aclk) begin
    if (write && (write_address == watched)) begin
      written <= 1'b1;
      stored  <= write_data;
    end
    if (read) begin
      shown    <= written && (read_address == watched);
      collided <= write && (write_address == watched);
      old_word <= stored;
      new_word <= write_data;
    end
  end

  wire unpromised = shown && collided && (old_word != new_word);

  always @* begin
    right_word: assert(!shown || collided || (read_data == old_word));
    can_show: cover(shown && !collided && (read_data == 2'd2) && (watched == 2'd3));
    can_give_the_old_word: cover(unpromised && (read_data == old_word));
    can_give_the_new_word: cover(unpromised && (read_data == new_word));
    can_give_a_third_word: cover(unpromised && (read_data != old_word) && (read_data != new_word));
  end

endmodule

`default_nettype wire
