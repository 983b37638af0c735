// verdict_combination: one verdict of the PARTS of a comparison: 0 less, 1 equal, 2 greater, 3
// unordered, part 0 in the lowest bits. A part's verdict means something where its bit of `known`
// is 1.
// ANY = 0: the last of them in the order less, equal, unordered, greater, so that one that is
// greater decides, whatever the others are. ANY = 1: the first in the order less, unordered, equal,
// greater, so that one that is less decides.
// Latency: CUTS; initiation interval 1; no reset.
// The verdict means something where `decided` is 1: a part decides, or all are known.
`default_nettype none

module verdict_combination #(
  parameter       PARTS = 2,
  parameter       ANY   = 0,
  parameter [0:0] CUTS  = 1'b0
) (
  input  wire               aclk,
  input  wire [2*PARTS-1:0] verdicts,
  input  wire [PARTS-1:0]   known,
  output wire [1:0]         verdict,
  output wire               decided
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (PARTS < 1) begin : g_refused_parts PARTS_is_below_1 refused (); end
  endgenerate

  // Stage combine: among parts none of which decides, unordered outweighs equal, equal the rest.
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
