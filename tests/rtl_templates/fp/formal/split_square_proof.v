// split_square_proof: fp_logic_product with SPLIT, fed with any numbers cycle by cycle, gives the
// square of the one that came LATENCY cycles before.
`default_nettype none

module split_square_proof #(
  parameter       PRECISION = 8,
  parameter [6:0] CUTS      = 7'h40,
  parameter       LATENCY   = 1       // the population count of CUTS
) (
  input wire                 aclk,
  input wire [PRECISION-1:0] a
);

  localparam [2*PRECISION-1:0] ALL_ONES = {PRECISION{1'b1}};

  wire [2*PRECISION-1:0] product;

  fp_logic_product #(
    .PRECISION(PRECISION),
    .SQUARE   (1),
    .SPLIT    (1),
    .CUTS     (CUTS)
  ) dut (
    .aclk   (aclk),
    .a      (a),
    .b      (a),
    .product(product)
  );

  reg [LATENCY*PRECISION-1:0] sent = 0;
  reg [LATENCY-1:0]           past = 0;  // bit k: more than k cycles have passed

  wire [2*PRECISION-1:0] due = sent[(LATENCY-1)*PRECISION+:PRECISION];

  always @(posedge aclk) begin
    sent <= {sent, a};
    past <= {past, 1'b1};
  end

  always @(*) begin
    if (past[LATENCY-1]) begin
      assert (product == due * due);
      cover (product == ALL_ONES * ALL_ONES);
    end
  end

endmodule

`default_nettype wire
