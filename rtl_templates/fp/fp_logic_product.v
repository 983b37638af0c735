// fp_logic_product: the product of two integers, or the square of one, without `*`.
// Latency: the population count of CUTS (seven bits); initiation interval 1; no reset.
//
// Booth's digits make half as many rows as there are bits, a square's on average half as long as a
// product's. A row is gates of five inputs. With the sum's bit they fill a look-up table of six
// inputs in front of a carry chain, so the second to fourth row of each four cost their sum alone.
// Then sums are added two by two.
`default_nettype none

module fp_logic_product #(
  parameter       PRECISION = 24,  // to 127
  parameter       SQUARE    = 0,   // 1: of a; b is not read
  parameter       SIGNED    = 0,   // 1: a and b are in two's complement, of 4 bits or more
  parameter [6:0] CUTS      = 7'b0
) (
  input  wire                   aclk,
  input  wire [PRECISION-1:0]   a,
  input  wire [PRECISION-1:0]   b,
  output wire [2*PRECISION-1:0] product
);

  localparam ROWS = (SQUARE != 0) ? PRECISION / 2 : PRECISION / 2 + 1;
  // Whether the last digit is a sign and the bit below it.
  localparam CARRIES = (SIGNED != 0) && ((SQUARE != 0) || (PRECISION % 2 != 0));
  // Of the first digit's middle bit; each other is two places up.
  localparam PLACE = (SQUARE != 0) ? 1 + PRECISION % 2 : 0;

  // From the first place of row `first` to the last one of row `last`.
  function integer width_of(input integer first, input integer last);
    width_of = (SQUARE != 0) ? 4 * last - 2 * first + PLACE + 3
                             : 2 * (last - first) + PRECISION + 6;
  endfunction

  function integer smaller(input integer first, input integer second);
    smaller = (first < second) ? first : second;
  endfunction

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if ((PRECISION < 2) || (PRECISION > 127)) begin : g_refused_precision
      PRECISION_is_not_2_to_127 refused ();
    end
    if ((SIGNED != 0) && (PRECISION < 4)) begin : g_refused_signed
      PRECISION_of_SIGNED_is_below_4 refused ();
    end
  endgenerate

  genvar level;
  genvar index;

  // The operands of levels 0 to 2, where rows join.
  generate
    for (level = 0; level < 3; level = level + 1) begin : g_operands
      wire [PRECISION-1:0] a_factor;
      wire [PRECISION-1:0] b_factor;
      wire                 unused_bits = ^{a_factor, b_factor};

      if (level == 0) begin : g_first
        assign a_factor = a;
        assign b_factor = b;
      end else begin : g_later
        fp_rank #(
          .WIDTH     (2 * PRECISION),
          .REGISTERED(CUTS[level-1])
        ) rank (
          .aclk(aclk),
          .d   ({g_operands[level-1].a_factor, g_operands[level-1].b_factor}),
          .q   ({a_factor, b_factor})
        );
      end
    end
  endgenerate

  // The row of the last Booth digit, where that is -1, is a ones' complement: the 1 that it lacks
  // waits for the last stage, which adds it.
  generate
    for (level = 0; level < 7; level = level + 1) begin : g_owed
      wire carry;
      wire unused_carry = carry;

      if (level > 0) begin : g_later
        fp_rank #(
          .WIDTH     (1),
          .REGISTERED(CUTS[level-1])
        ) rank (
          .aclk(aclk),
          .d   (g_owed[level-1].carry),
          .q   (carry)
        );
      end else if (CARRIES) begin : g_carry
        assign carry = a[PRECISION-1] && !a[PRECISION-2];
      end else begin : g_no_carry
        assign carry = 1'b0;
      end
    end
  endgenerate

  // Levels 0 to 2 add the second, third and fourth row of each four. Levels 3 to 6: 8, 16, 32, 64
  // rows.
  generate
    for (level = 0; level < 7; level = level + 1) begin : g_sums
      localparam PITCH = (level < 3) ? 4 : 1 << level;
      localparam ADDED = (level < 3) ? level + 1 : PITCH / 2;  // rows of the lower addend
      localparam ALL   = (level < 3) ? level + 2 : PITCH;
      localparam COUNT = (ROWS + PITCH - 1) / PITCH;

      for (index = 0; index < COUNT; index = index + 1) begin : g_part
        localparam FIRST = PITCH * index;
        localparam UPPER = FIRST + ADDED;  // first row of the upper addend
        localparam LOW   = width_of(FIRST, smaller(UPPER, ROWS) - 1);
        localparam SUM   = width_of(FIRST, smaller(FIRST + ALL, ROWS) - 1);

        wire [LOW-1:0] low;
        wire [SUM-1:0] sum;
        wire [SUM-1:0] value;

        if (level == 0) begin : g_rows
          fp_product_row #(
            .PRECISION(PRECISION),
            .SQUARE   (SQUARE),
            .SIGNED   (SIGNED),
            .ROW      (FIRST),
            .WIDTH    (LOW)
          ) product_row (
            .a  (g_operands[0].a_factor),
            .b  (g_operands[0].b_factor),
            .row(low)
          );
        end else if (level < 3) begin : g_same
          assign low = g_sums[level-1].g_part[index].value;
        end else begin : g_halves
          assign low = g_sums[level-1].g_part[2*index].value;
        end

        if (UPPER < ROWS) begin : g_add
          localparam SHIFT = 2 * ADDED;
          localparam HIGH  = SUM - SHIFT;

          wire [HIGH-1:0] high;

          if (level < 3) begin : g_rows
            fp_product_row #(
              .PRECISION(PRECISION),
              .SQUARE   (SQUARE),
              .SIGNED   (SIGNED),
              .ROW      (UPPER),
              .WIDTH    (HIGH)
            ) product_row (
              .a  (g_operands[level].a_factor),
              .b  (g_operands[level].b_factor),
              .row(high)
            );
          end else begin : g_halves
            assign high = g_sums[level-1].g_part[2*index+1].value;
          end

          fp_shifted_sum #(
            .LOW  (LOW),
            .HIGH (HIGH),
            .SHIFT(SHIFT),
            .CARRY(CARRIES && (UPPER == ROWS - 1))
          ) shifted_sum (
            .low  (low),
            .high (high),
            .carry(g_owed[level].carry),
            .sum  (sum)
          );
        end else begin : g_pass
          assign sum = low;
        end

        fp_rank #(
          .WIDTH     (SUM),
          .REGISTERED(CUTS[level])
        ) rank (
          .aclk(aclk),
          .d   (sum),
          .q   (value)
        );
      end
    end
  endgenerate

  localparam TOTAL = width_of(0, ROWS - 1);

  wire [TOTAL-1:0] total = g_sums[6].g_part[0].value;

  // A product's rows begin two places below it, the rows of an odd square one place above.
  generate
    if (SQUARE == 0) begin : g_product_of_two
      wire unused_places = ^{total[TOTAL-1:2*PRECISION+2], total[1:0]};

      assign product = total[2*PRECISION+1:2];
    end else if (PRECISION % 2 == 0) begin : g_even_square
      assign product = total;
    end else begin : g_odd_square
      fp_ranks #(
        .WIDTH(1),
        .COUNT(7),
        .CUTS (CUTS)
      ) last_place (
        .aclk(aclk),
        .d   (a[0]),
        .q   (product[0])
      );

      assign product[2*PRECISION-1:1] = total;
    end
  endgenerate

endmodule

`default_nettype wire
