// embedded_multiplier: a * b, and the registers that an embedded multiplier has behind its product.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
// A factor is in two's complement where SIGNED_A (SIGNED_B) is 1, without a sign where it is 0.
`default_nettype none

module embedded_multiplier #(
  parameter       A_WIDTH  = 18,
  parameter       B_WIDTH  = 18,
  parameter       SIGNED_A = 0,
  parameter       SIGNED_B = 0,
  parameter [1:0] CUTS     = 2'b00
) (
  input  wire                       aclk,
  input  wire [A_WIDTH-1:0]         a,
  input  wire [B_WIDTH-1:0]         b,
  output wire [A_WIDTH+B_WIDTH-1:0] product
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (A_WIDTH < 1) begin : g_refused_a
      A_WIDTH_is_below_1 refused ();
    end
    if (B_WIDTH < 1) begin : g_refused_b
      B_WIDTH_is_below_1 refused ();
    end
  endgenerate

  wire [A_WIDTH+B_WIDTH-1:0] whole;

  generate
    // Not as numbers with signs: of as many bits, these would overflow.
    if ((SIGNED_A == 0) && (SIGNED_B == 0)) begin : g_unsigned
      assign whole = a * b;
    end else begin : g_signed
      wire [A_WIDTH:0] a_extended = {(SIGNED_A != 0) && a[A_WIDTH-1], a};
      wire [B_WIDTH:0] b_extended = {(SIGNED_B != 0) && b[B_WIDTH-1], b};

      assign whole = $signed(a_extended) * $signed(b_extended);
    end
  endgenerate

  fp_ranks #(
    .WIDTH(A_WIDTH + B_WIDTH),
    .COUNT(2),
    .CUTS (CUTS)
  ) ranks (
    .aclk(aclk),
    .d   (whole),
    .q   (product)
  );

endmodule

`default_nettype wire
