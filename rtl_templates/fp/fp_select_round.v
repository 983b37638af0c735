// fp_select_round: rounds and packs a result whose leading one is in the first or second place.
// Four cuts, initiation interval 1, no reset. Special values and promises as in fp_round.
`default_nettype none

module fp_select_round #(
  parameter       WIDTH                = 48,
  parameter       EXPONENT_WIDTH       = 10,  // above RESULT_EXPONENT_BITS + 1
  parameter       RESULT_EXPONENT_BITS = 8,
  parameter       RESULT_PRECISION     = 24,
  parameter       OVERFLOW             = 1,
  parameter       UNDERFLOW            = 1,
  parameter       GRADUAL              = 0,   // 1: with UNDERFLOW alone
  parameter       TOWARD_ZERO          = 0,
  parameter [3:0] CUTS                 = 4'b0
) (
  input  wire                                             aclk,
  input  wire                                             sign,
  input  wire [EXPONENT_WIDTH-1:0]                        exponent,  // of the second place
  input  wire [WIDTH-1:0]                                 value,
  input  wire                                             sticky,
  input  wire                                             nan,
  input  wire                                             infinite,
  input  wire                                             zero,
  input  wire                                             suspect,
  output wire [RESULT_EXPONENT_BITS+RESULT_PRECISION-1:0] y,
  output wire                                             exceptional
);

  localparam KEPT = RESULT_PRECISION + 2;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (WIDTH < 2) begin : g_refused_width
      WIDTH_is_below_2 refused ();
    end
    if (RESULT_EXPONENT_BITS < 2) begin : g_refused_result_exponent
      RESULT_EXPONENT_BITS_is_below_2 refused ();
    end
    if (RESULT_PRECISION < 2) begin : g_refused_result_precision
      RESULT_PRECISION_is_below_2 refused ();
    end
    if (EXPONENT_WIDTH <= RESULT_EXPONENT_BITS + 1) begin : g_refused_exponent_width
      EXPONENT_WIDTH_is_too_small_for_RESULT_EXPONENT_BITS refused ();
    end
    if ((GRADUAL != 0) && (UNDERFLOW == 0)) begin : g_refused_gradual
      GRADUAL_without_UNDERFLOW refused ();
    end
  endgenerate

  // Stage select: a one in the first place is one exponent up.
  wire                      s0_high     = value[WIDTH-1];
  wire [WIDTH-1:0]          s0_value    = s0_high ? value : (value << 1);
  wire [EXPONENT_WIDTH-1:0] s0_exponent = exponent + {{(EXPONENT_WIDTH - 1) {1'b0}}, s0_high};
  wire [KEPT-1:0]           s0_significand;
  wire                      s0_lost;

  fp_fit #(
    .FROM(WIDTH),
    .TO  (KEPT)
  ) s0_fit (
    .value (s0_value),
    .fitted(s0_significand),
    .sticky(s0_lost)
  );

  wire [EXPONENT_WIDTH-1:0] s1_exponent;
  wire [KEPT-1:0]           s1_significand;
  wire                      s1_sticky;
  wire                      s1_sign;
  wire                      s1_nan;
  wire                      s1_infinite;
  wire                      s1_zero;
  wire                      s1_suspect;

  fp_rank #(
    .WIDTH     (EXPONENT_WIDTH + KEPT + 6),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   ({s0_exponent, s0_significand, sticky || s0_lost, sign, nan, infinite, zero, suspect}),
    .q   ({s1_exponent, s1_significand, s1_sticky,
           s1_sign, s1_nan, s1_infinite, s1_zero, s1_suspect})
  );

  // Stages denormalise, round, pack.
  fp_round #(
    .EXPONENT_WIDTH      (EXPONENT_WIDTH),
    .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
    .RESULT_PRECISION    (RESULT_PRECISION),
    .OVERFLOW            (OVERFLOW),
    .UNDERFLOW           (UNDERFLOW),
    .GRADUAL             (GRADUAL),
    .TOWARD_ZERO         (TOWARD_ZERO),
    .CUTS                (CUTS[3:1])
  ) s1_round (
    .aclk       (aclk),
    .sign       (s1_sign),
    .exponent   (s1_exponent),
    .significand(s1_significand),
    .sticky     (s1_sticky),
    .nan        (s1_nan),
    .infinite   (s1_infinite),
    .zero       (s1_zero),
    .suspect    (s1_suspect),
    .y          (y),
    .exceptional(exceptional)
  );

endmodule

`default_nettype wire
