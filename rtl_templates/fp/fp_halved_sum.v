// fp_halved_sum: a + b + carry, modulo 2^WIDTH. With the cut, the lower half of the bits is added
// in front of it and the upper half behind it, so each carry chain has half the length.
// Latency: CUTS; initiation interval 1; no reset.
`default_nettype none

module fp_halved_sum #(
  parameter       WIDTH = 8,    // bits of each operand, 2 or more
  parameter       GATED = 0,    // 1: gates compute `b`, as in fp_chain_sum
  parameter [0:0] CUTS  = 1'b0  // 1: registers between lower and upper half
) (
  input  wire             aclk,
  input  wire [WIDTH-1:0] a,
  input  wire [WIDTH-1:0] b,
  input  wire             carry,
  output wire [WIDTH-1:0] sum
);

  localparam LOWER = WIDTH / 2;
  localparam UPPER = WIDTH - LOWER;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 2) begin : g_refused_width WIDTH_is_below_2 refused (); end
  endgenerate

  generate
    if (CUTS != 0) begin : g_halves
      wire [LOWER:0]   s0_lower;
      wire [UPPER-1:0] s1_a;
      wire [UPPER-1:0] s1_b;
      wire             s1_carry;
      wire [LOWER-1:0] s1_lower;
      wire [UPPER-1:0] s1_upper;

      fp_chain_sum #(
        .WIDTH(LOWER + 1),
        .GATED(GATED)
      ) s0_sum (
        .a    ({1'b0, a[LOWER-1:0]}),
        .b    ({1'b0, b[LOWER-1:0]}),
        .carry(carry),
        .sum  (s0_lower)
      );

      fp_rank #(
        .WIDTH(2 * UPPER + LOWER + 1)
      ) rank_0 (
        .aclk(aclk),
        .d   ({a[WIDTH-1:LOWER], b[WIDTH-1:LOWER], s0_lower}),
        .q   ({s1_a, s1_b, s1_carry, s1_lower})
      );

      // Behind the cut both operands are registers, so GATED would gain nothing.
      fp_chain_sum #(
        .WIDTH(UPPER)
      ) s1_sum (
        .a    (s1_a),
        .b    (s1_b),
        .carry(s1_carry),
        .sum  (s1_upper)
      );

      assign sum = {s1_upper, s1_lower};
    end else begin : g_whole
      wire unused_aclk = aclk;

      fp_chain_sum #(
        .WIDTH(WIDTH),
        .GATED(GATED)
      ) whole (
        .a    (a),
        .b    (b),
        .carry(carry),
        .sum  (sum)
      );
    end
  endgenerate

endmodule

`default_nettype wire
