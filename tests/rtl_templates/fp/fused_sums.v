// fused_sums: fp_fused_sum and fp_fused_comparison in several shapes, only for the regression. The
// slots are {shape, GRADUAL, variant}, the shapes counting slowest; with ALTERNATE they are {shape,
// variant}, and GRADUAL turns from slot to slot. Variant 0 has multipliers and no registers.
// Variant 1 has logic, SOME_CUTS, and CANCELLATION = 1 whatever the shape is.
`default_nettype none

module fused_sums #(
    parameter        EXPONENT_BITS = 3,
    parameter        PRECISION     = 3,
    parameter [29:0] SOME_CUTS     = 30'h0,
    parameter        SHAPES        = (PRECISION < 3) ? 7 : 10,  // sums of more digits can be squared
    parameter        ALTERNATE     = 0,
    parameter        OF_SHAPE      = ALTERNATE ? 2 : 4,
    parameter        SLOTS         = OF_SHAPE * SHAPES
) (
    input wire                               aclk,
    input wire [EXPONENT_BITS+PRECISION-1:0] x0,
    input wire [EXPONENT_BITS+PRECISION-1:0] x1,
    input wire [EXPONENT_BITS+PRECISION-1:0] x2,
    input wire [EXPONENT_BITS+PRECISION-1:0] x3,
    input wire [EXPONENT_BITS+PRECISION-1:0] x4
);

  localparam PACKED = EXPONENT_BITS + PRECISION;

  wire [PACKED-1:0] none = {PACKED{1'b0}};

  // The answers, which the test reads by hierarchical name, as in fp_units.
  wire [63:0] y   [0:SLOTS-1]  /* verilator public_flat_rd */;
  wire        flag[0:SLOTS-1]  /* verilator public_flat_rd */;
  wire [1:0]  order[0:SLOTS-1] /* verilator public_flat_rd */;

  genvar slot;

  generate
    for (slot = 0; slot < SLOTS; slot = slot + 1) begin : built
      localparam SHAPE   = slot / OF_SHAPE;
      localparam VARIANT = slot % 2;
      localparam GRADUAL = ALTERNATE ? (SHAPE + VARIANT) % 2 : slot / 2 % 2;

      localparam ONE_SIGN = (SHAPE == 0) || (SHAPE == 5) || (SHAPE == 7);

      // The shapes: x0^2 + x1^2 + x2^2, x0 x1 - x2 x3, x0 x1 + x2, x0^2 - x1 x2 + x3,
      // x0 + x1 - x2, -x0^2 - ... - x4^2, -x0 x1 + x2 x3 - x4^2 + x1; and, with squared sums, (x0 -
      // x1)^2 + (x2 + x3)^2, (x0 - x1)^2 - (x2 + x3)^2, (x0 + x1)^2 + x2 x3 - x4.
      localparam TERMS = (SHAPE == 1) || (SHAPE == 2) || (SHAPE == 7) || (SHAPE == 8) ? 2
                         : (SHAPE == 5) ? 5 : (SHAPE == 6) ? 4 : 3;
      localparam [TERMS-1:0] SQUARES = (SHAPE == 0) ? 7 : (SHAPE == 3) ? 1 : (SHAPE == 5) ? 31
                                       : (SHAPE == 6) ? 4 : 0;
      localparam [TERMS-1:0] PLAIN = (SHAPE == 2) ? 2 : (SHAPE == 3) ? 4 : (SHAPE == 4) ? 7
                                     : (SHAPE == 6) ? 8 : (SHAPE == 9) ? 4 : 0;
      localparam [TERMS-1:0] SUMS        = (SHAPE == 7) || (SHAPE == 8) ? 2 : (SHAPE == 9) ? 1 : 0;
      localparam [TERMS-1:0] DIFFERENCES = (SHAPE == 7) || (SHAPE == 8) ? 1 : 0;
      localparam [TERMS-1:0] NEGATED = (SHAPE == 1) ? 2 : (SHAPE == 3) ? 2 : (SHAPE == 4) ? 4
                                       : (SHAPE == 5) ? 31 : (SHAPE == 6) ? 5 : (SHAPE == 8) ? 2
                                       : (SHAPE == 9) ? 4 : 0;

      wire [TERMS*PACKED-1:0] a;
      wire [TERMS*PACKED-1:0] b;
      wire [PACKED-1:0]       sum;

      case (SHAPE)
        0, 4: begin : three
          assign a = {x2, x1, x0};
          assign b = {none, none, none};
        end
        1, 7, 8: begin : difference
          assign a = {x2, x0};
          assign b = {x3, x1};
        end
        2: begin : multiply_add
          assign a = {x2, x0};
          assign b = {none, x1};
        end
        3: begin : mixed
          assign a = {x3, x1, x0};
          assign b = {none, x2, none};
        end
        5: begin : five
          assign a = {x4, x3, x2, x1, x0};
          assign b = {none, none, none, none, none};
        end
        9: begin : sum_and_product
          assign a = {x4, x2, x0};
          assign b = {none, x3, x1};
        end
        default: begin : four
          assign a = {x1, x4, x2, x0};
          assign b = {none, none, x3, x1};
        end
      endcase

      fp_fused_sum #(
          .EXPONENT_BITS(EXPONENT_BITS),
          .PRECISION    (PRECISION),
          .TERMS        (TERMS),
          .SQUARES      (SQUARES),
          .PLAIN        (PLAIN),
          .SUMS         (SUMS),
          .DIFFERENCES  (DIFFERENCES),
          .NEGATED      (NEGATED),
          .CANCELLATION (!ONE_SIGN || (VARIANT == 1)),
          .GRADUAL      (GRADUAL),
          .EMBEDDED     (VARIANT == 0),
          .SUM_SELECTS  ((VARIANT == 0) ? 2 : 1),
          .CUTS         ((VARIANT == 1) ? SOME_CUTS : 30'h0)
      ) unit (
          .aclk       (aclk),
          .a          (a),
          .b          (b),
          .y          (sum),
          .exceptional(flag[slot])
      );

      fp_fused_comparison #(
          .EXPONENT_BITS(EXPONENT_BITS),
          .PRECISION    (PRECISION),
          .TERMS        (TERMS),
          .SQUARES      (SQUARES),
          .PLAIN        (PLAIN),
          .SUMS         (SUMS),
          .DIFFERENCES  (DIFFERENCES),
          .NEGATED      (NEGATED),
          .GRADUAL      (GRADUAL),
          .EMBEDDED     (VARIANT == 0),
          .SUM_SELECTS  ((VARIANT == 0) ? 2 : 1),
          .CUTS         ((VARIANT == 1) ? SOME_CUTS[24:0] : 25'h0)
      ) comparison (
          .aclk   (aclk),
          .a      (a),
          .b      (b),
          .verdict(order[slot])
      );

      assign y[slot] = {{(64 - PACKED) {1'b0}}, sum};
    end
  endgenerate

endmodule

`default_nettype wire
