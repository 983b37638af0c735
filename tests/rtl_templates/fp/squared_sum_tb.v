// squared_sum_tb: fp_squared_sum against fp_add and fp_square for every pair of operands, in a
// simulator other than Verilator.
`default_nettype none

module squared_sum_tb;

  parameter EXPONENT_BITS = 3;
  parameter PRECISION     = 3;
  parameter SUBTRACT      = 1;
  parameter GRADUAL       = 1;
  parameter SUM_SELECTS   = 2;

  localparam PACKED = EXPONENT_BITS + PRECISION;
  localparam COUNT  = 1 << PACKED;

  reg               aclk = 1'b0;
  reg  [PACKED-1:0] a;
  reg  [PACKED-1:0] b;
  wire [PACKED-1:0] sum;
  wire [PACKED-1:0] square;
  wire [PACKED-1:0] y;
  wire [1:0]        unused_exceptional;
  integer           pair;
  integer           wrong = 0;

  fp_add #(
      .EXPONENT_BITS(EXPONENT_BITS),
      .PRECISION    (PRECISION),
      .SUBTRACT     (SUBTRACT),
      .GRADUAL      (GRADUAL)
  ) add (
      .aclk       (aclk),
      .a          (a),
      .b          (b),
      .y          (sum),
      .exceptional(unused_exceptional[0])
  );

  fp_square #(
      .EXPONENT_BITS(EXPONENT_BITS),
      .PRECISION    (PRECISION),
      .GRADUAL      (GRADUAL)
  ) square_of_sum (
      .aclk       (aclk),
      .a          (sum),
      .y          (square),
      .exceptional(unused_exceptional[1])
  );

  fp_squared_sum #(
      .EXPONENT_BITS(EXPONENT_BITS),
      .PRECISION    (PRECISION),
      .SUBTRACT     (SUBTRACT),
      .GRADUAL      (GRADUAL),
      .SUM_SELECTS  (SUM_SELECTS)
  ) dut (
      .aclk(aclk),
      .a   (a),
      .b   (b),
      .y   (y)
  );

  initial begin
    for (pair = 0; pair < COUNT * COUNT; pair = pair + 1) begin
      {a, b} = pair;
      #1;
      // The comparison is by `!==`, so an unknown answer is a wrong one.
      if (y !== square) begin
        wrong = wrong + 1;
        if (wrong < 10) $display("WRONG a %h b %h: expected %h, got %h", a, b, square, y);
      end
    end
    if (wrong == 0) $display("PASS");
    $finish;
  end

endmodule

`default_nettype wire
