// beat_memory: words of several beats, written whole and read beat by beat, the lowest bits first.
// A beat's address is {the word's address, the beat's number}. Latency 1. No reset. A read of the
// word that is written in the same cycle returns nothing, as in dual_port_memory.
`default_nettype none

module beat_memory #(
  parameter WIDTH = 8,         // bits of a beat, 1 or more
  parameter BEAT_BITS = 2,     // 0 to 8: a word has 2^BEAT_BITS beats
  parameter ADDRESS_BITS = 4,  // 1 to 20: the memory has 2^ADDRESS_BITS words
  // 1: block memory whose write port is wider than its read port, so no multiplexer is needed. The
  // tools must support memories with ports of two widths. 0: a word is read whole, from any memory
  // that synthesis chooses, and a multiplexer selects the beat.
  parameter BLOCK = 0
) (
  input  wire                              aclk,
  input  wire                              write_enable,
  input  wire [ADDRESS_BITS-1:0]           write_address,
  input  wire [(WIDTH<<BEAT_BITS)-1:0]     write_data,
  input  wire                              read_enable,
  input  wire [ADDRESS_BITS+BEAT_BITS-1:0] read_address,
  output wire [WIDTH-1:0]                  read_data
);

  localparam BEATS = 1 << BEAT_BITS;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if ((BEAT_BITS < 0) || (BEAT_BITS > 8))
      begin : g_refused_beat_bits BEAT_BITS_is_not_0_to_8 refused (); end
    if (ADDRESS_BITS < 1) begin : g_refused_address_bits ADDRESS_BITS_is_below_1 refused (); end
    if (ADDRESS_BITS > 20) begin : g_refused_address_shift ADDRESS_BITS_is_above_20 refused (); end
  endgenerate

  wire [ADDRESS_BITS-1:0] read_word = read_address[ADDRESS_BITS+BEAT_BITS-1:BEAT_BITS];

  genvar b;
  generate
    if (BLOCK != 0) begin : g_block
      (* no_rw_check, ram_style = "block", rw_addr_collision = "no" *)
      reg [WIDTH-1:0] words [0:(1<<(ADDRESS_BITS+BEAT_BITS))-1];
      reg [WIDTH-1:0] read_data_q;

      for (b = 0; b < BEATS; b = b + 1) begin : g_beat
        wire [ADDRESS_BITS+BEAT_BITS-1:0] place;

        assign place[ADDRESS_BITS+BEAT_BITS-1:BEAT_BITS] = write_address;
        if (BEAT_BITS > 0) begin : g_number
          assign place[BEAT_BITS-1:0] = b;
        end

        always @(posedge aclk) begin
          if (write_enable) begin
            words[place] <= write_data[b*WIDTH +: WIDTH];
          end
        end
      end

      always @(posedge aclk) begin
        if (read_enable) begin
          read_data_q <= words[read_address];
`ifndef SYNTHESIS
          if (write_enable && (write_address == read_word)) begin
            read_data_q <= {WIDTH{1'bx}};
          end
`endif
        end
      end

      assign read_data = read_data_q;
    end else begin : g_word
      wire [(WIDTH<<BEAT_BITS)-1:0] word;

      dual_port_memory #(
        .WIDTH       (WIDTH << BEAT_BITS),
        .ADDRESS_BITS(ADDRESS_BITS)
      ) memory (
        .aclk         (aclk),
        .write_enable (write_enable),
        .write_address(write_address),
        .write_data   (write_data),
        .read_enable  (read_enable),
        .read_address (read_word),
        .read_data    (word)
      );

      if (BEAT_BITS == 0) begin : g_one_beat
        assign read_data = word;
      end else begin : g_multiplexer
        reg [BEAT_BITS-1:0] beat_q;

        always @(posedge aclk) begin
          if (read_enable) begin
            beat_q <= read_address[BEAT_BITS-1:0];
          end
        end

        // Each bit of the number halves the list of beats.
        reg [(WIDTH<<BEAT_BITS)-1:0] left;
        integer                      number_bit;
        integer                      w;

        always @* begin
          left = word;
          for (number_bit = 0; number_bit < BEAT_BITS; number_bit = number_bit + 1) begin
            for (w = 0; w < (BEATS >> (number_bit + 1)); w = w + 1) begin
              left[w*WIDTH +: WIDTH] = beat_q[number_bit] ? left[(2*w+1)*WIDTH +: WIDTH]
                                                          : left[2*w*WIDTH +: WIDTH];
            end
          end
        end

        assign read_data = left[WIDTH-1:0];
      end
    end
  endgenerate

endmodule

`default_nettype wire
