// fixed_memory_squares: the squares of a and b, each less its DROPPED low bits, read at the two
// ports of one memory.
// Latency: the population count of CUTS (three bits); initiation interval 1; no reset. CUTS[1] is
// 1, since a block memory is read into a register.
// Operands are in two's complement.
//
// The two lowest bits of a square take no memory: bit 0 is that of the operand, bit 1 is 0.
//
// SIGNED_ADDRESS = 1: the memory has a word for each operand, and nothing removes signs.
//
// SIGNED_ADDRESS = 0: the memory has a word for each magnitude below 2^ADDRESS_BITS, half as many.
// Only the most negative operand has the magnitude 2^ADDRESS_BITS. Its low bits address word 0,
// which is 0, and its square is a single one above the bits of all words.
`default_nettype none

module fixed_memory_squares #(
  parameter       A_WIDTH        = 8,      // bits of a, 1 to 15
  parameter       B_WIDTH        = 8,      // bits of b, 1 to 15
  parameter       DROPPED_A      = 0,      // low bits of the square that y_a lacks, 0 or more
  parameter       DROPPED_B      = 0,      // low bits of the square that y_b lacks, 0 or more
  // bits of y_a and y_b, as their ranges need; 1 to twice the operand's less those dropped
  parameter       WIDTH_A        = 16,
  parameter       WIDTH_B        = 16,
  parameter       SIGNED_ADDRESS = 0,      // 1: operands address words; 0: magnitudes do
  parameter [2:0] CUTS           = 3'b010  // a register behind stage k if bit k is 1; bit 1 is 1
) (
  input  wire               aclk,
  input  wire [A_WIDTH-1:0] a,
  input  wire [B_WIDTH-1:0] b,
  output wire [WIDTH_A-1:0] y_a,
  output wire [WIDTH_B-1:0] y_b
);

  localparam WIDER        = (A_WIDTH > B_WIDTH) ? A_WIDTH : B_WIDTH;
  localparam WIDEST       = (WIDER > 15) ? 15 : WIDER;
  localparam OPERAND      = (WIDEST < 3) ? 3 : WIDEST;
  localparam ADDRESS_BITS = (SIGNED_ADDRESS != 0) ? OPERAND : OPERAND - 1;
  localparam SQUARE       = 2 * OPERAND;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((A_WIDTH < 1) || (A_WIDTH > 15)) begin : g_refused_a
      A_WIDTH_is_not_1_to_15 refused ();
    end else if (DROPPED_A < 0) begin : g_refused_dropped_a
      DROPPED_A_is_below_0 refused ();
    end else if ((WIDTH_A < 1) || (WIDTH_A + DROPPED_A > 2 * A_WIDTH)) begin : g_refused_width_a
      WIDTH_A_is_not_1_to_that_of_the_square refused ();
    end
    if ((B_WIDTH < 1) || (B_WIDTH > 15)) begin : g_refused_b
      B_WIDTH_is_not_1_to_15 refused ();
    end else if (DROPPED_B < 0) begin : g_refused_dropped_b
      DROPPED_B_is_below_0 refused ();
    end else if ((WIDTH_B < 1) || (WIDTH_B + DROPPED_B > 2 * B_WIDTH)) begin : g_refused_width_b
      WIDTH_B_is_not_1_to_that_of_the_square refused ();
    end
    if ((SIGNED_ADDRESS != 0) && (SIGNED_ADDRESS != 1)) begin : g_refused_address
      SIGNED_ADDRESS_is_not_0_or_1 refused ();
    end
    if (!CUTS[1]) begin : g_refused_cuts CUTS_has_no_register_behind_the_memory refused (); end
  endgenerate

  // The memory stores bits HIGH-1 to LOW of a square: those that one of the results needs.
  localparam END_A   = WIDTH_A + DROPPED_A;
  localparam END_B   = WIDTH_B + DROPPED_B;
  localparam END     = (END_A > END_B) ? END_A : END_B;
  localparam DROPPED = (DROPPED_A < DROPPED_B) ? DROPPED_A : DROPPED_B;
  localparam LOW     = (DROPPED < 2) ? 2 : DROPPED;
  localparam TOP     = (END > 2 * ADDRESS_BITS) ? 2 * ADDRESS_BITS : END;
  localparam HIGH    = (TOP > LOW) ? TOP : LOW + 1;

  (* ram_style = "block", rom_style = "block" *)
  reg [HIGH-1:LOW] words [0:(1<<ADDRESS_BITS)-1];

  // Each word has its own initial statement, in two loops. Yosys 0.23 spends 27 s on one statement
  // with 2^13 turns, 3 s on these. Verilator repeats a generate loop at most 1024 times.
  localparam COLUMN_BITS = ADDRESS_BITS / 2;
  localparam COLUMNS     = 1 << COLUMN_BITS;
  localparam ROWS        = 1 << (ADDRESS_BITS - COLUMN_BITS);

  genvar row;
  genvar column;
  generate
    for (row = 0; row < ROWS; row = row + 1) begin : g_row
      for (column = 0; column < COLUMNS; column = column + 1) begin : g_word
        localparam              ADDRESS   = row * COLUMNS + column;
        localparam              NEGATIVE  = (ADDRESS >= (1 << (OPERAND - 1))) ? 1 : 0;
        localparam              MAGNITUDE = (NEGATIVE != 0) ? (1 << OPERAND) - ADDRESS : ADDRESS;
        localparam [SQUARE-1:0] WORD      = MAGNITUDE * MAGNITUDE;

        initial words[ADDRESS] = WORD[HIGH-1:LOW];
      end
    end
  endgenerate

  // Both squares, with a zero above each.
  wire [A_WIDTH+B_WIDTH-1:0] operands = {b, a};
  wire [2*(SQUARE+1)-1:0]    squares;
  wire                       unused_bits = ^squares;

  genvar port;
  generate
    for (port = 0; port < 2; port = port + 1) begin : g_port
      localparam OWN   = (port == 0) ? A_WIDTH : B_WIDTH;
      localparam FIRST = (port == 0) ? 0 : A_WIDTH;

      // Stage magnitude; -x is ~x + 1.
      wire [OWN-1:0]     s0_x = operands[FIRST+:OWN];
      wire [OPERAND-1:0] s0_address;

      if (SIGNED_ADDRESS != 0) begin : g_signed
        assign s0_address = {{(OPERAND - OWN) {s0_x[OWN-1]}}, s0_x};
      end else begin : g_magnitude
        wire           s0_negative = s0_x[OWN-1];
        wire [OWN-1:0] s0_one      = {{(OWN - 1) {1'b0}}, s0_negative};
        wire [OWN-1:0] s0_absolute = (s0_x ^ {OWN{s0_negative}}) + s0_one;

        assign s0_address = {{(OPERAND - OWN) {1'b0}}, s0_absolute};
      end

      wire [OPERAND-1:0] s1_address;

      fp_rank #(
        .WIDTH     (OPERAND),
        .REGISTERED(CUTS[0])
      ) rank_0 (
        .aclk(aclk),
        .d   (s0_address),
        .q   (s1_address)
      );

      // Stage read.
      reg [HIGH-1:LOW] s2_word_q;
      reg              s2_odd_q;
      reg              s2_top_q;

      always @(posedge aclk) begin
        s2_word_q <= words[s1_address[ADDRESS_BITS-1:0]];
        s2_odd_q  <= s1_address[0];
        s2_top_q  <= s1_address[OPERAND-1];
      end

      // Stage output.
      wire [SQUARE:0] s2_below    = {{(SQUARE + 1 - HIGH) {1'b0}}, s2_word_q,
                                     {(LOW - 1) {1'b0}}, s2_odd_q};
      wire            s2_beyond   = (SIGNED_ADDRESS == 0) && s2_top_q;
      wire [SQUARE:0] s2_greatest = {2'b00, s2_beyond, {(SQUARE - 2) {1'b0}}};

      assign squares[port*(SQUARE+1)+:SQUARE+1] = s2_below | s2_greatest;
    end
  endgenerate

  fp_rank #(
    .WIDTH     (WIDTH_A),
    .REGISTERED(CUTS[2])
  ) rank_a (
    .aclk(aclk),
    .d   (squares[DROPPED_A+:WIDTH_A]),
    .q   (y_a)
  );
  fp_rank #(
    .WIDTH     (WIDTH_B),
    .REGISTERED(CUTS[2])
  ) rank_b (
    .aclk(aclk),
    .d   (squares[SQUARE+1+DROPPED_B+:WIDTH_B]),
    .q   (y_b)
  );

endmodule

`default_nettype wire
