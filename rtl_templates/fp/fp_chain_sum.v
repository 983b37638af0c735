// fp_chain_sum: a + b + carry, modulo 2^WIDTH, in one carry chain. Combinational.
// GATED = 1 says that `b` comes from gates: look-up tables with inputs to spare take them in, in
// front of the chain. The chain itself reads `a` alone then, as the minuend of a subtraction; of a
// sum Yosys takes either operand.
`default_nettype none

module fp_chain_sum #(
  parameter WIDTH = 8,
  parameter GATED = 0
) (
  input  wire [WIDTH-1:0] a,
  input  wire [WIDTH-1:0] b,
  input  wire             carry,
  output wire [WIDTH-1:0] sum
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (WIDTH < 1) begin : g_refused_width
      WIDTH_is_below_1 refused ();
    end
  endgenerate

  // A carry enters as a carry, or no borrow, out of an extra last place.
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
