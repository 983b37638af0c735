// block_reader: fills the memory with the items of one set and reads them back, block by block.
// Block b holds items b * LANES to the last: the first LANES of them stay in the lanes, one each,
// and meet all that follow. A block with one item has no pair and is left out. Items are read as
// soon as they are written, so that the first block costs no time of its own; then one word a
// cycle, without a gap between blocks. Behind the last word follows one that says `close`;
// `set_closed` ends the set and lets the next one in. Items beyond CAPACITY are accepted, not kept,
// and raise `overrun`.
// Words: latency 1 from the address. Reset forgets the set.
`default_nettype none

module block_reader #(
  parameter LANES = 8,
  parameter CAPACITY = 1024,  // 2 .. 2^INDEX_BITS
  parameter INDEX_BITS = 10
) (
  input  wire                  aclk,
  input  wire                  aresetn,
  input  wire                  s_axis_tvalid,
  output wire                  s_axis_tready,
  input  wire                  s_axis_tlast,
  output wire                  write_enable,
  input  wire                  write_ready,
  output wire [INDEX_BITS-1:0] write_address,
  output wire                  read_enable,
  output wire [INDEX_BITS-1:0] read_address,
  output wire                  m_word_tvalid,
  input  wire                  m_word_tready,
  output wire                  m_word_first,
  output wire                  m_word_close,
  output wire [INDEX_BITS-1:0] m_word_index,
  input  wire                  set_closed,
  output wire                  busy,
  output wire                  overrun
);

  localparam BLOCK = (LANES < CAPACITY) ? LANES : CAPACITY;  // items from one block to the next
  localparam [INDEX_BITS:0] ONE  = 1;
  localparam [INDEX_BITS:0] STEP = BLOCK[INDEX_BITS:0];
  localparam [INDEX_BITS:0] FULL = CAPACITY[INDEX_BITS:0];

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (LANES < 1) begin : g_refused_lanes
      LANES_is_below_1 refused ();
    end
    if (CAPACITY < 2) begin : g_refused_capacity
      CAPACITY_is_below_2 refused ();
    end
    if (INDEX_BITS < 1) begin : g_refused_index_bits
      INDEX_BITS_is_below_1 refused ();
    end
    if (INDEX_BITS > 30) begin : g_refused_index_shift
      INDEX_BITS_is_above_30 refused ();
    end
    if (((CAPACITY - 1) >>> INDEX_BITS) > 0) begin : g_refused_last_item
      INDEX_BITS_is_too_small_for_CAPACITY refused ();
    end
  endgenerate

  wire restart = !aresetn || set_closed;

  // Load.
  reg  [INDEX_BITS:0] loaded_q;    // items in the memory
  reg                 complete_q;  // the set's last item has come
  reg                 overrun_q;
  wire                accept = s_axis_tvalid && s_axis_tready;
  wire                full   = (loaded_q == FULL);

  assign s_axis_tready = !complete_q && write_ready;
  assign write_enable  = accept && !full;
  assign write_address = loaded_q[INDEX_BITS-1:0];

  always @(posedge aclk) begin
    if (restart) begin
      loaded_q   <= {(INDEX_BITS+1){1'b0}};
      complete_q <= 1'b0;
      overrun_q  <= 1'b0;
    end else if (accept) begin
      if (full) begin
        overrun_q <= 1'b1;
      end else begin
        loaded_q <= loaded_q + ONE;
      end
      complete_q <= s_axis_tlast;
    end
  end

  // Read. While more items may come, the last that fits could be the set's last or not: it waits.
  reg  [INDEX_BITS:0]   next_q;       // the item to be read
  reg                   first_q;      // it starts a block
  reg  [INDEX_BITS:0]   next_base_q;  // the item that starts the next block
  reg                   walked_q;     // every block was read
  reg                   closed_q;     // and the word behind them was sent
  reg                   m_valid_q;
  reg                   m_first_q;
  reg                   m_close_q;
  reg  [INDEX_BITS-1:0] m_index_q;

  wire [INDEX_BITS:0] following = next_q + ONE;
  wire                last      = complete_q && (following == loaded_q);
  wire                known     = complete_q || (following != FULL);
  wire                available = (next_q != loaded_q) && known && !walked_q;
  wire                room      = !m_valid_q || m_word_tready;
  wire                read      = available && room;
  wire                close     = walked_q && !closed_q && room;
  wire                more      = (next_base_q + ONE < loaded_q);  // a block of two items at least

  always @(posedge aclk) begin
    if (restart) begin
      next_q      <= {(INDEX_BITS+1){1'b0}};
      first_q     <= 1'b1;
      next_base_q <= STEP;
      walked_q    <= 1'b0;
      closed_q    <= 1'b0;
    end else begin
      if (read) begin
        next_q  <= last ? next_base_q : following;
        first_q <= last;
      end
      if (read && last) begin
        next_base_q <= next_base_q + STEP;
        walked_q    <= !more;
      end
      if (close) begin
        closed_q <= 1'b1;
      end
    end
  end

  always @(posedge aclk) begin
    if (!aresetn) begin
      m_valid_q <= 1'b0;
    end else begin
      m_valid_q <= read || close || (m_valid_q && !m_word_tready);
    end
  end

  always @(posedge aclk) begin
    if (room) begin
      m_first_q <= first_q;
      m_close_q <= walked_q;
      m_index_q <= next_q[INDEX_BITS-1:0];
    end
  end

  assign read_enable   = read;
  assign read_address  = next_q[INDEX_BITS-1:0];
  assign m_word_tvalid = m_valid_q;
  assign m_word_first  = m_first_q;
  assign m_word_close  = m_close_q;
  assign m_word_index  = m_index_q;
  assign busy          = (loaded_q != {(INDEX_BITS+1){1'b0}});
  assign overrun       = overrun_q;

endmodule

`default_nettype wire
