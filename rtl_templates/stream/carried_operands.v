// carried_operands: the operands of the comparisons inside a lane; those of the undecided leave.
// A slot that is named on `undecided` leaves on m_request as {slot, operands}, first come first
// served, latency 3, in every second cycle at most: the request register loads only when empty, so
// that no path leads on from m_request_tready in the same cycle. All slots may wait: `undecided` is
// never refused. Reset forgets what waits.
`default_nettype none

module carried_operands #(
  parameter OPERAND_BITS = 128,
  parameter SLOT_BITS = 5
) (
  input  wire                              aclk,
  input  wire                              aresetn,
  input  wire                              start_valid,
  input  wire [SLOT_BITS-1:0]              start_slot,
  input  wire [OPERAND_BITS-1:0]           start_operands,
  input  wire                              undecided_valid,
  input  wire [SLOT_BITS-1:0]              undecided_slot,
  output wire                              m_request_tvalid,
  input  wire                              m_request_tready,
  output wire [SLOT_BITS+OPERAND_BITS-1:0] m_request_tdata
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (OPERAND_BITS < 1) begin : g_refused_operand_bits
      OPERAND_BITS_is_below_1 refused ();
    end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits
      SLOT_BITS_is_below_1 refused ();
    end
  endgenerate

  wire                    waiting_valid;
  wire [SLOT_BITS-1:0]    waiting_slot;
  wire                    unused_ready;
  reg                     request_valid_q;
  reg  [SLOT_BITS-1:0]    request_slot_q;
  wire [OPERAND_BITS-1:0] request_operands;
  wire                    load = waiting_valid && !request_valid_q;

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
    .m_axis_tready(!request_valid_q),
    .m_axis_tdata (waiting_slot)
  );

  dual_port_memory #(
    .WIDTH       (OPERAND_BITS),
    .ADDRESS_BITS(SLOT_BITS)
  ) memory (
    .aclk         (aclk),
    .write_enable (start_valid),
    .write_address(start_slot),
    .write_data   (start_operands),
    .read_enable  (load),
    .read_address (waiting_slot),
    .read_data    (request_operands)
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
    end
  end

  assign m_request_tvalid = request_valid_q;
  assign m_request_tdata  = {request_slot_q, request_operands};

endmodule

`default_nettype wire
