// fp_embedded_product: the product of two significands, by multipliers FACTOR_A by FACTOR_B wide.
// Latency: the population count of CUTS (eight bits); initiation interval 1; no reset.
//
// Each part of a has a column of multipliers, with one row for each part of b. A product is added
// to the sum of the row below, shifted down by FACTOR_B bits. A device that has an adder and
// registers behind its multipliers uses them. A cut between two rows delays the operands of all
// rows above it, so synthesis need not move registers into a wide product. Columns are then added
// one by one.
`default_nettype none

module fp_embedded_product #(
  parameter       PRECISION = 24,  // digits of a significand, 2 or more
  parameter       FACTOR_A  = 24,  // first factor of `*`, 1 bit or more
  parameter       FACTOR_B  = 17,  // second factor of `*`, 1 bit or more
  // A register at cut k if bit k is 1. Cut 0 is in front of the multipliers, cut 1 behind them.
  // Cuts 2 to 5 are behind the first rows, 6 and 7 behind the sums.
  parameter [7:0] CUTS      = 8'b0
) (
  input  wire                   aclk,
  input  wire [PRECISION-1:0]   a,
  input  wire [PRECISION-1:0]   b,
  output wire [2*PRECISION-1:0] product
);

  localparam COLUMNS = (FACTOR_A > 0) ? (PRECISION + FACTOR_A - 1) / FACTOR_A : 1;
  localparam ROWS    = (FACTOR_B > 0) ? (PRECISION + FACTOR_B - 1) / FACTOR_B : 1;

  // The rows that have a cut of their own.
  localparam CUT_ROWS = 4;

  function integer smaller(input integer first, input integer second);
    smaller = (first < second) ? first : second;
  endfunction

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if (FACTOR_A < 1) begin : g_refused_factor_a FACTOR_A_is_below_1 refused (); end
    if (FACTOR_B < 1) begin : g_refused_factor_b FACTOR_B_is_below_1 refused (); end
  endgenerate

  genvar column;
  genvar row;

  generate
    for (column = 0; column < COLUMNS; column = column + 1) begin : g_columns
      localparam A_WIDTH = smaller(FACTOR_A, PRECISION - column * FACTOR_A);

      wire [A_WIDTH+PRECISION-1:0] value;

      for (row = 0; row < ROWS; row = row + 1) begin : g_rows
        localparam B_WIDTH    = smaller(FACTOR_B, PRECISION - row * FACTOR_B);
        localparam CUTS_BELOW = smaller(row, CUT_ROWS);

        wire [A_WIDTH-1:0]         a_part;
        wire [B_WIDTH-1:0]         b_part;
        wire [A_WIDTH+B_WIDTH-1:0] partial;
        wire [A_WIDTH+B_WIDTH-1:0] sum;

        if (CUTS_BELOW > 0) begin : g_delayed
          fp_ranks #(
            .WIDTH(A_WIDTH + B_WIDTH),
            .COUNT(CUTS_BELOW),
            .CUTS (CUTS[CUTS_BELOW+1:2])
          ) operand_ranks (
            .aclk(aclk),
            .d   ({a[column*FACTOR_A+:A_WIDTH], b[row*FACTOR_B+:B_WIDTH]}),
            .q   ({a_part, b_part})
          );
        end else begin : g_immediate
          assign a_part = a[column*FACTOR_A+:A_WIDTH];
          assign b_part = b[row*FACTOR_B+:B_WIDTH];
        end

        embedded_multiplier #(
          .A_WIDTH(A_WIDTH),
          .B_WIDTH(B_WIDTH),
          .CUTS   ({1'b0, CUTS[1:0]})
        ) multiplier (
          .aclk   (aclk),
          .a      (a_part),
          .b      (b_part),
          .product(partial)
        );

        wire [A_WIDTH+B_WIDTH-1:0] joined;

        if (row == 0) begin : g_first
          assign joined = partial;
        end else begin : g_later
          // Never carries: (2^A - 1) (2^B - 1) + 2^A - 1 < 2^(A + B).
          assign joined = partial + {{B_WIDTH{1'b0}}, g_rows[row-1].sum[FACTOR_B+:A_WIDTH]};
        end

        if (row < CUT_ROWS) begin : g_cut
          fp_rank #(
            .WIDTH     (A_WIDTH + B_WIDTH),
            .REGISTERED(CUTS[row+2])
          ) row_rank (
            .aclk(aclk),
            .d   (joined),
            .q   (sum)
          );
        end else begin : g_uncut
          assign sum = joined;
        end

        // Bits that later rows cannot change are delayed until the last row.
        localparam DONE = (row == ROWS - 1) ? A_WIDTH + B_WIDTH : FACTOR_B;

        if (row + 1 < CUT_ROWS) begin : g_early
          fp_ranks #(
            .WIDTH(DONE),
            .COUNT(CUT_ROWS - row - 1),
            .CUTS (CUTS[CUT_ROWS+1:row+3])
          ) done_ranks (
            .aclk(aclk),
            .d   (sum[DONE-1:0]),
            .q   (value[row*FACTOR_B+:DONE])
          );
        end else begin : g_late
          assign value[row*FACTOR_B+:DONE] = sum[DONE-1:0];
        end
      end
    end

    for (column = 0; column < COLUMNS; column = column + 1) begin : g_sums
      localparam PLACE = column * FACTOR_A;
      localparam TERM  = smaller(FACTOR_A, PRECISION - PLACE) + PRECISION;

      wire [PLACE+TERM-1:0] joined;
      wire [PLACE+TERM-1:0] sum;

      if (column == 0) begin : g_first
        assign joined = g_columns[0].value;
      end else begin : g_later
        wire [TERM-1:0] term;

        fp_rank #(
          .WIDTH     (TERM),
          .REGISTERED((column > 1) && CUTS[6])
        ) column_rank (
          .aclk(aclk),
          .d   (g_columns[column].value),
          .q   (term)
        );

        wire [TERM-1:0] upper = {
          {(TERM - PRECISION) {1'b0}}, g_sums[column-1].sum[PLACE+:PRECISION]
        };

        assign joined = {term + upper, g_sums[column-1].sum[PLACE-1:0]};
      end

      // The first sum has two columns if there are two.
      if (column == smaller(1, COLUMNS - 1)) begin : g_cut
        fp_rank #(
          .WIDTH     (PLACE + TERM),
          .REGISTERED(CUTS[6])
        ) sum_rank (
          .aclk(aclk),
          .d   (joined),
          .q   (sum)
        );
      end else begin : g_uncut
        assign sum = joined;
      end
    end
  endgenerate

  fp_rank #(
    .WIDTH     (2 * PRECISION),
    .REGISTERED(CUTS[7])
  ) product_rank (
    .aclk(aclk),
    .d   (g_sums[COLUMNS-1].sum),
    .q   (product)
  );

endmodule

`default_nettype wire
