// serial_square_tb: fp_serial_square against fp_square for every operand, one after the other, in a
// simulator other than Verilator. Nothing is known of the unit's registers before the first one.
`default_nettype none

module serial_square_tb;

  parameter EXPONENT_BITS = 2;
  parameter PRECISION     = 13;
  parameter GRADUAL       = 1;
  parameter TOWARD_ZERO   = 0;

  localparam PACKED  = EXPONENT_BITS + PRECISION;
  localparam COUNT   = 1 << PACKED;
  localparam CYCLES  = (PRECISION + 5) / 6;
  localparam LATENCY = CYCLES + 10;  // with all cuts

  reg               aclk  = 1'b0;
  reg               start = 1'b0;
  reg  [PACKED-1:0] a;
  reg  [PACKED-1:0] judged;
  wire [PACKED-1:0] y;
  wire              exceptional;
  wire [PACKED-1:0] square;
  wire              square_exceptional;
  integer           cycle;
  integer           wrong = 0;

  fp_serial_square #(
      .EXPONENT_BITS(EXPONENT_BITS),
      .PRECISION    (PRECISION),
      .GRADUAL      (GRADUAL),
      .TOWARD_ZERO  (TOWARD_ZERO),
      .CUTS         ({(CYCLES + 10) {1'b1}})
  ) dut (
      .aclk       (aclk),
      .start      (start),
      .a          (a),
      .y          (y),
      .exceptional(exceptional)
  );

  fp_square #(
      .EXPONENT_BITS(EXPONENT_BITS),
      .PRECISION    (PRECISION),
      .GRADUAL      (GRADUAL),
      .TOWARD_ZERO  (TOWARD_ZERO)
  ) expected (
      .aclk       (aclk),
      .a          (judged),
      .y          (square),
      .exceptional(square_exceptional)
  );

  initial begin
    for (cycle = 0; cycle < COUNT * CYCLES + LATENCY; cycle = cycle + 1) begin
      start  = (cycle % CYCLES == 0);
      a      = start ? cycle / CYCLES : $random;
      judged = (cycle - LATENCY) / CYCLES;
      #1;
      // The comparison is by `!==`, so an unknown answer is a wrong one.
      if ((cycle >= LATENCY) && ((cycle - LATENCY) % CYCLES == 0)
          && ({exceptional, y} !== {square_exceptional, square})) begin
        wrong = wrong + 1;
        if (wrong < 10) $display("WRONG a %h: expected %h, got %h", judged, square, y);
      end
      aclk = 1'b1;
      #1;
      aclk = 1'b0;
    end
    if (wrong == 0) $display("PASS");
    $finish;
  end

endmodule

`default_nettype wire
