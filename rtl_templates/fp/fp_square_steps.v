// fp_square_steps: the upper digits of the square of a significand in [1, 2). Each cycle multiplies
// by six bits of the significand.
// Latency: CYCLES + 3. Initiation interval, from one `start` to the next: CYCLES or more. No reset:
// `start` ends an unfinished square.
//
// With P = PRECISION the significand is 2^(P-1) + r, and its square is 2^(2P-2) + r m for m = 2^P +
// r. Each step adds m times three digits of r, which are -1 to 2, to the sum, and the sum moves
// down by three digits before the next step. Bits that it moves out only affect `sticky`. The
// digits of r + 0101...01 are those of r, each plus one. So an addition finds them, and a row, m
// times a digit, is gates of four inputs.
//
// This table shows the register that a step fills in each cycle after `start`:
//
//   cycle   0         1         2         3         4
//   step 0  digits_q  two_q     three_q   sum_q
//   step 1            digits_q  two_q     three_q   sum_q
`default_nettype none

module fp_square_steps #(
  parameter PRECISION = 24,                  // digits with the leading one, 13 or more
  parameter CYCLES    = (PRECISION + 5) / 6  // derived; no other value is legal
) (
  input  wire                 aclk,
  input  wire                 start,   // `a` is valid
  input  wire [PRECISION-1:0] a,       // with its leading one
  output wire                 third,   // the third cycle after that of `start`
  output wire [PRECISION+5:0] square,  // the first place is worth 2
  output wire                 sticky
);

  localparam PADDED   = 6 * CYCLES;
  localparam MULTIPLE = PRECISION + 2;
  localparam ROW      = PRECISION + 4;  // sums of three rows need two more
  localparam TWO      = ROW + 2;
  localparam SUM      = ROW + 4;
  localparam STEPS    = (CYCLES > 4) ? CYCLES - 1 : 3;

  localparam [6:0] ONES = 7'b0010101;
  localparam [1:0] ONE  = 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (PRECISION < 13) begin : g_refused_precision PRECISION_is_below_13 refused (); end
    if (CYCLES != (PRECISION + 5) / 6)
      begin : g_refused_cycles CYCLES_is_not_that_of_PRECISION refused (); end
  endgenerate

  // Bit k of `steps` marks the k-th cycle after `start`, in which the digits of step k are found.
  reg  [STEPS-1:0]     steps_q;
  wire [STEPS:0]       steps              = {steps_q, start};
  reg  [PRECISION-2:0] rest_q;
  wire                 unused_leading_one = a[PRECISION-1];
  wire                 unused_last_step   = steps[STEPS];

  assign third = steps[3];

  always @(posedge aclk) begin
    steps_q <= {steps_q[STEPS-2:0] & {(STEPS - 1) {!start}}, start};
    if (start) begin
      rest_q <= a[PRECISION-2:0];
    end
  end

  // Zeros below r pad its digits to whole steps, so any square keeps the same places.
  wire [PADDED-1:0] first;
  wire [PADDED-1:0] later;
  wire              unused_bits = ^{first[PADDED-1:6], later[5:0]};

  generate
    if (PADDED > PRECISION) begin : g_padded
      assign first = {1'b0, a[PRECISION-2:0], {(PADDED - PRECISION) {1'b0}}};
      assign later = {1'b0, rest_q, {(PADDED - PRECISION) {1'b0}}};
    end else begin : g_full
      assign first = {1'b0, a[PRECISION-2:0]};
      assign later = {1'b0, rest_q};
    end
  endgenerate

  reg  [5:0] later_bits;
  wire [5:0] bits     = start ? first[5:0] : later_bits;
  reg  [5:0] digits_q;
  reg        carry_q;
  wire [6:0] plus_one = {1'b0, bits} + ONES + {6'd0, carry_q && !start};
  integer    k;

  always @* begin
    later_bits = 6'd0;
    for (k = 1; k < CYCLES; k = k + 1) begin
      later_bits = later_bits | (later[6*k+:6] & {6{steps[k]}});
    end
  end

  always @(posedge aclk) begin
    digits_q <= plus_one[5:0];
    carry_q  <= plus_one[6];
  end

  // The rows of a step. A negative row is a ones' complement: it lacks 1 in its last place.
  wire [3*ROW-1:0] rows;
  wire [2:0]       negative;

  genvar row;
  generate
    for (row = 0; row < 3; row = row + 1) begin : g_row
      wire                single;
      wire                doubled;
      wire [MULTIPLE-1:0] multiple;

      fp_booth_digit #(
        .CODE(2)
      ) booth_digit (
        .digit   ({1'b0, digits_q[2*row+:2]}),
        .single  (single),
        .doubled (doubled),
        .negative(negative[row])
      );

      fp_booth_multiple #(
        .WIDTH(PRECISION + 1)
      ) booth_multiple (
        .single  (single),
        .doubled (doubled),
        .negative(negative[row]),
        .value   ({2'b10, rest_q}),
        .multiple(multiple)
      );

      assign rows[row*ROW+:ROW] = {{2{negative[row]}}, multiple};
    end
  endgenerate

  // The second row is added to the first one, the third row a cycle later. If the second or the
  // third row is negative, the 1 that it lacks enters as the carry out of an extra last place. The
  // 1 that the first row lacks is added in the last sum.
  reg  [TWO-1:0] two_q;
  reg  [ROW-1:0] row_2_q;
  reg            two_lacks_q;
  reg            row_2_lacks_q;
  reg  [SUM-1:0] three_q;
  reg            three_lacks_q;

  wire [ROW-1:0] row_0 = rows[ROW-1:0];
  wire [ROW-1:0] upper_two;
  wire           unused_place_two;
  wire [ROW-1:0] upper_three;
  wire           unused_place_three;

  assign {upper_two, unused_place_two} =
      {{2{row_0[ROW-1]}}, row_0[ROW-1:2], 1'b1} + {rows[ROW+:ROW], negative[1]};
  assign {upper_three, unused_place_three} =
      {{2{two_q[TWO-1]}}, two_q[TWO-1:4], 1'b1} + {row_2_q, row_2_lacks_q};

  always @(posedge aclk) begin
    two_q         <= {upper_two, row_0[1:0]};
    row_2_q       <= rows[2*ROW+:ROW];
    two_lacks_q   <= negative[0];
    row_2_lacks_q <= negative[2];
    three_q       <= {upper_three, two_q[3:0]};
    three_lacks_q <= two_lacks_q;
  end

  // The sum of the steps so far, from the third cycle on.
  reg  [SUM-1:0] sum_q;
  reg            sticky_q;
  wire [SUM-1:0] moved = {{6{sum_q[SUM-1]}}, sum_q[SUM-1:6]} & {SUM{!third}};
  wire [SUM-1:0] sum;
  wire           unused_place_sum;

  assign {sum, unused_place_sum} = {moved, 1'b1} + {three_q, three_lacks_q};

  always @(posedge aclk) begin
    sum_q    <= sum;
    sticky_q <= !third && (sticky_q || (|sum_q[5:0]));
  end

  wire unused_sign = ^sum_q[SUM-1:SUM-2];

  // 2^(2P-2) is a one in the second place.
  assign square = {sum_q[SUM-3:SUM-4] + ONE, sum_q[SUM-5:0]};
  assign sticky = sticky_q;

endmodule

`default_nettype wire
