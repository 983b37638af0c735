// fixed_memory_square: the square of a, less its DROPPED low bits, read from a memory.
// Latency: the population count of CUTS (three bits); initiation interval 1; no reset.
// The operand is in two's complement.
`default_nettype none

module fixed_memory_square #(
  parameter       A_WIDTH        = 8,      // bits of a, 1 to 15
  parameter       DROPPED        = 0,      // low bits of the square that y lacks, 0 or more
  // bits of y, as its range needs; 1 to 2 A_WIDTH - DROPPED
  parameter       WIDTH          = 16,
  parameter       SIGNED_ADDRESS = 0,      // 1: the operand addresses a word; 0: its magnitude does
  parameter [2:0] CUTS           = 3'b010  // a register behind stage k if bit k is 1; bit 1 is 1
) (
  input  wire               aclk,
  input  wire [A_WIDTH-1:0] a,
  output wire [WIDTH-1:0]   y
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((A_WIDTH < 1) || (A_WIDTH > 15)) begin : g_refused_a
      A_WIDTH_is_not_1_to_15 refused ();
    end else if (DROPPED < 0) begin : g_refused_dropped
      DROPPED_is_below_0 refused ();
    end else if ((WIDTH < 1) || (WIDTH + DROPPED > 2 * A_WIDTH)) begin : g_refused_width
      WIDTH_is_not_1_to_that_of_the_square refused ();
    end
    if ((SIGNED_ADDRESS != 0) && (SIGNED_ADDRESS != 1)) begin : g_refused_address
      SIGNED_ADDRESS_is_not_0_or_1 refused ();
    end
    if (!CUTS[1]) begin : g_refused_cuts CUTS_has_no_register_behind_the_memory refused (); end
  endgenerate

  // The second port reads nothing; synthesis removes it.
  wire [WIDTH-1:0] unread;
  wire             unused_bits = ^unread;

  fixed_memory_squares #(
    .A_WIDTH       (A_WIDTH),
    .B_WIDTH       (A_WIDTH),
    .DROPPED_A     (DROPPED),
    .DROPPED_B     (DROPPED),
    .WIDTH_A       (WIDTH),
    .WIDTH_B       (WIDTH),
    .SIGNED_ADDRESS(SIGNED_ADDRESS),
    .CUTS          (CUTS)
  ) both (
    .aclk(aclk),
    .a   (a),
    .b   ({A_WIDTH{1'b0}}),
    .y_a (y),
    .y_b (unread)
  );

endmodule

`default_nettype wire
