// operands_proof: each lane of a slot that is named on `undecided` has one request that leaves
// carried_operands, first come first served and the lowest lane first. The request has all of its
// beats in their order, the slot in each, and the operands that were stored for it. Requests do
// leave: a beat in every second cycle in which they are taken, with a cycle more between the words
// of a group. One request at a time is watched, chosen by the solver, and those ahead of it are
// counted. A slot is stored, then may be undecided, and is stored again when its request has left.
`default_nettype none

module operands_proof #(
  parameter LANES = 1,  // 1 or 2
  parameter BEAT_BITS = 1,
  parameter BLOCK = 0
) (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       start,
  input wire       start_slot,
  input wire [5:0] start_operands,
  input wire       undecided,
  input wire       undecided_slot,
  input wire [1:0] undecided_lanes,
  input wire       m_ready,
  input wire       choose  // the request that is named now is watched, if no other is
);

  localparam PART_BITS = (2 >> BEAT_BITS) + 1;
  localparam [1:0] LAST = (1 << BEAT_BITS) - 1;
  localparam [2:0] NONE = 0;
  localparam [2:0] ONE  = 1;

  (* anyconst *) reg watched;  // a slot
  (* anyconst *) reg watched_lane;

  wire                 m_valid;
  wire                 m_slot;
  wire [PART_BITS-1:0] m_part;
  wire                 m_last;

  reg                  started = 1'b0;
  wire                 aresetn = started && aresetn_later;

  // With LANES = 1, `undecided` always marks the one lane of the slot.
  wire [1:0]           lanes   = (LANES == 1) ? 2'b01 : undecided_lanes;

  carried_operands #(
    .LANES       (LANES),
    .OPERAND_BITS(3),
    .SLOT_BITS   (1),
    .BEAT_BITS   (BEAT_BITS),
    .BLOCK       (BLOCK)
  ) dut (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .start_valid     (start),
    .start_slot      (start_slot),
    .start_operands  (start_operands[3*LANES-1:0]),
    .undecided_valid (undecided),
    .undecided_slot  (undecided_slot),
    .undecided_lanes (lanes[LANES-1:0]),
    .m_request_tvalid(m_valid),
    .m_request_tready(m_ready),
    .m_request_tdata ({m_slot, m_part}),
    .m_request_tlast (m_last)
  );

  reg  [1:0]           stored  = 2'd0;  // slots with operands about which nothing is decided yet
  reg  [3:0]           asking  = 4'd0;  // slots, and lanes in them, whose request has not left
  reg  [2:0]           operands;        // the watched slot's operands
  reg  [2:0]           waiting = NONE;  // requests inside
  reg  [2:0]           ahead   = NONE;  // requests ahead of the watched one
  reg                  watching = 1'b0;
  reg  [1:0]           beat    = 2'd0;  // the number of the beat that leaves next
  reg  [2:0]           quiet   = NONE;  // cycles without a beat although a request is inside
  reg                  left    = 1'b0;   // the watched request has left before
  reg                  held    = 1'b0;
  reg  [1+PART_BITS:0] held_beat;

  wire                 leave   = m_valid && m_ready;
  wire                 ends    = leave && (beat == LAST);
  wire                 chosen  = undecided && (undecided_slot == watched) &&
                                 lanes[watched_lane] && choose && !watching;
  wire [1:0]           one     = 2'd1;
  wire [1:0]           starts  = start ? (one << start_slot) : 2'd0;
  wire [1:0]           named   = undecided ? (one << undecided_slot) : 2'd0;
  wire [3:0]           asks    = undecided ? ({2'b00, lanes} << {undecided_slot, 1'b0}) : 4'd0;
  wire [1:0]           left_of = asking[2*m_slot +: 2];  // marks of the slot on offer
  wire [3:0]           first   = left_of[0] ? 4'd1 : 4'd2;
  wire [3:0]           done    = ends ? (first << {m_slot, 1'b0}) : 4'd0;
  wire [1:0]           busy    = {|asking[3:2], |asking[1:0]};
  wire [1:0]           asked   = undecided ? {1'b0, lanes[0]} + {1'b0, lanes[1]} : 2'd0;
  wire [5:0]           whole   = {3'd0, operands};  // zeros above the operands
  wire [PART_BITS-1:0] part    = whole[beat*PART_BITS +: PART_BITS];

  always @(posedge aclk) begin
    started   <= 1'b1;
    held      <= aresetn && m_valid && !m_ready;
    held_beat <= {m_last, m_slot, m_part};
    left      <= left || (watching && (ahead == NONE) && ends);
    if (start && (start_slot == watched)) begin
      operands <= start_operands[3*watched_lane +: 3];
    end
    if (!aresetn) begin
      stored   <= 2'd0;
      asking   <= 4'd0;
      waiting  <= NONE;
      watching <= 1'b0;
      beat     <= 2'd0;
      quiet    <= NONE;
    end else begin
      stored  <= (stored | starts) & ~named;
      asking  <= (asking | asks) & ~done;
      waiting <= waiting + {1'b0, asked} - {2'b00, ends};
      quiet   <= ((waiting != NONE) && !m_valid) ? quiet + ONE : NONE;
      if (leave) begin
        beat <= (beat == LAST) ? 2'd0 : beat + 2'd1;
      end
      if (watching && ends) begin
        ahead    <= ahead - ONE;
        watching <= (ahead != NONE);
      end
      if (chosen) begin
        watching <= 1'b1;
        ahead    <= waiting - {2'b00, ends} + {2'b00, watched_lane && lanes[0]};
      end
    end
  end

  always @* begin
    if (!aresetn) begin
      assume(!start && !undecided);
    end
    starts_free: assume((starts & (stored | busy)) == 2'd0);
    asks_once: assume((named & ~stored) == 2'd0);
    names_a_lane: assume(!undecided || (lanes != 2'd0));
    if (started && aresetn) begin
      nothing_made_up: assert(!m_valid || busy[m_slot]);
      first_come_first_served: assert(!m_valid || !watching || (ahead != NONE)
                                      || ((m_slot == watched) && (m_part == part)));
      says_which_is_last: assert(!m_valid || (m_last == (beat == LAST)));
      watched_is_inside: assert(!watching || (ahead < waiting));
      keeps_moving: assert(quiet < ((LANES == 1) ? 3'd3 : 3'd4));
      holds_until_taken: assert(!held || (m_valid && ({m_last, m_slot, m_part} == held_beat)));
      can_leave: cover(watching && (ahead == NONE) && ends && (operands == 3'd5)
                       && (watched_lane == (LANES == 2)));
      can_be_last_of_all: cover(watching && (ahead == ONE));
      can_hold: cover(held && m_last);
      can_use_a_slot_again: cover(left && watching);
    end
  end

endmodule

`default_nettype wire
