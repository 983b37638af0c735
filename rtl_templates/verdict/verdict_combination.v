// verdict_combination: one verdict from those of a comparison's PARTS: 0 less, 1 equal, 2 greater,
// 3 unordered, with part 0 in the lowest bits. A part's verdict is valid where its bit of `known`
// is 1.
// Latency: CUTS; initiation interval 1; no reset.
// The verdict is valid where `decided` is 1: a part decides, or all parts are known.
`default_nettype none

module verdict_combination #(
  parameter       PARTS = 2,    // number of parts, 1 or more
  // 0: the last verdict in the order less, equal, unordered, greater. So one part that is greater
  // decides, whatever the others are. 1: the first in the order less, unordered, equal, greater. So
  // one part that is less decides.
  parameter       ANY   = 0,
  parameter [0:0] CUTS  = 1'b0  // 1: a register behind the stage
) (
  input  wire               aclk,
  input  wire [2*PARTS-1:0] verdicts,
  input  wire [PARTS-1:0]   known,
  output wire [1:0]         verdict,
  output wire               decided
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (PARTS < 1) begin : g_refused_parts PARTS_is_below_1 refused (); end
  endgenerate

  // Stage combine: if no part decides, unordered wins over equal, and equal over the rest.
  wire [PARTS-1:0] s0_low;
  wire [PARTS-1:0] s0_high;

  genvar part;
  generate
    for (part = 0; part < PARTS; part = part + 1) begin : g_part
      assign s0_low[part]  = verdicts[2*part];
      assign s0_high[part] = verdicts[2*part+1];
    end
  endgenerate

  wire [PARTS-1:0] s0_decides   = known & ~s0_low & (s0_high ^ {PARTS{ANY != 0}});
  wire             s0_decided   = |s0_decides;
  wire             s0_unordered = |(s0_low & s0_high);
  wire             s0_equal     = |(s0_low & ~s0_high);
  wire             s0_rest      = !s0_unordered && !s0_equal;
  wire             s0_verdict_0 = !s0_decided && !s0_rest;
  wire             s0_verdict_1 = (ANY != 0) ? (!s0_decided && (s0_unordered || s0_rest))
                                             : (s0_decided || s0_unordered);

  fp_rank #(
    .WIDTH     (3),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_verdict_1, s0_verdict_0, s0_decided || (&known)}),
    .q   ({verdict, decided})
  );

endmodule

`default_nettype wire
