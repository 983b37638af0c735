// fp_shifted_sum: low + high * 2^SHIFT, and with CARRY + carry * 2^SHIFT. Its one carry chain is as
// long as `high`.
// Combinational. The sum must fit.
`default_nettype none

module fp_shifted_sum #(
  parameter LOW   = 26,  // bits of `low`, SHIFT + 1 to HIGH + SHIFT - 1
  parameter HIGH  = 26,  // bits of `high`, LOW - SHIFT + 1 or more
  parameter SHIFT = 2,   // places of `high` above `low`, 1 or more
  parameter CARRY = 0    // 1: `carry` is added; 0: it is not read
) (
  input  wire [LOW-1:0]        low,
  input  wire [HIGH-1:0]       high,
  input  wire                  carry,
  output wire [HIGH+SHIFT-1:0] sum
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (SHIFT < 1) begin : g_refused_shift SHIFT_is_below_1 refused (); end
    if (SHIFT >= LOW) begin : g_refused_low_end SHIFT_is_not_below_LOW refused (); end
    if (LOW >= HIGH + SHIFT)
      begin : g_refused_high_end LOW_is_not_below_HIGH_plus_SHIFT refused (); end
  endgenerate

  wire [HIGH-1:0] low_above = {{(HIGH + SHIFT - LOW) {1'b0}}, low[LOW-1:SHIFT]};

  wire [HIGH-1:0] above;

  // A carry enters below the chain: there a constant one and the carry add up to two.
  generate
    if (CARRY != 0) begin : g_carry
      wire [HIGH:0] one_below = {low_above, 1'b1} + {high, carry};
      wire          unused    = one_below[0];

      assign above = one_below[HIGH:1];
    end else begin : g_no_carry
      wire unused_carry = carry;

      assign above = low_above + high;
    end
  endgenerate

  assign sum = {above, low[SHIFT-1:0]};

endmodule

`default_nettype wire
