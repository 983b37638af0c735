// fp_units: every floating-point unit in every variant, for the regression alone. A slot of the
// answers belongs to {unit, GRADUAL, TOWARD_ZERO, mask}, the mask counting fastest; the units are
// in the order of `unit_slots` in units_under_test.cpp. Where a unit lacks a parameter, another
// takes its place: see below.
`default_nettype none

module fp_units #(
    parameter         EXPONENT_BITS        = 4,
    parameter         PRECISION            = 4,
    parameter         RESULT_EXPONENT_BITS = 4,
    parameter         RESULT_PRECISION     = 4,
    parameter [127:0] SOME_CUTS            = {64{2'b01}},
    parameter         FIRST_MASK           = 0,    // 2: SOME_CUTS alone, to build in less time
    parameter         SLOT                 = 128,  // width of a result, zero-extended
    parameter         SLOTS                = 132
) (
    input wire         aclk,
    input wire [127:0] a,
    input wire [127:0] b,
    input wire         exceptional  // of fp_ulp_distance
);

  // Read by hierarchical name: as one vector it would be most of the simulation's work.
  wire [SLOT-1:0] y    [0:SLOTS-1]  /* verilator public_flat_rd */;
  wire            flag [0:SLOTS-1]  /* verilator public_flat_rd */;  // exceptional or decided

  localparam PACKED        = EXPONENT_BITS + PRECISION;
  localparam RESULT_PACKED = RESULT_EXPONENT_BITS + RESULT_PRECISION;

  wire [PACKED-1:0] x0 = a[PACKED-1:0];
  wire [PACKED-1:0] x1 = b[PACKED-1:0];

  genvar gradual;
  genvar toward_zero;
  genvar mask;
  genvar subtract;
  genvar guard;

  generate
    for (gradual = 0; gradual < 2; gradual = gradual + 1) begin : with_subnormals
      for (toward_zero = 0; toward_zero < 2; toward_zero = toward_zero + 1) begin : with_rounding
        for (mask = FIRST_MASK; mask < 3; mask = mask + 1) begin : with_cuts
          localparam VARIANT = (gradual * 2 + toward_zero) * 3 + mask;
          localparam [127:0] ALL_OR_NONE = {128{mask == 1}};
          localparam [127:0] CUTS = (mask == 2) ? SOME_CUTS : ALL_OR_NONE;

          for (subtract = 0; subtract < 2; subtract = subtract + 1) begin : add
            wire [RESULT_PACKED-1:0] r;
            fp_add #(
                .EXPONENT_BITS       (EXPONENT_BITS),
                .PRECISION           (PRECISION),
                .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
                .RESULT_PRECISION    (RESULT_PRECISION),
                .SUBTRACT            (subtract),
                .GRADUAL             (gradual),
                .TOWARD_ZERO         (toward_zero),
                .CUTS                (CUTS[8:0])
            ) unit (
                .aclk       (aclk),
                .a          (x0),
                .b          (x1),
                .y          (r),
                .exceptional(flag[12*subtract+VARIANT])
            );
            assign y[12*subtract+VARIANT] = r;
          end

          wire [RESULT_PACKED-1:0] product;
          fp_multiply #(
              .EXPONENT_BITS       (EXPONENT_BITS),
              .PRECISION           (PRECISION),
              .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
              .RESULT_PRECISION    (RESULT_PRECISION),
              .GRADUAL             (gradual),
              .TOWARD_ZERO         (toward_zero),
              .CUTS                (CUTS[8:0])
          ) multiply (
              .aclk       (aclk),
              .a          (x0),
              .b          (x1),
              .y          (product),
              .exceptional(flag[12*2+VARIANT])
          );
          assign y[12*2+VARIANT] = product;

          wire [RESULT_PACKED-1:0] squared;
          fp_square #(
              .EXPONENT_BITS       (EXPONENT_BITS),
              .PRECISION           (PRECISION),
              .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
              .RESULT_PRECISION    (RESULT_PRECISION),
              .GRADUAL             (gradual),
              .TOWARD_ZERO         (toward_zero),
              .CUTS                (CUTS[8:0])
          ) square (
              .aclk       (aclk),
              .a          (x0),
              .y          (squared),
              .exceptional(flag[12*3+VARIANT])
          );
          assign y[12*3+VARIANT] = squared;

          wire [RESULT_PACKED-1:0] quotient;
          fp_divide #(
              .EXPONENT_BITS       (EXPONENT_BITS),
              .PRECISION           (PRECISION),
              .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
              .RESULT_PRECISION    (RESULT_PRECISION),
              .GRADUAL             (gradual),
              .TOWARD_ZERO         (toward_zero),
              .CUTS                (CUTS[RESULT_PRECISION+7:0])
          ) divide (
              .aclk       (aclk),
              .a          (x0),
              .b          (x1),
              .y          (quotient),
              .exceptional(flag[12*4+VARIANT])
          );
          assign y[12*4+VARIANT] = quotient;

          wire [RESULT_PACKED-1:0] root;
          fp_square_root #(
              .EXPONENT_BITS       (EXPONENT_BITS),
              .PRECISION           (PRECISION),
              .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
              .RESULT_PRECISION    (RESULT_PRECISION),
              .GRADUAL             (gradual),
              .TOWARD_ZERO         (toward_zero),
              .CUTS                (CUTS[RESULT_PRECISION+5:0])
          ) square_root (
              .aclk       (aclk),
              .a          (x0),
              .y          (root),
              .exceptional(flag[12*5+VARIANT])
          );
          assign y[12*5+VARIANT] = root;

          wire [RESULT_PACKED-1:0] converted;
          fp_convert #(
              .EXPONENT_BITS       (EXPONENT_BITS),
              .PRECISION           (PRECISION),
              .RESULT_EXPONENT_BITS(RESULT_EXPONENT_BITS),
              .RESULT_PRECISION    (RESULT_PRECISION),
              .GRADUAL             (gradual),
              .TOWARD_ZERO         (toward_zero),
              .CUTS                (CUTS[4:0])
          ) convert (
              .aclk       (aclk),
              .a          (x0),
              .y          (converted),
              .exceptional(flag[12*6+VARIANT])
          );
          assign y[12*6+VARIANT] = converted;

          // Takes the rounding's place: minimum or maximum.
          wire [PACKED-1:0] extremum;
          fp_minimum_maximum #(
              .EXPONENT_BITS(EXPONENT_BITS),
              .PRECISION    (PRECISION),
              .MAXIMUM      (toward_zero),
              .GRADUAL      (gradual),
              .CUTS         (CUTS[1:0])
          ) minimum_maximum (
              .aclk       (aclk),
              .a          (x0),
              .b          (x1),
              .y          (extremum),
              .exceptional(flag[12*7+VARIANT])
          );
          assign y[12*7+VARIANT] = extremum;

          // Takes the rounding's place: comparison or interval decision.
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
            assign flag[12*8+VARIANT] = 1'b0;
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
                .decided(flag[12*8+VARIANT])
            );
          end
          assign y[12*8+VARIANT] = verdict;

          // Take the subnormals' and the rounding's place: NONNEGATIVE and four guards.
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
                .decided    (flag[12*(9+guard)+VARIANT])
            );
            assign y[12*(9+guard)+VARIANT] = order;
          end
        end
      end
    end
  endgenerate

endmodule

`default_nettype wire
