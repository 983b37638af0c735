// bound_units: every error-bound unit under every mask, only for the tests. A slot of the answers
// belongs to {unit, mask}, the mask counting fastest; the units are in the order of `Unit` in
// bound_units_test.cpp.
`default_nettype none

module bound_units #(
    parameter EXPONENT_BITS   = 4,
    parameter PRECISION       = 4,
    parameter BOUND_PRECISION = 3,
    parameter SLOT            = 64,  // width of an answer, zero-extended
    parameter SLOTS           = 68
) (
    input wire        aclk,
    input wire [63:0] x,
    input wire [63:0] a,
    input wire [63:0] b,
    input wire        exceptional
);

  // The answers, which the test reads by their hierarchical names: as one vector they would take
  // most of the simulation's work.
  wire [SLOT-1:0] y[0:SLOTS-1]  /* verilator public_flat_rd */;

  localparam PACKED    = EXPONENT_BITS + PRECISION;
  localparam MAGNITUDE = PACKED - 1;
  localparam BOUND     = EXPONENT_BITS + BOUND_PRECISION - 1;

  // The limits of the range checks, in as many leading bits as the check below has.
  localparam [MAGNITUDE-1:0] FINITE_LEAST    = 1;
  localparam [MAGNITUDE-1:0] FINITE_GREATEST = (1 << EXPONENT_BITS) - 2;
  localparam [MAGNITUDE-1:0] INNER_LEAST     = 3;
  localparam [MAGNITUDE-1:0] INNER_GREATEST  = 1 << EXPONENT_BITS;

  wire [PACKED-1:0] value   = x[PACKED-1:0];
  wire [BOUND-1:0]  bound_a = a[BOUND-1:0];
  wire [BOUND-1:0]  bound_b = b[BOUND-1:0];

  genvar mask;
  genvar gradual;
  genvar guard;

  generate
    for (mask = 0; mask < 4; mask = mask + 1) begin : with_cuts
      localparam [1:0] CUTS = mask;

      for (gradual = 0; gradual < 2; gradual = gradual + 1) begin : with_subnormals
        wire [BOUND-1:0] magnitude_y;
        bound_magnitude #(
            .EXPONENT_BITS  (EXPONENT_BITS),
            .PRECISION      (PRECISION),
            .BOUND_PRECISION(BOUND_PRECISION),
            .GRADUAL        (gradual),
            .CUTS           (CUTS)
        ) magnitude (
            .aclk(aclk),
            .x   (value),
            .y   (magnitude_y)
        );
        assign y[4*gradual+mask] = magnitude_y;

        wire [BOUND-1:0] binade_y;
        bound_binade #(
            .EXPONENT_BITS  (EXPONENT_BITS),
            .PRECISION      (PRECISION),
            .BOUND_PRECISION(BOUND_PRECISION),
            .GRADUAL        (gradual),
            .CUTS           (CUTS[0])
        ) binade (
            .aclk(aclk),
            .x   (value),
            .y   (binade_y)
        );
        assign y[4*(2+gradual)+mask] = binade_y;
      end

      wire [BOUND-1:0] reciprocal_y;
      bound_reciprocal #(
          .EXPONENT_BITS  (EXPONENT_BITS),
          .PRECISION      (PRECISION),
          .BOUND_PRECISION(BOUND_PRECISION),
          .CUTS           (CUTS[0])
      ) reciprocal (
          .aclk(aclk),
          .x   (value),
          .y   (reciprocal_y)
      );
      assign y[4*4+mask] = reciprocal_y;

      wire [BOUND-1:0] add_y;
      bound_add #(
          .EXPONENT_BITS  (EXPONENT_BITS),
          .BOUND_PRECISION(BOUND_PRECISION),
          .CUTS           (CUTS)
      ) add (
          .aclk(aclk),
          .a   (bound_a),
          .b   (bound_b),
          .y   (add_y)
      );
      assign y[4*5+mask] = add_y;

      wire [BOUND-1:0] multiply_y;
      bound_multiply #(
          .EXPONENT_BITS  (EXPONENT_BITS),
          .BOUND_PRECISION(BOUND_PRECISION),
          .CUTS           (CUTS)
      ) multiply (
          .aclk(aclk),
          .a   (bound_a),
          .b   (bound_b),
          .y   (multiply_y)
      );
      assign y[4*6+mask] = multiply_y;

      wire [BOUND-1:0] maximum_y;
      bound_maximum #(
          .EXPONENT_BITS  (EXPONENT_BITS),
          .BOUND_PRECISION(BOUND_PRECISION),
          .CUTS           (CUTS[0])
      ) maximum (
          .aclk(aclk),
          .a   (bound_a),
          .b   (bound_b),
          .y   (maximum_y)
      );
      assign y[4*7+mask] = maximum_y;

      wire holds;
      bound_at_most #(
          .EXPONENT_BITS  (EXPONENT_BITS),
          .PRECISION      (PRECISION),
          .BOUND_PRECISION(BOUND_PRECISION),
          .CUTS           (CUTS[0])
      ) at_most (
          .aclk (aclk),
          .bound(bound_a),
          .x    (value),
          .holds(holds)
      );
      assign y[4*8+mask] = holds;

      // The guards: some fit below the bound's digits, some do not, and one is exceeded by nothing.
      for (guard = 0; guard < 4; guard = guard + 1) begin : with_guard
        localparam [PACKED-1:0] SMALL = guard ? 5 : 0;
        localparam [PACKED-1:0] LARGE = {PACKED{1'b1}} >> ((guard == 3) ? 0 : 4);

        wire [1:0] verdict;
        wire       decided;
        bound_decision #(
            .EXPONENT_BITS  (EXPONENT_BITS),
            .PRECISION      (PRECISION),
            .BOUND_PRECISION(BOUND_PRECISION),
            .GUARD_ULP      ((guard < 2) ? SMALL : LARGE),
            .CUTS           (CUTS)
        ) decision (
            .aclk       (aclk),
            .difference (value),
            .bound      (bound_a),
            .exceptional(exceptional),
            .verdict    (verdict),
            .decided    (decided)
        );
        assign y[4*(9+guard)+mask] = {decided, verdict};
      end

      wire [3:0] fails;
      fp_range_check #(
          .EXPONENT_BITS(EXPONENT_BITS),
          .PRECISION    (PRECISION),
          .SIGN         (1),
          .CUTS         (CUTS[0])
      ) sign_alone (
          .aclk (aclk),
          .x    (value),
          .fails(fails[0])
      );
      fp_range_check #(
          .EXPONENT_BITS(EXPONENT_BITS),
          .PRECISION    (PRECISION),
          .LEADING_BITS (EXPONENT_BITS),
          .LEAST        (FINITE_LEAST),
          .GREATEST     (FINITE_GREATEST),
          .CUTS         (CUTS[0])
      ) normal_numbers (
          .aclk (aclk),
          .x    (value),
          .fails(fails[1])
      );
      fp_range_check #(
          .EXPONENT_BITS(EXPONENT_BITS),
          .PRECISION    (PRECISION),
          .SIGN         (2),
          .LEADING_BITS (EXPONENT_BITS + 1),
          .LEAST        (INNER_LEAST),
          .GREATEST     (INNER_GREATEST),
          .CUTS         (CUTS[0])
      ) inner (
          .aclk (aclk),
          .x    (value),
          .fails(fails[2])
      );
      fp_range_check #(
          .EXPONENT_BITS(EXPONENT_BITS),
          .PRECISION    (PRECISION),
          .LEADING_BITS (MAGNITUDE),
          .GREATEST     ({MAGNITUDE{1'b1}}),
          .CUTS         (CUTS[0])
      ) anything (
          .aclk (aclk),
          .x    (value),
          .fails(fails[3])
      );
      assign y[4*13+mask] = fails[0];
      assign y[4*14+mask] = fails[1];
      assign y[4*15+mask] = fails[2];
      assign y[4*16+mask] = fails[3];
    end
  endgenerate

endmodule

`default_nettype wire
