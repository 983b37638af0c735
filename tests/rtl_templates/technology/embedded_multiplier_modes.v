// embedded_multiplier_modes: instances of embedded_multiplier with all signs and all cuts, side by
// side. Factors have A_WIDTH and B_WIDTH bits.
`default_nettype none

module embedded_multiplier_modes #(
  parameter A_WIDTH = 18,
  parameter B_WIDTH = 3
) (
  input  wire                            aclk,
  input  wire [A_WIDTH-1:0]              a,
  input  wire [B_WIDTH-1:0]              b,
  output wire [32*(A_WIDTH+B_WIDTH)-1:0] products
);

  genvar mode;
  generate
    for (mode = 0; mode < 32; mode = mode + 1) begin : g_mode
      localparam [4:0] MODE = mode;

      embedded_multiplier #(
        .A_WIDTH (A_WIDTH),
        .B_WIDTH (B_WIDTH),
        .SIGNED_A(MODE[0]),
        .SIGNED_B(MODE[1]),
        .CUTS    (MODE[4:2])
      ) multiplier (
        .aclk   (aclk),
        .a      (a),
        .b      (b),
        .product(products[mode*(A_WIDTH+B_WIDTH)+:A_WIDTH+B_WIDTH])
      );
    end
  endgenerate

endmodule

`default_nettype wire
