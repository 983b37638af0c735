// block_exponent: the largest of COUNT biased exponents, by a tree of LEVELS comparisons. If all
// are 0 the result is 1, since subnormal numbers have the exponent of the smallest normal ones.
// not_finite: the largest is the exponent of infinities and NaNs.
// Latency: the population count of CUTS (LEVELS bits); initiation interval 1; no reset.
`default_nettype none

module block_exponent #(
  parameter              COUNT         = 8,  // number of exponents, 1 or more
  parameter              LEVELS        = 3,  // levels of comparisons, 1 or more; 2^LEVELS >= COUNT
  parameter              EXPONENT_BITS = 8,  // bits of the exponent, 2 or more
  parameter [LEVELS-1:0] CUTS          = 0   // a register behind level k where bit k is 1
) (
  input  wire                           aclk,
  input  wire [COUNT*EXPONENT_BITS-1:0] exponents,
  output wire [EXPONENT_BITS-1:0]       largest,
  output wire                           not_finite
);

  localparam DEPTH = (LEVELS < 1) ? 1 : LEVELS;  // 1 if LEVELS is refused

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (COUNT < 1) begin : g_refused_count COUNT_is_below_1 refused (); end
    if ((LEVELS < 1) || ((1 << LEVELS) < COUNT))
      begin : g_refused_levels LEVELS_are_too_few_for_COUNT refused (); end
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
  endgenerate

  // Stages level 0 to DEPTH - 1: the larger exponent of each pair goes on.
  genvar level, k;
  generate
    for (level = 0; level < DEPTH; level = level + 1) begin : g_level
      localparam FROM = (COUNT + (1 << level) - 1) >> level;
      localparam TO   = (FROM + 1) / 2;

      wire [FROM*EXPONENT_BITS-1:0] candidates;
      wire [TO*EXPONENT_BITS-1:0]   maxima;
      wire [TO*EXPONENT_BITS-1:0]   winners;

      if (level == 0) begin : g_first
        assign candidates = exponents;
      end else begin : g_later
        assign candidates = g_level[level-1].winners;
      end

      for (k = 0; k < TO; k = k + 1) begin : g_pair
        wire [EXPONENT_BITS-1:0] a = candidates[2*k*EXPONENT_BITS+:EXPONENT_BITS];
        wire [EXPONENT_BITS-1:0] chosen;

        if (2 * k + 1 < FROM) begin : g_two
          wire [EXPONENT_BITS-1:0] b = candidates[(2*k+1)*EXPONENT_BITS+:EXPONENT_BITS];

          assign chosen = (a > b) ? a : b;
        end else begin : g_one
          assign chosen = a;
        end

        assign maxima[k*EXPONENT_BITS+:EXPONENT_BITS] =
            {chosen[EXPONENT_BITS-1:1], chosen[0] || ((level == DEPTH - 1) && (chosen == 0))};
      end

      fp_rank #(
        .WIDTH     (TO * EXPONENT_BITS),
        .REGISTERED(CUTS[level])
      ) rank (
        .aclk(aclk),
        .d   (maxima),
        .q   (winners)
      );
    end
  endgenerate

  assign largest    = g_level[DEPTH-1].winners;
  assign not_finite = &largest;

endmodule

`default_nettype wire
