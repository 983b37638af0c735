// embedded_multiplier: a * b, with the registers of an embedded multiplier: one in front for the
// factors, two behind for the product.
// Latency: the population count of CUTS (three bits); initiation interval 1; no reset.
`default_nettype none

module embedded_multiplier #(
  parameter       A_WIDTH  = 18,  // bits of `a`, 1 or more
  parameter       B_WIDTH  = 18,  // bits of `b`, 1 or more
  parameter       SIGNED_A = 0,   // 1: `a` is in two's complement; 0: unsigned
  parameter       SIGNED_B = 0,   // 1: `b` is in two's complement; 0: unsigned
  // Registers: bit 0 of the factors, bits 1 and 2 of the product.
  parameter [2:0] CUTS     = 3'b000
) (
  input  wire                       aclk,
  input  wire [A_WIDTH-1:0]         a,
  input  wire [B_WIDTH-1:0]         b,
  output wire [A_WIDTH+B_WIDTH-1:0] product
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (A_WIDTH < 1) begin : g_refused_a A_WIDTH_is_below_1 refused (); end
    if (B_WIDTH < 1) begin : g_refused_b B_WIDTH_is_below_1 refused (); end
  endgenerate

  wire [A_WIDTH-1:0]         factor_a;
  wire [B_WIDTH-1:0]         factor_b;
  wire [A_WIDTH+B_WIDTH-1:0] whole;

  fp_rank #(
    .WIDTH     (A_WIDTH + B_WIDTH),
    .REGISTERED(CUTS[0])
  ) factors (
    .aclk(aclk),
    .d   ({a, b}),
    .q   ({factor_a, factor_b})
  );

  generate
    // Two unsigned factors are multiplied as such: as signed numbers of the same width they would
    // overflow.
    if ((SIGNED_A == 0) && (SIGNED_B == 0)) begin : g_unsigned
      assign whole = factor_a * factor_b;
    end else begin : g_signed
      wire [A_WIDTH:0] a_extended = {(SIGNED_A != 0) && factor_a[A_WIDTH-1], factor_a};
      wire [B_WIDTH:0] b_extended = {(SIGNED_B != 0) && factor_b[B_WIDTH-1], factor_b};

      assign whole = $signed(a_extended) * $signed(b_extended);
    end
  endgenerate

  fp_ranks #(
    .WIDTH(A_WIDTH + B_WIDTH),
    .COUNT(2),
    .CUTS (CUTS[2:1])
  ) ranks (
    .aclk(aclk),
    .d   (whole),
    .q   (product)
  );

endmodule

`default_nettype wire
