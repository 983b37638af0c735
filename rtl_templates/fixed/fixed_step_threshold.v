// fixed_step_threshold: the threshold of a running bound, THRESHOLD_k in step k. The step is the
// number of leading bits that the largest of COUNT magnitudes uses, 0 to LAST. `leading` has the
// LAST leading bits of each magnitude and its sign, in two's complement.
// Latency: the population count of CUTS (three bits); initiation interval 1; no reset.
`default_nettype none

module fixed_step_threshold #(
  parameter             COUNT       = 4,      // number of magnitudes, 1 or more
  parameter             LAST        = 3,      // the last step, 1 to 7
  parameter             WIDTH       = 12,     // bits of a threshold, 1 or more
  parameter [WIDTH-1:0] THRESHOLD_0 = 16,     // threshold of step 0
  parameter [WIDTH-1:0] THRESHOLD_1 = 32,     // threshold of step 1
  parameter [WIDTH-1:0] THRESHOLD_2 = 64,     // threshold of step 2; not used if LAST is below 2
  parameter [WIDTH-1:0] THRESHOLD_3 = 128,    // threshold of step 3; not used if LAST is below 3
  parameter [WIDTH-1:0] THRESHOLD_4 = 0,      // threshold of step 4; not used if LAST is below 4
  parameter [WIDTH-1:0] THRESHOLD_5 = 0,      // threshold of step 5; not used if LAST is below 5
  parameter [WIDTH-1:0] THRESHOLD_6 = 0,      // threshold of step 6; not used if LAST is below 6
  parameter [WIDTH-1:0] THRESHOLD_7 = 0,      // threshold of step 7; not used if LAST is below 7
  parameter [2:0]       CUTS        = 3'b000  // a register behind stage k if bit k is 1
) (
  input  wire                      aclk,
  input  wire [COUNT*(LAST+1)-1:0] leading,
  output wire [WIDTH-1:0]          threshold
);

  localparam MOST = ((LAST < 1) || (LAST > 7)) ? 1 : LAST;  // 1 if LAST is refused

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((LAST < 1) || (LAST > 7)) begin : g_refused_last LAST_is_not_1_to_7 refused (); end
  endgenerate

  // Stages join and encode.
  wire [2:0] s2_step;

  fixed_common_drop #(
    .COUNT    (COUNT),
    .MOST     (MOST),
    .DROP_BITS(3),
    .CUTS     (CUTS[1:0])
  ) used (
    .aclk  (aclk),
    .excess(leading),
    .drop  (s2_step)
  );

  // Stage select.
  reg [WIDTH-1:0] s2_threshold;

  always @* begin
    case (s2_step)
      3'd0:    s2_threshold = THRESHOLD_0;
      3'd1:    s2_threshold = THRESHOLD_1;
      3'd2:    s2_threshold = THRESHOLD_2;
      3'd3:    s2_threshold = THRESHOLD_3;
      3'd4:    s2_threshold = THRESHOLD_4;
      3'd5:    s2_threshold = THRESHOLD_5;
      3'd6:    s2_threshold = THRESHOLD_6;
      default: s2_threshold = THRESHOLD_7;
    endcase
  end

  fp_rank #(
    .WIDTH     (WIDTH),
    .REGISTERED(CUTS[2])
  ) rank_2 (
    .aclk(aclk),
    .d   (s2_threshold),
    .q   (threshold)
  );

endmodule

`default_nettype wire
