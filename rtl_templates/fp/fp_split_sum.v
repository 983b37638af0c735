// fp_split_sum: fp_shifted_sum, whose places from SPLIT up arrive and leave one cycle later. The
// carry into them waits in a register, the only one, so that no carry chain leads from below SPLIT
// to above. Initiation interval 1; no reset. SPLIT at HIGH + SHIFT or above: no split.
`default_nettype none

module fp_split_sum #(
  parameter LOW   = 26,
  parameter HIGH  = 26,
  parameter SHIFT = 2,
  parameter CARRY = 0,   // of fp_shifted_sum; 0 where the sum is split
  parameter SPLIT = 28
) (
  input  wire                  aclk,
  input  wire [LOW-1:0]        low,
  input  wire [HIGH-1:0]       high,
  input  wire                  carry,
  output wire [HIGH+SHIFT-1:0] sum
);

  localparam SUM = HIGH + SHIFT;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (SPLIT <= SHIFT) begin : g_refused_split
      SPLIT_is_not_above_SHIFT refused ();
    end
    if ((SPLIT < SUM) && (CARRY != 0)) begin : g_refused_carry
      CARRY_of_a_split_sum refused ();
    end
  endgenerate

  generate
    if (SPLIT >= SUM) begin : g_whole
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
      localparam LOW_BELOW = (LOW < SPLIT) ? LOW : SPLIT;
      localparam UPPER     = SUM - SPLIT;

      wire             unused_carry = carry;
      wire             carry_below;
      wire             late_carry;
      wire [UPPER-1:0] low_above;

      // One place more, which is the carry.
      fp_shifted_sum #(
        .LOW  (LOW_BELOW),
        .HIGH (SPLIT - SHIFT + 1),
        .SHIFT(SHIFT)
      ) below (
        .low  (low[LOW_BELOW-1:0]),
        .high ({1'b0, high[SPLIT-SHIFT-1:0]}),
        .carry(1'b0),
        .sum  ({carry_below, sum[SPLIT-1:0]})
      );

      fp_rank #(
        .WIDTH(1)
      ) carry_rank (
        .aclk(aclk),
        .d   (carry_below),
        .q   (late_carry)
      );

      if (LOW > SPLIT) begin : g_both
        assign low_above = {{(SUM - LOW) {1'b0}}, low[LOW-1:SPLIT]};
      end else begin : g_high_alone
        assign low_above = {UPPER{1'b0}};
      end

      fp_chain_sum #(
        .WIDTH(UPPER)
      ) above (
        .a    (high[HIGH-1:SPLIT-SHIFT]),
        .b    (low_above),
        .carry(late_carry),
        .sum  (sum[SUM-1:SPLIT])
      );
    end
  endgenerate

endmodule

`default_nettype wire
