// fp_serial_steps: the upper digits of the square of a significand in [1, 2), six bits in each cycle.
// Latency: CYCLES + 3; initiation interval CYCLES, from one `start` to the next, or more; no reset.
//
// a = 2^(P-1) + r makes a^2 = 2^(2P-2) + r m with m = 2^P + r. r + 0101...01 has the digits of r in
// base 4 from -1 to 2, each plus one, so that a row, m times a digit, is gates of four inputs. Each
// step adds three rows to the sum, which has moved down by three digits: what falls out below it
// matters to `sticky` alone.
`default_nettype none

module fp_serial_steps #(
  parameter PRECISION = 24,
  parameter CYCLES    = 4,  // (PRECISION + 5) / 6
  parameter KEPT      = 30  // 2 PRECISION - 6 (CYCLES - 1)
) (
  input  wire                 aclk,
  input  wire                 start,   // `a` is there
  input  wire [PRECISION-1:0] a,       // with its leading one
  output wire [KEPT-1:0]      square,
  output wire                 sticky,
  output wire                 third    // the cycle is the third one behind that of `start`
);

  localparam PADDED = 6 * CYCLES;
  localparam ROW    = PRECISION + 3;
  localparam SUM    = (KEPT > ROW + 3) ? KEPT + 1 : ROW + 4;
  localparam STEPS  = (CYCLES > 4) ? CYCLES - 1 : 3;

  localparam [6:0] ONES = 7'b0010101;
  localparam [1:0] ONE  = 1;

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (PRECISION < 13) begin : g_refused_precision
      PRECISION_is_below_13 refused ();
    end
    if (CYCLES != (PRECISION + 5) / 6) begin : g_refused_cycles
      CYCLES_is_not_that_of_PRECISION refused ();
    end
    if (KEPT != 2 * PRECISION - 6 * (CYCLES - 1)) begin : g_refused_kept
      KEPT_is_not_that_of_PRECISION refused ();
    end
  endgenerate

  // The digits of step k are found in cycle k; bit k says which that is.
  reg  [STEPS-1:0]     steps_q;
  wire [STEPS:0]       steps = {steps_q, start};
  reg  [PRECISION-2:0] rest_q;
  wire                 unused_leading_one = a[PRECISION-1];

  always @(posedge aclk) begin
    steps_q <= steps[STEPS-1:0];
    if (start) begin
      rest_q <= a[PRECISION-2:0];
    end
  end

  wire [PADDED-1:0] now    = {{(PADDED - PRECISION + 1) {1'b0}}, a[PRECISION-2:0]};
  wire [PADDED-1:0] later  = {{(PADDED - PRECISION + 1) {1'b0}}, rest_q};
  wire              unused_bits = ^{now, later, steps};
  reg  [5:0]        bits;
  reg  [5:0]        digits_q;
  reg               carry_q;
  wire              carry    = carry_q && !start;
  wire [6:0]        plus_one = {1'b0, bits} + ONES + {6'd0, carry};
  integer           k;

  always @* begin
    bits = now[5:0] & {6{start}};
    for (k = 1; k < CYCLES; k = k + 1) begin
      bits = bits | (later[6*k +: 6] & {6{steps[k]}});
    end
  end

  always @(posedge aclk) begin
    digits_q <= plus_one[5:0];
    carry_q  <= plus_one[6];
  end

  // The rows of a step.
  wire [3*ROW-1:0] rows;
  wire [2:0]       negative;

  genvar row;
  generate
    for (row = 0; row < 3; row = row + 1) begin : g_row
      fp_digit_row #(
        .WIDTH(PRECISION + 1)
      ) digit_row (
        .digit_plus_one(digits_q[2*row +: 2]),
        .value         ({2'b10, rest_q}),
        .row           (rows[row*ROW +: ROW]),
        .negative      (negative[row])
      );
    end
  endgenerate

  wire signed [ROW-1:0] row_0 = rows[ROW-1:0];
  wire signed [ROW-1:0] row_1 = rows[ROW +: ROW];

  // The second row on the first one, then the third, each with what a negative row lacks.
  reg  signed [ROW+1:0] two_q;
  reg  signed [ROW-1:0] row_2_q;
  reg  signed [ROW+3:0] three_q;
  reg  [1:0]            lacks_q;  // of rows 2 and 0, beside two_q
  reg                   owed_q;   // of row 0, beside three_q
  wire signed [1:0]     lacks_1     = {1'b0, negative[1]};
  wire signed [1:0]     lacks_2     = {1'b0, lacks_q[1]};
  wire signed [1:0]     owed        = {1'b0, owed_q};
  wire signed [ROW-1:0] upper_two   = (row_0 >>> 2) + row_1 + lacks_1;
  wire signed [ROW-1:0] upper_three = (two_q >>> 4) + row_2_q + lacks_2;

  // The sum of all steps so far.
  reg  signed [SUM-1:0] sum_q;
  reg                   sticky_q;
  wire signed [SUM-1:0] moved  = sum_q >>> 6;
  wire signed [SUM-1:0] before = moved & {SUM{!third}};

  always @(posedge aclk) begin
    two_q    <= {upper_two, row_0[1:0]};
    row_2_q  <= rows[2*ROW +: ROW];
    lacks_q  <= {negative[2], negative[0]};
    three_q  <= {upper_three, two_q[3:0]};
    owed_q   <= lacks_q[0];
    sum_q    <= before + three_q + owed;
    sticky_q <= !third && (sticky_q || (sum_q[5:0] != 6'd0));
  end

  wire unused_sign = ^sum_q[SUM-1:KEPT];

  assign third  = steps[3];
  assign square = {sum_q[KEPT-1:KEPT-2] + ONE, sum_q[KEPT-3:0]};
  assign sticky = sticky_q;

endmodule

`default_nettype wire
