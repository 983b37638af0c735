// fp_subnormal_shift: if a result's exponent is below 1, by how many places its significand moves
// down to make it 1.
// Combinational.
`default_nettype none

module fp_subnormal_shift #(
  parameter EXPONENT_WIDTH = 10,  // bits of `exponent`, above AMOUNT_BITS
  parameter AMOUNT_BITS    = 6,   // bits of `amount`, 1 or more
  // 1: subnormals; 0: `amount` and `tiny` are 0, `limited` is `exponent`.
  parameter GRADUAL        = 1
) (
  input  wire [EXPONENT_WIDTH-1:0] exponent,  // biased and signed
  output wire [EXPONENT_WIDTH-1:0] limited,   // `exponent`, or 0 if that is below 1
  output wire                      tiny,      // `exponent` is below 1
  output wire [AMOUNT_BITS-1:0]    amount     // all ones if the distance has more bits
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (AMOUNT_BITS < 1) begin : g_refused_amount_bits AMOUNT_BITS_is_below_1 refused (); end
    if (EXPONENT_WIDTH <= AMOUNT_BITS)
      begin : g_refused_exponent_width EXPONENT_WIDTH_is_not_above_AMOUNT_BITS refused (); end
  endgenerate

  generate
    if (GRADUAL != 0) begin : g_gradual
      wire [EXPONENT_WIDTH-1:0] distance = {{(EXPONENT_WIDTH - 1) {1'b0}}, 1'b1} - exponent;
      wire                      far      = |distance[EXPONENT_WIDTH-1:AMOUNT_BITS];

      assign tiny    = exponent[EXPONENT_WIDTH-1] || !(|exponent);
      assign limited = exponent & {EXPONENT_WIDTH{!tiny}};
      assign amount  = (distance[AMOUNT_BITS-1:0] | {AMOUNT_BITS{far}}) & {AMOUNT_BITS{tiny}};
    end else begin : g_flush
      assign tiny    = 1'b0;
      assign limited = exponent;
      assign amount  = {AMOUNT_BITS{1'b0}};
    end
  endgenerate

endmodule

`default_nettype wire
