// pool_proof: slot_pool never hands out a slot that is out, and never keeps one for ever, whenever
// slots come back. Two cycles after a slot came back, a slot is offered, and it stays on offer.
`default_nettype none

module pool_proof #(
  parameter SLOT_BITS = 1
) (
  input wire                 aclk,
  input wire                 aresetn_later,
  input wire                 take,
  input wire                 free,
  input wire [SLOT_BITS-1:0] free_slot
);

  localparam SLOTS = 1 << SLOT_BITS;

  reg                  started  = 1'b0;
  wire                 aresetn  = started && aresetn_later;
  reg  [SLOTS-1:0]     out      = {SLOTS{1'b0}};
  reg  [SLOTS-1:0]     last_out = {SLOTS{1'b1}};
  reg                  held     = 1'b0;
  reg  [SLOT_BITS-1:0] held_slot;
  reg  [3:0]           taken    = 4'd0;

  wire                 slot_valid;
  wire [SLOT_BITS-1:0] slot;
  wire                 handed = aresetn && slot_valid && take;
  wire [SLOTS-1:0]     one    = 1;

  slot_pool #(
    .SLOT_BITS(SLOT_BITS)
  ) dut (
    .aclk        (aclk),
    .aresetn     (aresetn),
    .m_slot_valid(slot_valid),
    .m_slot_ready(take),
    .m_slot      (slot),
    .s_free_valid(free),
    .s_free_slot (free_slot)
  );

  wire [SLOTS-1:0] out_next = (out | (handed ? (one << slot) : {SLOTS{1'b0}}))
                              & ~(free ? (one << free_slot) : {SLOTS{1'b0}});

  always @(posedge aclk) begin
    started   <= 1'b1;
    out       <= aresetn ? out_next : {SLOTS{1'b0}};
    last_out  <= aresetn ? out : {SLOTS{1'b0}};
    held      <= aresetn && slot_valid && !take;
    held_slot <= slot;
    taken     <= aresetn ? taken + {3'd0, handed} : 4'd0;
  end

  always @* begin
    if (!aresetn) begin
      assume(!free && !take);
    end
    if (free) begin
      assume(out[free_slot]);
    end
    if (aresetn) begin
      not_handed_out_twice: assert(!slot_valid || !out[slot]);
      none_is_kept: assert(&(out | last_out) || slot_valid);
      stays_offered: assert(!held || (slot_valid && (slot == held_slot)));
      can_run_out: cover(&out && !slot_valid);
      can_go_round: cover(taken == 4'd7);
    end
  end

endmodule

`default_nettype wire
