// fixed_norm_decision: decides the sign of a difference by the norm of the errors: greater (2) if
// it is at least s * 2^SHIFT_ABOVE + OFFSET_ABOVE, less (0) if it is below -s * 2^SHIFT_BELOW.
// Latency: the population count of CUTS (three bits); initiation interval 1; no reset.
// A difference between the two limits, or out of range, is undecided. If beyond_reach is 1, |x|^2
// is greater and the difference is undefined. The difference is in two's complement, the radius s
// is unsigned. A verdict is valid where `decided` is 1.
`default_nettype none

module fixed_norm_decision #(
  parameter                       WIDTH           = 30,  // bits of the difference, 1 or more
  parameter                       RADIUS_WIDTH    = 14,  // bits of the radius, 1 or more
  // 0: the difference is |x|^2 - s^2 and `radius` is s. 1: the difference is |x|^2 - |y|^2,
  // `radius` is |y|^2, and s is 2^k for the least k with |y|^2 < 4^k.
  parameter                       ROOT            = 0,
  parameter                       THRESHOLD_WIDTH = 18,  // bits of the largest threshold, unsigned
  // places by which s is shifted for the verdict greater, 0 to THRESHOLD_WIDTH - S_WIDTH
  parameter                       SHIFT_ABOVE     = 3,
  // added to the shifted s for the verdict greater, 0 or more
  parameter [THRESHOLD_WIDTH-1:0] OFFSET_ABOVE    = 14,
  // places by which s is shifted for the verdict less, 0 to THRESHOLD_WIDTH - S_WIDTH
  parameter                       SHIFT_BELOW     = 2,
  parameter                       SWAPPED         = 0,   // 1: the two verdicts are exchanged
  // a register behind stage k if bit k is 1
  parameter [2:0]                 CUTS            = 3'b000
) (
  input  wire                    aclk,
  input  wire [WIDTH-1:0]        difference,
  input  wire [RADIUS_WIDTH-1:0] radius,
  input  wire                    beyond_reach,
  input  wire                    out_of_range,
  output wire [1:0]              verdict,
  output wire                    decided
);

  // The width of s, or with ROOT of s - 1, which is k ones.
  localparam S_WIDTH = (ROOT != 0) ? (RADIUS_WIDTH + 1) / 2 : RADIUS_WIDTH;

  // The difference as wide as a threshold with a sign, or wider.
  localparam EXTENDED = (WIDTH > THRESHOLD_WIDTH) ? WIDTH : THRESHOLD_WIDTH + 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if (RADIUS_WIDTH < 1) begin : g_refused_radius RADIUS_WIDTH_is_below_1 refused (); end
    if ((SHIFT_ABOVE < 0) || (SHIFT_ABOVE + S_WIDTH > THRESHOLD_WIDTH))
      begin : g_refused_above SHIFT_ABOVE_is_not_0_to_what_THRESHOLD_WIDTH_holds refused (); end
    if ((SHIFT_BELOW < 0) || (SHIFT_BELOW + S_WIDTH > THRESHOLD_WIDTH))
      begin : g_refused_below SHIFT_BELOW_is_not_0_to_what_THRESHOLD_WIDTH_holds refused (); end
  endgenerate

  // Stage root: bit k is 1 where radius >= 4^k, so s0_s is s - 1.
  wire [S_WIDTH-1:0] s0_s;

  genvar place;
  generate
    if (ROOT != 0) begin : g_root
      for (place = 0; place < S_WIDTH; place = place + 1) begin : g_place
        assign s0_s[place] = |radius[RADIUS_WIDTH-1:2*place];
      end
    end else begin : g_radius
      assign s0_s = radius;
    end
  endgenerate

  wire [WIDTH-1:0]   s1_difference;
  wire [S_WIDTH-1:0] s1_s;
  wire               s1_beyond_reach;
  wire               s1_out_of_range;

  fp_rank #(
    .WIDTH     (WIDTH + S_WIDTH + 2),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({difference, s0_s, beyond_reach, out_of_range}),
    .q   ({s1_difference, s1_s, s1_beyond_reach, s1_out_of_range})
  );

  // Stage threshold.
  localparam [THRESHOLD_WIDTH-1:0] ONE    = (ROOT != 0) ? 1 : 0;
  localparam [THRESHOLD_WIDTH-1:0] OFFSET = OFFSET_ABOVE + (ONE << SHIFT_ABOVE);

  wire [THRESHOLD_WIDTH-1:0] s1_wide_s = {{(THRESHOLD_WIDTH - S_WIDTH) {1'b0}}, s1_s};
  wire [THRESHOLD_WIDTH-1:0] s1_above  = (s1_wide_s << SHIFT_ABOVE) + OFFSET;

  wire [WIDTH-1:0]           s2_difference;
  wire [THRESHOLD_WIDTH-1:0] s2_wide_s;
  wire [THRESHOLD_WIDTH-1:0] s2_above;
  wire                       s2_beyond_reach;
  wire                       s2_out_of_range;

  fp_rank #(
    .WIDTH     (WIDTH + 2 * THRESHOLD_WIDTH + 2),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   ({s1_difference, s1_wide_s, s1_above, s1_beyond_reach, s1_out_of_range}),
    .q   ({s2_difference, s2_wide_s, s2_above, s2_beyond_reach, s2_out_of_range})
  );

  // Stage compare. Thresholds meet only the low bits of the difference. The high bits, its sign on
  // top, say whether it is beyond every threshold. With ROOT, s2_wide_s is s - 1. So s
  // 2^SHIFT_BELOW is (s - 1) 2^SHIFT_BELOW, with ones in the places below, plus 1, which is a carry
  // out of an extra last place.
  localparam [THRESHOLD_WIDTH-1:0] ONES = (ONE << SHIFT_BELOW) - ONE;

  wire [THRESHOLD_WIDTH-1:0]  s2_below    = (s2_wide_s << SHIFT_BELOW) | ONES;
  wire [EXTENDED-1:0]         s2_extended =
      {{(EXTENDED - WIDTH) {s2_difference[WIDTH-1]}}, s2_difference};
  wire [THRESHOLD_WIDTH-1:0]  s2_low      = s2_extended[THRESHOLD_WIDTH-1:0];
  wire [EXTENDED-1:THRESHOLD_WIDTH] s2_high = s2_extended[EXTENDED-1:THRESHOLD_WIDTH];
  wire                        s2_negative = s2_extended[EXTENDED-1];
  wire [THRESHOLD_WIDTH:0]    s2_over     = {1'b0, s2_low} - {1'b0, s2_above};
  wire [THRESHOLD_WIDTH+1:0]  s2_under    =
      {1'b0, s2_low, 1'b1} + {1'b0, s2_below, ROOT != 0};
  wire                        s2_reaches  = !s2_over[THRESHOLD_WIDTH];    // low >= above
  wire                        s2_falls    = !s2_under[THRESHOLD_WIDTH+1]; // low + below < 2^T
  wire                        s2_greater  =
      (!s2_negative && (|s2_high || s2_reaches)) || s2_beyond_reach;
  wire                        s2_less     =
      s2_negative && (!(&s2_high) || s2_falls) && !s2_beyond_reach;
  wire                        unused_bits = ^{s2_over, s2_under};

  fp_rank #(
    .WIDTH     (3),
    .REGISTERED(CUTS[2])
  ) rank_2 (
    .aclk(aclk),
    .d   ({(SWAPPED != 0) ? s2_less : s2_greater, 1'b0,
           (s2_greater || s2_less) && !s2_out_of_range}),
    .q   ({verdict, decided})
  );

endmodule

`default_nettype wire
