// slot_pool: hands out 2^SLOT_BITS slots, each to one comparison at a time.
// A slot is taken in a cycle with m_slot_valid and m_slot_ready, and returned with s_free. After
// reset each slot is given out once, in turn. Then slots are given out in the order of their
// return. A returned slot may be taken two cycles later. One slot per cycle each way.
`default_nettype none

module slot_pool #(
  parameter SLOT_BITS = 5  // 1 to 30: 2^SLOT_BITS comparisons may be in flight
) (
  input  wire                 aclk,
  input  wire                 aresetn,
  output wire                 m_slot_valid,
  input  wire                 m_slot_ready,
  output wire [SLOT_BITS-1:0] m_slot,
  input  wire                 s_free_valid,
  input  wire [SLOT_BITS-1:0] s_free_slot
);

  localparam [SLOT_BITS:0] ONE = 1;
  localparam [SLOT_BITS:0] ALL = {1'b1, {SLOT_BITS{1'b0}}};

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (SLOT_BITS < 1) begin : g_refused_slot_bits SLOT_BITS_is_below_1 refused (); end
  endgenerate

  // A queue that reset leaves full: place k stands for slot k until a returned slot is written
  // there. It has a place for each slot, so it never overflows.
  reg  [SLOT_BITS:0]   write_q;
  reg  [SLOT_BITS:0]   read_q;
  reg                  valid_q;
  reg  [SLOT_BITS-1:0] place_q;      // the place read last
  reg                  first_lap_q;  // place_q was read before it was written
  wire [SLOT_BITS-1:0] returned;
  wire                 read = (read_q != write_q) && (!valid_q || m_slot_ready);

  always @(posedge aclk) begin
    if (!aresetn) begin
      write_q     <= ALL;
      read_q      <= ONE;
      valid_q     <= 1'b1;
      place_q     <= {SLOT_BITS{1'b0}};
      first_lap_q <= 1'b1;
    end else begin
      if (s_free_valid) begin
        write_q <= write_q + ONE;
      end
      if (read) begin
        read_q      <= read_q + ONE;
        place_q     <= read_q[SLOT_BITS-1:0];
        first_lap_q <= first_lap_q && !read_q[SLOT_BITS];
      end
      valid_q <= read || (valid_q && !m_slot_ready);
    end
  end

  dual_port_memory #(
    .WIDTH       (SLOT_BITS),
    .ADDRESS_BITS(SLOT_BITS)
  ) places (
    .aclk         (aclk),
    .write_enable (s_free_valid),
    .write_address(write_q[SLOT_BITS-1:0]),
    .write_data   (s_free_slot),
    .read_enable  (read),
    .read_address (read_q[SLOT_BITS-1:0]),
    .read_data    (returned)
  );

  assign m_slot_valid = valid_q;
  assign m_slot       = first_lap_q ? place_q : returned;

endmodule

`default_nettype wire
