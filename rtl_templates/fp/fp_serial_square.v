// fp_serial_square: a * a, rounded once to the result format. Each cycle multiplies by six bits of
// the operand, in logic on any device.
// Latency: the population count of CUTS, with bits 2 to CYCLES + 4 taken as 1. Initiation interval
// CYCLES: `start` says that an operand is there, and comes again after CYCLES cycles or later. No
// reset: `start` ends an unfinished square.
// Special values as IEEE 754.
// rtl_templates/fp/README.md states the promises in full.
`default_nettype none

module fp_serial_square #(
  parameter EXPONENT_BITS        = 8,                    // bits of the operand's exponent, 2 to 30
  parameter PRECISION            = 24,                   // digits with the leading one, 13 or more
  parameter RESULT_EXPONENT_BITS = EXPONENT_BITS,        // bits of the result's exponent, 2 to 30
  parameter RESULT_PRECISION     = PRECISION,            // digits of the result, 2 to PRECISION + 3
  parameter SPECIAL_OPERANDS     = 1,                    // 0 promises no NaN and no infinity
  parameter OVERFLOW             = 1,                    // 0 promises that no result overflows
  parameter UNDERFLOW            = 1,                    // 0 promises no tiny operand or result
  parameter GRADUAL              = 0,                    // 1: subnormals; 0: flushed to zero
  parameter TOWARD_ZERO          = 0,                    // 1: rounds toward zero; 0: nearest even
  parameter SUM_SELECTS          = 2,                    // bits that may select, 0 to 2; see fp_add
  parameter CYCLES               = (PRECISION + 5) / 6,  // derived; no other value is legal
  // A register behind stage k if bit k is 1; bits 2 to CYCLES + 4 are read as 1.
  parameter [CYCLES+9:0] CUTS = 0
) (
  input  wire                                             aclk,
  input  wire                                             start,
  input  wire [EXPONENT_BITS+PRECISION-1:0]               a,
  output wire [RESULT_EXPONENT_BITS+RESULT_PRECISION-1:0] y,
  output wire                                             exceptional
);

  function integer bits_for(input integer value);
    integer rest;
    begin
      bits_for = 0;
      for (rest = value; rest > 0; rest = rest >> 1) bits_for = bits_for + 1;
    end
  endfunction

  function integer larger(input integer first, input integer second);
    larger = (first > second) ? first : second;
  endfunction

  // Without underflow there are no subnormals, so GRADUAL has no effect.
  localparam SUBNORMALS = (GRADUAL != 0) && (UNDERFLOW != 0);

  // Cuts 2 to ROUND - 1 are registers of the steps.
  localparam ROUND   = CYCLES + 5;
  localparam PRODUCT = PRECISION + 6;  // the number of its places that are kept
  localparam EXPONENT_WIDTH =
      larger(larger(EXPONENT_BITS, RESULT_EXPONENT_BITS),
             bits_for(larger(PRODUCT, RESULT_PRECISION + 2))) + 2;
  localparam AMOUNT_BITS = bits_for(RESULT_PRECISION + 3);

  localparam integer BIAS        = (1 << (EXPONENT_BITS - 1)) - 1;
  localparam integer RESULT_BIAS = (1 << (RESULT_EXPONENT_BITS - 1)) - 1;
  localparam integer REBIAS      = RESULT_BIAS - 2 * BIAS;
  // 1: a subnormal's square is below half the smallest result: zero and inexact, as if flushed.
  localparam VANISHING = 2 * BIAS > RESULT_BIAS + RESULT_PRECISION;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((EXPONENT_BITS < 2) || (EXPONENT_BITS > 30))
      begin : g_refused_exponent EXPONENT_BITS_is_not_2_to_30 refused (); end
    if (PRECISION < 13) begin : g_refused_precision PRECISION_is_below_13 refused (); end
    if ((RESULT_EXPONENT_BITS < 2) || (RESULT_EXPONENT_BITS > 30))
      begin : g_refused_result_exponent RESULT_EXPONENT_BITS_is_not_2_to_30 refused (); end
    if (RESULT_PRECISION < 2)
      begin : g_refused_result_precision RESULT_PRECISION_is_below_2 refused (); end
    if (RESULT_PRECISION > PRECISION + 3)
      begin : g_refused_wide_result RESULT_PRECISION_is_above_PRECISION_plus_3 refused (); end
    if (CYCLES != (PRECISION + 5) / 6)
      begin : g_refused_cycles CYCLES_is_not_that_of_PRECISION refused (); end
  endgenerate

  // Stages count, normalise: the significand gets a leading one.
  wire                      s2_unused_sign;
  wire [EXPONENT_WIDTH-1:0] s2_a_exponent;
  wire [PRECISION-1:0]      s2_a_significand;
  wire                      s2_zero;
  wire                      s2_infinite;
  wire                      s2_nan;
  wire                      s2_flushed;

  fp_operand #(
    .EXPONENT_BITS   (EXPONENT_BITS),
    .PRECISION       (PRECISION),
    .EXPONENT_WIDTH  (EXPONENT_WIDTH),
    .SPECIAL_OPERANDS(SPECIAL_OPERANDS),
    .UNDERFLOW       (UNDERFLOW),
    .GRADUAL         (SUBNORMALS && !VANISHING),
    .CUTS            (CUTS[1:0])
  ) s0_operand (
    .aclk       (aclk),
    .a          (a),
    .sign       (s2_unused_sign),
    .exponent   (s2_a_exponent),
    .significand(s2_a_significand),
    .zero       (s2_zero),
    .infinite   (s2_infinite),
    .nan        (s2_nan),
    .flushed    (s2_flushed)
  );

  // Steps: the square of a significand in [1, 2) lies in [1, 4).
  wire [EXPONENT_WIDTH-1:0] s2_exponent = (s2_a_exponent << 1) + REBIAS[EXPONENT_WIDTH-1:0];
  wire                      unused_cuts = ^CUTS[ROUND-1:2];
  wire                      s2_suspect  = s2_nan || s2_infinite || s2_flushed;
  wire                      s2_start;
  wire                      third;
  wire [PRODUCT-1:0]        last_product;
  wire                      last_sticky;

  fp_ranks #(
    .WIDTH(1),
    .COUNT(2),
    .CUTS (CUTS[1:0])
  ) start_ranks (
    .aclk(aclk),
    .d   (start),
    .q   (s2_start)
  );

  fp_square_steps #(
    .PRECISION(PRECISION),
    .CYCLES   (CYCLES)
  ) s2_steps (
    .aclk  (aclk),
    .start (s2_start),
    .a     (s2_a_significand),
    .third (third),
    .square(last_product),
    .sticky(last_sticky)
  );

  // Beside the steps, two registers hold the exponent until the next square needs them.
  reg  [EXPONENT_WIDTH-1:0] s3_exponent_q;
  reg  [3:0]                s3_flags_q;
  wire [EXPONENT_WIDTH-1:0] s3_limited;
  wire                      s3_tiny;
  wire [AMOUNT_BITS-1:0]    s3_amount;

  fp_subnormal_shift #(
    .EXPONENT_WIDTH(EXPONENT_WIDTH),
    .AMOUNT_BITS   (AMOUNT_BITS),
    .GRADUAL       (SUBNORMALS)
  ) s3_subnormal_shift (
    .exponent(s3_exponent_q),
    .limited (s3_limited),
    .tiny    (s3_tiny),
    .amount  (s3_amount)
  );

  reg  [EXPONENT_WIDTH-1:0] last_exponent_q;
  reg                       last_tiny_q;
  reg  [AMOUNT_BITS-1:0]    last_amount_q;
  reg  [3:0]                last_flags_q;

  always @(posedge aclk) begin
    if (s2_start) begin
      s3_exponent_q <= s2_exponent;
      s3_flags_q    <= {s2_nan, s2_infinite, s2_zero, s2_suspect};
    end
    if (third) begin
      last_exponent_q <= s3_limited;
      last_tiny_q     <= s3_tiny;
      last_amount_q   <= s3_amount;
      last_flags_q    <= s3_flags_q;
    end
  end

  // Stages denormalise, select, round, pack.
  fp_select_round #(
    .WIDTH               (PRODUCT),
    .EXPONENT_WIDTH      (EXPONENT_WIDTH),
    .AMOUNT_BITS         (AMOUNT_BITS),
    .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
    .RESULT_PRECISION    (RESULT_PRECISION),
    .OVERFLOW            (OVERFLOW),
    .UNDERFLOW           (UNDERFLOW),
    .GRADUAL             (SUBNORMALS),
    .TOWARD_ZERO         (TOWARD_ZERO),
    .SUM_SELECTS         (SUM_SELECTS),
    .CUTS                (CUTS[ROUND+4:ROUND])
  ) select_round (
    .aclk       (aclk),
    .sign       (1'b0),
    .exponent   (last_exponent_q),
    .tiny       (last_tiny_q),
    .amount     (last_amount_q),
    .value      (last_product),
    .sticky     (last_sticky),
    .nan        (last_flags_q[3]),
    .infinite   (last_flags_q[2]),
    .zero       (last_flags_q[1]),
    .suspect    (last_flags_q[0]),
    .y          (y),
    .exceptional(exceptional)
  );

endmodule

`default_nettype wire
