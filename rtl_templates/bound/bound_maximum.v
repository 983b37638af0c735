// bound_maximum: the larger of a and b.
// Latency: CUTS; initiation interval 1; no reset.
`default_nettype none

module bound_maximum #(
  parameter       EXPONENT_BITS   = 8,    // bits of the exponent, 2 or more
  parameter       BOUND_PRECISION = 4,    // digits of a bound, 1 or more
  parameter [0:0] CUTS            = 1'b0  // 1: a register behind the stage
) (
  input  wire                                     aclk,
  input  wire [EXPONENT_BITS+BOUND_PRECISION-2:0] a,
  input  wire [EXPONENT_BITS+BOUND_PRECISION-2:0] b,
  output wire [EXPONENT_BITS+BOUND_PRECISION-2:0] y
);

  localparam BOUND = EXPONENT_BITS + BOUND_PRECISION - 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (BOUND_PRECISION < 1)
      begin : g_refused_bound_precision BOUND_PRECISION_is_below_1 refused (); end
  endgenerate

  // Stage select: the packed encodings of bounds have the order of the bounds, as integers.
  fp_rank #(
    .WIDTH     (BOUND),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ((a < b) ? b : a),
    .q   (y)
  );

endmodule

`default_nettype wire
