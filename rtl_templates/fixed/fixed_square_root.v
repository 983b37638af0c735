// fixed_square_root: the square root of a * 2^SHIFT, rounded down to an integer; one bit a stage.
// Latency: the population count of CUTS (WIDTH bits); initiation interval 1; no reset.
// a is unsigned. The root must be below 2^WIDTH.
`default_nettype none

module fixed_square_root #(
  parameter             A_WIDTH = 28,  // bits of a, 1 or more, above -SHIFT
  // exponent of a power of two; below 0, it drops low bits of a
  parameter             SHIFT   = 0,
  parameter             WIDTH   = 14,  // bits of the root, 1 or more
  parameter [WIDTH-1:0] CUTS    = 0    // a register behind digit k where bit k is 1
) (
  input  wire               aclk,
  input  wire [A_WIDTH-1:0] a,
  output wire [WIDTH-1:0]   y
);

  localparam UP       = (SHIFT > 0) ? SHIFT : 0;
  localparam DOWN     = (SHIFT < 0) ? -SHIFT : 0;
  localparam ROOT     = (WIDTH < 1) ? 1 : WIDTH;  // 1 if WIDTH is refused
  localparam RADICAND = 2 * ROOT;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if (A_WIDTH <= DOWN) begin : g_refused_a A_WIDTH_is_not_above_what_SHIFT_drops refused (); end
  endgenerate

  // The bits that the root depends on; higher bits are zero.
  wire [RADICAND+UP+A_WIDTH-1:0] s0_shifted  = {{(RADICAND + UP) {1'b0}}, a} << UP;
  wire [RADICAND-1:0]            s0_radicand = s0_shifted[DOWN+:RADICAND];
  wire                           unused_bits = ^s0_shifted;

  // Stages digit 0 to ROOT - 1, non-restoring. Let Q be the root's bits so far. At first and after
  // a 1, subtract 4Q + 1 from the remainder; after a 0, add 4Q + 3. The sign of the new remainder
  // is the next bit.
  genvar k;
  generate
    for (k = 0; k < ROOT; k = k + 1) begin : g_digit
      // The remainder is at most twice the root of k + 1 bits, with a sign.
      localparam REMAINDER = k + 3;

      wire [REMAINDER-3:0]      above;     // the remainder so far
      wire [RADICAND-2*k-1:0]   radicand;  // bits not yet used; each stage takes two
      wire [REMAINDER-1:0]      change;
      wire [REMAINDER-1:0]      remainder =
          {above, radicand[RADICAND-2*k-1:RADICAND-2*k-2]} + change;
      wire                      next_bit  = !remainder[REMAINDER-1];
      wire [k:0]                root;      // the root with its next bit
      wire [k:0]                next_root;

      if (k == 0) begin : g_first
        assign above    = 1'b0;
        assign radicand = s0_radicand;
        assign change   = 3'b111;
        assign root     = next_bit;
      end else begin : g_later
        wire [k-1:0] known = g_digit[k-1].next_root;

        assign above    = g_digit[k-1].g_more.next_remainder;
        assign radicand = g_digit[k-1].g_more.next_radicand;
        assign change   = {known[0], known ^ {k{known[0]}}, 2'b11};
        assign root     = {known, next_bit};
      end

      fp_rank #(
        .WIDTH     (k + 1),
        .REGISTERED(CUTS[k])
      ) rank_root (
        .aclk(aclk),
        .d   (root),
        .q   (next_root)
      );

      if (k + 1 < ROOT) begin : g_more
        wire [REMAINDER-2:0]    next_remainder;  // its sign is the root's next bit
        wire [RADICAND-2*k-3:0] next_radicand;

        fp_rank #(
          .WIDTH     (REMAINDER - 1 + RADICAND - 2 * k - 2),
          .REGISTERED(CUTS[k])
        ) rank (
          .aclk(aclk),
          .d   ({remainder[REMAINDER-2:0], radicand[RADICAND-2*k-3:0]}),
          .q   ({next_remainder, next_radicand})
        );
      end else begin : g_last
        wire unused_remainder = ^remainder;
      end
    end
  endgenerate

  assign y = g_digit[ROOT-1].next_root;

endmodule

`default_nettype wire
