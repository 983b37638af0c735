// fp_units: every floating-point unit in every variant, only for the regression. A slot of the
// answers belongs to {unit, GRADUAL, TOWARD_ZERO, column}, the column counting fastest; the units
// are in the order of `UnitSlot` in units_under_test.cpp. Columns 0 to 2 are masks: no cuts, all,
// SOME_CUTS. Columns 3 to 11 are SOME_CUTS with 1 to 8 and 15 promised: bit 0 for SPECIAL_OPERANDS
// = 0, 1 for OVERFLOW = 0, 2 for UNDERFLOW = 0, 3 for CANCELLATION = 0. If a unit lacks a
// parameter, another one takes its place: see below.
`default_nettype none

module fp_units #(
    parameter         EXPONENT_BITS        = 4,
    parameter         PRECISION            = 4,
    parameter         RESULT_EXPONENT_BITS = 4,
    parameter         RESULT_PRECISION     = 4,
    parameter [127:0] SOME_CUTS            = {64{2'b01}},
    parameter         FIRST_COLUMN         = 0,    // other columns are not built, which saves time
    parameter         LAST_COLUMN          = 2,
    parameter         SLOT                 = 128,  // width of a result, zero-extended
    parameter         SLOTS                = 624
) (
    input wire         aclk,
    input wire [127:0] a,
    input wire [127:0] b,
    input wire         exceptional  // the input of fp_ulp_distance
);

  // The answers, which the test reads by hierarchical name: as one vector they would take most of
  // the simulation's work.
  wire [SLOT-1:0] y    [0:SLOTS-1]  /* verilator public_flat_rd */;
  wire            flag [0:SLOTS-1]  /* verilator public_flat_rd */;  // exceptional or decided

  localparam COLUMNS       = 12;
  localparam UNIT          = 4 * COLUMNS;
  localparam PACKED        = EXPONENT_BITS + PRECISION;
  localparam RESULT_PACKED = RESULT_EXPONENT_BITS + RESULT_PRECISION;

  wire [PACKED-1:0] x0 = a[PACKED-1:0];
  wire [PACKED-1:0] x1 = b[PACKED-1:0];

  genvar gradual;
  genvar toward_zero;
  genvar column;
  genvar subtract;
  genvar guard;

  generate
    for (gradual = 0; gradual < 2; gradual = gradual + 1) begin : with_subnormals
      for (toward_zero = 0; toward_zero < 2; toward_zero = toward_zero + 1) begin : with_rounding
        for (column = FIRST_COLUMN; column <= LAST_COLUMN; column = column + 1) begin : with_cuts
          localparam VARIANT = (gradual * 2 + toward_zero) * COLUMNS + column;
          localparam [127:0] ALL_OR_NONE = {128{column == 1}};
          localparam [127:0] CUTS = (column >= 2) ? SOME_CUTS : ALL_OR_NONE;
          localparam [3:0] COUNTED_UP = (column >= 2) ? column - 2 : 0;
          localparam [3:0] PROMISED = (column == 11) ? 15 : COUNTED_UP;
          localparam SELECTS = (column + gradual + 2 * toward_zero) % 3;

          for (subtract = 0; subtract < 2; subtract = subtract + 1) begin : add
            wire [RESULT_PACKED-1:0] r;
            fp_add #(
                .EXPONENT_BITS       (EXPONENT_BITS),
                .PRECISION           (PRECISION),
                .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
                .RESULT_PRECISION    (RESULT_PRECISION),
                .SUBTRACT            (subtract),
                .SPECIAL_OPERANDS    (!PROMISED[0]),
                .OVERFLOW            (!PROMISED[1]),
                .UNDERFLOW           (!PROMISED[2]),
                .CANCELLATION        (!PROMISED[3]),
                .GRADUAL             (gradual),
                .TOWARD_ZERO         (toward_zero),
                .SUM_SELECTS         (SELECTS),
                .CUTS                (CUTS[13:0])
            ) unit (
                .aclk       (aclk),
                .a          (x0),
                .b          (x1),
                .y          (r),
                .exceptional(flag[UNIT*subtract+VARIANT])
            );
            assign y[UNIT*subtract+VARIANT] = r;
          end

          wire [RESULT_PACKED-1:0] product;
          fp_multiply #(
              .EXPONENT_BITS       (EXPONENT_BITS),
              .PRECISION           (PRECISION),
              .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
              .RESULT_PRECISION    (RESULT_PRECISION),
              .SPECIAL_OPERANDS    (!PROMISED[0]),
              .OVERFLOW            (!PROMISED[1]),
              .UNDERFLOW           (!PROMISED[2]),
              .GRADUAL             (gradual),
              .TOWARD_ZERO         (toward_zero),
              .SUM_SELECTS         (SELECTS),
              .CUTS                (CUTS[14:0])
          ) multiply (
              .aclk       (aclk),
              .a          (x0),
              .b          (x1),
              .y          (product),
              .exceptional(flag[UNIT*2+VARIANT])
          );
          assign y[UNIT*2+VARIANT] = product;

          wire [RESULT_PACKED-1:0] squared;
          fp_square #(
              .EXPONENT_BITS       (EXPONENT_BITS),
              .PRECISION           (PRECISION),
              .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
              .RESULT_PRECISION    (RESULT_PRECISION),
              .SPECIAL_OPERANDS    (!PROMISED[0]),
              .OVERFLOW            (!PROMISED[1]),
              .UNDERFLOW           (!PROMISED[2]),
              .GRADUAL             (gradual),
              .TOWARD_ZERO         (toward_zero),
              .SUM_SELECTS         (SELECTS),
              .CUTS                (CUTS[14:0])
          ) square (
              .aclk       (aclk),
              .a          (x0),
              .y          (squared),
              .exceptional(flag[UNIT*3+VARIANT])
          );
          assign y[UNIT*3+VARIANT] = squared;

          wire [RESULT_PACKED-1:0] quotient;
          fp_divide #(
              .EXPONENT_BITS       (EXPONENT_BITS),
              .PRECISION           (PRECISION),
              .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
              .RESULT_PRECISION    (RESULT_PRECISION),
              .SPECIAL_OPERANDS    (!PROMISED[0]),
              .OVERFLOW            (!PROMISED[1]),
              .UNDERFLOW           (!PROMISED[2]),
              .GRADUAL             (gradual),
              .TOWARD_ZERO         (toward_zero),
              .SUM_SELECTS         (SELECTS),
              .CUTS                (CUTS[RESULT_PRECISION+8:0])
          ) divide (
              .aclk       (aclk),
              .a          (x0),
              .b          (x1),
              .y          (quotient),
              .exceptional(flag[UNIT*4+VARIANT])
          );
          assign y[UNIT*4+VARIANT] = quotient;

          wire [RESULT_PACKED-1:0] root;
          fp_square_root #(
              .EXPONENT_BITS       (EXPONENT_BITS),
              .PRECISION           (PRECISION),
              .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
              .RESULT_PRECISION    (RESULT_PRECISION),
              .SPECIAL_OPERANDS    (!PROMISED[0]),
              .OVERFLOW            (!PROMISED[1]),
              .UNDERFLOW           (!PROMISED[2]),
              .GRADUAL             (gradual),
              .TOWARD_ZERO         (toward_zero),
              .CUTS                (CUTS[RESULT_PRECISION+6:0])
          ) square_root (
              .aclk       (aclk),
              .a          (x0),
              .y          (root),
              .exceptional(flag[UNIT*5+VARIANT])
          );
          assign y[UNIT*5+VARIANT] = root;

          wire [RESULT_PACKED-1:0] converted;
          fp_convert #(
              .EXPONENT_BITS       (EXPONENT_BITS),
              .PRECISION           (PRECISION),
              .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
              .RESULT_PRECISION    (RESULT_PRECISION),
              .SPECIAL_OPERANDS    (!PROMISED[0]),
              .OVERFLOW            (!PROMISED[1]),
              .UNDERFLOW           (!PROMISED[2]),
              .GRADUAL             (gradual),
              .TOWARD_ZERO         (toward_zero),
              .CUTS                (CUTS[5:0])
          ) convert (
              .aclk       (aclk),
              .a          (x0),
              .y          (converted),
              .exceptional(flag[UNIT*6+VARIANT])
          );
          assign y[UNIT*6+VARIANT] = converted;

          wire [RESULT_PACKED-1:0] logic_product;
          fp_multiply #(
              .EXPONENT_BITS       (EXPONENT_BITS),
              .PRECISION           (PRECISION),
              .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
              .RESULT_PRECISION    (RESULT_PRECISION),
              .SPECIAL_OPERANDS    (!PROMISED[0]),
              .OVERFLOW            (!PROMISED[1]),
              .UNDERFLOW           (!PROMISED[2]),
              .GRADUAL             (gradual),
              .TOWARD_ZERO         (toward_zero),
              .SUM_SELECTS         (SELECTS),
              .EMBEDDED            (0),
              .CUTS                (CUTS[14:0])
          ) logic_multiply (
              .aclk       (aclk),
              .a          (x0),
              .b          (x1),
              .y          (logic_product),
              .exceptional(flag[UNIT*7+VARIANT])
          );
          assign y[UNIT*7+VARIANT] = logic_product;

          wire [RESULT_PACKED-1:0] logic_squared;
          fp_square #(
              .EXPONENT_BITS       (EXPONENT_BITS),
              .PRECISION           (PRECISION),
              .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
              .RESULT_PRECISION    (RESULT_PRECISION),
              .SPECIAL_OPERANDS    (!PROMISED[0]),
              .OVERFLOW            (!PROMISED[1]),
              .UNDERFLOW           (!PROMISED[2]),
              .GRADUAL             (gradual),
              .TOWARD_ZERO         (toward_zero),
              .SUM_SELECTS         (SELECTS),
              .EMBEDDED            (0),
              .SPLIT               (column >= 2 && PRECISION <= 65 && CUTS[9]),
              .CUTS                (CUTS[14:0])
          ) logic_square (
              .aclk       (aclk),
              .a          (x0),
              .y          (logic_squared),
              .exceptional(flag[UNIT*8+VARIANT])
          );
          assign y[UNIT*8+VARIANT] = logic_squared;

          // Minimum or maximum takes the place of TOWARD_ZERO.
          wire [PACKED-1:0] extremum;
          fp_minimum_maximum #(
              .EXPONENT_BITS   (EXPONENT_BITS),
              .PRECISION       (PRECISION),
              .MAXIMUM         (toward_zero),
              .SPECIAL_OPERANDS(!PROMISED[0]),
              .OVERFLOW        (!PROMISED[1]),
              .UNDERFLOW       (!PROMISED[2]),
              .GRADUAL         (gradual),
              .CUTS            (CUTS[1:0])
          ) minimum_maximum (
              .aclk       (aclk),
              .a          (x0),
              .b          (x1),
              .y          (extremum),
              .exceptional(flag[UNIT*9+VARIANT])
          );
          assign y[UNIT*9+VARIANT] = extremum;

          // Comparison or interval decision takes the place of TOWARD_ZERO.
          wire [1:0] verdict;
          if (toward_zero == 0) begin : compare
            fp_compare #(
                .EXPONENT_BITS(EXPONENT_BITS),
                .PRECISION    (PRECISION),
                .GRADUAL      (gradual),
                .CUTS         (CUTS[1:0])
            ) unit (
                .aclk   (aclk),
                .a      (x0),
                .b      (x1),
                .verdict(verdict)
            );
            assign flag[UNIT*10+VARIANT] = 1'b0;
          end else begin : interval_decision
            fp_interval_decision #(
                .EXPONENT_BITS(EXPONENT_BITS),
                .PRECISION    (PRECISION),
                .CUTS         (CUTS[0:0])
            ) unit (
                .aclk   (aclk),
                .minimum(x0),
                .maximum(x1),
                .verdict(verdict),
                .decided(flag[UNIT*10+VARIANT])
            );
          end
          assign y[UNIT*10+VARIANT] = verdict;

          // NONNEGATIVE and four guards take the places of GRADUAL and TOWARD_ZERO.
          for (guard = 0; guard < 2; guard = guard + 1) begin : ulp_distance
            localparam [PACKED-1:0] SMALL = guard;
            localparam [PACKED-1:0] LARGE = guard ? ~({PACKED{1'b1}} >> 2) : 5;
            wire [1:0] order;
            fp_ulp_distance #(
                .EXPONENT_BITS(EXPONENT_BITS),
                .PRECISION    (PRECISION),
                .GUARD_ULP    (toward_zero ? LARGE : SMALL),
                .NONNEGATIVE  (gradual),
                .CUTS         (CUTS[1:0])
            ) unit (
                .aclk       (aclk),
                .f          (x0),
                .g          (x1),
                .exceptional(exceptional),
                .verdict    (order),
                .decided    (flag[UNIT*(11+guard)+VARIANT])
            );
            assign y[UNIT*(11+guard)+VARIANT] = order;
          end
        end
      end
    end
  endgenerate

endmodule

`default_nettype wire
