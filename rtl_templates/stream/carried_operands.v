// carried_operands: stores the operands of every comparison inside a lane or a group of lanes, and
// sends those of undecided comparisons as requests.
//
// For each lane that `undecided` marks in a slot, a packet of beats {slot, part of the operands}
// leaves on m_request. The lowest lane and the lowest part come first, and zeros are above the
// operands. First come, first served. Latency 3 (with LANES > 1: 4). At most one beat leaves in two
// cycles: the request register loads only when empty, so no path leads on from m_request_tready in
// the same cycle. All slots may wait: `undecided` is never refused. Reset forgets waiting requests.
`default_nettype none

module carried_operands #(
  parameter LANES = 1,           // lanes in lock step, 1 to 64
  parameter OPERAND_BITS = 128,  // bits of a comparison's operands, 1 or more
  parameter SLOT_BITS = 5,       // 1 to 20: 2^SLOT_BITS comparisons may be in flight
  // 0 to 8: a packet has 2^BEAT_BITS beats; LANES << BEAT_BITS is at most 256
  parameter BEAT_BITS = 0,
  parameter BLOCK = 0            // 0 or 1: the kind of memory, as in beat_memory
) (
  input  wire                                             aclk,
  input  wire                                             aresetn,
  input  wire                                             start_valid,
  input  wire [SLOT_BITS-1:0]                             start_slot,
  input  wire [LANES*OPERAND_BITS-1:0]                    start_operands,
  input  wire                                             undecided_valid,
  input  wire [SLOT_BITS-1:0]                             undecided_slot,
  input  wire [LANES-1:0]                                 undecided_lanes,
  output wire                                             m_request_tvalid,
  input  wire                                             m_request_tready,
  output wire [SLOT_BITS+((OPERAND_BITS-1)>>BEAT_BITS):0] m_request_tdata,
  output wire                                             m_request_tlast
);

  localparam PART_BITS  = ((OPERAND_BITS - 1) >> BEAT_BITS) + 1;
  localparam LANE_BITS  = (LANES > 32) ? 6 : (LANES > 16) ? 5 : (LANES > 8) ? 4 : (LANES > 4) ? 3
                        : (LANES > 2)  ? 2 : (LANES > 1)  ? 1 : 0;
  localparam PLACE_BITS = LANE_BITS + BEAT_BITS;     // names a beat of a slot: {lane, beat}
  localparam MARKS      = (LANES == 1) ? 0 : LANES;  // a slot of one lane needs no mark

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((LANES < 1) || (LANES > 64)) begin : g_refused_lanes LANES_is_not_1_to_64 refused (); end
    if (OPERAND_BITS < 1) begin : g_refused_operand_bits OPERAND_BITS_is_below_1 refused (); end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits SLOT_BITS_is_below_1 refused (); end
    if ((BEAT_BITS < 0) || (BEAT_BITS > 8))
      begin : g_refused_beat_bits BEAT_BITS_is_not_0_to_8 refused (); end
  endgenerate

  wire                              waiting_valid;
  wire                              waiting_ready;
  wire [MARKS+SLOT_BITS-1:0]        waiting;  // {the marks of its lanes, a slot}
  wire [SLOT_BITS-1:0]              waiting_slot = waiting[SLOT_BITS-1:0];
  wire                              unused_ready;
  wire [MARKS+SLOT_BITS-1:0]        undecided;
  wire [LANES-1:0]                  waiting_lanes;
  wire                              lane_valid;
  wire [5:0]                        lane;
  reg                               request_valid_q;
  reg  [SLOT_BITS-1:0]              request_slot_q;
  reg                               request_last_q;
  wire [PART_BITS-1:0]              request_part;
  wire                              load = lane_valid && !request_valid_q;
  wire [SLOT_BITS+PLACE_BITS-1:0]   beat_address;  // the address of the beat that is read next
  wire                              last_beat;
  wire [(PART_BITS<<PLACE_BITS)-1:0] whole_operands;

  stream_fifo #(
    .WIDTH     (MARKS + SLOT_BITS),
    .DEPTH_BITS(SLOT_BITS)
  ) waiting_slots (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(undecided_valid),
    .s_axis_tready(unused_ready),
    .s_axis_tdata (undecided),
    .m_axis_tvalid(waiting_valid),
    .m_axis_tready(waiting_ready),
    .m_axis_tdata (waiting)
  );

  marked_lanes #(
    .LANES(LANES)
  ) undecided_by_lane (
    .aclk        (aclk),
    .aresetn     (aresetn),
    .s_word_valid(waiting_valid),
    .s_word_ready(waiting_ready),
    .s_word_lanes(waiting_lanes),
    .m_lane_valid(lane_valid),
    .m_lane_ready(!request_valid_q && last_beat),
    .m_lane      (lane)
  );

  assign undecided[SLOT_BITS-1:0] = undecided_slot;

  genvar k;
  generate
    if (LANES == 1) begin : g_one_lane
      wire unused_lanes = &{undecided_lanes, lane};

      assign waiting_lanes = 1'b1;
    end else begin : g_group
      wire unused_lane = &lane;

      assign undecided[SLOT_BITS +: LANES] = undecided_lanes;
      assign waiting_lanes                 = waiting[SLOT_BITS +: LANES];
      assign beat_address[BEAT_BITS +: LANE_BITS] = lane[LANE_BITS-1:0];
    end

    assign beat_address[SLOT_BITS+PLACE_BITS-1 -: SLOT_BITS] = waiting_slot;
    if (BEAT_BITS == 0) begin : g_one_beat
      assign last_beat = 1'b1;
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

      assign beat_address[BEAT_BITS-1:0] = beat_q;
      assign last_beat                   = &beat_q;
    end

    // A lane's operands fill whole beats. The number of lanes in a slot is rounded up to a power of
    // two.
    for (k = 0; k < (1 << LANE_BITS); k = k + 1) begin : g_lane
      localparam LANE_SPAN = PART_BITS << BEAT_BITS;
      localparam USED      = (k < LANES) ? OPERAND_BITS : 0;

      if (k < LANES) begin : g_operands
        assign whole_operands[k*LANE_SPAN +: OPERAND_BITS] =
            start_operands[k*OPERAND_BITS +: OPERAND_BITS];
      end
      if (LANE_SPAN > USED) begin : g_padding
        assign whole_operands[k*LANE_SPAN+USED +: LANE_SPAN-USED] = {(LANE_SPAN-USED){1'b0}};
      end
    end
  endgenerate

  beat_memory #(
    .WIDTH       (PART_BITS),
    .BEAT_BITS   (PLACE_BITS),
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
