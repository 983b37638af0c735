// carried_operands: the operands of the comparisons inside a lane; those of the undecided leave.
// A slot that is named on `undecided` leaves on m_request as a packet of 2^BEAT_BITS beats {slot,
// part of the operands}, the lowest part first, zeros above the operands. First come first served,
// latency 3, a beat in every second cycle at most: the request register loads only when empty, so
// that no path leads on from m_request_tready in the same cycle. All slots may wait: `undecided` is
// never refused. BLOCK as in beat_memory. Reset forgets what waits.
`default_nettype none

module carried_operands #(
  parameter OPERAND_BITS = 128,
  parameter SLOT_BITS = 5,
  parameter BEAT_BITS = 0,
  parameter BLOCK = 0
) (
  input  wire                                             aclk,
  input  wire                                             aresetn,
  input  wire                                             start_valid,
  input  wire [SLOT_BITS-1:0]                             start_slot,
  input  wire [OPERAND_BITS-1:0]                          start_operands,
  input  wire                                             undecided_valid,
  input  wire [SLOT_BITS-1:0]                             undecided_slot,
  output wire                                             m_request_tvalid,
  input  wire                                             m_request_tready,
  output wire [SLOT_BITS+((OPERAND_BITS-1)>>BEAT_BITS):0] m_request_tdata,
  output wire                                             m_request_tlast
);

  localparam PART_BITS  = ((OPERAND_BITS - 1) >> BEAT_BITS) + 1;
  localparam WHOLE_BITS = PART_BITS << BEAT_BITS;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (OPERAND_BITS < 1) begin : g_refused_operand_bits
      OPERAND_BITS_is_below_1 refused ();
    end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits
      SLOT_BITS_is_below_1 refused ();
    end
    if ((BEAT_BITS < 0) || (BEAT_BITS > 8)) begin : g_refused_beat_bits
      BEAT_BITS_is_not_0_to_8 refused ();
    end
  endgenerate

  wire                           waiting_valid;
  wire [SLOT_BITS-1:0]           waiting_slot;
  wire                           unused_ready;
  reg                            request_valid_q;
  reg  [SLOT_BITS-1:0]           request_slot_q;
  reg                            request_last_q;
  wire [PART_BITS-1:0]           request_part;
  wire                           load = waiting_valid && !request_valid_q;
  wire [SLOT_BITS+BEAT_BITS-1:0] beat_address;  // of the beat that is read next
  wire                           last_beat;
  wire [WHOLE_BITS-1:0]          whole_operands;

  stream_fifo #(
    .WIDTH     (SLOT_BITS),
    .DEPTH_BITS(SLOT_BITS)
  ) waiting_slots (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(undecided_valid),
    .s_axis_tready(unused_ready),
    .s_axis_tdata (undecided_slot),
    .m_axis_tvalid(waiting_valid),
    .m_axis_tready(!request_valid_q && last_beat),
    .m_axis_tdata (waiting_slot)
  );

  assign whole_operands[OPERAND_BITS-1:0] = start_operands;

  generate
    if (BEAT_BITS == 0) begin : g_one_beat
      assign beat_address = waiting_slot;
      assign last_beat    = 1'b1;
    end else begin : g_beats
      localparam [BEAT_BITS-1:0] ONE = 1;

      reg [BEAT_BITS-1:0] beat_q;

      always @(posedge aclk) begin
        if (!aresetn) begin
          beat_q <= {BEAT_BITS{1'b0}};
        end else if (load) begin
          beat_q <= beat_q + ONE;
        end
      end

      assign beat_address = {waiting_slot, beat_q};
      assign last_beat    = &beat_q;
    end
    if (WHOLE_BITS > OPERAND_BITS) begin : g_padding
      assign whole_operands[WHOLE_BITS-1:OPERAND_BITS] = {(WHOLE_BITS-OPERAND_BITS){1'b0}};
    end
  endgenerate

  beat_memory #(
    .WIDTH       (PART_BITS),
    .BEAT_BITS   (BEAT_BITS),
    .ADDRESS_BITS(SLOT_BITS),
    .BLOCK       (BLOCK)
  ) memory (
    .aclk         (aclk),
    .write_enable (start_valid),
    .write_address(start_slot),
    .write_data   (whole_operands),
    .read_enable  (load),
    .read_address (beat_address),
    .read_data    (request_part)
  );

  always @(posedge aclk) begin
    if (!aresetn) begin
      request_valid_q <= 1'b0;
    end else begin
      request_valid_q <= load || (request_valid_q && !m_request_tready);
    end
  end

  always @(posedge aclk) begin
    if (load) begin
      request_slot_q <= waiting_slot;
      request_last_q <= last_beat;
    end
  end

  assign m_request_tvalid = request_valid_q;
  assign m_request_tdata  = {request_slot_q, request_part};
  assign m_request_tlast  = request_last_q;

endmodule

`default_nettype wire
