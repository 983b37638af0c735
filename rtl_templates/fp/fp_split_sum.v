// fp_split_sum: low + high * 2^SHIFT. The bits of the sum from LATE_FROM up are late: they, and the
// bits of `low` and `high` in the same places, come one cycle after the others. A register holds
// the carry into them, so no carry chain crosses LATE_FROM.
// Latency 0 of either part; initiation interval 1; no reset. Without late bits this is
// fp_shifted_sum.
`default_nettype none

module fp_split_sum #(
  parameter LOW       = 26,  // bits of `low`, SHIFT + 1 to HIGH + SHIFT - 1
  parameter HIGH      = 26,  // bits of `high`, LOW - SHIFT + 1 or more
  parameter SHIFT     = 2,   // places of `high` above `low`, 1 or more
  parameter CARRY     = 0,   // 1: `carry` is added, if no bit is late; 0: it is not read
  parameter LATE_FROM = 28   // lowest late bit, above SHIFT; HIGH + SHIFT or more: no bit is late
) (
  input  wire                  aclk,
  input  wire [LOW-1:0]        low,
  input  wire [HIGH-1:0]       high,
  input  wire                  carry,
  output wire [HIGH+SHIFT-1:0] sum
);

  localparam SUM = HIGH + SHIFT;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (LATE_FROM <= SHIFT) begin : g_refused_late_from LATE_FROM_is_not_above_SHIFT refused (); end
    if ((LATE_FROM < SUM) && (LOW >= SUM))
      begin : g_refused_low_end LOW_is_not_below_HIGH_plus_SHIFT refused (); end
    if ((LATE_FROM < SUM) && (CARRY != 0))
      begin : g_refused_carry CARRY_of_a_split_sum refused (); end
  endgenerate

  generate
    if (LATE_FROM >= SUM) begin : g_none_late
      wire unused_aclk = aclk;

      fp_shifted_sum #(
        .LOW  (LOW),
        .HIGH (HIGH),
        .SHIFT(SHIFT),
        .CARRY(CARRY)
      ) whole (
        .low  (low),
        .high (high),
        .carry(carry),
        .sum  (sum)
      );
    end else begin : g_split
      localparam EARLY_LOW = (LOW < LATE_FROM) ? LOW : LATE_FROM;
      localparam LATE      = SUM - LATE_FROM;

      wire            unused_carry = carry;
      wire            early_carry;
      wire            late_carry;
      wire [LATE-1:0] late_low;

      // This sum has one bit more than the early bits: the carry into the late ones.
      fp_shifted_sum #(
        .LOW  (EARLY_LOW),
        .HIGH (LATE_FROM - SHIFT + 1),
        .SHIFT(SHIFT)
      ) early (
        .low  (low[EARLY_LOW-1:0]),
        .high ({1'b0, high[LATE_FROM-SHIFT-1:0]}),
        .carry(1'b0),
        .sum  ({early_carry, sum[LATE_FROM-1:0]})
      );

      fp_rank #(
        .WIDTH(1)
      ) carry_rank (
        .aclk(aclk),
        .d   (early_carry),
        .q   (late_carry)
      );

      if (LOW > LATE_FROM) begin : g_both
        assign late_low = {{(SUM - LOW) {1'b0}}, low[LOW-1:LATE_FROM]};
      end else begin : g_high_alone
        assign late_low = {LATE{1'b0}};
      end

      fp_chain_sum #(
        .WIDTH(LATE)
      ) late (
        .a    (high[HIGH-1:LATE_FROM-SHIFT]),
        .b    (late_low),
        .carry(late_carry),
        .sum  (sum[SUM-1:LATE_FROM])
      );
    end
  endgenerate

endmodule

`default_nettype wire
