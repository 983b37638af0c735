// reference_port: surrounds one free-running reference; requests in, answers out, in order.
// requested_operands supplies the operands.
//
// INITIATION_INTERVAL = 1: operands are taken at once, and the answer leaves REFERENCE_LATENCY
// cycles later. Above 1: reference_phase counts the cycles of the interval, from reset_phase on. A
// comparison starts in phase 0 if its operands are there. They are taken in phase
// LAST_OPERAND_PHASE, and the answer leaves REFERENCE_LATENCY cycles after the start. Reset forgets
// all requests: the unit that answers m_refetch must be reset with it.
`default_nettype none

module reference_port #(
  parameter OPERAND_BITS = 128,       // bits of a comparison's operands, 1 or more
  parameter TAG_BITS = 32,            // bits of a tag (m_refetch_tdata), 1 or more
  parameter LANE_BITS = 3,            // bits of a lane's number, 1 or more
  parameter SLOT_BITS = 5,            // bits of a slot, 1 or more
  parameter REFERENCE_LATENCY = 32,   // latency in cycles, 0 or more; 1 or more if folded
  parameter INITIATION_INTERVAL = 1,  // cycles from a start to the next, 1 or more; above 1: folded
  parameter LAST_OPERAND_PHASE = 0,   // phase in which operands leave, below INITIATION_INTERVAL
  parameter PHASE_BITS = 1,           // bits of a phase, 1 to 30; they hold INITIATION_INTERVAL - 1
  parameter CARRIED = 1,              // 1: a request carries the operands; 0: the tag
  parameter BEAT_BITS = 0,            // 0 to 8: a packet has 2^BEAT_BITS beats
  parameter OUTSTANDING_BITS = 4      // 1 to 30: 2^OUTSTANDING_BITS + 1 tags may wait for operands
) (
  input  wire                                                                                   aclk,
  input  wire                                                                                   aresetn,
  input  wire                                                                                   s_request_tvalid,
  output wire                                                                                   s_request_tready,
  input  wire [LANE_BITS+SLOT_BITS+(CARRIED != 0 ? (OPERAND_BITS-1)>>BEAT_BITS : TAG_BITS-1):0] s_request_tdata,
  input  wire [PHASE_BITS-1:0]                                                                  reset_phase,  // a constant below INITIATION_INTERVAL
  output wire [PHASE_BITS-1:0]                                                                  reference_phase,
  output wire [OPERAND_BITS-1:0]                                                                reference_operands,
  input  wire [1:0]                                                                             reference_verdict,
  output wire                                                                                   m_answer_valid,
  output wire [LANE_BITS+SLOT_BITS+2-1:0]                                                       m_answer_tdata,
  output wire                                                                                   m_refetch_tvalid,
  input  wire                                                                                   m_refetch_tready,
  output wire [TAG_BITS-1:0]                                                                    m_refetch_tdata,
  input  wire                                                                                   s_refetch_tvalid,
  output wire                                                                                   s_refetch_tready,
  input  wire [OPERAND_BITS-1:0]                                                                s_refetch_tdata
);

  localparam PART_BITS    = ((OPERAND_BITS - 1) >> BEAT_BITS) + 1;
  localparam PAYLOAD_BITS = (CARRIED != 0) ? PART_BITS : TAG_BITS;
  localparam SENDER_BITS  = LANE_BITS + SLOT_BITS;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (OPERAND_BITS < 1) begin : g_refused_operand_bits OPERAND_BITS_is_below_1 refused (); end
    if (TAG_BITS < 1) begin : g_refused_tag_bits TAG_BITS_is_below_1 refused (); end
    if (LANE_BITS < 1) begin : g_refused_lane_bits LANE_BITS_is_below_1 refused (); end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits SLOT_BITS_is_below_1 refused (); end
    if (REFERENCE_LATENCY < 0)
      begin : g_refused_reference_latency REFERENCE_LATENCY_is_below_0 refused (); end
    if (INITIATION_INTERVAL < 1) begin : g_refused_initiation_interval
      INITIATION_INTERVAL_is_below_1 refused ();
    end else if ((LAST_OPERAND_PHASE < 0) || (LAST_OPERAND_PHASE >= INITIATION_INTERVAL))
    begin : g_refused_last_operand_phase
      LAST_OPERAND_PHASE_is_outside_INITIATION_INTERVAL refused ();
    end
    if ((INITIATION_INTERVAL > 1) && (REFERENCE_LATENCY < 1)) begin : g_refused_folded_latency
      REFERENCE_LATENCY_is_0_with_INITIATION_INTERVAL_above_1 refused ();
    end
    if ((PHASE_BITS < 1) || (PHASE_BITS > 30)) begin : g_refused_phase_bits
      PHASE_BITS_is_not_1_to_30 refused ();
    end else if (((INITIATION_INTERVAL - 1) >>> PHASE_BITS) > 0) begin : g_refused_last_phase
      PHASE_BITS_is_too_small_for_INITIATION_INTERVAL refused ();
    end
    if ((BEAT_BITS < 0) || (BEAT_BITS > 8))
      begin : g_refused_beat_bits BEAT_BITS_is_not_0_to_8 refused (); end
    if (OUTSTANDING_BITS < 1)
      begin : g_refused_outstanding_bits OUTSTANDING_BITS_is_below_1 refused (); end
  endgenerate

  // Operands that wait at the datapath, and their sender. `take`: they may leave at the end of the
  // cycle.
  wire                   offer_valid;
  wire [SENDER_BITS-1:0] offer_sender;
  wire                   take;
  wire [SENDER_BITS-1:0] answer_sender;

  requested_operands #(
    .OPERAND_BITS    (OPERAND_BITS),
    .TAG_BITS        (TAG_BITS),
    .SENDER_BITS     (SENDER_BITS),
    .CARRIED         (CARRIED),
    .BEAT_BITS       (BEAT_BITS),
    .OUTSTANDING_BITS(OUTSTANDING_BITS)
  ) requests (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .s_request_tvalid(s_request_tvalid),
    .s_request_tready(s_request_tready),
    .s_request_tdata (s_request_tdata[PAYLOAD_BITS-1:0]),
    .s_request_tuser (s_request_tdata[PAYLOAD_BITS +: SENDER_BITS]),
    .m_refetch_tvalid(m_refetch_tvalid),
    .m_refetch_tready(m_refetch_tready),
    .m_refetch_tdata (m_refetch_tdata),
    .s_refetch_tvalid(s_refetch_tvalid),
    .s_refetch_tready(s_refetch_tready),
    .s_refetch_tdata (s_refetch_tdata),
    .m_axis_tvalid   (offer_valid),
    .m_axis_tready   (take),
    .m_axis_tdata    (reference_operands),
    .m_axis_tuser    (offer_sender)
  );

  generate
    if (INITIATION_INTERVAL <= 1) begin : g_every_cycle
      wire unused_reset_phase = &reset_phase;

      assign take            = 1'b1;
      assign reference_phase = {PHASE_BITS{1'b0}};

      valid_delay_line #(
        .LENGTH(REFERENCE_LATENCY)
      ) valid_beside_reference (
        .aclk   (aclk),
        .aresetn(aresetn),
        .d      (offer_valid),
        .q      (m_answer_valid)
      );

      delay_line #(
        .WIDTH (SENDER_BITS),
        .LENGTH(REFERENCE_LATENCY)
      ) sender_beside_reference (
        .aclk(aclk),
        .d   (offer_sender),
        .q   (answer_sender)
      );
    end else begin : g_folded
      localparam LAST_PHASE   = INITIATION_INTERVAL - 1;
      localparam ANSWER_PHASE = REFERENCE_LATENCY % INITIATION_INTERVAL;
      // The number of comparisons that may be inside. Each moves on by one place when the next may
      // start.
      localparam PLACES       = (REFERENCE_LATENCY + INITIATION_INTERVAL - 1) / INITIATION_INTERVAL;

      localparam [PHASE_BITS-1:0] FIRST = 0;
      localparam [PHASE_BITS-1:0] ONE   = 1;

      reg  [PHASE_BITS-1:0]             phase_q;
      reg  [PLACES-1:0]                 valid_q;
      reg  [PLACES*SENDER_BITS-1:0]     sender_q;
      wire                              start        = (phase_q == FIRST);
      wire                              started      =
          (LAST_OPERAND_PHASE == 0) ? offer_valid : valid_q[0];
      wire [PLACES:0]                   valid_moved  = {valid_q, offer_valid};
      wire [(PLACES+1)*SENDER_BITS-1:0] sender_moved = {sender_q, offer_sender};

      assign take = (phase_q == LAST_OPERAND_PHASE[PHASE_BITS-1:0]) && started;

      always @(posedge aclk) begin
        if (!aresetn) begin
          phase_q <= reset_phase;
        end else if (phase_q == LAST_PHASE[PHASE_BITS-1:0]) begin
          phase_q <= FIRST;
        end else begin
          phase_q <= phase_q + ONE;
        end
      end

      always @(posedge aclk) begin
        if (!aresetn) begin
          valid_q <= {PLACES{1'b0}};
        end else if (start) begin
          valid_q <= valid_moved[PLACES-1:0];
        end
      end

      always @(posedge aclk) begin
        if (start) begin
          sender_q <= sender_moved[PLACES*SENDER_BITS-1:0];
        end
      end

      wire unused_moved = &{valid_moved[PLACES], sender_moved[PLACES*SENDER_BITS +: SENDER_BITS]};

      assign reference_phase = phase_q;
      assign m_answer_valid  = valid_q[PLACES-1] && (phase_q == ANSWER_PHASE[PHASE_BITS-1:0]);
      assign answer_sender   = sender_q[(PLACES-1)*SENDER_BITS +: SENDER_BITS];
    end
  endgenerate

  assign m_answer_tdata = {answer_sender, reference_verdict};

endmodule

`default_nettype wire
