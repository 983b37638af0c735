// operands_proof: of each slot that is named on `undecided`, one request leaves carried_operands,
// first come first served, with all of its beats in their order, the slot in each, and the operands
// that were stored for it; and requests do leave: a beat in every second cycle in which they are
// taken. One request at a time is watched, chosen by the solver, and those ahead of it are counted.
// A slot is stored, then may be undecided, and is stored again when its request has left.
`default_nettype none

module operands_proof #(
  parameter BEAT_BITS = 1,
  parameter BLOCK = 0
) (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       start,
  input wire       start_slot,
  input wire [2:0] start_operands,
  input wire       undecided,
  input wire       undecided_slot,
  input wire       m_ready,
  input wire       choose  // the request that is named now is watched, if no other is
);

  localparam PART_BITS = (2 >> BEAT_BITS) + 1;
  localparam [1:0] LAST = (1 << BEAT_BITS) - 1;
  localparam [2:0] NONE = 0;
  localparam [2:0] ONE  = 1;

  (* anyconst *) reg watched;  // a slot

  wire                 m_valid;
  wire                 m_slot;
  wire [PART_BITS-1:0] m_part;
  wire                 m_last;

  reg                  started = 1'b0;
  wire                 aresetn = started && aresetn_later;

  carried_operands #(
    .OPERAND_BITS(3),
    .SLOT_BITS   (1),
    .BEAT_BITS   (BEAT_BITS),
    .BLOCK       (BLOCK)
  ) dut (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .start_valid     (start),
    .start_slot      (start_slot),
    .start_operands  (start_operands),
    .undecided_valid (undecided),
    .undecided_slot  (undecided_slot),
    .m_request_tvalid(m_valid),
    .m_request_tready(m_ready),
    .m_request_tdata ({m_slot, m_part}),
    .m_request_tlast (m_last)
  );

  reg  [1:0]           stored  = 2'd0;  // slots with operands about which nothing is decided yet
  reg  [1:0]           asking  = 2'd0;  // slots whose request has not left
  reg  [2:0]           operands;        // of the watched slot
  reg  [2:0]           waiting = NONE;  // requests inside
  reg  [2:0]           ahead   = NONE;  // of the watched one
  reg                  watching = 1'b0;
  reg  [1:0]           beat    = 2'd0;  // the number of the beat that leaves next
  reg  [2:0]           quiet   = NONE;  // cycles without a beat although a request is inside
  reg                  left    = 1'b0;   // the watched request has left before
  reg                  held    = 1'b0;
  reg  [1+PART_BITS:0] held_beat;

  wire                 leave   = m_valid && m_ready;
  wire                 ends    = leave && (beat == LAST);
  wire                 chosen  = undecided && (undecided_slot == watched) && choose && !watching;
  wire [1:0]           one     = 2'd1;
  wire [1:0]           starts  = start ? (one << start_slot) : 2'd0;
  wire [1:0]           asks    = undecided ? (one << undecided_slot) : 2'd0;
  wire [1:0]           done    = ends ? (one << m_slot) : 2'd0;
  wire [5:0]           whole   = {3'd0, operands};  // zeros above the operands
  wire [PART_BITS-1:0] part    = whole[beat*PART_BITS +: PART_BITS];

  always @(posedge aclk) begin
    started   <= 1'b1;
    held      <= aresetn && m_valid && !m_ready;
    held_beat <= {m_last, m_slot, m_part};
    left      <= left || (watching && (ahead == NONE) && ends);
    if (start && (start_slot == watched)) begin
      operands <= start_operands;
    end
    if (!aresetn) begin
      stored   <= 2'd0;
      asking   <= 2'd0;
      waiting  <= NONE;
      watching <= 1'b0;
      beat     <= 2'd0;
      quiet    <= NONE;
    end else begin
      stored  <= (stored | starts) & ~asks;
      asking  <= (asking | asks) & ~done;
      waiting <= waiting + {2'b00, undecided} - {2'b00, ends};
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
        ahead    <= waiting - {2'b00, ends};
      end
    end
  end

  always @* begin
    if (!aresetn) begin
      assume(!start && !undecided);
    end
    starts_free: assume((starts & (stored | asking)) == 2'd0);
    asks_once: assume((asks & ~stored) == 2'd0);
    if (started && aresetn) begin
      nothing_made_up: assert(!m_valid || asking[m_slot]);
      first_come_first_served: assert(!m_valid || !watching || (ahead != NONE)
                                      || ((m_slot == watched) && (m_part == part)));
      says_which_is_last: assert(!m_valid || (m_last == (beat == LAST)));
      watched_is_inside: assert(!watching || (ahead < waiting));
      keeps_moving: assert(quiet < 3'd3);
      holds_until_taken: assert(!held || (m_valid && ({m_last, m_slot, m_part} == held_beat)));
      can_leave: cover(watching && (ahead == NONE) && ends && (operands == 3'd5));
      can_be_last_of_all: cover(watching && (ahead == ONE));
      can_hold: cover(held && m_last);
      can_use_a_slot_again: cover(left && watching);
    end
  end

endmodule

`default_nettype wire
