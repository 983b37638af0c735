// fp_chain_sum: a + b + carry, modulo 2^WIDTH, in one carry chain. Combinational.
// GATED writes the sum as a - ~b - 1. A carry cell reads one operand directly as well, and that has
// to be `a`. Yosys uses the minuend of a subtraction there, but either operand of an addition.
`default_nettype none

module fp_chain_sum #(
  parameter WIDTH = 8,  // bits of each operand, 1 or more
  parameter GATED = 0   // 1: gates that compute `b` should share the chain's look-up tables
) (
  input  wire [WIDTH-1:0] a,
  input  wire [WIDTH-1:0] b,
  input  wire             carry,
  output wire [WIDTH-1:0] sum
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
  endgenerate

  // The carry enters through an extra last place, as its carry out or, inverted, as its borrow out.
  wire unused_place;

  generate
    if (GATED != 0) begin : g_gated
      assign {sum, unused_place} = {a, 1'b0} - {~b, !carry};
    end else begin : g_plain
      assign {sum, unused_place} = {a, 1'b1} + {b, carry};
    end
  endgenerate

endmodule

`default_nettype wire
