// fp_logic_product: the product of two integers, or the square of one, without `*`.
// Latency: the population count of CUTS (seven bits); initiation interval 1; no reset.
//
// Booth's digits make half as many rows as there are bits, and a square's rows are on average half
// as long as a product's. A row is gates of five inputs. Together with a bit of the sum they fill a
// look-up table of six inputs in front of a carry chain. So the second to the fourth row of each
// four need no area beyond their sums. Sums are then added two by two.
//
// Look-up tables of four inputs would stand two or three deep in front of each chain. For such
// devices DIGIT_STAGE = 1 finds the digits in a stage of its own, in front of a register. That
// stage decodes a square's digits as Booth's. A product gets digits of -1 to 2 instead: the digits
// of a + 0101...01 are these, each plus one. So an addition finds them, and a row is gates of four
// inputs.
//
// With SPLIT the late bits are added one cycle after the others, with the carries into them in
// registers. That shortens the longest carry chain, for 53 bits from 73 places to 49. At the last
// cut the other bits wait for the late ones.
`default_nettype none

module fp_logic_product #(
  parameter       PRECISION   = 24,   // bits of a factor, 2 to 127; to 63 with DIGIT_STAGE
  parameter       SQUARE      = 0,    // 1: a * a, and b is not read; 0: a * b
  parameter       SIGNED      = 0,    // 1: two's complement, of 4 bits or more; 0: unsigned
  parameter       DIGIT_STAGE = 0,    // 1: the first stage finds the digits; not with SIGNED
  // 1: the highest quarter of the bits is late. Only for a SQUARE of up to 65 bits, with CUTS[6],
  // without SIGNED and DIGIT_STAGE.
  parameter       SPLIT       = 0,
  parameter [6:0] CUTS        = 7'b0  // a register behind stage k if bit k is 1
) (
  input  wire                   aclk,
  input  wire [PRECISION-1:0]   a,
  input  wire [PRECISION-1:0]   b,
  output wire [2*PRECISION-1:0] product
);

  localparam ROWS = (SQUARE != 0) ? PRECISION / 2 : PRECISION / 2 + 1;
  // 1: the last digit consists of a sign and the bit below it.
  localparam CARRIES = (SIGNED != 0) && ((SQUARE != 0) || (PRECISION % 2 != 0));
  // The place of the first digit's middle bit. Each later digit is two places higher.
  localparam PLACE = (SQUARE != 0) ? 1 + PRECISION % 2 : 0;

  // CODE: the code of the digits, as in fp_booth_digit.
  localparam FOUND = (SQUARE != 0) ? 1 : 2;
  localparam CODE  = (DIGIT_STAGE != 0) ? FOUND : 0;
  // LEVEL_CUTS[l] is the cut behind level l of the sums. With a stage for the digits, the last
  // level adds nothing and its cut belongs to that stage.
  localparam [6:0] LEVEL_CUTS = (DIGIT_STAGE != 0) ? CUTS >> 1 : CUTS;

  // Bits of the sum of rows `first` to `last`, from the lowest bit of row `first`.
  function integer width_of(input integer first, input integer last);
    width_of = (SQUARE != 0) ? 4 * last - 2 * first + PLACE + 3
                             : 2 * (last - first) + PRECISION + 6;
  endfunction

  // Bits of the sum of all rows. Those from LATE_FROM up are late.
  localparam TOTAL     = width_of(0, ROWS - 1);
  localparam LATE_FROM = (SPLIT != 0) ? 3 * TOTAL / 4 : TOTAL;

  function integer smaller(input integer first, input integer second);
    smaller = (first < second) ? first : second;
  endfunction

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((PRECISION < 2) || (PRECISION > 127))
      begin : g_refused_precision PRECISION_is_not_2_to_127 refused (); end
    if ((SIGNED != 0) && (PRECISION < 4))
      begin : g_refused_signed PRECISION_of_SIGNED_is_below_4 refused (); end
    if ((DIGIT_STAGE != 0) && (SIGNED != 0))
      begin : g_refused_digits DIGIT_STAGE_of_SIGNED refused (); end
    if ((DIGIT_STAGE != 0) && (PRECISION > 63))
      begin : g_refused_stages DIGIT_STAGE_of_PRECISION_above_63 refused (); end
    if ((SPLIT != 0) && ((SQUARE == 0) || (SIGNED != 0)))
      begin : g_refused_split_kind SPLIT_of_no_unsigned_square refused (); end
    if ((SPLIT != 0) && (PRECISION > 65))
      begin : g_refused_split_precision SPLIT_of_PRECISION_above_65 refused (); end
    if ((SPLIT != 0) && (DIGIT_STAGE != 0))
      begin : g_refused_split_digits SPLIT_with_DIGIT_STAGE refused (); end
    if ((SPLIT != 0) && !CUTS[6])
      begin : g_refused_split_cut SPLIT_without_its_cut_6 refused (); end
  endgenerate

  genvar level;
  genvar index;

  // Booth's digits of a factor: three bits each, one of them shared with the next digit.
  function [3*ROWS-1:0] booth_digits(input [PRECISION-1:0] factor);
    integer                 row;
    reg     [PRECISION+3:0] extended;
    begin
      extended = {{3{(SIGNED != 0) && factor[PRECISION-1]}}, factor, 1'b0};
      for (row = 0; row < ROWS; row = row + 1) begin
        booth_digits[3*row+:3] = extended[2*row+PLACE+:3];
      end
    end
  endfunction

  // The stage of the digits.
  wire [PRECISION-1:0] first_a;
  wire [PRECISION-1:0] first_b;
  wire [3*ROWS-1:0]    first_digits;

  generate
    if (DIGIT_STAGE == 0) begin : g_booth
      assign first_a      = a;
      assign first_b      = b;
      assign first_digits = booth_digits(a);
    end else begin : g_digits
      wire [3*ROWS-1:0] found;

      if (SQUARE != 0) begin : g_decoded
        wire [3*ROWS-1:0] booth = booth_digits(a);

        for (index = 0; index < ROWS; index = index + 1) begin : g_digit
          fp_booth_digit booth_digit (
            .digit   (booth[3*index+:3]),
            .single  (found[3*index]),
            .doubled (found[3*index+1]),
            .negative(found[3*index+2])
          );
        end
      end else begin : g_plus_one
        localparam [2*ROWS-1:0] ONES = {ROWS{2'b01}};

        wire [2*ROWS-1:0] plus_one = {{(2 * ROWS - PRECISION) {1'b0}}, a} + ONES;

        for (index = 0; index < ROWS; index = index + 1) begin : g_digit
          assign found[3*index+:3] = {1'b0, plus_one[2*index+:2]};
        end
      end

      fp_rank #(
        .WIDTH     (2 * PRECISION + 3 * ROWS),
        .REGISTERED(CUTS[0])
      ) rank (
        .aclk(aclk),
        .d   ({a, b, found}),
        .q   ({first_a, first_b, first_digits})
      );
    end
  endgenerate

  // The operands of levels 0 to 2, where rows join. Booth's digits are bits of `a` and need no
  // registers beside it.
  generate
    for (level = 0; level < 3; level = level + 1) begin : g_operands
      wire [PRECISION-1:0] a_factor;
      wire [PRECISION-1:0] b_factor;
      wire [3*ROWS-1:0]    digits;
      wire [3*ROWS+2:0]    digits_and_none = {digits, 3'b000};
      wire [PRECISION-1:0] late_a;  // a_factor, one cycle later
      wire [3*ROWS-1:0]    late_digits = booth_digits(late_a);
      wire                 unused_bits = ^{a_factor, b_factor, digits_and_none, late_digits};

      if (SPLIT != 0) begin : g_late
        fp_rank #(
          .WIDTH(PRECISION)
        ) rank (
          .aclk(aclk),
          .d   (a_factor),
          .q   (late_a)
        );
      end else begin : g_none_late
        assign late_a = {PRECISION{1'b0}};
      end

      if (level == 0) begin : g_first
        assign a_factor = first_a;
        assign b_factor = first_b;
        assign digits   = first_digits;
      end else begin : g_later
        wire [3*ROWS-1:0] kept;
        wire              unused_kept = ^kept;

        fp_rank #(
          .WIDTH     (2 * PRECISION + 3 * ROWS),
          .REGISTERED(LEVEL_CUTS[level-1])
        ) rank (
          .aclk(aclk),
          .d   ({g_operands[level-1].a_factor, g_operands[level-1].b_factor,
                 g_operands[level-1].digits}),
          .q   ({a_factor, b_factor, kept})
        );

        assign digits = (DIGIT_STAGE == 0) ? booth_digits(a_factor) : kept;
      end
    end
  endgenerate

  // If the last Booth digit is -1, its row is a ones' complement. The 1 that it lacks is delayed
  // until the last stage, which adds it.
  generate
    for (level = 0; level < 7; level = level + 1) begin : g_owed
      wire carry;
      wire unused_carry = carry;

      if (level > 0) begin : g_later
        fp_rank #(
          .WIDTH     (1),
          .REGISTERED(LEVEL_CUTS[level-1])
        ) rank (
          .aclk(aclk),
          .d   (g_owed[level-1].carry),
          .q   (carry)
        );
      end else if (CARRIES) begin : g_carry
        assign carry = first_a[PRECISION-1] && !first_a[PRECISION-2];
      end else begin : g_no_carry
        assign carry = 1'b0;
      end
    end
  endgenerate

  // The rows. In each group of four the first two join at level 0, the third at level 1, the fourth
  // at level 2.
  generate
    for (index = 0; index < ROWS; index = index + 1) begin : g_rows
      localparam LEVEL = (index % 4 < 2) ? 0 : index % 4 - 1;
      localparam WIDTH = width_of(index, index);

      wire [WIDTH-1:0] row;

      fp_split_row #(
        .PRECISION(PRECISION),
        .SQUARE   (SQUARE),
        .SIGNED   (SIGNED),
        .CODE     (CODE),
        .ROW      (index),
        .WIDTH    (WIDTH),
        .LATE_FROM(LATE_FROM - 2 * index)
      ) split_row (
        .a         (g_operands[LEVEL].a_factor),
        .b         (g_operands[LEVEL].b_factor),
        .digit     (g_operands[LEVEL].digits_and_none[3*index+3+:3]),
        .previous  (g_operands[LEVEL].digits_and_none[3*index+:3]),
        .late_a    (g_operands[LEVEL].late_a),
        .late_digit(g_operands[LEVEL].late_digits[3*index+:3]),
        .row       (row)
      );
    end
  endgenerate

  // Levels 0 to 2 make sums of 2, 3 and 4 rows, levels 3 to 6 of 8, 16, 32 and 64.
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
        localparam LATE  = LATE_FROM - 2 * FIRST;  // the first late bit of this sum

        wire [LOW-1:0] low;
        wire [SUM-1:0] sum;
        wire [SUM-1:0] value;

        if (level == 0) begin : g_row
          assign low = g_rows[FIRST].row;
        end else if (level < 3) begin : g_same
          assign low = g_sums[level-1].g_part[index].value;
        end else begin : g_halves
          assign low = g_sums[level-1].g_part[2*index].value;
        end

        if (UPPER < ROWS) begin : g_add
          localparam SHIFT = 2 * ADDED;
          localparam HIGH  = SUM - SHIFT;

          wire [HIGH-1:0] high;

          if (level < 3) begin : g_row
            assign high = g_rows[UPPER].row;
          end else begin : g_halves
            assign high = g_sums[level-1].g_part[2*index+1].value;
          end

          fp_split_sum #(
            .LOW      (LOW),
            .HIGH     (HIGH),
            .SHIFT    (SHIFT),
            .CARRY    (CARRIES && (UPPER == ROWS - 1)),
            .LATE_FROM(LATE)
          ) split_sum (
            .aclk (aclk),
            .low  (low),
            .high (high),
            .carry(g_owed[level].carry),
            .sum  (sum)
          );
        end else begin : g_pass
          assign sum = low;
        end

        // The ones above a product's rows leave 01 or 10 in the two highest bits of a sum. So the
        // highest bit needs no register, which would stand at the end of a carry chain.
        localparam KEPT = ((SQUARE == 0) && (UPPER < ROWS)) ? SUM - 1 : SUM;

        // The last cut delays only the other bits: behind it the late ones are in time.
        localparam HELD = ((SPLIT != 0) && (level == 6)) ? LATE : KEPT;

        wire [KEPT-1:0] kept;

        fp_rank #(
          .WIDTH     (HELD),
          .REGISTERED(LEVEL_CUTS[level])
        ) rank (
          .aclk(aclk),
          .d   (sum[HELD-1:0]),
          .q   (kept[HELD-1:0])
        );

        if (HELD < KEPT) begin : g_late
          assign kept[KEPT-1:HELD] = sum[KEPT-1:HELD];
        end

        if (KEPT < SUM) begin : g_inverse
          wire unused_highest_bit = sum[SUM-1];

          assign value = {!kept[KEPT-1], kept};
        end else begin : g_all
          assign value = kept;
        end
      end
    end
  endgenerate

  wire [TOTAL-1:0] total = g_sums[6].g_part[0].value;

  // A product's rows begin two places below the product, those of an odd square one place above.
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
      ) lowest_bit (
        .aclk(aclk),
        .d   (a[0]),
        .q   (product[0])
      );

      assign product[2*PRECISION-1:1] = total;
    end
  endgenerate

endmodule

`default_nettype wire
