// memory_proof: a word that is read is the one written last at its address, and stays until the
// next read. The solver chooses one address, which is watched. Two reads may give any word: one in
// the cycle that writes its address, and one of an address that was never written. The covers reach
// such words. The proofs of templates with a memory inside rest on these facts.
`default_nettype none

module memory_proof #(
  parameter KIND = 0  // 0: dual_port_memory, 1: beat_memory in block memory, 2: port j of item_memory
) (
  input wire       aclk,
  input wire       write,
  input wire [1:0] write_address,
  input wire [1:0] write_data,
  input wire       read,
  input wire [1:0] read_address
);

  (* anyconst *) reg [1:0] watched;

  wire [1:0] read_data;
  reg        written  = 1'b0;
  reg  [1:0] stored;           // the watched word
  reg        shown    = 1'b0;  // the watched word was read last
  reg        known;            // its address had been written before
  reg        collided;         // its address was written in the same cycle
  reg  [1:0] old_word;
  reg  [1:0] new_word;
  wire       unpromised = shown && known && collided && (old_word != new_word);

  generate
    if (KIND == 0) begin : g_dual_port_memory
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
    end else if (KIND == 1) begin : g_beat_memory
      beat_memory #(
        .WIDTH       (2),
        .BEAT_BITS   (0),
        .ADDRESS_BITS(2),
        .BLOCK       (1)
      ) dut (
        .aclk         (aclk),
        .write_enable (write),
        .write_address(write_address),
        .write_data   (write_data),
        .read_enable  (read),
        .read_address (read_address),
        .read_data    (read_data)
      );
    end else begin : g_item_memory
      item_memory #(
        .WIDTH       (2),
        .ADDRESS_BITS(2)
      ) dut (
        .aclk        (aclk),
        .i_enable    (write),
        .i_write     (1'b1),
        .i_address   (write_address),
        .i_write_data(write_data),
        .i_read_data (),
        .j_enable    (read),
        .j_address   (read_address),
        .j_read_data (read_data)
      );
    end
  endgenerate

  always @(posedge aclk) begin
    if (write && (write_address == watched)) begin
      written <= 1'b1;
      stored  <= write_data;
    end
    if (read) begin
      shown    <= (read_address == watched);
      known    <= written;
      collided <= write && (write_address == watched);
      old_word <= stored;
      new_word <= write_data;
    end
  end

  always @* begin
    right_word: assert(!shown || !known || collided || (read_data == old_word));
    can_show: cover(shown && known && !collided && (read_data == 2'd2) && (watched == 2'd3));
    can_begin_with_zeros: cover(shown && !known && !collided && (read_data == 2'd0));
    can_begin_with_ones: cover(shown && !known && !collided && (read_data == 2'd3));
    can_give_the_old_word: cover(unpromised && (read_data == old_word));
    can_give_the_new_word: cover(unpromised && (read_data == new_word));
    can_give_a_third_word: cover(unpromised && (read_data != old_word) && (read_data != new_word));
  end

endmodule

`default_nettype wire
