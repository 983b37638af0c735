// fp_shift_right: moves a value down by steps of powers of two. Bit k of `lost` is 1 if the step of
// 2^k moved a one out, so the OR of `lost` is the sticky bit.
// Combinational. An amount of WIDTH or more leaves nothing of the value.
`default_nettype none

module fp_shift_right #(
  parameter WIDTH       = 24,  // bits of `value`, 1 or more
  parameter AMOUNT_BITS = 5    // bits of `amount`, 1 to 30
) (
  input  wire [WIDTH-1:0]       value,
  input  wire [AMOUNT_BITS-1:0] amount,
  output reg  [WIDTH-1:0]       shifted,
  output reg  [AMOUNT_BITS-1:0] lost
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if ((AMOUNT_BITS < 1) || (AMOUNT_BITS > 30))
      begin : g_refused_amount_bits AMOUNT_BITS_is_not_1_to_30 refused (); end
  endgenerate

  integer k;

  // One loop over constant distances is shorter than a chain of generated steps.
  always @* begin
    shifted = value;
    for (k = AMOUNT_BITS - 1; k >= 0; k = k - 1) begin
      lost[k] = amount[k] && (|(shifted & ~({WIDTH{1'b1}} << (1 << k))));
      if (amount[k]) shifted = shifted >> (1 << k);
    end
  end

endmodule

`default_nettype wire
