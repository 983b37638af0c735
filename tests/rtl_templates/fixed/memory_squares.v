// memory_squares: squares read from memories, only for the tests. memory_squares_test.cpp describes
// the slots in the same words.
`default_nettype none

module memory_squares #(
    parameter SINGLES = 14,
    parameter PAIRS   = 24
) (
    input wire        aclk,
    input wire [31:0] a,
    input wire [31:0] b
);

  // The answers, which the test reads by hierarchical name: results of a, then of b.
  wire [31:0] results[0:2*(SINGLES+PAIRS)-1]  /* verilator public_flat_rd */;

  genvar slot;

  // Squares of 1 to 13 bits and of 15; pairs of 1 to 12 bits with 1, 5, 9 or 13. A result drops 0
  // to 5 low bits, or none if its square is short. Every second result leaves out the bits that the
  // square of a symmetric range does not need. Slots take turns of three with signed addresses.
  generate
    for (slot = 0; slot < SINGLES; slot = slot + 1) begin : g_singles
      localparam       A       = (slot == 13) ? 15 : slot + 1;
      localparam       DROPPED = (slot % 6 < 2 * A - 2) ? slot % 6 : 0;
      localparam       WIDTH   = 2 * A - DROPPED - slot % 2;
      localparam [2:0] CUTS    = {slot / 2 % 2 == 1, 1'b1, slot % 2 == 1};

      wire [WIDTH-1:0] y;

      assign results[slot]       = {{(32 - WIDTH) {1'b0}}, y};
      assign results[slot+SINGLES+PAIRS] = 32'b0;

      fixed_memory_square #(
          .A_WIDTH       (A),
          .DROPPED       (DROPPED),
          .WIDTH         (WIDTH),
          .SIGNED_ADDRESS(slot / 3 % 2),
          .CUTS          (CUTS)
      ) unit (
          .aclk(aclk),
          .a   (a[A-1:0]),
          .y   (y)
      );
    end
    for (slot = SINGLES; slot < SINGLES + PAIRS; slot = slot + 1) begin : g_pairs
      localparam       A         = (slot - SINGLES) / 4 * 2 + 1 + slot % 2;
      localparam       B         = (slot - SINGLES) % 4 * 4 + 1;
      localparam       DROPPED_A = (slot % 6 < 2 * A - 2) ? slot % 6 : 0;
      localparam       DROPPED_B = (slot % 5 < 2 * B - 2) ? slot % 5 : 0;
      localparam       WIDTH_A   = 2 * A - DROPPED_A - slot % 2;
      localparam       WIDTH_B   = 2 * B - DROPPED_B - slot / 4 % 2;
      localparam [2:0] CUTS      = {slot / 2 % 2 == 1, 1'b1, slot % 3 == 1};

      wire [WIDTH_A-1:0] y_a;
      wire [WIDTH_B-1:0] y_b;

      assign results[slot]       = {{(32 - WIDTH_A) {1'b0}}, y_a};
      assign results[slot+SINGLES+PAIRS] = {{(32 - WIDTH_B) {1'b0}}, y_b};

      fixed_memory_squares #(
          .A_WIDTH       (A),
          .B_WIDTH       (B),
          .DROPPED_A     (DROPPED_A),
          .DROPPED_B     (DROPPED_B),
          .WIDTH_A       (WIDTH_A),
          .WIDTH_B       (WIDTH_B),
          .SIGNED_ADDRESS(slot / 3 % 2),
          .CUTS          (CUTS)
      ) unit (
          .aclk(aclk),
          .a   (a[A-1:0]),
          .b   (b[B-1:0]),
          .y_a (y_a),
          .y_b (y_b)
      );
    end
  endgenerate

endmodule

`default_nettype wire
