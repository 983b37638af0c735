// fixed_norm_decision: decides the sign of a difference |x|^2 - s^2 by the norm of the errors:
// greater (2) from s * 2^SHIFT_ABOVE + OFFSET_ABOVE on, less (0) below -s * 2^SHIFT_BELOW. SWAPPED
// exchanges the two verdicts.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// What lies between stays undecided, as what is out of range does. The difference is in two's
// complement, the radius s has no sign. A verdict means something where `decided` is 1.
`default_nettype none

module fixed_norm_decision #(
  parameter                   WIDTH        = 30,
  parameter                   RADIUS_WIDTH = 14,
  parameter                   LIMIT_WIDTH  = 18,  // of the largest limit, without a sign
  parameter                   SHIFT_ABOVE  = 3,
  parameter [LIMIT_WIDTH-1:0] OFFSET_ABOVE = 14,
  parameter                   SHIFT_BELOW  = 2,
  parameter                   SWAPPED      = 0,
  parameter [1:0]             CUTS         = 2'b00
) (
  input  wire                    aclk,
  input  wire [WIDTH-1:0]        difference,
  input  wire [RADIUS_WIDTH-1:0] radius,
  input  wire                    out_of_range,
  output wire [1:0]              verdict,
  output wire                    decided
);

  // A bit above the wider of the two, and one for the sum.
  localparam COMMON = ((WIDTH > LIMIT_WIDTH) ? WIDTH : LIMIT_WIDTH + 1) + 1;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (WIDTH < 1) begin : g_refused_width
      WIDTH_is_below_1 refused ();
    end
    if (RADIUS_WIDTH < 1) begin : g_refused_radius
      RADIUS_WIDTH_is_below_1 refused ();
    end
    if ((SHIFT_ABOVE < 0) || (SHIFT_ABOVE + RADIUS_WIDTH > LIMIT_WIDTH)) begin : g_refused_above
      SHIFT_ABOVE_is_not_0_to_what_LIMIT_WIDTH_holds refused ();
    end
    if ((SHIFT_BELOW < 0) || (SHIFT_BELOW + RADIUS_WIDTH > LIMIT_WIDTH)) begin : g_refused_below
      SHIFT_BELOW_is_not_0_to_what_LIMIT_WIDTH_holds refused ();
    end
  endgenerate

  // Stage limit.
  wire [LIMIT_WIDTH-1:0] s0_radius      = {{(LIMIT_WIDTH - RADIUS_WIDTH) {1'b0}}, radius};
  wire [LIMIT_WIDTH-1:0] s0_above       = (s0_radius << SHIFT_ABOVE) + OFFSET_ABOVE;
  wire [WIDTH-1:0]       s1_difference;
  wire [LIMIT_WIDTH-1:0] s1_radius;
  wire [LIMIT_WIDTH-1:0] s1_above;
  wire                   s1_out_of_range;

  fp_rank #(
    .WIDTH     (WIDTH + 2 * LIMIT_WIDTH + 1),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({difference, s0_radius, s0_above, out_of_range}),
    .q   ({s1_difference, s1_radius, s1_above, s1_out_of_range})
  );

  // Stage compare.
  wire [LIMIT_WIDTH-1:0] s1_below  = s1_radius << SHIFT_BELOW;
  wire [COMMON-1:0]      s1_common = {{(COMMON - WIDTH) {s1_difference[WIDTH-1]}}, s1_difference};
  wire [COMMON-1:0]      s1_over   = s1_common - {{(COMMON - LIMIT_WIDTH) {1'b0}}, s1_above};
  wire [COMMON-1:0]      s1_under  = s1_common + {{(COMMON - LIMIT_WIDTH) {1'b0}}, s1_below};
  wire                   s1_greater  = !s1_over[COMMON-1];
  wire                   s1_less     = s1_under[COMMON-1];
  wire                   unused_bits = ^{s1_over, s1_under};

  fp_rank #(
    .WIDTH     (3),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ({(SWAPPED != 0) ? s1_less : s1_greater, 1'b0,
           (s1_greater || s1_less) && !s1_out_of_range}),
    .q   ({verdict, decided})
  );

endmodule

`default_nettype wire
