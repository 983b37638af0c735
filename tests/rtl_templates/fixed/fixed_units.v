// fixed_units: the units of fixed point at small widths, only for the tests. fixed_units_test.cpp
// describes the slots in the same words.
`default_nettype none

module fixed_units #(
    parameter WIDTHS    = 5,
    // The number of kinds: sum, difference, product, square, minimum, maximum, absolute; then
    // products by fixed_product with positive factors, which are both, that of a square, the first,
    // or the second; then the sum and the difference of a and b shifted up by 2 and by 3 places.
    parameter KINDS     = 13,
    parameter DECISIONS = 96,
    parameter CHECKS    = 80,
    parameter OVERFLOWS = 36,
    parameter TABLES    = 40,
    parameter FLOATINGS = 24
) (
    input wire       aclk,
    input wire [5:0] a,
    input wire [4:0] b,
    input wire       flag
);

  localparam SLOTS = KINDS * WIDTHS * WIDTHS * 4;

  function integer larger(input integer first, input integer second);
    larger = (first > second) ? first : second;
  endfunction

  // The bits of the whole result of a kind.
  function integer whole(input integer kind, input integer a_width, input integer b_width);
    case (kind)
      2: whole = a_width + b_width;
      3: whole = 2 * a_width;
      6: whole = a_width;
      7: whole = a_width + b_width + 2;
      8: whole = 2 * a_width + 2;
      9, 10: whole = a_width + b_width + 1;
      11: whole = larger(a_width, b_width + 2) + 1;
      12: whole = larger(a_width, b_width + 3) + 1;
      default: whole = larger(a_width, b_width) + 1;
    endcase
  endfunction

  // Address bits and bits of a word, for each slot of a table.
  function integer address_bits(input integer slot);
    case (slot / 8)
      0: address_bits = 1;
      1: address_bits = 2;
      2: address_bits = 6;
      3: address_bits = 7;
      default: address_bits = 10;
    endcase
  endfunction

  function integer word_bits(input integer slot);
    case (slot / 2 % 4)
      0: word_bits = 1;
      1: word_bits = 7;
      2: word_bits = 24;
      default: word_bits = 43;
    endcase
  endfunction

  // Bits of a number, for each slot of a floating code.
  function integer number_bits(input integer slot);
    case (slot / 4)
      0: number_bits = 2;
      1: number_bits = 3;
      2: number_bits = 5;
      3: number_bits = 8;
      4: number_bits = 9;
      default: number_bits = 11;
    endcase
  endfunction

  // The answers, which the test reads by hierarchical name.
  wire [63:0] results[0:SLOTS-1]  /* verilator public_flat_rd */;
  wire [63:0] decisions[0:2*DECISIONS-1]  /* verilator public_flat_rd */;
  wire [63:0] checks[0:CHECKS-1]  /* verilator public_flat_rd */;
  wire [63:0] overflows[0:OVERFLOWS-1]  /* verilator public_flat_rd */;
  wire [63:0] tables[0:TABLES-1]  /* verilator public_flat_rd */;
  wire [63:0] floatings[0:FLOATINGS-1]  /* verilator public_flat_rd */;

  genvar slot;

  // Slot {kind, a's width, b's width, variant}. Variants 1 and 3 drop the lowest bit, 2 and 3 leave
  // out the top bit, if the result has enough bits.
  generate
    for (slot = 0; slot < SLOTS; slot = slot + 1) begin : g_results
      localparam       KIND    = slot / (4 * WIDTHS * WIDTHS);
      localparam       A       = 1 + slot / (4 * WIDTHS) % WIDTHS;
      localparam       B       = 1 + slot / 4 % WIDTHS;
      localparam       WHOLE   = whole(KIND, A, B);
      localparam       DROPPED = (WHOLE > 1) ? slot % 2 : 0;
      localparam       WIDTH   = larger(1, WHOLE - DROPPED - slot / 2 % 2);
      localparam [1:0] CUTS    = slot + slot / 4;

      wire [WIDTH-1:0] y;

      assign results[slot] = {{(64 - WIDTH) {1'b0}}, y};

      if ((KIND < 2) || (KIND > 10)) begin : g_sum
        fixed_sum #(
            .A_WIDTH (A),
            .B_WIDTH (B),
            .SHIFT_B ((KIND < 2) ? 0 : KIND - 9),
            .SUBTRACT((KIND == 1) || (KIND == 12)),
            .DROPPED (DROPPED),
            .WIDTH   (WIDTH),
            .CUTS    (CUTS[0])
        ) unit (
            .aclk(aclk),
            .a   (a[A-1:0]),
            .b   (b[B-1:0]),
            .y   (y)
        );
      end else if (KIND < 4) begin : g_product
        fixed_product #(
            .A_WIDTH (A),
            .B_WIDTH (B),
            .SQUARE  (KIND - 2),
            .DROPPED (DROPPED),
            .WIDTH   (WIDTH),
            .FACTOR_A(4),
            .FACTOR_B(2),
            .CUTS    (CUTS)
        ) unit (
            .aclk(aclk),
            .a   (a[A-1:0]),
            .b   (b[B-1:0]),
            .y   (y)
        );
      end else if (KIND < 6) begin : g_choice
        fixed_minimum_maximum #(
            .A_WIDTH(A),
            .B_WIDTH(B),
            .MAXIMUM(KIND - 4),
            .DROPPED(DROPPED),
            .WIDTH  (WIDTH),
            .CUTS   (CUTS)
        ) unit (
            .aclk(aclk),
            .a   (a[A-1:0]),
            .b   (b[B-1:0]),
            .y   (y)
        );
      end else if (KIND > 6) begin : g_positive
        localparam POSITIVE_A = KIND < 10;
        localparam POSITIVE_B = (KIND == 7) || (KIND == 10);

        wire [A:0] factor_a = {1'b0, a[A-1:0]};
        wire [B:0] factor_b = {1'b0, b[B-1:0]};

        fixed_product #(
            .A_WIDTH   (A + POSITIVE_A),
            .B_WIDTH   (B + POSITIVE_B),
            .SQUARE    (KIND == 8),
            .POSITIVE_A(POSITIVE_A),
            .POSITIVE_B(POSITIVE_B),
            .DROPPED   (DROPPED),
            .WIDTH     (WIDTH),
            .FACTOR_A  (4),
            .FACTOR_B  (2),
            .CUTS      (CUTS)
        ) unit (
            .aclk(aclk),
            .a   (factor_a[A+POSITIVE_A-1:0]),
            .b   (factor_b[B+POSITIVE_B-1:0]),
            .y   (y)
        );
      end else begin : g_absolute
        fixed_absolute #(
            .A_WIDTH(A),
            .DROPPED(DROPPED),
            .WIDTH  (WIDTH),
            .CUTS   (CUTS[0])
        ) unit (
            .aclk(aclk),
            .a   (a[A-1:0]),
            .y   (y)
        );
      end
    end
  endgenerate

  // Decisions by constants, on a difference of five bits, and decisions by a norm, on a difference
  // of six bits and a radius of three. In every fifth slot of the latter the radius is a square of
  // five bits.
  generate
    for (slot = 0; slot < DECISIONS; slot = slot + 1) begin : g_constant
      localparam [5:0] LESS_TO      = slot % 16 - 13;
      localparam [5:0] GREATER_FROM = slot % 16 - 12 + slot / 16;

      wire [1:0] verdict;
      wire       decided;

      assign decisions[slot] = {61'b0, verdict, decided};

      fixed_constant_decision #(
          .WIDTH       (5),
          .GREATER_FROM(GREATER_FROM),
          .LESS_TO     (LESS_TO),
          .EXACT       (slot / 2 % 3),
          .CUTS        (slot % 2)
      ) decision (
          .aclk        (aclk),
          .difference  (a[4:0]),
          .out_of_range(flag),
          .verdict     (verdict),
          .decided     (decided)
      );
    end

    for (slot = 0; slot < DECISIONS; slot = slot + 1) begin : g_norm
      wire [1:0] verdict;
      wire       decided;

      assign decisions[DECISIONS+slot] = {61'b0, verdict, decided};

      localparam RADIUS = (slot % 5 == 4) ? 5 : 3;

      fixed_norm_decision #(
          .WIDTH       (6),
          .RADIUS_WIDTH(RADIUS),
          .ROOT        (slot % 5 == 4),
          .THRESHOLD_WIDTH(6),
          .SHIFT_ABOVE (slot % 3),
          .OFFSET_ABOVE(slot / 3 % 8),
          .SHIFT_BELOW (slot / 24 % 3),
          .SWAPPED     (slot / 2 % 2),
          .CUTS        (slot % 8)
      ) decision (
          .aclk        (aclk),
          .difference  (a),
          .radius      (b[RADIUS-1:0]),
          .beyond_reach((RADIUS == 3) && b[3]),
          .out_of_range(flag),
          .verdict     (verdict),
          .decided     (decided)
      );
    end
  endgenerate

  // Checks of the range of four bits. The lower limit rises by one every five slots. The upper
  // limit lies 0, 1, 4, 9 or 16 above it, but at most at the end of the range of four bits.
  generate
    for (slot = 0; slot < CHECKS; slot = slot + 1) begin : g_check
      localparam       LOW      = slot / 5 - 8;
      localparam       HIGH     = LOW + (slot % 5) * (slot % 5);
      localparam [3:0] LEAST    = LOW;
      localparam [3:0] GREATEST = (HIGH > 7) ? 7 : HIGH;

      wire out_of_range;

      assign checks[slot] = {63'b0, out_of_range};

      fixed_range_check #(
          .A_WIDTH (4),
          .LEAST   (LEAST),
          .GREATEST(GREATEST),
          .CUTS    (slot % 2)
      ) check (
          .aclk        (aclk),
          .a           (a[3:0]),
          .out_of_range(out_of_range)
      );
    end
  endgenerate

  // Slot {operand's width, result's width}, both from 1 on: whether a's low bits do not fit the
  // result. A slot whose result is as wide as the operand or wider has no unit.
  generate
    for (slot = 0; slot < OVERFLOWS; slot = slot + 1) begin : g_overflow
      localparam A     = 1 + slot / 6;
      localparam WIDTH = 1 + slot % 6;

      wire overflow;

      assign overflows[slot] = {63'b0, overflow};

      if (WIDTH < A) begin : g_narrower
        fixed_overflow #(
            .A_WIDTH(A),
            .WIDTH  (WIDTH),
            .CUTS   (slot % 2)
        ) check (
            .aclk    (aclk),
            .a       (a[A-1:0]),
            .overflow(overflow)
        );
      end else begin : g_as_wide
        assign overflow = 1'b0;
      end
    end
  endgenerate

  // Slot {address bits, bits of a word, register}. The words are consecutive bits of a pattern that
  // repeats itself. Its 127 bits are a prime number, so that words differ.
  wire       [10:0]  address = {b, a};
  localparam [126:0] PATTERN = 127'h5a3c_91d7_e04f_2b68_c6f1_7a95_0d3e_8b24;

  generate
    for (slot = 0; slot < TABLES; slot = slot + 1) begin : g_table
      localparam                             ADDRESS_BITS = address_bits(slot);
      localparam                             WIDTH        = word_bits(slot);
      localparam                             REPEATED     = (WIDTH << ADDRESS_BITS) / 127 + 1;
      localparam [(WIDTH<<ADDRESS_BITS)-1:0] WORDS        = {REPEATED{PATTERN}};

      wire [WIDTH-1:0] y;

      assign tables[slot] = {{(64 - WIDTH) {1'b0}}, y};

      fixed_table #(
          .ADDRESS_BITS(ADDRESS_BITS),
          .WIDTH       (WIDTH),
          .WORDS       (WORDS),
          .CUTS        (slot % 2)
      ) unit (
          .aclk   (aclk),
          .address(address[ADDRESS_BITS-1:0]),
          .y      (y)
      );
    end
  endgenerate

  // Slot {bits of the number, cuts}.
  generate
    for (slot = 0; slot < FLOATINGS; slot = slot + 1) begin : g_floating
      localparam WIDTH         = number_bits(slot);
      localparam EXPONENT_BITS = (WIDTH > 8) ? 4 : (WIDTH > 4) ? 3 : (WIDTH > 2) ? 2 : 1;

      wire [EXPONENT_BITS+WIDTH-2:0] y;

      assign floatings[slot] = {{(65 - EXPONENT_BITS - WIDTH) {1'b0}}, y};

      fixed_floating #(
          .A_WIDTH      (WIDTH),
          .EXPONENT_BITS(EXPONENT_BITS),
          .CUTS         (slot % 4)
      ) unit (
          .aclk(aclk),
          .a   (address[WIDTH-1:0]),
          .y   (y)
      );
    end
  endgenerate

endmodule

`default_nettype wire
