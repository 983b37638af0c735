// lane_tracker: knows which slot's verdict leaves a free-running lane, and sends the undecided out.
// A comparison enters with `start`; LANE_LATENCY + 1 cycles later `exit` says what became of it.
// With RECOMPUTE = 1 the undecided also leave on m_request as {slot, payload}, at most every second
// cycle: the request register loads only when empty, so that no path leads on from m_request_tready
// in the same cycle. At most 2^SLOT_BITS comparisons may be on the way: then nothing here can
// overflow. Reset forgets all.
`default_nettype none

module lane_tracker #(
  parameter PAYLOAD_BITS = 128,
  parameter SLOT_BITS = 5,
  parameter LANE_LATENCY = 16,
  parameter RECOMPUTE = 1
) (
  input  wire                              aclk,
  input  wire                              aresetn,
  input  wire                              start_valid,
  input  wire [SLOT_BITS-1:0]              start_slot,
  input  wire [PAYLOAD_BITS-1:0]           start_payload,
  input  wire [1:0]                        lane_verdict,
  input  wire                              lane_decided,
  output wire                              exit_valid,
  output wire [SLOT_BITS-1:0]              exit_slot,
  output wire [1:0]                        exit_verdict,
  output wire                              exit_decided,
  output wire                              m_request_tvalid,
  input  wire                              m_request_tready,
  output wire [SLOT_BITS+PAYLOAD_BITS-1:0] m_request_tdata
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (PAYLOAD_BITS < 1) begin : g_refused_payload_bits
      PAYLOAD_BITS_is_below_1 refused ();
    end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits
      SLOT_BITS_is_below_1 refused ();
    end
    if (LANE_LATENCY < 0) begin : g_refused_lane_latency
      LANE_LATENCY_is_below_0 refused ();
    end
  endgenerate

  wire                 lane_valid;
  wire [SLOT_BITS-1:0] lane_slot;

  valid_delay_line #(
    .LENGTH(LANE_LATENCY)
  ) valid_beside_lane (
    .aclk   (aclk),
    .aresetn(aresetn),
    .d      (start_valid),
    .q      (lane_valid)
  );

  delay_line #(
    .WIDTH (SLOT_BITS),
    .LENGTH(LANE_LATENCY)
  ) slot_beside_lane (
    .aclk(aclk),
    .d   (start_slot),
    .q   (lane_slot)
  );

  reg                 exit_valid_q;
  reg [SLOT_BITS-1:0] exit_slot_q;
  reg [1:0]           exit_verdict_q;
  reg                 exit_decided_q;

  always @(posedge aclk) begin
    if (!aresetn) begin
      exit_valid_q <= 1'b0;
    end else begin
      exit_valid_q <= lane_valid;
    end
  end

  always @(posedge aclk) begin
    exit_slot_q    <= lane_slot;
    exit_verdict_q <= lane_verdict;
    exit_decided_q <= lane_decided;
  end

  generate
    if (RECOMPUTE == 0) begin : g_no_requests
      wire unused_inputs = &{start_payload, m_request_tready};

      assign m_request_tvalid = 1'b0;
      assign m_request_tdata  = {(SLOT_BITS+PAYLOAD_BITS){1'b0}};
    end else begin : g_requests
      wire                    waiting_valid;
      wire                    waiting_ready;
      wire [SLOT_BITS-1:0]    waiting_slot;
      wire                    unused_ready;
      wire [PAYLOAD_BITS-1:0] request_payload;
      wire                    load = waiting_valid && waiting_ready;

      reg                     request_valid_q;
      reg  [SLOT_BITS-1:0]    request_slot_q;

      stream_fifo #(
        .WIDTH     (SLOT_BITS),
        .DEPTH_BITS(SLOT_BITS)
      ) waiting_slots (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(exit_valid_q && !exit_decided_q),
        .s_axis_tready(unused_ready),
        .s_axis_tdata (exit_slot_q),
        .m_axis_tvalid(waiting_valid),
        .m_axis_tready(waiting_ready),
        .m_axis_tdata (waiting_slot)
      );

      dual_port_memory #(
        .WIDTH       (PAYLOAD_BITS),
        .ADDRESS_BITS(SLOT_BITS)
      ) payloads (
        .aclk         (aclk),
        .write_enable (start_valid),
        .write_address(start_slot),
        .write_data   (start_payload),
        .read_enable  (load),
        .read_address (waiting_slot),
        .read_data    (request_payload)
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

      assign waiting_ready    = !request_valid_q;
      assign m_request_tvalid = request_valid_q;
      assign m_request_tdata  = {request_slot_q, request_payload};
    end
  endgenerate

  assign exit_valid   = exit_valid_q;
  assign exit_slot    = exit_slot_q;
  assign exit_verdict = exit_verdict_q;
  assign exit_decided = exit_decided_q;

endmodule

`default_nettype wire
